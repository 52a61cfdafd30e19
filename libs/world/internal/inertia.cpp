#include "world/internal/inertia.hpp"

#include <tinyxml2.h>

#include <Eigen/Eigenvalues>
#include <cmath>

namespace amiss::world {
namespace {

using tinyxml2::XMLElement;

constexpr double kMassInsteadKg = 1.0;
constexpr double kMaxMassKg = 1e5;

double number_of(const XMLElement& parent, const char* name, double otherwise) {
  const XMLElement* child = parent.FirstChildElement(name);
  return child != nullptr ? child->DoubleText(otherwise) : otherwise;
}

/// Moments about the principal axes are positive, and each is at most the sum of the two others.
bool is_valid(const XMLElement& inertia) {
  const double xy = number_of(inertia, "ixy", 0.0), xz = number_of(inertia, "ixz", 0.0);
  const double yz = number_of(inertia, "iyz", 0.0);
  Eigen::Matrix3d I;
  I << number_of(inertia, "ixx", 1.0), xy, xz, xy, number_of(inertia, "iyy", 1.0), yz, xz, yz,
      number_of(inertia, "izz", 1.0);
  if (!I.allFinite()) return false;
  const Eigen::Vector3d moments =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(I, Eigen::EigenvaluesOnly).eigenvalues();
  const double slack = 1e-6 * moments(2);
  return moments(0) > 0.0 && moments(0) + moments(1) + slack >= moments(2);
}

}  // namespace

std::vector<std::string> repair_inertial(XMLElement& inertial) {
  std::vector<std::string> repairs;
  if (XMLElement* mass = inertial.FirstChildElement("mass")) {
    const double value = mass->DoubleText(std::nan(""));
    if (!std::isfinite(value) || value <= 0.0 || value > kMaxMassKg) {
      const char* text = mass->GetText();
      repairs.push_back(std::string("mass '") + (text != nullptr ? text : "") +
                        "' is taken as 1 kg, it must be positive");
      mass->SetText(kMassInsteadKg);
    }
  }
  if (XMLElement* inertia = inertial.FirstChildElement("inertia")) {
    const bool valid = is_valid(*inertia);
    if (!valid) repairs.emplace_back("impossible inertia is taken from the shape instead");
    if (!valid) inertial.DeleteChild(inertia);
  }
  return repairs;
}

}  // namespace amiss::world
