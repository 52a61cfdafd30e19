#include "sim/internal/gpu_scene.hpp"

#include <cstddef>

namespace amiss::sim::internal {
namespace {

// GL takes offsets into buffers as pointers.
const void* offset_pointer(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

void describe_vertex(const GlFunctions& gl) {
  constexpr GLsizei kStride = sizeof(Vertex);
  gl.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, kStride, offset_pointer(offsetof(Vertex, position)));
  gl.VertexAttribPointer(1, 4, GL_SHORT, GL_TRUE, kStride, offset_pointer(offsetof(Vertex, normal)));
  gl.VertexAttribPointer(2, 2, GL_FLOAT, GL_FALSE, kStride, offset_pointer(offsetof(Vertex, uv)));
  gl.VertexAttribPointer(3, 4, GL_UNSIGNED_BYTE, GL_TRUE, kStride, offset_pointer(offsetof(Vertex, colour)));
  gl.VertexAttribPointer(4, 4, GL_UNSIGNED_BYTE, GL_TRUE, kStride, offset_pointer(offsetof(Vertex, matt)));
  for (GLuint place = 0; place < 5; ++place) gl.EnableVertexAttribArray(place);
}

}  // namespace

GLuint GpuScene::texture_of(const GlFunctions& gl, const std::shared_ptr<const world::Texture>& texture) {
  if (texture == nullptr || texture->pixels.empty()) return 0;
  const auto known = textures_.find(texture.get());
  if (known != textures_.end()) return known->second.id;
  // GL's first row is the lowest one.
  const auto width = static_cast<std::ptrdiff_t>(texture->width);
  std::vector<Rgb> upwards;
  upwards.reserve(texture->pixels.size());
  for (std::ptrdiff_t row = texture->height - 1; row >= 0; --row)
    upwards.insert(upwards.end(), texture->pixels.begin() + row * width, texture->pixels.begin() + (row + 1) * width);
  GLuint id = 0;
  gl.GenTextures(1, &id);
  gl.BindTexture(GL_TEXTURE_2D, id);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, texture->width, texture->height, 0, GL_RGB, GL_UNSIGNED_BYTE,
                upwards.data());
  gl.GenerateMipmap(GL_TEXTURE_2D);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  textures_.emplace(texture.get(), Uploaded{texture, id});
  return id;
}

void GpuScene::add(const GlFunctions& gl, const BodyMesh& mesh) {
  GpuBody body;
  gl.GenVertexArrays(1, &body.array);
  gl.BindVertexArray(body.array);
  gl.GenBuffers(1, &body.vertices);
  gl.BindBuffer(GL_ARRAY_BUFFER, body.vertices);
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.vertices.size() * sizeof(Vertex)), mesh.vertices.data(),
                GL_STATIC_DRAW);
  gl.GenBuffers(1, &body.indices);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, body.indices);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.indices.size() * sizeof(std::uint32_t)),
                mesh.indices.data(), GL_STATIC_DRAW);
  describe_vertex(gl);
  gl.BindVertexArray(0);
  for (const Batch& batch : mesh.batches)
    body.batches.push_back({texture_of(gl, batch.texture), batch.transparent, batch.closed, batch.box,
                            batch.first_index * sizeof(std::uint32_t), static_cast<GLsizei>(batch.index_count)});
  bodies_.push_back(std::move(body));
}

void GpuScene::keep(const GlFunctions& gl, std::size_t count) {
  while (bodies_.size() > count) {
    const GpuBody& body = bodies_.back();
    gl.DeleteVertexArrays(1, &body.array);
    gl.DeleteBuffers(1, &body.vertices);
    gl.DeleteBuffers(1, &body.indices);
    bodies_.pop_back();
  }
}

void GpuScene::release(const GlFunctions& gl) {
  keep(gl, 0);
  for (const auto& [source, uploaded] : textures_) gl.DeleteTextures(1, &uploaded.id);
  textures_.clear();
}

}  // namespace amiss::sim::internal
