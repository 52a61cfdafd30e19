#include "core/yaml_checks.hpp"

#include <gtest/gtest.h>
#include <unistd.h>
#include <yaml-cpp/yaml.h>

#include <filesystem>

#include "core/files.hpp"
#include "core/result.hpp"

namespace amiss {
namespace {

template <class Act>
std::string why_of(const Act& act) {
  try {
    act();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(YamlChecks, WhatIsWrongIsToldWithFileAndLine) {
  const YAML::Node item = YAML::Load("{name: mug,\n x: 1.5,\n y: far,\n big: 2000, empty: ''}");
  EXPECT_EQ(yaml_number("f", item, "x", 0.0), 1.5);
  EXPECT_EQ(yaml_number("f", item, "z", 7.0), 7.0);
  EXPECT_EQ(yaml_text("f", item, "name"), "mug");
  const auto number = [&](const char* key) {
    return why_of([&] { static_cast<void>(yaml_number("f", item, key, 0.0)); });
  };
  EXPECT_EQ(number("y"), "f:3: y is not a number from -1000 to 1000");
  EXPECT_EQ(number("big"), "f:4: big is not a number from -1000 to 1000");
  EXPECT_EQ(why_of([&] { static_cast<void>(yaml_text("f", item, "empty")); }),
            "f:4: empty is missing or empty; a name is needed");
  const auto keys = [&](const std::vector<std::string>& known, const std::vector<std::string>& needed) {
    return why_of([&] { check_yaml_keys("f", item, known, needed, "{..}"); });
  };
  EXPECT_EQ(keys({"name", "x", "y", "big", "empty"}, {"x"}), "");
  EXPECT_EQ(keys({"name", "x", "y", "big", "empty"}, {"z"}), "f:1: z is missing; a number is needed");
  EXPECT_EQ(keys({"name", "x", "y", "bag", "empty"}, {}),
            "f:4: unknown key 'big'; did you mean 'bag'? Allowed: name, x, y, bag, empty");
  EXPECT_EQ(why_of([&] { check_yaml_keys("f", item["x"], {}, {}, "{x: ..}"); }), "f:2: not a map; allowed is {x: ..}");
}

TEST(YamlChecks, NumbersAndTextsReadBackAsTheyWere) {
  for (const double value : {0.1, -1.0 / 3.0, 1e-17, 12345.678}) {
    EXPECT_EQ(YAML::Load(yaml_exact(value)).as<double>(), value);
  }
  for (const char* text : {"plain", "it's", "a: b # c", "'"}) {
    EXPECT_EQ(YAML::Load(yaml_quoted(text)).as<std::string>(), text);
  }
}

TEST(YamlChecks, AFileThatIsNoYamlIsRefused) {
  const auto file = std::filesystem::temp_directory_path() / ("amiss_yaml_" + std::to_string(getpid()) + ".yaml");
  save_atomically(file, "a: 1\nb: [\n");
  EXPECT_NE(why_of([&] { static_cast<void>(load_yaml(file)); }).find("not YAML"), std::string::npos);
  save_atomically(file, "a: 1\n");
  EXPECT_EQ(load_yaml(file)["a"].as<int>(), 1);
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace amiss
