#include "video/film.hpp"

#include <fmt/format.h>

#include <csignal>
#include <cstdlib>
#include <stdexcept>

#include "core/result.hpp"
#include "video/frame.hpp"

namespace amiss::video {

namespace {

/// A word of a shell's command line.
std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

std::string command(const std::filesystem::path& file, const FilmFormat& format, bool gif) {
  const std::string scale = fmt::format("scale={}:-2:flags=lanczos+accurate_rnd", format.width);
  const std::string how =
      gif ? fmt::format(
                "-filter_complex '{},split[a][b];[a]palettegen[p];[b][p]paletteuse=dither=bayer:bayer_scale=4' "
                "-f gif",
                scale)
          : fmt::format("-vf '{}' -c:v libx264 -preset medium -crf 20 -pix_fmt yuv420p -movflags +faststart -f mp4",
                        scale);
  return fmt::format(
      "exec ffmpeg -nostdin -hide_banner -loglevel error -y -f rawvideo -pix_fmt rgb24 -s {}x{} -r {} -i - "
      "-threads 2 -fflags +bitexact -flags:v +bitexact {} {}",
      kFrameWidth, kFrameHeight, format.frames_per_s, how, quoted(std::filesystem::absolute(file).string()));
}

}  // namespace

bool has_ffmpeg() { return std::system("command -v ffmpeg >/dev/null 2>&1") == 0; }

Film::Film(std::filesystem::path file, const FilmFormat& format) : file_(std::move(file)) {
  const std::string ending = file_.extension().string();
  if (ending != ".mp4" && ending != ".gif") throw ArgumentError(file_.string() + ": .mp4 and .gif are allowed");
  if (!has_ffmpeg()) throw InputError("the program ffmpeg is not installed: `apt-get install ffmpeg`");
  unfinished_ = file_;
  unfinished_ += ".unfinished";
  std::signal(SIGPIPE, SIG_IGN);  // ffmpeg's end is told by the write that fails
  pipe_ = ::popen(command(unfinished_, format, ending == ".gif").c_str(), "we");
  if (pipe_ == nullptr) fail();
}

Film::~Film() {
  if (pipe_ != nullptr) ::pclose(pipe_);
  std::error_code ignored;
  std::filesystem::remove(unfinished_, ignored);
}

void Film::add(const std::vector<Rgb>& frame) {
  static_assert(sizeof(Rgb) == 3);
  if (std::fwrite(frame.data(), sizeof(Rgb), frame.size(), pipe_) != frame.size()) fail();
}

void Film::finish() {
  const int status = ::pclose(pipe_);
  pipe_ = nullptr;
  if (status != 0) fail();
  std::filesystem::rename(unfinished_, file_);
}

void Film::fail() const { throw std::runtime_error(file_.string() + ": ffmpeg could not write it"); }

}  // namespace amiss::video
