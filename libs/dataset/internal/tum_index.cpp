#include <algorithm>

#include "core/files.hpp"
#include "core/result.hpp"
#include "dataset/internal/folder_index.hpp"
#include "dataset/internal/records.hpp"
#include "dataset/internal/text.hpp"

namespace amiss::dataset {
namespace {

constexpr double kMaxColourDepthS = 0.02;

struct StampedFile {
  Stamp stamp;
  std::filesystem::path file;
};

/// The lines "t file" (or, with two = true, "t file t file") of a list.
std::vector<StampedFile> load_list(const std::filesystem::path& folder, const char* list, bool two) {
  const std::string name = (folder / list).string();
  const std::string bytes = load_bytes(folder / list);
  std::vector<StampedFile> files;
  LineReader lines(bytes);
  while (const auto line = lines.next()) {
    const auto words = words_of(*line);
    if (words.empty() || words[0].starts_with('#')) continue;
    if (words.size() != (two ? 4U : 2U)) {
      refuse_line(name, lines.line(), two ? "a line must be 'time file time file'" : "a line must be 'time file'");
    }
    for (std::size_t i = 0; i + 1 < words.size(); i += 2) {
      files.push_back({stamp_of(words[i], name, lines.line()), folder / words[i + 1]});
    }
  }
  return files;
}

struct Pair {
  StampedFile colour, depth;
};

std::vector<Pair> paired(std::vector<StampedFile> colour, std::vector<StampedFile> depth) {
  const auto sorted_stamps = [](std::vector<StampedFile>& files) {
    std::sort(files.begin(), files.end(), [](const StampedFile& a, const StampedFile& b) { return a.stamp < b.stamp; });
    std::vector<Stamp> stamps;
    for (const StampedFile& file : files) stamps.push_back(file.stamp);
    return stamps;
  };
  const std::vector<Stamp> colour_at = sorted_stamps(colour), depth_at = sorted_stamps(depth);
  std::vector<Pair> pairs;
  for (const auto& [c, d] : associated(colour_at, depth_at)) pairs.push_back({colour[c], depth[d]});
  return pairs;
}

std::vector<Pair> load_pairs(const std::filesystem::path& folder, std::size_t& colour_images) {
  if (!std::filesystem::exists(folder / "associations.txt")) {
    std::vector<StampedFile> colour = load_list(folder, "rgb.txt", false);
    colour_images = colour.size();
    return paired(std::move(colour), load_list(folder, "depth.txt", false));
  }
  // The lists that they were made of are read too where they are there: a broken one is no folder to be trusted.
  for (const char* list : {"rgb.txt", "depth.txt"}) {
    if (std::filesystem::exists(folder / list)) (void)load_list(folder, list, false);
  }
  const std::vector<StampedFile> files = load_list(folder, "associations.txt", true);
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i + 1 < files.size(); i += 2) pairs.push_back({files[i], files[i + 1]});
  colour_images = pairs.size();
  return pairs;
}

}  // namespace

std::vector<std::pair<std::size_t, std::size_t>> associated(const std::vector<Stamp>& colour,
                                                            const std::vector<Stamp>& depth) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  std::size_t next = 0;
  const auto apart = [](Stamp a, Stamp b) { return std::abs(seconds(a - b)); };
  for (std::size_t c = 0; c < colour.size(); ++c) {
    while (next + 1 < depth.size() && apart(depth[next + 1], colour[c]) <= apart(depth[next], colour[c])) ++next;
    if (next >= depth.size() || apart(depth[next], colour[c]) > kMaxColourDepthS) continue;
    pairs.emplace_back(c, next);
    ++next;
  }
  return pairs;
}

bool is_tum_folder(const std::filesystem::path& folder) {
  const auto has = [&folder](const char* file) { return std::filesystem::exists(folder / file); };
  return has("groundtruth.txt") || has("associations.txt") || (has("rgb.txt") && has("depth.txt"));
}

FolderIndex index_tum(const std::filesystem::path& folder, const std::filesystem::path& poses_file) {
  // What a robot believed comes before what was true: that is for those who score.
  const bool estimated = std::filesystem::exists(folder / "estimated.txt");
  const std::filesystem::path own = folder / (estimated ? "estimated.txt" : "groundtruth.txt");
  const std::filesystem::path& file = poses_file.empty() ? own : poses_file;
  const std::vector<StampedPose> poses = parse_tum_trajectory(load_bytes(file), file.string());
  std::size_t colour_images = 0;
  FolderIndex index;
  for (Pair& pair : load_pairs(folder, colour_images)) {
    const auto pose = pose_at(poses, pair.depth.stamp);
    if (pose)
      index.frames.push_back({pair.depth.stamp, std::move(pair.colour.file), std::move(pair.depth.file), *pose});
  }
  index.dropped = colour_images - index.frames.size();
  return index;
}

}  // namespace amiss::dataset
