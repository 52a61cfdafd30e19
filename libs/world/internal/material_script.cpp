#include "world/internal/material_script.hpp"

#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>

#include "core/files.hpp"
#include "core/result.hpp"

namespace amiss::world {
namespace {

namespace fs = std::filesystem;

struct NamedColour {
  std::string_view name;
  float r, g, b;
};

constexpr std::array kGazeboColours = {NamedColour{"White", 1.0F, 1.0F, 1.0F},
                                       NamedColour{"Grey", 0.7F, 0.7F, 0.7F},
                                       NamedColour{"Gray", 0.7F, 0.7F, 0.7F},
                                       NamedColour{"DarkGrey", 0.175F, 0.175F, 0.175F},
                                       NamedColour{"DarkGray", 0.175F, 0.175F, 0.175F},
                                       NamedColour{"LightGrey", 0.85F, 0.85F, 0.85F},
                                       NamedColour{"Black", 0.05F, 0.05F, 0.05F},
                                       NamedColour{"FlatBlack", 0.1F, 0.1F, 0.1F},
                                       NamedColour{"Red", 1.0F, 0.0F, 0.0F},
                                       NamedColour{"RedBright", 0.87F, 0.26F, 0.07F},
                                       NamedColour{"Green", 0.0F, 1.0F, 0.0F},
                                       NamedColour{"DarkGreen", 0.0F, 0.4F, 0.0F},
                                       NamedColour{"Blue", 0.0F, 0.0F, 1.0F},
                                       NamedColour{"SkyBlue", 0.13F, 0.44F, 0.70F},
                                       NamedColour{"Yellow", 1.0F, 1.0F, 0.0F},
                                       NamedColour{"DarkYellow", 0.7F, 0.7F, 0.0F},
                                       NamedColour{"ZincYellow", 0.97F, 0.95F, 0.21F},
                                       NamedColour{"Orange", 1.0F, 0.51F, 0.07F},
                                       NamedColour{"DarkOrange", 0.8F, 0.36F, 0.02F},
                                       NamedColour{"Gold", 0.80F, 0.65F, 0.25F},
                                       NamedColour{"Purple", 1.0F, 0.0F, 1.0F},
                                       NamedColour{"Indigo", 0.33F, 0.0F, 0.5F},
                                       NamedColour{"Turquoise", 0.0F, 1.0F, 1.0F},
                                       NamedColour{"Wood", 0.62F, 0.45F, 0.29F},
                                       NamedColour{"WoodFloor", 0.65F, 0.48F, 0.31F},
                                       NamedColour{"WoodPallet", 0.65F, 0.50F, 0.33F},
                                       NamedColour{"Bricks", 0.55F, 0.30F, 0.24F},
                                       NamedColour{"Road", 0.35F, 0.35F, 0.36F},
                                       NamedColour{"Residential", 0.55F, 0.56F, 0.53F},
                                       NamedColour{"Grass", 0.30F, 0.45F, 0.20F},
                                       NamedColour{"CeilingTiled", 0.85F, 0.85F, 0.82F},
                                       NamedColour{"PaintedWall", 0.85F, 0.83F, 0.78F},
                                       NamedColour{"Carpet", 0.50F, 0.42F, 0.38F}};

/// Words of the script; braces are words, comments are gone, line ends are kept because values end there.
std::vector<std::vector<std::string>> lines_of(const std::string& script) {
  std::vector<std::vector<std::string>> lines;
  std::istringstream in(script);
  for (std::string line; std::getline(in, line);) {
    line = line.substr(0, line.find("//"));
    std::string spaced;
    for (const char c : line) spaced += c == '{' || c == '}' ? std::string{' ', c, ' '} : std::string(1, c);
    std::istringstream words(spaced);
    std::vector<std::string> row;
    for (std::string word; words >> word;) {
      const bool brace = word == "{" || word == "}";
      if (brace && !row.empty()) lines.push_back(std::exchange(row, {}));
      row.push_back(word);
      if (brace) lines.push_back(std::exchange(row, {}));
    }
    if (!row.empty()) lines.push_back(std::move(row));
  }
  return lines;
}

std::optional<Eigen::Vector4f> colour_in(const std::vector<std::string>& row) {
  Eigen::Vector4f colour(0.0F, 0.0F, 0.0F, 1.0F);
  if (row.size() < 4) return std::nullopt;
  for (std::size_t i = 1; i < std::min<std::size_t>(row.size(), 5); ++i) {
    std::istringstream number(row[i]);
    if (!(number >> colour(static_cast<Eigen::Index>(i) - 1))) return std::nullopt;
  }
  return colour.cwiseMax(0.0F).cwiseMin(1.0F);
}

fs::path find_texture(const std::string& name, const fs::path& script, const std::vector<fs::path>& places) {
  const fs::path folder = script.parent_path();
  std::vector<fs::path> folders = {folder, folder.parent_path() / "textures", folder / "textures"};
  folders.insert(folders.end(), places.begin(), places.end());
  std::error_code error;
  for (const fs::path& candidate : folders) {
    if (fs::is_regular_file(candidate / name, error)) return candidate / name;
  }
  return {};
}

struct Found {
  ScriptMaterial result;
  std::optional<Eigen::Vector4f> ambient, diffuse, specular;
};

void take_row(const std::vector<std::string>& row, const fs::path& script, const std::vector<fs::path>& places,
              Found& found) {
  if (row[0] == "ambient") found.ambient = colour_in(row);
  if (row[0] == "diffuse") found.diffuse = colour_in(row);
  if (row[0] == "specular") found.specular = colour_in(row);
  if (row[0] == "texture" && row.size() > 1 && found.result.texture.empty()) {
    found.result.texture = find_texture(row[1], script, places);
  }
}

ScriptMaterial finished(Found found) {
  Material& material = found.result.material;
  if (found.ambient) material.diffuse = found.ambient->head<3>();
  // OGRE adds ambient and diffuse light; the brighter of the two is the colour that one sees
  if (found.diffuse) {
    material.diffuse = found.ambient ? Eigen::Vector3f(material.diffuse.cwiseMax(found.diffuse->head<3>()))
                                     : Eigen::Vector3f(found.diffuse->head<3>());
    material.alpha = (*found.diffuse)(3);
  }
  if (found.specular) material.specular = found.specular->head<3>().maxCoeff();
  if (!found.result.texture.empty()) material.diffuse = Eigen::Vector3f::Ones();
  return found.result;
}

std::optional<ScriptMaterial> find_in_script(const std::string& name, const fs::path& script,
                                             const std::vector<fs::path>& places) {
  constexpr std::size_t kMaxScriptBytes = 1 << 20;
  const std::vector<std::vector<std::string>> lines = lines_of(load_bytes(script, kMaxScriptBytes));
  int depth = 0;
  bool inside = false;
  Found found;
  for (const std::vector<std::string>& row : lines) {
    if (row[0] == "}" && --depth == 0 && inside) return finished(std::move(found));
    if (row[0] == "{") ++depth;
    if (depth == 0 && row[0] == "material") inside = row.size() > 1 && row[1] == name;
    if (inside && depth > 0) take_row(row, script, places, found);
  }
  return std::nullopt;
}

std::vector<fs::path> scripts_in(const fs::path& place) {
  std::error_code error;
  if (!fs::is_directory(place, error)) return {place};
  std::vector<fs::path> scripts;
  for (const fs::directory_entry& entry : fs::directory_iterator(place, error)) {
    if (entry.path().extension() == ".material") scripts.push_back(entry.path());
  }
  std::sort(scripts.begin(), scripts.end());
  return scripts;
}

}  // namespace

std::optional<Eigen::Vector3f> gazebo_colour(const std::string& name) {
  constexpr std::string_view kPrefix = "Gazebo/";
  if (name.rfind(kPrefix, 0) != 0) return std::nullopt;
  const std::string_view colour = std::string_view(name).substr(kPrefix.size());
  const auto* const found = std::find_if(kGazeboColours.begin(), kGazeboColours.end(),
                                         [&](const NamedColour& known) { return known.name == colour; });
  if (found == kGazeboColours.end()) return std::nullopt;
  return Eigen::Vector3f(found->r, found->g, found->b);
}

std::optional<ScriptMaterial> find_script_material(const std::string& name, const std::vector<fs::path>& places) {
  for (const fs::path& place : places) {
    for (const fs::path& script : scripts_in(place)) {
      if (script.extension() != ".material") continue;
      try {
        if (const std::optional<ScriptMaterial> found = find_in_script(name, script, places)) return found;
      } catch (const InputError&) {
        continue;  // an unreadable script is as good as none; the caller says that the material is missing
      }
    }
  }
  return std::nullopt;
}

}  // namespace amiss::world
