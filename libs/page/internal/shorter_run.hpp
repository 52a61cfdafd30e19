// The events that a report has room for: events of a run, bytes for a kind -> fewer events, by time, start first and
// end last. See report_page.hpp for what is kept.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

namespace amiss::page {

[[nodiscard]] std::vector<nlohmann::ordered_json> shortened(const std::vector<nlohmann::ordered_json>& events,
                                                            std::size_t most_of_a_kind);

}  // namespace amiss::page
