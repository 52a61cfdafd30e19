// The lines that a run has told so far, for any number of readers: one thread appends, others read from where they are.
// A reader that is slow stays behind and holds up nobody; what it has not read is kept once, not once for each reader.
#pragma once

#include <functional>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace amiss::page {

class History {
 public:
  void append(std::string line);
  [[nodiscard]] std::size_t size() const;

  struct Batch {
    std::string text;      // lines, each with its newline
    std::size_t next = 0;  // the line to go on with
  };
  /// Lines from `from` on, at least one where there is one, no more than fit into `most_bytes`.
  [[nodiscard]] Batch read(std::size_t from, std::size_t most_bytes) const;
  [[nodiscard]] std::vector<std::string> lines() const;

  /// Called after every append, by the thread that appends; empty for nobody.
  void set_listener(std::function<void()> listener);

 private:
  mutable std::mutex mutex_;
  std::vector<std::string> lines_;
  std::function<void()> listener_;
};

}  // namespace amiss::page
