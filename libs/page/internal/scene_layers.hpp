// What a scene shows, layer by layer: Story, instant -> named objects of MRPT. Map frame, metres.
#pragma once

#include <mrpt/opengl/COpenGLScene.h>

#include "page/story.hpp"

namespace amiss::page {

class SceneLayers {
 public:
  /// Both outlive it.
  SceneLayers(mrpt::opengl::COpenGLScene& scene, const Story& story, double t_s)
      : scene_(scene), story_(story), t_s_(t_s) {}

  void add_floor() const;    // "floor plan", "grid"
  void add_voxels() const;   // "reference map", "map now", "appeared", "vanished"
  void add_views() const;    // "view ID"
  void add_ways() const;     // "driven", "way"
  void add_regions() const;  // "region ID" and its letter; "segments"
  void add_objects() const;  // "object NAME" and its letter
  void add_robot() const;    // "robot"

 private:
  template <class Thing>
  std::shared_ptr<Thing> add(const std::string& name) const {
    auto thing = Thing::Create();
    thing->setName(name);
    scene_.insert(thing);
    return thing;
  }
  void add_grid(const Eigen::AlignedBox2d& floor) const;
  void add_letter(const std::string& text, const Eigen::Vector3d& p, const mrpt::img::TColor& colour) const;

  mrpt::opengl::COpenGLScene& scene_;
  const Story& story_;
  double t_s_;
};

}  // namespace amiss::page
