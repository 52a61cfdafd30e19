#include "dataset/cloud_files.hpp"

#include "core/files.hpp"
#include "core/result.hpp"

namespace amiss::dataset {
namespace {

constexpr std::size_t kMaxFileBytes = std::size_t{1} << 31U;

void check_sizes(const CloudFile& file) {
  const std::size_t n = file.cloud().points.size();
  const auto fits = [n](std::size_t size) { return size == 0 || size == n; };
  bool all = fits(file.cloud().colours.size()) && fits(file.cloud().normals.size());
  for (const ScalarField& field : file.fields) all = all && field.values.size() == n;
  if (!all) throw ArgumentError("a cloud's colours, normals and fields must be as many as its points");
}

}  // namespace

const ScalarField* CloudFile::field(std::string_view name) const {
  for (const ScalarField& f : fields) {
    if (f.name == name) return &f;
  }
  return nullptr;
}

CloudFile load_cloud(const std::filesystem::path& file) {
  const std::string bytes = load_bytes(file, kMaxFileBytes);
  if (bytes.empty()) throw InputError(file.string() + ": is empty; a PLY or PCD file is needed");
  // What begins as neither is told of as what its name says.
  const bool begins_as_pcd = bytes[0] == '#' || bytes.starts_with("VERSION") || bytes.starts_with("FIELDS");
  const bool is_ply = bytes.starts_with("ply") || (file.extension() == ".ply" && !begins_as_pcd);
  return is_ply ? parse_ply(bytes, file.string()) : parse_pcd(bytes, file.string());
}

void save_cloud(const std::filesystem::path& file, const CloudFile& cloud, CloudFormat format) {
  check_sizes(cloud);
  const std::string extension = file.extension().string();
  if (extension == ".ply") {
    save_atomically(file, ply_bytes(cloud, format));
  } else if (extension == ".pcd") {
    save_atomically(file, pcd_bytes(cloud, format));
  } else {
    throw ArgumentError(file.string() + ": the extension of a cloud must be .ply or .pcd");
  }
}

}  // namespace amiss::dataset
