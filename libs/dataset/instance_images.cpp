#include "dataset/instance_images.hpp"

#include <algorithm>
#include <cmath>

#include "core/files.hpp"
#include "core/result.hpp"
#include "dataset/internal/images.hpp"
#include "dataset/internal/records.hpp"
#include "dataset/internal/text.hpp"

namespace amiss::dataset {
namespace {

constexpr std::string_view kHeader = "number\tname\tkind\tclass\ton_floor";
constexpr double kMostNumber = 65535.0;

std::vector<std::string_view> fields_of(std::string_view line) {
  std::vector<std::string_view> fields;
  while (true) {
    const std::size_t tab = line.find('\t');
    fields.push_back(line.substr(0, tab));
    if (tab == std::string_view::npos) return fields;
    line.remove_prefix(tab + 1);
  }
}

Instance instance_of(std::string_view line, const std::string& name, int number) {
  const auto fields = fields_of(line);
  if (fields.size() != 5) refuse_line(name, number, "a line must have five fields: " + std::string(kHeader));
  const double value = finite_number(fields[0], name, number);
  if (value < 1.0 || value > kMostNumber || value != std::floor(value)) {
    refuse_line(name, number, "the number of a body must be a whole one from 1 to 65535");
  }
  const auto named = semantic_class_of(fields[3]);
  if (!named) refuse_line(name, number, "'" + shown(fields[3]) + "' is no semantic class");
  if (fields[4] != "yes" && fields[4] != "no") refuse_line(name, number, "on_floor must be yes or no");
  return {static_cast<std::uint16_t>(value), std::string(fields[1]), std::string(fields[2]), *named,
          fields[4] == "yes"};
}

}  // namespace

void save_instances(const std::filesystem::path& file, const std::vector<Instance>& instances) {
  std::string text = std::string(kHeader) + "\n";
  for (const Instance& one : instances) {
    text += std::to_string(one.number) + "\t" + one.name + "\t" + one.kind + "\t" + std::string(to_string(one.value)) +
            "\t" + (one.on_floor ? "yes" : "no") + "\n";
  }
  save_atomically(file, text);
}

std::vector<Instance> load_instances(const std::filesystem::path& file) {
  const std::string bytes = load_bytes(file), name = file.string();
  std::vector<Instance> instances;
  LineReader lines(bytes);
  while (const auto line = lines.next()) {
    if (line->empty() || *line == kHeader) continue;
    instances.push_back(instance_of(*line, name, lines.line()));
  }
  return instances;
}

InstanceWriter::InstanceWriter(std::filesystem::path folder) : folder_(std::move(folder)) {
  std::filesystem::create_directories(folder_ / "instances");
}

void InstanceWriter::add(Stamp stamp, int width, int height, const std::vector<std::uint16_t>& numbers) {
  const std::string time = text_of(stamp);
  const std::vector<float> as_depth(numbers.begin(), numbers.end());  // the same kind of file
  save_atomically(folder_ / "instances" / (time + ".png"), depth_png_bytes(as_depth, width, height, 1.0));
  list_.append(time).append(" instances/").append(time).append(".png\n");
}

void InstanceWriter::finish() const {
  save_atomically(folder_ / "instances.txt", "# timestamp filename\n" + list_);
}

InstanceImages::InstanceImages(const std::filesystem::path& folder) {
  const std::filesystem::path list = folder / "instances.txt";
  const std::string bytes = load_bytes(list);
  LineReader lines(bytes);
  while (const auto line = lines.next()) {
    const auto words = words_of(*line);
    if (words.empty() || words[0].starts_with('#')) continue;
    if (words.size() != 2) refuse_line(list.string(), lines.line(), "a line must be 'time file'");
    files_[stamp_of(words[0], list.string(), lines.line())] = folder / words[1];
  }
}

std::optional<std::vector<std::uint16_t>> InstanceImages::load(Stamp stamp) const {
  const auto found = files_.find(stamp);
  if (found == files_.end()) return std::nullopt;
  const DepthImage image = load_depth(found->second, 1.0);
  std::vector<std::uint16_t> numbers(image.depth_m.size());
  std::transform(image.depth_m.begin(), image.depth_m.end(), numbers.begin(), [](float value) {
    return std::isfinite(value) ? static_cast<std::uint16_t>(std::lround(value)) : std::uint16_t{0};
  });
  return numbers;
}

}  // namespace amiss::dataset
