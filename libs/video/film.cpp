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

std::string command(const std::filesystem::path& file, const FilmFormat& format, bool gif, int said) {
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
      "-threads 2 -fflags +bitexact -flags:v +bitexact {} {} >/dev/null 2>/dev/fd/{}",
      kFrameWidth, kFrameHeight, format.frames_per_s, how, quoted(std::filesystem::absolute(file).string()), said);
}

/// What tells the cause; the lines after it follow from it.
std::string first_line(std::FILE* file) {
  std::string text(2000, '\0');
  std::rewind(file);
  text.resize(std::fread(text.data(), 1, text.size(), file));
  text.erase(0, text.find_first_not_of(" \r\n"));
  return text.substr(0, text.find_first_of("\r\n"));
}

}  // namespace

bool has_ffmpeg() { return std::system("command -v ffmpeg >/dev/null 2>&1") == 0; }

Film::Film(std::filesystem::path file, const FilmFormat& format) : file_(std::move(file)) {
  const std::string ending = file_.extension().string();
  if (ending != ".mp4" && ending != ".gif") throw ArgumentError(file_.string() + ": .mp4 and .gif are allowed");
  if (std::filesystem::is_directory(file_)) throw ArgumentError(file_.string() + ": is a folder; a file is needed");
  if (!has_ffmpeg()) throw InputError("the program ffmpeg is not installed: `apt-get install ffmpeg`");
  unfinished_ = file_;
  unfinished_ += ".unfinished";
  said_.reset(std::tmpfile());
  if (!said_) throw std::runtime_error("there is no temporary file to be had");
  std::signal(SIGPIPE, SIG_IGN);  // ffmpeg's end is told by the write that fails
  pipe_ = ::popen(command(unfinished_, format, ending == ".gif", ::fileno(said_.get())).c_str(), "we");
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

void Film::fail() {
  if (pipe_ != nullptr) ::pclose(pipe_);
  pipe_ = nullptr;
  std::string line = first_line(said_.get());
  if (!line.empty()) line = ": " + line;
  throw std::runtime_error(file_.string() + ": ffmpeg could not write it" + line);
}

}  // namespace amiss::video
