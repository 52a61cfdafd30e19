#include "experiment/rounds.hpp"

#include <fmt/format.h>

namespace amiss::experiment {

namespace {

constexpr int kMostInVain = 3;

}  // namespace

bool run_rounds(const Folder& folder, const std::function<RoundEnd(const std::vector<Trial>& missing)>& round,
                const RunHooks& hooks) {
  std::vector<Trial> missing = folder.missing();
  for (int in_vain = 0; !missing.empty();) {
    const RoundEnd end = round(missing);
    if (end.stopped) return false;
    const std::size_t before = missing.size();
    missing = folder.missing();
    if (missing.empty()) break;
    in_vain = missing.size() < before ? 0 : in_vain + 1;
    const std::string last = end.last_words.empty() ? "" : ", the last words are: " + end.last_words;
    if (in_vain == kMostInVain) {
      hooks.tell(fmt::format("{} trials are missing and nothing came of handing them out {} times{}", missing.size(),
                             kMostInVain, last));
      return false;
    }
    hooks.tell(fmt::format("{} trials came back without a result and are handed out again{}", missing.size(), last));
  }
  folder.clear_work();
  return true;
}

}  // namespace amiss::experiment
