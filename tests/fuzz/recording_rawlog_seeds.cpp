#include "fuzz/seeds.hpp"
#include "recording/small_rawlog.hpp"

namespace amiss::fuzz {

std::vector<std::string> valid_inputs() {
  const test::TemporaryFolder folder;
  const auto file = test::small_rawlog(folder, 2, true);
  return {test::unpacked(file), folder.read("a.rawlog")};
}

std::vector<std::string> words() {
  return {std::string(8, '\xff'), std::string(4, '\xff'), "\x88", "\x9dmrpt::obs::CObservationRawDAQ",
          "/amiss/depth",         "mrpt::img::CImage\x09"};
}

}  // namespace amiss::fuzz
