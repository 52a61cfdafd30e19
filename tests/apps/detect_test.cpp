// `amiss detect` and `amiss evaluate chapter5` on folders in ObChange's layout of full rooms that this program did not
// write: odd names, fields and line ends that are legal.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "apps/program.hpp"
#include "change/room.hpp"
#include "dataset/cloud_files.hpp"

namespace amiss {
namespace {

namespace fs = std::filesystem;
using test::Ended;

struct Detect : testing::Test {
  test::TemporaryFolder folder;

  [[nodiscard]] Ended amiss(const std::vector<std::string>& arguments) const {
    return test::run(arguments, folder.path());
  }
  [[nodiscard]] nlohmann::json json_of(const fs::path& file) const {
    return nlohmann::json::parse(folder.read(file.string()));
  }
};

/// A PCD as others write it: CRLF, comments, fields in another order, a padding field, packed colours, a point without
/// a depth first. Its index in the file is one more than that in the room.
std::string odd_pcd(const change::Scene& scene, bool labelled) {
  std::ostringstream out;
  const std::size_t n = scene.cloud.points.size() + 1;
  out << "# .PCD v.7\r\nVERSION .7\r\nFIELDS rgb y x " << (labelled ? "label " : "") << "z _\r\nSIZE 4 4 4 "
      << (labelled ? "4 " : "") << "4 1\r\nTYPE U F F " << (labelled ? "U " : "") << "F U\r\nCOUNT 1 1 1 "
      << (labelled ? "1 " : "") << "1 2\r\nWIDTH " << n << "\r\nHEIGHT 1\r\nVIEWPOINT 0 0 0 1 0 0 0\r\nPOINTS " << n
      << "\r\nDATA ascii\r\n";
  out << "0 nan nan " << (labelled ? "0 " : "") << "nan 0 0\r\n";
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const Eigen::Vector3f& p = scene.cloud.points[i];
    const Rgb c = scene.cloud.colours[i];
    out << ((c.r << 16) + (c.g << 8) + c.b) << ' ' << p.y() << ' ' << p.x() << ' ';
    if (labelled) out << static_cast<int>(scene.labels[i]) << ' ';
    out << p.z() << " 0 0\r\n";
  }
  return out.str();
}

/// Lines of `.anno`: indices of the file, the last word as it comes.
std::string line_of(const std::string& name, const segment::Indices& points, const std::string& last) {
  std::string line = name;
  for (const std::uint32_t i : points) line += " " + std::to_string(i + 1);
  return line + last + "\r\n";
}

change::Room furnished(std::uint64_t seed) {
  change::Room room(seed);
  change::add_lamp(room, 0.9F, 0.2F);
  return room;
}

/// A room with two visits: in scene3 a can is new and the lamp stands elsewhere by 5 cm; scene4 is not annotated.
void write_room(const test::TemporaryFolder& folder, const std::string& name, bool labelled) {
  fs::create_directories(folder.path() / name / "annotations");
  folder.write(name + "/Scene1.PCD", odd_pcd(furnished(1).scene(true), labelled));
  change::Room now(2);
  change::add_lamp(now, 0.95F, 0.16F);
  const std::size_t before = now.size();
  change::add_can(now, 0.5F, 0.1F);
  folder.write(name + "/scene3.pcd", odd_pcd(now.scene(true), labelled));
  folder.write(name + "/scene4.pcd", odd_pcd(furnished(3).scene(true), labelled));
  folder.write(name + "/readme.txt", "not of the data");
  folder.write(name + "/annotations/scene3_GT.anno",
               "\r\n" + line_of("005_tomato_soup_can", now.since(before), "  true ") + "\n" + "nothing_left false\n");
}

TEST_F(Detect, FindsTheNewObjectOfAFolderOfOthers) {
  write_room(folder, "big_room", true);
  const Ended ended = amiss({"detect", "big_room", "big_room", "--out", "out", "--set", "detect.min_points=20"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  const auto report = json_of("out/scene3/report.json");
  EXPECT_EQ(report["method"], "local-verification");
  EXPECT_EQ(report["objects"], 1);
  EXPECT_EQ(report["labels"]["current"], "field 'label' of scene3.pcd");
  EXPECT_EQ(json_of("out/scene4/report.json")["objects"], 0);
  const auto objects = json_of("out/scene3/objects.json");
  EXPECT_NEAR(objects["objects"][0]["centre_m"][0].get<double>(), 0.535, 0.01);
  EXPECT_NEAR(objects["objects"][0]["centre_m"][2].get<double>(), 0.76, 0.01);
  EXPECT_EQ(objects["parameters"]["detect.min_points"], "20");
  for (const auto& decision : objects["decisions"]) {
    if (decision["verdict"] != "novel") continue;
    EXPECT_EQ(decision["because"]["parameter"].get<std::string>().rfind("detect.max_", 0), 0U) << decision;
    EXPECT_LE(decision["object"].get<std::size_t>(), objects["objects"].size());
  }
  EXPECT_TRUE(std::any_of(objects["decisions"].begin(), objects["decisions"].end(),
                          [](const auto& d) { return d["verdict"] == "moved a little"; }));
  const dataset::CloudFile painted = dataset::load_cloud(folder.path() / "out/scene3/detected.ply");
  const auto& numbers = painted.field("object")->values;
  EXPECT_EQ(numbers.size(), dataset::load_cloud(folder.path() / "big_room/scene3.pcd").cloud().points.size());
  EXPECT_EQ(std::count(numbers.begin(), numbers.end(), 1.0), objects["objects"][0]["points"]);
  EXPECT_TRUE(fs::exists(folder.path() / "out/scene3/objects.png"));
}

TEST_F(Detect, LabelsAreAskedForOnlyWhereTheyAreNeeded) {
  write_room(folder, "office_partial", false);
  const std::vector<std::string> call = {
      "detect", "office_partial/Scene1.PCD", "office_partial/scene3.pcd", "--out", "out", "--labels", "none"};
  ASSERT_EQ(amiss(call).status, 0);
  EXPECT_EQ(json_of("out/report.json")["objects"], 1);
  EXPECT_EQ(json_of("out/report.json")["labels"]["current"], "none");
  std::vector<std::string> semantic = call;
  semantic[4] = "out2";
  semantic.insert(semantic.end(), {"--method", "semantic"});
  const Ended refused = amiss(semantic);
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("labels"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder.path() / "out2")) << "refused before a folder is made";
}

TEST_F(Detect, TableOfAllMethodsIsWrittenAndContinued) {
  write_room(folder, "rooms/kitchen_partial", true);
  const std::vector<std::string> call = {"evaluate", "chapter5", "rooms", "--out", "out", "--quiet"};
  const Ended first = amiss(call);
  ASSERT_EQ(first.status, 0) << first.err;
  const std::string table = folder.read("out/table52.tsv");
  std::istringstream lines(table);
  std::vector<std::string> rows;
  for (std::string line; std::getline(lines, line);) rows.push_back(line);
  ASSERT_EQ(rows.size(), 13U) << "a heading, six methods in one room, six averages";
  EXPECT_EQ(rows[0], "room\tmethod\tprecision\tprecision_sd\trecall\trecall_sd\tf1\tf1_sd\tmissed\twrong");
  EXPECT_EQ(rows[1].rfind("kitchen_partial\toctomap\t", 0), 0U);
  EXPECT_EQ(rows[12].rfind("average\tlocal-verification\t1.0000\t0.0000\t0.", 0), 0U) << rows[12];
  EXPECT_TRUE(rows[12].ends_with("\t0\t0")) << rows[12];
  EXPECT_NE(folder.read("out/report.html").find("data:image/jpeg;base64,"), std::string::npos) << "what was found";
  EXPECT_NE(folder.read("out/table52.html").find("kitchen_partial/scene4: no annotations"), std::string::npos);
  EXPECT_NE(folder.read("out/table52.md").find("| average | local-verification |"), std::string::npos);
  EXPECT_EQ(json_of("out/report.json")["wall"]["done_before"], 0);
  EXPECT_TRUE(fs::exists(folder.path() / "out/trials/kitchen_partial/scene3/local-verification.png"));

  fs::remove(folder.path() / "out/trials/kitchen_partial/scene3/metaroom.json");
  folder.write("out/trials/kitchen_partial/scene3/octomap.json", "{\"cut");
  ASSERT_EQ(amiss(call).status, 0);
  EXPECT_EQ(folder.read("out/table52.tsv"), table);
  EXPECT_EQ(json_of("out/report.json")["wall"]["done_before"], 4);
}

TEST_F(Detect, ReconstructionsOfTheSameRoomsStandInOneTable) {
  write_room(folder, "fine/kitchen_partial", true);
  write_room(folder, "coarse/kitchen_partial", false);
  const std::vector<std::string> call = {"evaluate", "reconstructions", "tsdf_5mm=fine", "octomap=coarse", "--out",
                                         "out",      "--labels",        "none"};
  ASSERT_EQ(amiss(call).status, 0);
  const std::string table = folder.read("out/generality.tsv");
  EXPECT_EQ(table.rfind("room\treconstruction\tmethod\tprecision\tprecision_sd\trecall\trecall_sd\tf1\tf1_sd\t", 0),
            0U);
  std::vector<std::size_t> places;
  for (const char* row : {"\nkitchen_partial\ttsdf_5mm\tlocal-verification\t1.0000",
                          "\nkitchen_partial\toctomap\tlocal-verification\t1.0000",
                          "\naverage\ttsdf_5mm\tlocal-verification\t1.0000", "\naverage\toctomap\t"}) {
    places.push_back(table.find(row));
    EXPECT_NE(places.back(), std::string::npos) << row << table;
  }
  EXPECT_TRUE(std::is_sorted(places.begin(), places.end())) << table;
  EXPECT_NE(folder.read("out/generality.md").find("octomap: 1 visits with 1 annotated objects"), std::string::npos);
  EXPECT_NE(folder.read("out/generality.html").find("tsdf_5mm"), std::string::npos);
  ASSERT_EQ(amiss(call).status, 0);
  EXPECT_EQ(folder.read("out/generality.tsv"), table);
  EXPECT_EQ(json_of("out/report.json")["wall"]["done_before"], 2);
  EXPECT_EQ(amiss({"evaluate", "reconstructions", "a=fine", "a=coarse", "--out", "x"}).status, 2);
  EXPECT_EQ(amiss({"evaluate", "reconstructions", "fine", "--out", "x"}).status, 2);
  EXPECT_FALSE(fs::exists(folder.path() / "x"));
}

TEST_F(Detect, WhatCannotBeUsedIsRefusedWithASentence) {
  write_room(folder, "room", true);
  folder.write("room/annotations/scene3_GT.anno", "can 1 2 99999999\n");
  const Ended broken = amiss({"evaluate", "chapter5", "room", "--out", "out"});
  EXPECT_EQ(broken.status, 3);
  EXPECT_NE(broken.err.find("scene3_GT.anno:1"), std::string::npos) << broken.err;
  EXPECT_EQ(amiss({"evaluate", "chapter5", "room", "--out", "out", "--methods", "magic"}).status, 2);
  EXPECT_EQ(amiss({"evaluate", "chapter5", "none", "--out", "out"}).status, 3);
  EXPECT_EQ(amiss({"detect", "room/Scene1.PCD", "--out", "out"}).status, 2);
  fs::remove(folder.path() / "room/Scene1.PCD");
  const Ended without = amiss({"detect", "room", "room", "--out", "out"});
  EXPECT_EQ(without.status, 3);
  EXPECT_NE(without.err.find("scene1.pcd"), std::string::npos) << without.err;
}

}  // namespace
}  // namespace amiss
