#include "robot/internal/urdf_text.hpp"

#include "core/files.hpp"
#include "core/result.hpp"

namespace amiss::robot {
namespace {

constexpr std::size_t kMaxUrdfBytes = std::size_t{32} << 20;
constexpr int kMaxDepth = 100;

bool nests_too_deep(const std::string& text) {
  int depth = 0;
  for (std::size_t i = text.find('<'); i != std::string::npos; i = text.find('<', i + 1)) {
    const std::size_t end = text.find('>', i);
    if (end == std::string::npos || i + 1 >= text.size()) return false;
    const char next = text[i + 1];
    if (next == '/') --depth;
    const bool opens = next != '/' && next != '!' && next != '?' && text[end - 1] != '/';
    if (opens && ++depth > kMaxDepth) return true;
  }
  return false;
}

}  // namespace

std::string load_urdf_text(const std::filesystem::path& urdf) {
  std::string text = load_bytes(urdf, kMaxUrdfBytes);
  const std::string file = urdf.string();
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) throw InputError(file + ": the file is empty");
  if (text.find('\0') != std::string::npos) throw InputError(file + ": not a URDF file, it holds zero bytes");
  if (urdf.extension() == ".xacro" || text.find("<xacro:") != std::string::npos) {
    throw InputError(file + ": this is a xacro file; expand it with `xacro` first, only plain URDF is allowed");
  }
  if (text.find("<robot") == std::string::npos)
    throw InputError(file + ": no <robot> element in it; allowed are URDF files");
  if (nests_too_deep(text)) {
    throw InputError(file + ": elements nest deeper than " + std::to_string(kMaxDepth) + " levels");
  }
  return text;
}

}  // namespace amiss::robot
