#include "core/files.hpp"
#include "fuzz/seeds.hpp"

namespace amiss::fuzz {

std::vector<std::string> valid_inputs() { return {load_bytes(AMISS_SOURCE_DIR "/robot_model/hsr.urdf")}; }

std::vector<std::string> words() {
  return {"<link name=\"x\"/>",
          "<joint",
          "type=\"prismatic\"",
          "</robot>",
          "<!--",
          "&lt;",
          "&#0;",
          "\"",
          "/>",
          "<mimic joint=\"head_pan_joint\"/>",
          "xyz=\"nan 0 0\"",
          "package://"};
}

}  // namespace amiss::fuzz
