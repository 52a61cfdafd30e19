#include <algorithm>
#include <charconv>
#include <cmath>

#include "scenario/scenario_file.hpp"

namespace amiss::scenario {

namespace {

std::string number(double value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  return {text, end};
}

/// Single quotes of YAML, in which only the quote itself is special.
std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("''") : std::string(1, c);
  return out + "'";
}

std::string place(const world::Place& p) {
  std::string text = ", x: " + number(p.x_m) + ", y: " + number(p.y_m);
  if (p.z_m) text += ", z: " + number(*p.z_m);
  return p.yaw_rad == 0.0 ? text : text + ", yaw_deg: " + number(degrees(p.yaw_rad));
}

std::string pose(double x_m, double y_m, double yaw_rad) {
  return "{x: " + number(x_m) + ", y: " + number(y_m) + ", yaw_deg: " + number(degrees(yaw_rad)) + "}";
}

std::string amount(const world::Fault& fault) {
  switch (fault.kind) {
    case world::FaultKind::kWrong:
      return ", factor: " + number(fault.amount);
    case world::FaultKind::kSlow:
    case world::FaultKind::kIntermittent:
      return ", period: " + number(fault.amount);
    case world::FaultKind::kDelayed:
      return ", delay: " + number(fault.amount);
    case world::FaultKind::kOff:
    case world::FaultKind::kStuck:
    case world::FaultKind::kGarbage:
    case world::FaultKind::kJump:
      break;
  }
  return "";
}

struct ChangeText {
  const Vocabulary& vocabulary;

  std::string operator()(const world::AddBody& c) const {
    const bool is_object =
        std::find(vocabulary.objects.begin(), vocabulary.objects.end(), c.kind) != vocabulary.objects.end();
    return std::string("add: {") + (is_object ? "object: " : "furniture: ") + quoted(c.kind) +
           ", name: " + quoted(c.name) + place(c.place) + "}";
  }
  std::string operator()(const world::MoveBody& c) const {
    return "move: {name: " + quoted(c.name) + place(c.place) + "}";
  }
  std::string operator()(const world::RemoveBody& c) const { return "remove: {name: " + quoted(c.name) + "}"; }
  std::string operator()(const world::CloseDoor& c) const {
    return "close_door: {leaf: " + quoted(c.leaf) + ", frame: " + quoted(c.frame) + "}";
  }
  std::string operator()(const world::Walk& c) const {
    std::string way;
    for (const Eigen::Vector2d& p : c.way_m) {
      way += (way.empty() ? "[" : ", [") + number(p.x()) + ", " + number(p.y()) + "]";
    }
    return "walk: {name: " + quoted(c.name) + ", speed: " + number(c.speed_m_s) + ", way: [" + way + "]}";
  }
  std::string operator()(const world::Kidnap& c) const {
    return "kidnap: " + pose(c.T_world_base.x_m, c.T_world_base.y_m, c.T_world_base.yaw_rad);
  }
  std::string operator()(const world::Fault& c) const {
    if (c.kind == world::FaultKind::kJump) return "jump: " + pose(c.jump.x_m, c.jump.y_m, c.jump.yaw_rad);
    return "fault: {sensor: " + std::string(to_string(c.sensor)) + ", kind: " + std::string(to_string(c.kind)) +
           (c.for_s < world::Fault{}.for_s ? ", for: " + number(c.for_s) : "") + amount(c) + "}";
  }
};

std::string moment(const world::Moment& m) {
  const std::string after = ", after: " + number(m.after_s);
  switch (m.kind) {
    case world::Moment::Kind::kTime:
      return "at: " + number(m.after_s);
    case world::Moment::Kind::kRobotNear:
      return "when: {robot_near: {x: " + number(m.place_m.x()) + ", y: " + number(m.place_m.y()) +
             ", within: " + number(m.within_m) + "}}" + after;
    case world::Moment::Kind::kDetected:
      return "when: {detected: " + quoted(m.object) + "}" + after;
    case world::Moment::Kind::kExamined:
      return "when: {examined: " + quoted(m.object) + "}" + after;
  }
  return "";
}

std::string settings(const char* key, const std::vector<Setting>& all) {
  if (all.empty()) return "";
  std::string text = std::string(key) + ":\n";
  for (const Setting& s : all) text += "  " + s.key + ": " + quoted(s.value) + "\n";
  return text;
}

std::string words(const char* key, const std::vector<std::string>& all) {
  if (all.empty()) return "";
  std::string text;
  for (const std::string& word : all) text += (text.empty() ? "" : ", ") + quoted(word);
  return "  " + std::string(key) + ": [" + text + "]\n";
}

std::string limits(const std::string& key, const score::Limits& l) {
  std::string text;
  if (l.least) text += "min: " + number(*l.least);
  if (l.most) text += (text.empty() ? "max: " : ", max: ") + number(*l.most);
  return key + ": {" + text + "}";
}

std::string expectations(const score::Expectations& e) {
  std::string text = words("found", e.found) + words("not_found", e.not_found) + words("detected", e.detected) +
                     words("not_detected", e.not_detected) + words("end", e.end) + words("why", e.why);
  if (e.exit_status) text += "  exit_status: " + std::to_string(*e.exit_status) + "\n";
  if (!e.found_by_s.empty()) text += "  found_by:\n";
  for (const auto& [object, by_s] : e.found_by_s) text += "    " + quoted(object) + ": " + number(by_s) + "\n";
  if (!e.category.empty()) text += "  category:\n";
  for (const auto& [object, category] : e.category) text += "    " + quoted(object) + ": " + category + "\n";
  if (!e.navigation_errors.empty()) text += "  navigation_errors:\n";
  for (const auto& [key, l] : e.navigation_errors) text += "    " + limits(key, l) + "\n";
  for (const auto& [key, l] : e.numbers) text += "  " + limits(key, l) + "\n";
  return text.empty() ? "expect: {}\n" : "expect:\n" + text;
}

}  // namespace

std::string to_yaml(const Scenario& s, const Vocabulary& vocabulary) {
  std::string text;
  if (!s.about.empty()) text += "about: " + quoted(s.about) + "\n";
  text += "world: " + quoted(s.world) + "\nseed: " + std::to_string(s.seed) +
          "\nuntil: " + (s.until_found ? "found" : "explored") + "\ntime_limit: " + number(s.time_limit_s) + "\n";
  if (s.start) text += "start: " + pose(s.start->x_m, s.start->y_m, s.start->yaw_rad) + "\n";
  text += settings("params", s.params) + settings("reference_params", s.reference_params);
  if (!s.script.events.empty()) text += "events:\n";
  for (const world::Event& event : s.script.events) {
    text += "  - {" + moment(event.moment) + ", " + std::visit(ChangeText{vocabulary}, event.change) + "}\n";
  }
  return text + expectations(s.expect);
}

}  // namespace amiss::scenario
