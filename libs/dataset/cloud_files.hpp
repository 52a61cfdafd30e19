// Point clouds and meshes as others write them: PLY (ascii, binary of both byte orders) and PCD (ascii, binary,
// binary_compressed), read with distrust and written whole or not at all. Readers of our own: PCL's crash on broken
// files.
//
// in: file     out: points [m], colours, normals and every other scalar by its name (label, instance, curvature, ...),
// in the order of the file: point i of the file is point i here, also where it is not finite. Colours are `rgb` or
// `rgba` (packed, as float or integer) or red, green, blue; normals are normal_x .. or nx ..; fields of several values,
// padding and lists of vertices are skipped; polygons become triangles. Comments of the header are kept as notes.
// Errors: InputError that names the file, the line of the header where there is one, and what is allowed.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/triangle_mesh.hpp"

namespace amiss::dataset {

/// One number for each point.
struct ScalarField {
  std::string name;
  std::vector<double> values;
};

struct CloudFile {
  TriangleMesh<Map> mesh;  // without triangles it is a cloud
  std::vector<ScalarField> fields;
  std::vector<std::string> notes = {};  // lines of text: `comment` of PLY, '#' of PCD

  [[nodiscard]] const Cloud<Map>& cloud() const { return mesh.vertices; }
  [[nodiscard]] const ScalarField* field(std::string_view name) const;  // nullptr where there is none
};

/// PLY or PCD: the first bytes of the file say which.
[[nodiscard]] CloudFile load_cloud(const std::filesystem::path& file);
[[nodiscard]] CloudFile parse_ply(std::string_view bytes, const std::string& name);
[[nodiscard]] CloudFile parse_pcd(std::string_view bytes, const std::string& name);

enum class CloudFormat { kAscii, kBinary };
/// Colours, normals, fields and triangles are written where they are there. PCD has no triangles.
[[nodiscard]] std::string ply_bytes(const CloudFile& cloud, CloudFormat format = CloudFormat::kBinary);
[[nodiscard]] std::string pcd_bytes(const CloudFile& cloud, CloudFormat format = CloudFormat::kBinary);
/// .ply or .pcd by the extension; ArgumentError for another one, std::runtime_error when writing fails.
void save_cloud(const std::filesystem::path& file, const CloudFile& cloud, CloudFormat format = CloudFormat::kBinary);

}  // namespace amiss::dataset
