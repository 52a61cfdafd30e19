#include "world/internal/scene_reader.hpp"

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <map>
#include <utility>

#include "core/result.hpp"
#include "world/internal/image.hpp"
#include "world/internal/mesh_mend.hpp"

namespace amiss::world {
namespace {

namespace fs = std::filesystem;

constexpr float kCreaseDeg = 40.0F;  // edges sharper than this stay sharp where normals are computed
constexpr std::size_t kMaxVertices = 20'000'000;

Rgb rgb_of(const aiColor4D& c) {
  const auto byte = [](float v) { return static_cast<std::uint8_t>(std::lround(std::clamp(v, 0.0F, 1.0F) * 255.0F)); };
  return {byte(c.r), byte(c.g), byte(c.b)};
}

struct Gathered {
  Mesh mesh;
  bool has_uvs = false, has_colours = false;
};

class SceneReader {
 public:
  SceneReader(const fs::path& file, TextureCache& textures) : file_(file), textures_(textures) {}

  MeshFile run() {
    Assimp::Importer importer;
    importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
    importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, true);  // submeshes are named so
    importer.SetPropertyFloat(AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, kCreaseDeg);
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    const aiScene* scene =
        importer.ReadFile(file_.string(), aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_GenSmoothNormals |
                                              aiProcess_JoinIdenticalVertices);
    if (scene == nullptr || scene->mRootNode == nullptr) {
      std::string why = importer.GetErrorString();
      std::replace(why.begin(), why.end(), '\n', ' ');
      throw InputError(file_.string() + ": not a mesh that can be read (" + why + "; allowed: .dae, .obj, .stl, .ply)");
    }
    add_node(*scene, *scene->mRootNode, aiMatrix4x4(), "");
    for (auto& [key, gathered] : gathered_) {
      mend_mesh(gathered.mesh);
      if (gathered.mesh.indices.empty()) continue;
      if (!gathered.has_uvs) gathered.mesh.uvs.clear();
      if (!gathered.has_colours) gathered.mesh.colours.clear();
      const Material material = material_of(*scene, key.second, gathered.has_colours);
      out_.parts.push_back({key.first, std::make_shared<const Mesh>(std::move(gathered.mesh)), material});
    }
    if (out_.parts.empty()) throw InputError(file_.string() + ": no triangle in it");
    return std::move(out_);
  }

 private:
  void add_node(const aiScene& scene, const aiNode& node, const aiMatrix4x4& T_file_parent, const std::string& parent) {
    const aiMatrix4x4 T_file_node = T_file_parent * node.mTransformation;
    const std::string name = node.mName.length > 0 ? node.mName.C_Str() : parent;
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
      const aiMesh& mesh = *scene.mMeshes[node.mMeshes[i]];
      if ((mesh.mPrimitiveTypes & aiPrimitiveType_TRIANGLE) == 0U) continue;
      add_mesh(mesh, T_file_node, gathered_[{name, mesh.mMaterialIndex}]);
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i) add_node(scene, *node.mChildren[i], T_file_node, name);
  }

  void add_mesh(const aiMesh& source, const aiMatrix4x4& T_file_node, Gathered& to) {
    Mesh& mesh = to.mesh;
    const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
    if (mesh.vertices.size() + source.mNumVertices > kMaxVertices) {
      throw InputError(file_.string() + ": more than " + std::to_string(kMaxVertices) + " vertices in it");
    }
    add_vertices(source, T_file_node, mesh);
    to.has_uvs = to.has_uvs || source.HasTextureCoords(0);
    to.has_colours = to.has_colours || source.HasVertexColors(0);
    const bool mirrors = aiMatrix3x3(T_file_node).Determinant() < 0.0F;
    for (unsigned i = 0; i < source.mNumFaces; ++i) {
      const aiFace& face = source.mFaces[i];
      if (face.mNumIndices != 3) continue;
      mesh.indices.push_back(base + face.mIndices[0]);
      mesh.indices.push_back(base + face.mIndices[mirrors ? 2 : 1]);
      mesh.indices.push_back(base + face.mIndices[mirrors ? 1 : 2]);
    }
  }

