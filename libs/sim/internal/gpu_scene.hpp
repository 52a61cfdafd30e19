// Bodies and textures as GL keeps them.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "sim/internal/body_mesh.hpp"
#include "sim/internal/gl_functions.hpp"

namespace amiss::sim::internal {

struct GpuBatch {
  GLuint texture = 0;  // 0: none
  bool transparent = false, closed = true;
  Eigen::AlignedBox3f box;  // of the body's frame
  std::size_t offset_bytes = 0;
  GLsizei index_count = 0;
};

struct GpuBody {
  GLuint array = 0, vertices = 0, indices = 0;
  std::vector<GpuBatch> batches;
};

class GpuScene {
 public:
  void add(const GlFunctions& gl, const BodyMesh& mesh);
  void keep(const GlFunctions& gl, std::size_t count);
  void release(const GlFunctions& gl);

  [[nodiscard]] const std::vector<GpuBody>& bodies() const { return bodies_; }

 private:
  GLuint texture_of(const GlFunctions& gl, const std::shared_ptr<const world::Texture>& texture);

  std::vector<GpuBody> bodies_;
  struct Uploaded {
    std::shared_ptr<const world::Texture> source;  // kept, so that its address stays its own
    GLuint id;
  };
  std::map<const world::Texture*, Uploaded> textures_;
};

}  // namespace amiss::sim::internal
