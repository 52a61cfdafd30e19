#include "mapping/floor_grid_files.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <locale>
#include <sstream>

#include "core/files.hpp"
#include "core/result.hpp"
#include "mapping/internal/text.hpp"

namespace amiss::mapping {
namespace {

constexpr int kMaxEdge = 32768;  // cells
constexpr std::size_t kMaxCells = std::size_t{1} << 26;
constexpr std::size_t kMaxYamlBytes = std::size_t{1} << 16;
constexpr int kOccupiedPixel = 0, kUnknownPixel = 205, kFreePixel = 254;  // as map_server saves them

double number_of(const YAML::Node& node, const std::string& what) {
  const auto value = node.IsScalar() ? parse_number<double>(node.Scalar()) : std::nullopt;
  if (!value || !std::isfinite(*value)) throw InputError(what + " must be a finite number");
  return *value;
}

YAML::Node required(const YAML::Node& map, const char* key, const std::string& name) {
  if (!map[key]) throw InputError(name + ": key " + key + " is missing; image, resolution and origin are needed");
  return map[key];
}

double optional_number(const YAML::Node& map, const char* key, double fallback, const std::string& name) {
  return map[key] ? number_of(map[key], name + ": " + key) : fallback;
}

void read_origin(const YAML::Node& origin, FloorGridHeader& header, const std::string& name) {
  if (!origin.IsSequence() || origin.size() != 3) throw InputError(name + ": origin must be a list [x, y, yaw]");
  header.origin_m = {number_of(origin[0], name + ": origin[0]"), number_of(origin[1], name + ": origin[1]")};
  if (header.origin_m.cwiseAbs().maxCoeff() > 1e6) throw InputError(name + ": origin must lie within +-1e6 m");
  if (std::abs(number_of(origin[2], name + ": origin[2]")) > 1e-9) {
    throw InputError(name + ": the origin's yaw must be 0; turned maps are not supported");
  }
}

FloorGridHeader header_of(const YAML::Node& map, const std::string& name) {
  if (!map.IsMap()) throw InputError(name + ": a YAML map with image, resolution and origin is needed");
  FloorGridHeader header;
  const YAML::Node image = required(map, "image", name);
  if (!image.IsScalar() || image.Scalar().empty()) throw InputError(name + ": image must name a PGM file");
  header.image = image.Scalar();
  header.resolution_m = number_of(required(map, "resolution", name), name + ": resolution");
  if (header.resolution_m < 0.001 || header.resolution_m > 10.0) {
    throw InputError(name + ": resolution must be 0.001 to 10 m");
  }
  read_origin(required(map, "origin", name), header, name);
  header.negate = optional_number(map, "negate", 0.0, name) != 0.0;
  header.occupied_threshold = optional_number(map, "occupied_thresh", header.occupied_threshold, name);
  header.free_threshold = optional_number(map, "free_thresh", header.free_threshold, name);
  if (!(header.free_threshold >= 0.0 && header.free_threshold <= header.occupied_threshold &&
        header.occupied_threshold <= 1.0)) {
    throw InputError(name + ": free_thresh and occupied_thresh must satisfy 0 <= free <= occupied <= 1");
  }
  if (map["mode"] && !(map["mode"].IsScalar() && map["mode"].Scalar() == "trinary")) {
    throw InputError(name + ": mode must be trinary");
  }
  return header;
}

/// The words of a PGM file; a # starts a comment that ends with the line.
class PgmReader {
 public:
  PgmReader(std::string_view bytes, std::string name) : bytes_(bytes), name_(std::move(name)) {}

