#include "core/params.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numbers>

#include "core/frames.hpp"
#include "core/result.hpp"
#include "core/temporary_folder.hpp"

namespace amiss {
namespace {

using test::sentence_of;
using test::TemporaryFolder;

struct Sample {
  double resolution_m = 0.05, fov_rad = 58.0 * std::numbers::pi / 180.0;
  int samples = 1000;
  bool carve = true;
  std::string store = "blocks";

  ParamTable table() {
    ParamTable rows;
    rows.number("mapping.resolution", resolution_m, "m", 0.01, 0.5, "edge of a voxel");
    rows.number("view.fov", fov_rad, "deg", 10, 120, "field of view");
    rows.integer("view.samples", samples, 1, 5000, "poses that are tried");
    rows.flag("mapping.carve", carve, "rays free the space they cross");
    rows.choice("mapping.store", store, {"blocks", "octomap"}, "who keeps the voxels");
    return rows;
  }
};

std::string refusal(std::string_view assignment) {
  Sample sample;
  ParamTable table = sample.table();
  return sentence_of<ArgumentError>([&] { table.set_override(assignment); });
}

/// The refusal of a file, without the name of its folder.
std::string file_refusal(std::string_view text) {
  const TemporaryFolder folder;
  Sample sample;
  ParamTable table = sample.table();
  const auto file = folder.write("p.yaml", text);
  const std::string sentence = sentence_of<ArgumentError>([&] { table.load_file(file); });
  const std::string prefix = folder.path().string() + "/";
  EXPECT_EQ(sentence.rfind(prefix, 0), 0U) << sentence;
  return sentence.substr(std::min(prefix.size(), sentence.size()));
}

TEST(Params, OverridesSetWhatTheyName) {
  Sample sample;
  ParamTable table = sample.table();
  for (const char* assignment :
       {"mapping.resolution=0.1", "view.fov=90", "view.samples=+7", "mapping.carve=false", "mapping.store=octomap"}) {
    table.set_override(assignment);
  }
  EXPECT_DOUBLE_EQ(sample.resolution_m, 0.1);
  EXPECT_DOUBLE_EQ(sample.fov_rad, std::numbers::pi / 2.0) << "degrees outside, radians inside";
  EXPECT_EQ(sample.samples, 7);
  EXPECT_FALSE(sample.carve);
  EXPECT_EQ(sample.store, "octomap");
}

TEST(Params, BothEndsOfARangeAreAllowed) {
  Sample sample;
  ParamTable table = sample.table();
  table.set_override("view.fov=10");
  table.set_override("view.fov=120");
  table.set_override("mapping.resolution=1e-2");
  EXPECT_DOUBLE_EQ(sample.resolution_m, 0.01);
}

TEST(Params, WhatIsNotAllowedIsToldWithWhatIs) {
  EXPECT_EQ(refusal("mapping.resolution=3"), "--set: mapping.resolution = '3' is not allowed; allowed: 0.01 .. 0.5 m");
  EXPECT_EQ(refusal("view.samples=2.5"),
            "--set: view.samples = '2.5' is not allowed; allowed: whole numbers 1 .. 5000");
  EXPECT_EQ(refusal("mapping.store=tree"), "--set: mapping.store = 'tree' is not allowed; allowed: blocks, octomap");
  EXPECT_EQ(refusal("mapping.carve=yes"), "--set: mapping.carve = 'yes' is not allowed; allowed: true, false");
  for (const char* text : {"nan", "-nan", "inf", "-inf", "", " 0.1", "0.1 ", "0,1", "0.1m", "--1", "1e999", "0x1p-4"}) {
    EXPECT_NE(refusal(std::string("mapping.resolution=") + text).find("allowed"), std::string::npos) << text;
  }
  EXPECT_NE(refusal("view.samples=99999999999999999999").find("allowed"), std::string::npos);
}

TEST(Params, UnknownKeysGetTheNearestOne) {
  EXPECT_EQ(refusal("mapping.resolutoin=0.1"),
            "--set: there is no parameter 'mapping.resolutoin'; did you mean 'mapping.resolution'?");
  EXPECT_EQ(refusal("qqq=1"), "--set: there is no parameter 'qqq'; --print-params lists them");
  EXPECT_EQ(refusal("mapping.carve"), "--set mapping.carve: a key=value is needed");
}

TEST(Params, RefusedValuesChangeNothing) {
  Sample sample;
  ParamTable table = sample.table();
  EXPECT_THROW(table.set_override("mapping.resolution=9"), ArgumentError);
  EXPECT_THROW(table.set_override("mapping.store=tree"), ArgumentError);
  EXPECT_DOUBLE_EQ(sample.resolution_m, 0.05);
  EXPECT_EQ(sample.store, "blocks");
}

TEST(Params, FilesNestAndErrorsNameTheLine) {
  const TemporaryFolder folder;
  Sample sample;
  ParamTable table = sample.table();
  table.load_file(folder.write("p.yaml", "# ours\nmapping:\n  resolution: 0.1\n  carve: false\nview: {fov: 60}\n"));
  EXPECT_DOUBLE_EQ(sample.resolution_m, 0.1);
  EXPECT_FALSE(sample.carve);
  EXPECT_EQ(file_refusal("view:\n  fov: 60\n  sample: 5\n"),
            "p.yaml:3: there is no parameter 'view.sample'; did you mean 'view.samples'?");
  EXPECT_EQ(file_refusal("\n\nview:\n  fov: 5\n"), "p.yaml:4: view.fov = '5' is not allowed; allowed: 10 .. 120 deg");
  EXPECT_EQ(file_refusal("view:\n  fov: .nan\n"), "p.yaml:2: view.fov = '.nan' is not allowed; allowed: 10 .. 120 deg");
}

TEST(Params, FilesThatAreNoParameters) {
  EXPECT_EQ(file_refusal("view:\n  fov: [1, 2]\n"),
            "p.yaml:2: view.fov is empty, a list or nested too deeply; a single value is allowed");
  EXPECT_NE(file_refusal("view:\n  fov:\n").find("is empty, a list"), std::string::npos);
  EXPECT_NE(file_refusal("just words\n").find("p.yaml:1: keys and values are needed"), std::string::npos);
  EXPECT_NE(file_refusal("view: {fov: 60\n").find("is not YAML"), std::string::npos);
  EXPECT_NE(file_refusal("view:\n\tfov: 60\n").find("is not YAML"), std::string::npos);
  EXPECT_NE(file_refusal("? [1, 2]\n: 3\n").find("p.yaml:"), std::string::npos);
  EXPECT_NE(file_refusal("a: &a {b: *a}\n").find("p.yaml:"), std::string::npos) << "a map that holds itself";
  EXPECT_NE(file_refusal("view: {fov: 60, fov: 70}\n").find("p.yaml:1"), std::string::npos) << "a key twice";
  EXPECT_NE(file_refusal(std::string("\0\x01\xff\xfe", 4)).find("p.yaml:"), std::string::npos);
  EXPECT_NE(file_refusal(std::string(20000, '{')).find("p.yaml:"), std::string::npos) << "nested beyond reason";
}

TEST(Params, EmptyFilesChangeNothingAndMissingOnesAreToldSo) {
  const TemporaryFolder folder;
  Sample sample;
  ParamTable table = sample.table();
  const std::string before = table.to_yaml();
  table.load_file(folder.write("empty.yaml", ""));
  table.load_file(folder.write("comment.yaml", "# nothing\n"));
  EXPECT_EQ(table.to_yaml(), before);
  EXPECT_THROW(table.load_file(folder.path() / "none.yaml"), InputError);
}

TEST(Params, YamlTellsRangeAndMeaning) {
  Sample sample;
  const std::string yaml = sample.table().to_yaml();
  EXPECT_NE(yaml.find("view:\n  fov: 58  # [10 .. 120 deg] field of view\n"), std::string::npos) << yaml;
  EXPECT_LT(yaml.find("mapping:"), yaml.find("view:")) << "sorted";
}

RC_GTEST_PROP(Params, WhatIsPrintedIsReadBack, ()) {
  Sample sample;
  sample.resolution_m = 0.01 + 1e-9 * *rc::gen::inRange(0, 490000001);
  sample.fov_rad = radians(10.0 + 1e-6 * *rc::gen::inRange(0, 110000001));
  sample.samples = *rc::gen::inRange(1, 5001);
  sample.carve = *rc::gen::arbitrary<bool>();
  sample.store = *rc::gen::element<std::string>("blocks", "octomap");
  const TemporaryFolder folder;
  Sample other;
  ParamTable table = other.table();
  table.load_file(folder.write("p.yaml", sample.table().to_yaml()));
  RC_ASSERT(other.resolution_m == sample.resolution_m);
  RC_ASSERT(std::abs(other.fov_rad - sample.fov_rad) < 1e-9);
  RC_ASSERT(other.samples == sample.samples);
  RC_ASSERT(other.carve == sample.carve && other.store == sample.store);
  RC_ASSERT(other.table().to_yaml() == sample.table().to_yaml());
}

TEST(Params, NearestWord) {
  const std::vector<std::string> words{"tidy", "map", "diff", "plan"};
  EXPECT_EQ(nearest_word("tydi", words), "tidy");
  EXPECT_EQ(nearest_word("dif", words), "diff");
  EXPECT_EQ(nearest_word("plan", words), "plan");
  EXPECT_EQ(nearest_word("xyzzy", words), "");
  EXPECT_EQ(nearest_word("", words), "");
  EXPECT_EQ(nearest_word("map", {}), "");
}

}  // namespace
}  // namespace amiss
