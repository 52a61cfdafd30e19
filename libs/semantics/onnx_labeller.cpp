#include "semantics/onnx_labeller.hpp"

#include "semantics/internal/cloud_check.hpp"

namespace amiss::semantics {

std::vector<SemanticClass> OnnxLabeller::label(const Cloud<Map>& cloud) const {
  check_cloud(cloud);
  std::vector<SemanticClass> classes;
  classes.reserve(cloud.points.size());
  for (const Eigen::Vector3f& p : cloud.points) classes.push_back(votes_.at(p));
  return classes;
}

}  // namespace amiss::semantics
