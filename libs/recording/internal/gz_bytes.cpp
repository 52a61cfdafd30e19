#include "recording/internal/gz_bytes.hpp"

#include <zlib.h>

#include <algorithm>

#include "core/result.hpp"

namespace amiss::recording::internal {

namespace {

constexpr std::uint64_t kPiece = std::uint64_t{1} << 20U;

}  // namespace

struct GzBytes::Stream {
  gzFile file = nullptr;
  Stream() = default;
  ~Stream() {
    if (file != nullptr) gzclose(file);
  }
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;
};

GzBytes::GzBytes(const std::filesystem::path& file) : name_(file.string()), stream_(std::make_unique<Stream>()) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) throw InputError(name_ + ": there is no such file");
  stream_->file = gzopen(name_.c_str(), "rb");
  if (stream_->file == nullptr) throw InputError(name_ + ": cannot be read");
  gzbuffer(stream_->file, kPiece / 4);
}

GzBytes::~GzBytes() = default;

bool GzBytes::is_cut() const {
  int status = Z_OK;
  const char* why = gzerror(stream_->file, &status);
  if (status == Z_OK || status == Z_STREAM_END || status == Z_BUF_ERROR) return status == Z_BUF_ERROR;
  throw InputError(name_ + ": its packed data was damaged (" + why + ")");
}

std::string GzBytes::take(std::uint64_t size) {
  std::string bytes;
  while (bytes.size() < size) {
    const std::size_t before = bytes.size();
    bytes.resize(before + std::min(kPiece, size - before));
    const int got = gzread(stream_->file, bytes.data() + before, static_cast<unsigned>(bytes.size() - before));
    bytes.resize(before + static_cast<std::size_t>(std::max(got, 0)));
    if (got <= 0) {
      (void)is_cut();
      throw BrokenOff{};
    }
  }
  at_ += size;
  return bytes;
}

bool GzBytes::at_end() {
  const int next = gzgetc(stream_->file);
  if (next >= 0) {
    gzungetc(next, stream_->file);
    return false;
  }
  if (is_cut()) throw BrokenOff{};
  return true;
}

}  // namespace amiss::recording::internal
