// Listening to a mission's sinks beside those who do already, and what a replay has to know of its decisions.
#pragma once

#include <functional>
#include <string>

#include "mission/sinks.hpp"

namespace amiss::recording::internal {

/// Runs what is there, then `after`, for each event.
template <class Event, class After>
void chain(std::function<void(const Event&)>& sink, After after) {
  sink = [before = std::move(sink), after](const Event& event) {
    before(event);
    after(event);
  };
}

/// topic, type, message
using Put = std::function<void(const char*, const char*, std::string)>;
/// The places where the mission compares and segments, and the colours that it segments.
void tell_decisions(mission::Sinks& sinks, const Put& put);

}  // namespace amiss::recording::internal
