#include "world/nudges.hpp"

#include "core/result.hpp"
#include "files_for_test.hpp"

namespace amiss::world {
namespace {

class NudgesTest : public FilesForTest {
 protected:
  static World two_bodies() {
    World world;
    for (const char* name : {"chair_1", "keyboard_1"}) {
      Body body;
      body.name = name;
      body.pose.T = Eigen::Translation3d(2.0, 1.0, 0.5) * Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ());
      world.bodies.push_back(body);
    }
    return world;
  }
};

TEST_F(NudgesTest, ABodyTurnsAboutItsOwnOriginAndIsThenShifted) {
  const World before = two_bodies();
  const World after = nudged(before, {{"chair_1", {0.03, -0.02}, 0.1}});
  EXPECT_TRUE(after.bodies[0].pose.position().isApprox(Eigen::Vector3d(2.03, 0.98, 0.5)));
  const Eigen::Matrix3d turn = before.bodies[0].pose.T.linear().transpose() * after.bodies[0].pose.T.linear();
  EXPECT_NEAR(Eigen::AngleAxisd(turn).angle(), 0.1, 1e-12);
  EXPECT_TRUE(after.bodies[1].pose.T.isApprox(before.bodies[1].pose.T));
  EXPECT_THROW(static_cast<void>(nudged(before, {{"sofa", {0, 0}, 0}})), ArgumentError);
}

TEST_F(NudgesTest, FilesGiveBackWhatWasSaved) {
  const World world = two_bodies();
  const std::vector<Nudge> nudges{{"keyboard_1", {0.012345678901, -0.1}, -0.05}, {"chair_1", {0.0, 0.0}, 0.0}};
  save_nudges(folder_ / "nudges.yaml", nudges);
  const std::vector<Nudge> read = load_nudges(folder_ / "nudges.yaml", world);
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].body, "keyboard_1");
  EXPECT_EQ(read[0].shift_m, nudges[0].shift_m);
  EXPECT_NEAR(read[0].yaw_rad, -0.05, 1e-15);
  save_nudges(folder_ / "none.yaml", {});
  EXPECT_TRUE(load_nudges(folder_ / "none.yaml", world).empty());
}

TEST_F(NudgesTest, WrongFilesAreRefusedWithTheirLine) {
  const World world = two_bodies();
  const auto why = [&](const std::string& text) -> std::string {
    const auto file = write("nudges.yaml", text);
    try {
      static_cast<void>(load_nudges(file, world));
    } catch (const InputError& error) {
      return std::string(error.what()).substr(file.string().size());
    }
    return "";
  };
  EXPECT_EQ(why("- {body: chair_1}\n- {body: chair_2}\n"),
            ":2: there is no body 'chair_2' in the world; did you mean 'chair_1'?");
  EXPECT_EQ(why("- {body: chair_1, z: 3}\n"), ":1: unknown key 'z' Allowed: body, x, y, yaw_deg");
  EXPECT_EQ(why("- {body: chair_1, x: far}\n"), ":1: x is not a number from -1000 to 1000");
  EXPECT_EQ(why("body: chair_1\n"), ":1: not a list; allowed is - {body: NAME, x: .., y: ..}");
}

}  // namespace
}  // namespace amiss::world
