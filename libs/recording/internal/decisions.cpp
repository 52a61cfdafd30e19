#include "recording/internal/decisions.hpp"

#include "recording/robot_messages.hpp"
#include "recording/ros_messages.hpp"

namespace amiss::recording::internal {

void tell_decisions(mission::Sinks& sinks, const Put& put) {
  using Kind = Decision::Kind;
  const auto decided = [put](Kind kind, int region) {
    put("/amiss/decisions", "amiss_msgs/msg/Decision", decision_message({kind, region}));
  };
  chain<mission::FrameEvent>(sinks.segmenting, [put, decided](const auto& e) {
    put("/amiss/segmented", "sensor_msgs/msg/Image", colour_message(*e.frame));
    decided(Kind::kSegmenting, 0);
  });
  chain<mission::ExaminationEvent>(sinks.examined, [decided](const auto& e) { decided(Kind::kExamined, e.region); });
  chain<mission::DifferenceEvent>(sinks.compared, [decided](const auto&) { decided(Kind::kCompared, 0); });
}

}  // namespace amiss::recording::internal
