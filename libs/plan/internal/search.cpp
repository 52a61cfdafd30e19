#include "plan/internal/search.hpp"

#include <algorithm>

namespace amiss::plan {

OperatorSequence path_to(int state, const std::vector<Origin>& origins) {
  OperatorSequence path;
  while (state != 0) {
    const Origin& origin = origins[static_cast<std::size_t>(state)];
    path.push_back(origin.op);
    state = origin.parent;
  }
  std::reverse(path.begin(), path.end());
  return path;
}

}  // namespace amiss::plan