  int number(const char* what, int low, int high) {
    std::string_view word = next_word(bytes_, at_);
    while (!word.empty() && word.front() == '#') {
      at_ = std::min(bytes_.find('\n', at_ - word.size()), bytes_.size());
      word = next_word(bytes_, at_);
    }
    const auto value = parse_number<int>(word);
    if (!value || *value < low || *value > high) {
      throw InputError(name_ + ": " + what + " must be " + std::to_string(low) + " to " + std::to_string(high));
    }
    return *value;
  }
  [[nodiscard]] std::string_view binary() const { return bytes_.substr(std::min(at_ + 1, bytes_.size())); }
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  std::string_view bytes_;
  std::string name_;
  std::size_t at_ = 2;  // behind P2 or P5
};

struct Image {
  int width = 0, height = 0, max = 0;
  std::vector<int> pixels;
};

Image read_pgm(std::string_view pgm, const std::string& name) {
  const bool text = pgm.substr(0, 2) == "P2";
  if (!text && pgm.substr(0, 2) != "P5") throw InputError(name + ": not a PGM image; allowed are P2 and P5");
  PgmReader reader(pgm, name);
  Image image;
  image.width = reader.number("the width", 1, kMaxEdge);
  image.height = reader.number("the height", 1, kMaxEdge);
  image.max = reader.number("the largest grey value", 1, 255);
  const std::size_t n = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  if (n > kMaxCells) throw InputError(name + ": more than " + std::to_string(kMaxCells) + " pixels");
  const std::string_view data = reader.binary();
  if (data.size() < (text ? 2 * n - 1 : n)) throw InputError(name + ": cut short, fewer pixels than width x height");
  image.pixels.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    image.pixels[i] = text ? reader.number("a pixel", 0, image.max) : int{static_cast<unsigned char>(data[i])};
    if (image.pixels[i] > image.max) throw InputError(name + ": a pixel is larger than the largest grey value");
  }
  return image;
}

Occupancy occupancy_of(int pixel, int max, const FloorGridHeader& header) {
  const double dark = static_cast<double>(header.negate ? pixel : max - pixel) / max;
  if (dark > header.occupied_threshold) return Occupancy::kOccupied;
  return dark < header.free_threshold ? Occupancy::kFree : Occupancy::kUnknown;
}

int pixel_of(Occupancy value) {
  if (value == Occupancy::kUnknown) return kUnknownPixel;
  return value == Occupancy::kFree ? kFreePixel : kOccupiedPixel;
}

std::string pgm_bytes(const FloorGrid& grid) {
  std::string pgm = "P5\n" + std::to_string(grid.width()) + " " + std::to_string(grid.height()) + "\n255\n";
  for (int y = grid.height() - 1; y >= 0; --y) {
    for (int x = 0; x < grid.width(); ++x) pgm.push_back(static_cast<char>(pixel_of(grid.at(Cell{x, y}))));
  }
  return pgm;
}

}  // namespace

FloorGridHeader parse_floor_grid_header(std::string_view yaml, const std::string& name) {
  try {
    return header_of(YAML::Load(std::string(yaml)), name);
  } catch (const YAML::Exception& e) {
    throw InputError(name + ":" + std::to_string(e.mark.line + 1) + ": not YAML: " + e.msg);
  }
}

FloorGrid parse_floor_grid(const FloorGridHeader& header, std::string_view pgm, const std::string& name) {
  const Image image = read_pgm(pgm, name);
  FloorGrid grid(header.resolution_m, header.origin_m, image.width, image.height);
  std::size_t i = 0;
  for (int y = image.height - 1; y >= 0; --y) {
    for (int x = 0; x < image.width; ++x) grid.set({x, y}, occupancy_of(image.pixels[i++], image.max, header));
  }
  return grid;
}

FloorGrid load_floor_grid(const std::filesystem::path& yaml_file) {
  const FloorGridHeader header = parse_floor_grid_header(load_bytes(yaml_file, kMaxYamlBytes), yaml_file.string());
  const std::filesystem::path image = yaml_file.parent_path() / header.image;
  return parse_floor_grid(header, load_bytes(image, 8 * kMaxCells), image.string());
}

void save_floor_grid(const std::filesystem::path& yaml_file, const FloorGrid& grid) {
  const std::filesystem::path image = std::filesystem::path(yaml_file).replace_extension(".pgm");
  std::ostringstream yaml;
  yaml.imbue(std::locale::classic());
  yaml << std::setprecision(17) << "image: " << image.filename().string() << "\nresolution: " << grid.resolution_m()
       << "\norigin: [" << grid.origin_m().x() << ", " << grid.origin_m().y()
       << ", 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
  save_atomically(image, pgm_bytes(grid));
  save_atomically(yaml_file, yaml.str());
}

}  // namespace amiss::mapping
