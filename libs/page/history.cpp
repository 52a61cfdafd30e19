#include "page/history.hpp"

namespace amiss::page {

void History::append(std::string line) {
  const std::lock_guard lock(mutex_);
  lines_.push_back(std::move(line));
  if (listener_) listener_();
}

std::size_t History::size() const {
  const std::lock_guard lock(mutex_);
  return lines_.size();
}

History::Batch History::read(std::size_t from, std::size_t most_bytes) const {
  const std::lock_guard lock(mutex_);
  Batch batch{{}, from};
  while (batch.next < lines_.size()) {
    const std::string& line = lines_[batch.next];
    if (!batch.text.empty() && batch.text.size() + line.size() + 1 > most_bytes) break;
    batch.text += line;
    batch.text += '\n';
    ++batch.next;
  }
  return batch;
}

std::vector<std::string> History::lines() const {
  const std::lock_guard lock(mutex_);
  return lines_;
}

void History::set_listener(std::function<void()> listener) {
  const std::lock_guard lock(mutex_);
  listener_ = std::move(listener);
}

}  // namespace amiss::page
