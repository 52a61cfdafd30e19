#include "page/internal/scene_cloud.hpp"

#include <mrpt/opengl/CPointCloudColoured.h>
#include <mrpt/opengl/CSetOfLines.h>

namespace amiss::page {

void add_cloud(mrpt::opengl::COpenGLScene& scene, const Cloud<Map>& points,
               const std::vector<Eigen::Vector3d>& camera_way) {
  constexpr float kWidth_px = 2.0F, kFull = 255.0F;
  constexpr Rgb kGrey{138, 143, 152};
  const auto cloud = mrpt::opengl::CPointCloudColoured::Create();
  cloud->setName("points");
  cloud->setPointSize(kWidth_px);
  cloud->reserve(points.points.size());
  for (std::size_t i = 0; i < points.points.size(); ++i) {
    const Eigen::Vector3f& p = points.points[i];
    const Rgb c = points.colours.empty() ? kGrey : points.colours[i];
    cloud->push_back(p.x(), p.y(), p.z(), static_cast<float>(c.r) / kFull, static_cast<float>(c.g) / kFull,
                     static_cast<float>(c.b) / kFull);
  }
  scene.insert(cloud);
  const auto way = mrpt::opengl::CSetOfLines::Create();
  way->setName("camera");
  way->setColor_u8(0, 114, 178);
  way->setLineWidth(kWidth_px);
  for (std::size_t i = 1; i < camera_way.size(); ++i) {
    const Eigen::Vector3d &a = camera_way[i - 1], &b = camera_way[i];
    way->appendLine(a.x(), a.y(), a.z(), b.x(), b.y(), b.z());
  }
  scene.insert(way);
}

}  // namespace amiss::page
