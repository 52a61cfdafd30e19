#include "dataset/room_folders.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <map>

#include "core/result.hpp"

namespace amiss::dataset {

namespace {

namespace fs = std::filesystem;

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// The files of a folder by their names in lower case; of names that differ in case only the first by name.
std::map<std::string, fs::path> entries_of(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> paths;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    paths.push_back(it->path());
  }
  if (error) throw InputError(folder.string() + ": cannot be read as a folder: " + error.message());
  std::sort(paths.begin(), paths.end());
  std::map<std::string, fs::path> entries;
  for (const fs::path& path : paths) entries.emplace(lower(path.filename().string()), path);
  return entries;
}

/// 7 of "scene7.pcd" for the ending ".pcd"; names are in lower case.
std::optional<int> scene_number(const std::string& name, const std::string& ending) {
  const std::string begin = "scene";
  if (!name.starts_with(begin) || !name.ends_with(ending) || name.size() <= begin.size() + ending.size()) return {};
  int number = 0;
  const char* last = name.data() + name.size() - ending.size();
  const auto [end, error] = std::from_chars(name.data() + begin.size(), last, number);
  if (error != std::errc() || end != last || number < 0) return {};
  return number;
}

std::optional<fs::path> file_among(const std::map<std::string, fs::path>& entries, const std::string& name) {
  const auto found = entries.find(name);
  if (found == entries.end() || !fs::is_regular_file(found->second)) return {};
  return found->second;
}

/// Annotations of a room: its own folder of them, the parallel tree of the data set, beside the clouds.
std::vector<std::map<std::string, fs::path>> annotation_places(const std::map<std::string, fs::path>& room_entries,
                                                               const std::map<std::string, fs::path>& all_annotations,
                                                               const std::string& room) {
  std::vector<std::map<std::string, fs::path>> places;
  const auto add = [&](const std::map<std::string, fs::path>& entries, const std::string& name) {
    const auto found = entries.find(lower(name));
    if (found != entries.end() && fs::is_directory(found->second)) places.push_back(entries_of(found->second));
  };
  add(room_entries, "annotations");
  add(all_annotations, room);
  places.push_back(room_entries);
  return places;
}

RoomFolder room_in(const fs::path& folder, const std::map<std::string, fs::path>& all_annotations) {
  RoomFolder room{folder.filename().string(), {}};
  const auto entries = entries_of(folder);
  std::map<int, fs::path> clouds;
  for (const char* ending : {".ply", ".pcd"}) {
    for (const auto& [name, path] : entries) {
      const auto number = scene_number(name, ending);
      if (number && fs::is_regular_file(path)) clouds[*number] = path;
    }
  }
  if (clouds.empty()) return room;
  const auto places = annotation_places(entries, all_annotations, room.name);
  for (const auto& [number, cloud] : clouds) {
    SceneFiles scene{number, cloud, {}, {}};
    for (const auto& place : places) {
      for (const char* ending : {"_gt.anno", ".anno"}) {
        if (!scene.annotations) scene.annotations = file_among(place, scene.name() + ending);
      }
    }
    for (const char* ending : {"_space.bt", "_space.ot"}) {
      if (!scene.space) scene.space = file_among(entries, scene.name() + ending);
    }
    room.scenes.push_back(std::move(scene));
  }
  return room;
}

/// "rooms/" and "." too have a name.
fs::path named(const fs::path& folder) { return fs::absolute(folder / "").lexically_normal().parent_path(); }

}  // namespace

const SceneFiles* RoomFolder::scene(int number) const {
  const auto found =
      std::find_if(scenes.begin(), scenes.end(), [=](const SceneFiles& s) { return s.number == number; });
  return found == scenes.end() ? nullptr : &*found;
}

bool is_room_folder(const fs::path& folder) {
  return fs::is_directory(folder) && !room_in(named(folder), {}).scenes.empty();
}

std::vector<RoomFolder> room_folders(const fs::path& folder) {
  const fs::path top = named(folder);
  const auto entries = entries_of(top);
  if (RoomFolder single = room_in(top, {}); !single.scenes.empty()) return {single};
  std::map<std::string, fs::path> all_annotations;
  if (const auto found = entries.find("annotations"); found != entries.end() && fs::is_directory(found->second)) {
    all_annotations = entries_of(found->second);
  }
  std::vector<RoomFolder> rooms;
  for (const auto& [name, path] : entries) {
    if (!fs::is_directory(path) || name == "annotations" || name.starts_with('.')) continue;
    RoomFolder room = room_in(path, all_annotations);
    if (!room.scenes.empty()) rooms.push_back(std::move(room));
  }
  if (rooms.empty()) {
    throw InputError(folder.string() + ": holds no room; scene1.pcd (or .ply), scene2.pcd, ... are looked for in it " +
                     "and in its folders");
  }
  return rooms;
}

}  // namespace amiss::dataset
