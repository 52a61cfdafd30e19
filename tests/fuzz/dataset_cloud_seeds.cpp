#include "dataset/cloud_files.hpp"
#include "fuzz/seeds.hpp"

namespace amiss::fuzz {

std::vector<std::string> valid_inputs() {
  dataset::CloudFile file;
  file.fields = {{"label", {}}, {"score", {}}};
  for (int i = 0; i < 12; ++i) {
    file.mesh.vertices.points.emplace_back(static_cast<float>(i), 0.5F, -1.0F);
    file.mesh.vertices.normals.emplace_back(0.0F, 0.0F, 1.0F);
    file.mesh.vertices.colours.push_back({static_cast<std::uint8_t>(i), 2, 3});
    file.fields[0].values.push_back(i);
    file.fields[1].values.push_back(0.1 * i);
  }
  std::vector<std::string> inputs{dataset::pcd_bytes(file, dataset::CloudFormat::kAscii), dataset::pcd_bytes(file),
                                  "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nPOINTS 2\nDATA binary_compressed\n" +
                                      std::string("\x06\0\0\0\x18\0\0\0\1\0\0\xe0\x0c\1", 14)};
  file.mesh.triangles = {{0, 1, 2}, {3, 4, 11}};
  inputs.push_back(dataset::ply_bytes(file, dataset::CloudFormat::kAscii));
  inputs.push_back(dataset::ply_bytes(file));
  return inputs;
}

std::vector<std::string> words() {
  return {"COUNT 1 4096 1\n",
          "POINTS 4294967295\n",
          "HEIGHT 65536\n",
          "DATA binary_compressed\n",
          "SIZE 8 8 8\n",
          "element face 9\n",
          "property list uint double vertex_indices\n",
          "binary_big_endian",
          "property uchar x\n",
          "element vertex 18446744073709551615\n"};
}

}  // namespace amiss::fuzz
