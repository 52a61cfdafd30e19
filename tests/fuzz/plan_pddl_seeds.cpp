#include "core/files.hpp"
#include "fuzz/seeds.hpp"

namespace amiss::fuzz {

std::vector<std::string> valid_inputs() {
  std::string search = load_bytes(AMISS_SOURCE_DIR "/share/pddl/search.pddl");
  search += '\0';
  search +=
      "(define (problem visits) (:domain search) (:objects hsr - robot here a b - waypoint t - triangle r - region)\n"
      "(:init (robot_at hsr here) (connected here a) (connected a b) (= (distance here a) 120) (= (distance a b) 80)\n"
      "(= (total-cost) 0) (views a t) (viewpoint b r)) (:goal (and (explored t) (examined r)))\n"
      "(:metric minimize (total-cost)))";
  std::string own;  // a zero byte first: the domain of the target itself
  own += '\0';
  own += "(define (problem e) (:domain d) (:objects o - a u - b) (:init (p o) (= (f k) 2)) (:goal (q o u)))";
  own += '\0';
  own += "(go o u)\n(go k k)\n";
  return {search, own};
}

std::vector<std::string> words() {
  return {"(and ", "(not ", "(or ", "(when ", "(forall (?x) ", "(exists (?x - a) ", "(either a b)",
          ")",     ";",     "?x",   "- ",     "(= ",           ":action",           "(increase (total-cost) -1)"};
}

}  // namespace amiss::fuzz
