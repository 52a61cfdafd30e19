#include "segment/internal/pieces.hpp"

#include <gtest/gtest.h>

#include <set>

#include "segment/scene.hpp"

namespace amiss::segment::internal {
namespace {

using testing::box_at;

const Cylinder kCrop{Eigen::Vector2d(0.95, 0.0), 0.35, -0.15, 0.4};
const Plane kGround{Eigen::Vector3d::UnitZ(), -testing::kFloorZ, 100};

std::vector<Piece> pieces_in(const std::vector<testing::Body>& bodies, bool join) {
  const Params params;
  const auto view = testing::look(bodies, -0.75, 1);
  const Window window = window_of(view.frame, view.T_map_camera, kCrop, params.max_range_m);
  const auto pieces = pieces_of(window, relief_of(window, kGround, params), params);
  return join ? joined(pieces, window, params) : pieces;
}

std::size_t large(const std::vector<Piece>& pieces) {
  return static_cast<std::size_t>(
      std::count_if(pieces.begin(), pieces.end(), [](const Piece& piece) { return piece.members.size() > 100; }));
}

TEST(Pieces, ColourAndSmoothnessCutABoxOfTwoColours) {
  const std::vector<testing::Body> bodies{box_at(0.95, 0.05, {0.1, 0.1, 0.1}, 0.0, {220, 30, 30}),
                                          box_at(0.95, -0.05, {0.1, 0.1, 0.1}, 0.0, {30, 30, 220})};
  EXPECT_GE(large(pieces_in(bodies, false)), 2U);
  EXPECT_EQ(large(pieces_in(bodies, true)), 1U);
}

TEST(Pieces, AGapKeepsThingsApart) {
  const std::vector<testing::Body> bodies{box_at(0.95, 0.08, {0.1, 0.1, 0.1}, 0.0, {220, 30, 30}),
                                          box_at(0.95, -0.08, {0.1, 0.1, 0.1}, 0.0, {220, 30, 30})};
  EXPECT_EQ(large(pieces_in(bodies, true)), 2U);
}

TEST(Pieces, NoPixelIsInTwoOfThem) {
  const auto pieces = pieces_in({box_at(0.95, 0.0, {0.2, 0.1, 0.1}, 0.4, {220, 30, 30})}, false);
  std::set<std::uint32_t> seen;
  std::size_t members = 0;
  for (const Piece& piece : pieces) {
    seen.insert(piece.members.begin(), piece.members.end());
    members += piece.members.size();
    EXPECT_EQ(piece.contact_m, 0.0);
  }
  EXPECT_EQ(seen.size(), members);
}

TEST(Pieces, WhatReachesOutOfTheCropHasContact) {
  double contact_m = 0.0;
  for (const Piece& piece : pieces_in({box_at(1.25, 0.0, {0.2, 1.0, 0.3}, 0.0, {90, 90, 90})}, true)) {
    contact_m = std::max(contact_m, piece.contact_m);
  }
  EXPECT_GT(contact_m, 0.1);
}

}  // namespace
}  // namespace amiss::segment::internal
