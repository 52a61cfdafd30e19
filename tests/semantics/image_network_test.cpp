#include "semantics/image_network.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "core/result.hpp"
#include "core/temporary_folder.hpp"
#include "semantics/small_network.hpp"

namespace amiss::semantics {
namespace {

using C = SemanticClass;

const std::vector<C> kClasses{C::kWall, C::kFloor, C::kTable};

/// Red, green and blue stripes.
RgbdFrame stripes() {
  RgbdFrame frame;
  frame.intrinsics = {60, 40, 60, 60, 29.5, 19.5};
  for (int i = 0; i < 60 * 40; ++i) {
    const int stripe = i % 60 / 20;
    frame.colour.push_back(stripe == 0 ? Rgb{200, 10, 10} : stripe == 1 ? Rgb{10, 200, 10} : Rgb{10, 10, 200});
  }
  frame.depth_m.assign(60 * 40, 1.0F);
  return frame;
}

std::string why(const std::filesystem::path& description) {
  try {
    (void)load_image_network(description);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST(ImageNetwork, PixelsGetTheClassOfTheHighestScore) {
  ImageNetwork network(test::colour_network(32, 24), {32, 24}, kClasses, "colours.onnx");
  const std::vector<C> classes = network.classes_of(stripes());
  ASSERT_EQ(classes.size(), 60U * 40U);
  for (std::size_t i = 0; i < classes.size(); ++i) {
    const std::size_t u = i % 60;
    if (u % 20 < 3 || u % 20 > 16) continue;  // scaled images blur at borders
    EXPECT_EQ(classes[i], kClasses[u / 20]) << u;
  }
}

/// The mean is taken off before the comparison: with a high mean of red, red is what is least.
TEST(ImageNetwork, MeanAndDeviationAreApplied) {
  NetworkInput input{32, 24, {2.0, 0, 0}, {1, 1, 1}};
  ImageNetwork network(test::colour_network(32, 24), input, kClasses, "colours.onnx");
  EXPECT_NE(network.classes_of(stripes())[60 * 20 + 10], C::kWall);
}

TEST(ImageNetwork, DescriptionReadsAsWritten) {
  const amiss::test::TemporaryFolder folder;
  folder.write("n.onnx", test::colour_network(32, 24));
  ImageNetwork network = load_image_network(
      folder.write("n.yaml", "network: n.onnx\ninput: [32, 24]\nclasses: [wall, floor, unlabelled]\n"));
  EXPECT_EQ(network.classes_of(stripes())[60 * 20 + 50], C::kUnlabelled);
}

TEST(ImageNetwork, BrokenDescriptionsNameTheLine) {
  const amiss::test::TemporaryFolder folder;
  folder.write("n.onnx", test::colour_network(32, 24));
  const auto says = [&](const std::string& text) { return why(folder.write("n.yaml", text)); };
  EXPECT_NE(says("network: n.onnx\ninput: [32, 24]\nclasses: [wall, flor, table]\n").find("n.yaml:3"),
            std::string::npos);
  EXPECT_NE(says("network: n.onnx\ninput: [32]\nclasses: [wall]\n").find("n.yaml:2"), std::string::npos);
  EXPECT_NE(says("network: n.onnx\ninput: [32, 24]\nclasses: [wall]\nscale: 2\n").find("scale"), std::string::npos);
  EXPECT_NE(says("network: n.onnx\ninput: [32, 24]\ndeviation: [1, 0, 1]\nclasses: [wall]\n").find("above 0"),
            std::string::npos);
  EXPECT_NE(says("network: none.onnx\ninput: [32, 24]\nclasses: [wall]\n").find("none.onnx"), std::string::npos);
  EXPECT_NE(says("network: n.onnx\ninput: [32, 24]\nclasses: [wall, floor]\n").find("1 x 3 x 24 x 32"),
            std::string::npos);
}

TEST(ImageNetwork, BrokenNetworksAreOneSentence) {
  for (const std::string& bytes : {std::string(), std::string("hello"), test::colour_network(32, 24).substr(0, 80)}) {
    try {
      ImageNetwork network(bytes, {32, 24}, kClasses, "broken.onnx");
      ADD_FAILURE() << bytes.size();
    } catch (const InputError& e) {
      EXPECT_EQ(std::string(e.what()).rfind("broken.onnx: ", 0), 0U);
      EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos);
    }
  }
}

TEST(ImageNetwork, FramesWithoutColourAreRefused) {
  ImageNetwork network(test::colour_network(32, 24), {32, 24}, kClasses, "colours.onnx");
  RgbdFrame frame = stripes();
  frame.colour.clear();
  EXPECT_THROW((void)network.classes_of(frame), InputError);
}

}  // namespace
}  // namespace amiss::semantics