  static void add_vertices(const aiMesh& source, const aiMatrix4x4& T_file_node, Mesh& mesh) {
    aiMatrix3x3 T_normal(T_file_node);
    if (T_normal.Determinant() != 0.0F) T_normal.Inverse().Transpose();
    for (unsigned i = 0; i < source.mNumVertices; ++i) {
      const aiVector3D p = T_file_node * source.mVertices[i];
      const aiVector3D n = source.HasNormals() ? T_normal * source.mNormals[i] : aiVector3D(0.0F);
      const aiVector3D uv = source.HasTextureCoords(0) ? source.mTextureCoords[0][i] : aiVector3D(0.0F);
      mesh.vertices.emplace_back(p.x, p.y, p.z);
      mesh.normals.push_back(Eigen::Vector3f(n.x, n.y, n.z).stableNormalized());
      mesh.uvs.emplace_back(uv.x, uv.y);
      mesh.colours.push_back(source.HasVertexColors(0) ? rgb_of(source.mColors[0][i]) : Rgb{255, 255, 255});
    }
  }

  Material material_of(const aiScene& scene, unsigned index, bool has_colours) {
    Material material;
    if (index >= scene.mNumMaterials) return material;
    const aiMaterial& source = *scene.mMaterials[index];
    aiColor4D diffuse(0.7F, 0.7F, 0.7F, 1.0F);
    if (source.Get(AI_MATKEY_COLOR_DIFFUSE, diffuse) == AI_SUCCESS) {
      material.diffuse = Eigen::Vector3f(diffuse.r, diffuse.g, diffuse.b).cwiseMax(0.0F).cwiseMin(1.0F);
    }
    float opacity = 1.0F;
    // exporters disagree about the meaning of 0: nobody models what cannot be seen
    if (source.Get(AI_MATKEY_OPACITY, opacity) == AI_SUCCESS && opacity > 0.0F)
      material.alpha = std::min(opacity, 1.0F);
    aiString name;
    const bool named = source.GetTextureCount(aiTextureType_DIFFUSE) > 0
                           ? source.GetTexture(aiTextureType_DIFFUSE, 0, &name) == AI_SUCCESS
                           : source.GetTexture(aiTextureType_BASE_COLOR, 0, &name) == AI_SUCCESS;
    if (named && name.length > 0) material.texture = texture(scene, name.C_Str());
    if (material.texture != nullptr || has_colours) material.diffuse = Eigen::Vector3f::Ones();
    return material;
  }

  std::shared_ptr<const Texture> texture(const aiScene& scene, const std::string& name) {
    if (const aiTexture* embedded = scene.GetEmbeddedTexture(name.c_str())) return decoded(*embedded);
    const std::string plain = name.rfind("file://", 0) == 0 ? name.substr(7) : name;
    std::string slashes = plain;
    std::replace(slashes.begin(), slashes.end(), '\\', '/');
    const fs::path folder = file_.parent_path(), leaf = fs::path(slashes).filename();
    std::error_code error;
    for (const fs::path& candidate : {folder / slashes, folder / leaf, folder / ".." / "materials" / "textures" / leaf,
                                      folder / ".." / "textures" / leaf, folder / "textures" / leaf}) {
      if (!fs::is_regular_file(candidate, error)) continue;
      try {
        return textures_.get(candidate);
      } catch (const InputError& fault) {
        out_.warnings.push_back(std::string(fault.what()) + "; the texture is left out");
        return nullptr;
      }
    }
    out_.warnings.push_back(file_.string() + ": texture '" + name + "' is not found and left out");
    return nullptr;
  }

  std::shared_ptr<const Texture> decoded(const aiTexture& embedded) const {
    if (embedded.mHeight != 0) return nullptr;  // raw pixels, which no supported format embeds
    const char* bytes = reinterpret_cast<const char*>(embedded.pcData);
    return decode_texture(std::string(bytes, embedded.mWidth), textures_.max_texture_px());
  }

  const fs::path& file_;
  TextureCache& textures_;
  std::map<std::pair<std::string, unsigned>, Gathered> gathered_;  // by submesh and material
  MeshFile out_;
};

}  // namespace

MeshFile read_mesh_file(const fs::path& file, TextureCache& textures) { return SceneReader(file, textures).run(); }

}  // namespace amiss::world
