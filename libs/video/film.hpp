// A film file from frames, by the program ffmpeg, which gets them through a pipe: .mp4 (H.264) or .gif (256 colours, a
// palette of its own). The file is there when finish() returns, and not before.
// in: frames of kFrameWidth x kFrameHeight     out: the file, `width` pixels wide
// ArgumentError for another ending or a folder; InputError where ffmpeg is not installed; std::runtime_error where it
// fails, with the first line that it says; nothing of it goes to standard error.
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/frames.hpp"

namespace amiss::video {

struct FilmFormat {
  int frames_per_s = 25;
  int width = 1280;  // even
};

/// Is the program there?
[[nodiscard]] bool has_ffmpeg();

class Film {
 public:
  Film(std::filesystem::path file, const FilmFormat& format);
  ~Film();  // without finish() nothing is left
  Film(const Film&) = delete;
  Film& operator=(const Film&) = delete;

  void add(const std::vector<Rgb>& frame);
  void finish();

 private:
  struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  /// Ends ffmpeg where it still runs.
  [[noreturn]] void fail();
  std::filesystem::path file_, unfinished_;
  std::unique_ptr<std::FILE, Closer> said_;  // by ffmpeg; without a name
  std::FILE* pipe_ = nullptr;
};

}  // namespace amiss::video
