#include "dataset/room_folders.hpp"

#include <gtest/gtest.h>

#include "core/files.hpp"
#include "core/result.hpp"
#include "core/temporary_folder.hpp"

namespace amiss::dataset {
namespace {

namespace fs = std::filesystem;

struct RoomFolders : testing::Test {
  test::TemporaryFolder folder;
  void put(const fs::path& file) const {
    fs::create_directories((folder.path() / file).parent_path());
    save_atomically(folder.path() / file, "x");
  }
};

TEST_F(RoomFolders, AreFoundInObChangesLayout) {
  for (const char* file :
       {"small_room/scene1.pcd", "small_room/scene2.pcd", "small_room/Annotations/scene2_GT.anno",
        "big_room/scene1.pcd", "big_room/scene10.pcd", "big_room/scene2.pcd", "big_room/scene2_space.bt"}) {
    put(file);
  }
  const auto rooms = room_folders(folder.path());
  ASSERT_EQ(rooms.size(), 2U);
  EXPECT_EQ(rooms[0].name, "big_room");
  ASSERT_EQ(rooms[0].scenes.size(), 3U);
  EXPECT_EQ(rooms[0].scenes[2].number, 10) << "by number, not by name";
  EXPECT_EQ(rooms[0].scene(2)->space, folder.path() / "big_room/scene2_space.bt");
  EXPECT_FALSE(rooms[0].scene(10)->space);
  EXPECT_EQ(rooms[0].scene(3), nullptr);
  EXPECT_EQ(rooms[1].scene(2)->annotations, folder.path() / "small_room/Annotations/scene2_GT.anno");
  EXPECT_FALSE(rooms[1].scene(1)->annotations);
}

TEST_F(RoomFolders, OddButLegalNamesAreRead) {
  for (const char* file :
       {"Arena/Scene1.PLY", "Arena/SCENE3.pcd", "Arena/scene3.ply", "Arena/scene3.anno", "Arena/notes.txt",
        "Arena/scene.pcd", "Arena/scene4x.pcd", "Arena/scene3_old.pcd", "Arena/scene5.pcd/inside", ".hidden/scene1.pcd",
        "empty/readme.md", "GH30_office/scene1.pcd", "Annotations/gh30_office/scene1_GT.anno", "readme.md"}) {
    put(file);
  }
  const auto rooms = room_folders(folder.path());
  ASSERT_EQ(rooms.size(), 2U);
  ASSERT_EQ(rooms[0].scenes.size(), 2U);
  EXPECT_EQ(rooms[0].scenes[0].cloud.filename(), "Scene1.PLY");
  EXPECT_EQ(rooms[0].scenes[1].cloud.filename(), "SCENE3.pcd");
  EXPECT_EQ(rooms[0].scenes[1].annotations->filename(), "scene3.anno");
  EXPECT_EQ(rooms[1].scenes[0].annotations, folder.path() / "Annotations/gh30_office/scene1_GT.anno");
}

TEST_F(RoomFolders, OneRoomMayBeGivenItself) {
  put("kitchen_partial/scene1.pcd");
  put("kitchen_partial/old/scene1.pcd");
  const auto rooms = room_folders(folder.path() / "kitchen_partial" / "");
  ASSERT_EQ(rooms.size(), 1U);
  EXPECT_EQ(rooms[0].name, "kitchen_partial");
  EXPECT_TRUE(is_room_folder(folder.path() / "kitchen_partial"));
  EXPECT_FALSE(is_room_folder(folder.path()));
  EXPECT_FALSE(is_room_folder(folder.path() / "kitchen_partial/scene1.pcd"));
}

TEST_F(RoomFolders, NothingThereIsRefused) {
  EXPECT_THROW((void)room_folders(folder.path()), InputError);
  EXPECT_THROW((void)room_folders(folder.path() / "none"), InputError);
}

}  // namespace
}  // namespace amiss::dataset
