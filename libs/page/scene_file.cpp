#include "page/scene_file.hpp"

#include <mrpt/io/CMemoryStream.h>
#include <mrpt/serialization/CArchive.h>
#include <zlib.h>

#include <stdexcept>

#include "core/files.hpp"
#include "page/internal/scene_cloud.hpp"
#include "page/internal/scene_layers.hpp"

namespace amiss::page {

namespace {

/// As the program gzip would, without name and time.
std::string gzipped(std::string bytes) {
  constexpr int kWindow = 15 + 16, kMemory = 8;  // zlib's defaults, with gzip's header
  z_stream z{};
  if (deflateInit2(&z, Z_DEFAULT_COMPRESSION, Z_DEFLATED, kWindow, kMemory, Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::runtime_error("a scene cannot be compressed");
  std::string out(deflateBound(&z, bytes.size()), '\0');
  z.next_in = reinterpret_cast<Bytef*>(bytes.data());
  z.avail_in = static_cast<uInt>(bytes.size());
  z.next_out = reinterpret_cast<Bytef*>(out.data());
  z.avail_out = static_cast<uInt>(out.size());
  const int status = deflate(&z, Z_FINISH);
  out.resize(z.total_out);
  deflateEnd(&z);
  if (status != Z_STREAM_END) throw std::runtime_error("a scene cannot be compressed");
  return out;
}

/// Light from above without highlights, which would hide colours.
void set_light(mrpt::opengl::TLightParameters& light) {
  light.ambient = mrpt::img::TColorf(0.55F, 0.55F, 0.55F);
  light.diffuse = mrpt::img::TColorf(0.5F, 0.5F, 0.5F);
  light.specular = mrpt::img::TColorf(0.0F, 0.0F, 0.0F);
  light.direction = mrpt::math::TVector3Df(-0.35F, 0.5F, -0.79F);
}

std::string bytes_of(mrpt::opengl::COpenGLScene& scene) {
  set_light(scene.getViewport()->lightParameters());
  mrpt::io::CMemoryStream memory;
  mrpt::serialization::archiveFrom(memory) << scene;
  return gzipped({static_cast<const char*>(memory.getRawBufferData()), memory.getTotalBytesCount()});
}

}  // namespace

std::string scene_bytes(const Story& story, double t_s) {
  mrpt::opengl::COpenGLScene scene;
  const SceneLayers layers(scene, story, t_s);
  layers.add_floor();
  layers.add_voxels();
  layers.add_views();
  layers.add_ways();
  layers.add_regions();
  layers.add_objects();
  layers.add_robot();
  return bytes_of(scene);
}

std::string scene_bytes(const Cloud<Map>& points, const std::vector<Eigen::Vector3d>& camera_way) {
  mrpt::opengl::COpenGLScene scene;
  add_cloud(scene, points, camera_way);
  return bytes_of(scene);
}

void save_scene(const std::filesystem::path& file, const std::string& bytes) { save_atomically(file, bytes); }

}  // namespace amiss::page
