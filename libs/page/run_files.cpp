#include "page/run_files.hpp"

#include <fstream>
#include <nlohmann/json.hpp>

#include "core/files.hpp"
#include "core/result.hpp"
#include "page/recorder.hpp"

namespace amiss::page {

namespace fs = std::filesystem;

namespace {

bool is_event(const std::string& line) {
  const auto json = nlohmann::json::parse(line, nullptr, false);
  return json.is_object() && json.contains("e") && json["e"].is_string() && json.contains("t") && json["t"].is_number();
}

}  // namespace

std::vector<std::string> load_timeline(const fs::path& folder) {
  const fs::path file = folder / Recorder::kTimeline;
  if (!fs::is_regular_file(file)) {
    throw InputError(file.string() + ": is not there; the folder of a tidy-up run is needed");
  }
  const std::string bytes = load_bytes(file);
  std::vector<std::string> lines;
  for (std::size_t begin = 0, end = 0; (end = bytes.find('\n', begin)) != std::string::npos; begin = end + 1) {
    lines.push_back(bytes.substr(begin, end - begin));
    if (is_event(lines.back())) continue;
    throw InputError(file.string() + ":" + std::to_string(lines.size()) +
                     ": is no event; one JSON object with e and t a line is allowed");
  }
  const auto first = lines.empty() ? nlohmann::json() : nlohmann::json::parse(lines.front());
  if (!first.contains("schema") || first["schema"] != kSchema) {
    throw InputError(file.string() + ":1: the beginning of a run is needed, with schema " + std::to_string(kSchema));
  }
  return lines;
}

Story load_story(const fs::path& folder) {
  const std::vector<std::string> lines = load_timeline(folder);
  try {
    return read_story(lines);
  } catch (const InputError& e) {
    throw InputError((folder / e.what()).string());  // which begins with the file's name
  }
}

std::string load_picture(const fs::path& folder, Slice slice) {
  const fs::path file = folder / Recorder::kCamera;
  if (!fs::is_regular_file(file)) throw InputError(file.string() + ": is not there; the run's pictures are in it");
  std::ifstream stream(file, std::ios::binary);
  stream.seekg(0, std::ios::end);
  const auto size = static_cast<std::size_t>(std::max<std::streamoff>(0, stream.tellg()));
  if (!stream || slice.bytes > size || slice.begin > size - slice.bytes) {
    throw InputError(file.string() + ": is shorter than the timeline says");
  }
  std::string bytes(slice.bytes, '\0');
  stream.seekg(static_cast<std::streamoff>(slice.begin));
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return bytes;
}

std::vector<ServedFile> served_files(const fs::path& folder) {
  std::vector<ServedFile> files;
  const auto add = [&](const char* name, const char* type) {
    files.push_back({std::string("/") + name, type, folder / name});
  };
  add(Recorder::kCamera, "application/octet-stream");
  add(Recorder::kTimeline, "application/jsonl");
  add("params.yaml", "text/plain; charset=utf-8");
  add("report.json", "application/json");
  add("log.txt", "text/plain; charset=utf-8");
  return files;
}

}  // namespace amiss::page
