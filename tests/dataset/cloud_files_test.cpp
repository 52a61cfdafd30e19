// PLY and PCD: round trips, files that others wrote, odd but legal ones, and what is refused.
#include "dataset/cloud_files.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "core/random.hpp"
#include "core/result.hpp"
#include "core/temporary_folder.hpp"
#include "mapping/test_data.hpp"

namespace amiss::dataset {
namespace {

CloudFile some_cloud() {
  CloudFile file;
  RandomStream random(3, "cloud");
  Cloud<Map>& cloud = file.mesh.vertices;
  file.fields = {{"label", {}}, {"score", {}}};
  for (int i = 0; i < 200; ++i) {
    const auto coordinate = [&] { return static_cast<float>(random.uniform(-3.0, 3.0)); };
    cloud.points.emplace_back(coordinate(), coordinate(), coordinate());
    cloud.normals.push_back(Eigen::Vector3f(coordinate(), coordinate(), coordinate()).normalized());
    cloud.colours.push_back({static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(255 - i), 7});
    file.fields[0].values.push_back(i == 5 ? 100000 : i % 4);
    file.fields[1].values.push_back(random.uniform(0.0, 1.0));
  }
  return file;
}

void expect_same(const CloudFile& a, const CloudFile& b) {
  EXPECT_EQ(a.cloud().points, b.cloud().points);
  EXPECT_EQ(a.cloud().normals, b.cloud().normals);
  EXPECT_EQ(a.cloud().colours, b.cloud().colours);
  EXPECT_EQ(a.mesh.triangles, b.mesh.triangles);
  ASSERT_EQ(a.fields.size(), b.fields.size());
  for (std::size_t i = 0; i < a.fields.size(); ++i) {
    EXPECT_EQ(a.fields[i].name, b.fields[i].name);
    EXPECT_EQ(a.fields[i].values, b.fields[i].values);
  }
}

std::string why(const std::string& bytes, bool ply) {
  try {
    (void)(ply ? parse_ply(bytes, "cloud") : parse_pcd(bytes, "cloud"));
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST(CloudFiles, NotesOfTheHeaderAreKept) {
  CloudFile cloud = some_cloud();
  cloud.notes = {"amiss labels: forest (forest.bin, learned)", "two\nlines"};
  const std::vector<std::string> kept{cloud.notes[0], "two lines"};
  for (const CloudFormat format : {CloudFormat::kAscii, CloudFormat::kBinary}) {
    EXPECT_EQ(parse_pcd(pcd_bytes(cloud, format), "pcd").notes, kept);
    EXPECT_EQ(parse_ply(ply_bytes(cloud, format), "ply").notes, kept);
  }
  EXPECT_NE(ply_bytes(cloud).find("\ncomment amiss labels: forest (forest.bin, learned)\n"), std::string::npos);
  EXPECT_NE(pcd_bytes(cloud).find("\n# amiss labels: forest (forest.bin, learned)\n"), std::string::npos);
  const std::string head = "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 1\nHEIGHT 1\nDATA ascii\n1 2 3\n";
  EXPECT_EQ(parse_pcd("# .PCD v.7\n#tight\n#\n" + head, "pcd").notes, std::vector<std::string>{"tight"});
}

TEST(CloudFiles, WhatIsNoCloudIsToldOfByItsNameAndWithoutItsBytes) {
  const test::TemporaryFolder folder;
  const auto said = [&](const char* name, std::string_view bytes) {
    const auto file = folder.write(name, bytes);
    return test::sentence_of<InputError>([&] { static_cast<void>(load_cloud(file)); }).substr(file.string().size());
  };
  EXPECT_EQ(said("empty.ply", ""), ": is empty; a PLY or PCD file is needed");
  EXPECT_EQ(said("other.ply", "solid\n"), ": the first line of a PLY file must be 'ply'");
  EXPECT_EQ(said("other.pcd",
                 "\x7f"
                 "ELF\x02\x01\xff\xfe\x1b[2J more\n"),
            ":1: '\\x7fELF\\x02\\x01\\xff\\xfe\\x1b...' is no entry of a PCD header");
}

TEST(CloudFiles, RoundTripsOfAllFormats) {
  CloudFile cloud = some_cloud();
  for (const CloudFormat format : {CloudFormat::kAscii, CloudFormat::kBinary}) {
    expect_same(parse_pcd(pcd_bytes(cloud, format), "pcd"), cloud);
    expect_same(parse_ply(ply_bytes(cloud, format), "ply"), cloud);
  }
  cloud.mesh.triangles = {{0, 1, 2}, {199, 3, 7}};
  for (const CloudFormat format : {CloudFormat::kAscii, CloudFormat::kBinary}) {
    expect_same(parse_ply(ply_bytes(cloud, format), "ply"), cloud);
  }
}

TEST(CloudFiles, SavesByExtensionAndLoadsByContent) {
  const test::TemporaryFolder folder;
  const CloudFile cloud = some_cloud();
  save_cloud(folder.path() / "a.ply", cloud);
  save_cloud(folder.path() / "a.pcd", cloud);
  expect_same(load_cloud(folder.path() / "a.ply"), cloud);
  expect_same(load_cloud(folder.path() / "a.pcd"), cloud);
  EXPECT_THROW(save_cloud(folder.path() / "a.xyz", cloud), ArgumentError);
  CloudFile uneven = cloud;
  uneven.mesh.vertices.colours.pop_back();
  EXPECT_THROW(save_cloud(folder.path() / "b.ply", uneven), ArgumentError);
}

TEST(CloudFiles, PointsKeepTheirIndexWhereTheyAreNotFinite) {
  const CloudFile file = parse_pcd(
      "FIELDS x y z label\nSIZE 4 4 4 4\nTYPE F F F U\nWIDTH 3\nHEIGHT 1\nDATA ascii\n"
      "1 2 3 4\nnan nan nan 0\n+1e0 -2 .5 9\n",
      "pcd");
  ASSERT_EQ(file.cloud().points.size(), 3U);
  EXPECT_TRUE(std::isnan(file.cloud().points[1].x()));
  EXPECT_EQ(file.cloud().points[2], Eigen::Vector3f(1, -2, 0.5F));
  EXPECT_EQ(file.field("label")->values, (std::vector<double>{4, 0, 9}));
  EXPECT_EQ(file.field("nothing"), nullptr);
}

TEST(CloudFiles, OddButLegalPly) {
  // Vertices behind another element, doubles, a list among the vertices, polygons, CR LF.
  const CloudFile file = parse_ply(
      "ply\r\nformat ascii 1.0\r\ncomment x\r\nelement camera 1\r\nproperty float focal\r\nelement vertex 4\r\n"
      "property double z\r\nproperty double y\r\nproperty list uchar int seen\r\nproperty double x\r\n"
      "property float red\r\nproperty float green\r\nproperty float blue\r\nelement face 1\r\n"
      "property list uchar uint vertex_index\r\nproperty uchar flags\r\nend_header\r\n"
      "525\r\n3 2 2 7 7 1 1 0.5 0\r\n0 0 0 0 1 1 1\r\n0 0 0 0 0 0 0\r\n0 0 1 5 0 0 0 0\r\n4 0 1 2 3 9\r\n",
      "ply");
  EXPECT_EQ(file.cloud().points[0], Eigen::Vector3f(1, 2, 3));
  EXPECT_EQ(file.cloud().colours[0], (Rgb{255, 128, 0}));
  EXPECT_EQ(file.mesh.triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {0, 2, 3}}));
}

TEST(CloudFiles, BigEndianPly) {
  std::string bytes =
      "ply\nformat binary_big_endian 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
      "property float z\nproperty ushort label\nend_header\n";
  bytes += std::string("\x3f\x80\0\0\x40\0\0\0\x40\x40\0\0\x01\x02", 14);
  const CloudFile file = parse_ply(bytes, "ply");
  EXPECT_EQ(file.cloud().points[0], Eigen::Vector3f(1, 2, 3));
  EXPECT_EQ(file.field("label")->values[0], 258.0);
}

TEST(CloudFiles, PackedColoursAsFloatAndAsInteger) {
  const std::uint32_t bits = 0x00102030;
  float as_float = 0;
  std::memcpy(&as_float, &bits, 4);
  std::string bytes = "FIELDS x y z rgb\nSIZE 4 4 4 4\nTYPE F F F F\nPOINTS 1\nDATA binary\n";
  bytes += std::string(12, '\0') + std::string(reinterpret_cast<const char*>(&as_float), 4);
  EXPECT_EQ(parse_pcd(bytes, "pcd").cloud().colours[0], (Rgb{0x10, 0x20, 0x30}));
}

TEST(CloudFiles, SaysWhatIsWrong) {
  const std::string ply = "ply\nformat ascii 1.0\n", pcd = "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\n";
  EXPECT_EQ(why("", true), "cloud: the first line of a PLY file must be 'ply'");
  EXPECT_EQ(why("ply\nformat text 1.0\n", true),
            "cloud:2: format must be ascii, binary_little_endian or binary_big_endian, and 1.0");
  EXPECT_EQ(why(ply + "element vertex 1\nproperty half x\n", true).rfind("cloud:4: 'half' is no type", 0), 0U);
  EXPECT_EQ(
      why(ply + "element vertex 4000000000\nproperty float x\nproperty float y\nproperty float z\nend_header\n1", true),
      "cloud: is too short for its 4000000000 elements 'vertex'");
  EXPECT_EQ(why(ply + "element vertex 1\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
                      "property list uchar int vertex_indices\nend_header\n1 2 3 3 0 0 1 ",
                true),
            "cloud: a face names vertex 1 of 1");
  EXPECT_EQ(why("", false).rfind("cloud: the header of a PCD file must end with DATA", 0), 0U);
  EXPECT_EQ(why("FIELDS x y z\nSIZE 4 4\nTYPE F F F\nPOINTS 0\nDATA ascii\n", false),
            "cloud: FIELDS, SIZE, TYPE and COUNT must have equally many entries");
  EXPECT_EQ(why(pcd + "WIDTH 5\nHEIGHT 1\nPOINTS 4\nDATA ascii\n", false),
            "cloud: POINTS 4 must be WIDTH times HEIGHT, 5");
  EXPECT_EQ(why(pcd + "POINTS 100000000\nDATA binary\nabc", false),
            "cloud: is too short for its 100000000 points of 12 bytes");
  EXPECT_EQ(why(pcd + "POINTS 1\nDATA ascii\n1 2 zwei", false), "cloud: point 0: 'zwei' is no number for z");
  EXPECT_EQ(why("FIELDS a\nSIZE 4\nTYPE F\nPOINTS 0\nDATA ascii\n", false),
            "cloud: has no fields x, y and z; a cloud needs the three");
}

TEST(CloudFiles, CloudsOfOthers) {
  const auto folder = mapping::test_data();
  if (!std::filesystem::exists(folder / "pointclouds")) GTEST_SKIP() << "no data of others in " << folder;
  const CloudFile bun = load_cloud(folder / "pointclouds" / "bun0.pcd");
  EXPECT_EQ(bun.cloud().points.size(), 397U);
  EXPECT_EQ(bun.cloud().normals.size(), 397U);
  EXPECT_NE(bun.field("curvature"), nullptr);
  EXPECT_EQ(load_cloud(folder / "pointclouds" / "bun4.pcd").cloud().points.size(), 361U);
  EXPECT_EQ(load_cloud(folder / "pointclouds" / "room_scan1.pcd").cloud().points.size(), 112586U);
  EXPECT_EQ(load_cloud(folder / "pointclouds" / "office1.pcd").cloud().colours.size(), 307200U);
  const CloudFile ply = load_cloud(folder / "pointclouds" / "parasaurolophus_6700.ply");
  EXPECT_EQ(ply.mesh.triangles.size(), 9140U);
  EXPECT_EQ(ply.cloud().normals.size(), 6700U);
  const CloudFile desk = load_cloud(folder / "rgbd_change_mosd" / "raw_pcd" / "test55.pcd");
  EXPECT_EQ(desk.cloud().points.size(), 307200U);
  EXPECT_EQ(desk.field("label")->values.size(), 307200U);
  const CloudFile house = load_cloud(folder / "semantic_house" / "dining_current.ply");
  EXPECT_EQ(house.cloud().points.size(), 281445U);
  EXPECT_NE(house.field("instance"), nullptr);
}

}  // namespace
}  // namespace amiss::dataset
