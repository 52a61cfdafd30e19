#include "video/film.hpp"

#include <gtest/gtest.h>

#include "core/result.hpp"
#include "core/temporary_folder.hpp"
#include "video/frame.hpp"

namespace amiss::video {
namespace {

/// What ffprobe says of the first stream: "width,height,frames a second,frames".
std::string probed(const std::filesystem::path& file) {
  const std::string command =
      "ffprobe -v error -count_frames -select_streams v:0 -show_entries "
      "stream=width,height,r_frame_rate,nb_read_frames -of csv=p=0 '" +
      file.string() + "'";
  std::string text(200, '\0');
  FILE* pipe = ::popen(command.c_str(), "r");
  text.resize(std::fread(text.data(), 1, text.size(), pipe));
  ::pclose(pipe);
  return text.substr(0, text.find('\n'));
}

TEST(Film, IsWhatFfprobeReads) {
  if (!has_ffmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
  const test::TemporaryFolder folder;
  for (const char* name : {"it's a film.mp4", "film.gif"}) {
    const auto file = folder.path() / name;
    if (file.extension() == ".mp4") {
      Film film(file, {10, 320});
      for (int i = 0; i < 12; ++i) {
        film.add(std::vector<Rgb>(static_cast<std::size_t>(kFrameWidth) * kFrameHeight,
                                  {static_cast<std::uint8_t>(20 * i), 100, 50}));
      }
      EXPECT_FALSE(std::filesystem::exists(file)) << "not before it is whole";
      film.finish();
      const std::string copy = (folder.path() / "film.mp4").string();
      std::filesystem::copy_file(file, copy);
      EXPECT_EQ(probed(copy), "320,180,10/1,12");
    } else {
      Film film(file, {10, 160});
      for (int i = 0; i < 5; ++i) {
        film.add(std::vector<Rgb>(static_cast<std::size_t>(kFrameWidth) * kFrameHeight,
                                  {static_cast<std::uint8_t>(50 * i), 100, 50}));
      }
      film.finish();
      EXPECT_EQ(probed(file), "160,90,10/1,5");
    }
  }
}

TEST(Film, LeavesNothingWhenItIsGivenUp) {
  if (!has_ffmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
  const test::TemporaryFolder folder;
  { const Film film(folder.path() / "film.mp4", {}); }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(Film, SaysInOneSentenceWhyFfmpegFailed) {
  if (!has_ffmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
  const test::TemporaryFolder folder;
  testing::internal::CaptureStderr();
  const std::string said = test::sentence_of<std::runtime_error>([&] {
    Film film(folder.path() / "nowhere" / "film.mp4", {10, 320});
    for (int i = 0; i < 3; ++i) film.add(std::vector<Rgb>(static_cast<std::size_t>(kFrameWidth) * kFrameHeight));
    film.finish();
  });
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(said.find((folder.path() / "nowhere" / "film.mp4: ffmpeg could not write it: ").string()), 0U) << said;
  EXPECT_NE(said.find("No such file or directory"), std::string::npos) << said;
  EXPECT_EQ(said.find('\n'), std::string::npos);
}

TEST(Film, RefusesOtherEndingsAndFolders) {
  EXPECT_THROW(Film("film.avi", {}), ArgumentError);
  const test::TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "film.mp4");
  EXPECT_THROW(Film(folder.path() / "film.mp4", {}), ArgumentError);
}

}  // namespace
}  // namespace amiss::video
