// A recorded run as MCAP, from front to back.
//
// in: MCAP file that a RunRecorder wrote, whole or broken off     out: entries in the order in which they happened
// InputError names the file and what is wrong: no recording of amiss, a message that is cut short, a frame whose images
// are missing.
#pragma once

#include "recording/mcap_reader.hpp"
#include "recording/source.hpp"

namespace amiss::recording {

class Recording final : public Source {
 public:
  /// Reads up to the setup.
  explicit Recording(const std::filesystem::path& file);

  [[nodiscard]] const Setup& setup() const override { return setup_; }
  [[nodiscard]] const std::map<std::string, std::string>& documents() const override { return reader_.attachments(); }
  std::optional<Entry> next() override;
  [[nodiscard]] bool complete() const override { return reader_.complete(); }

 private:
  std::filesystem::path path_;
  McapReader reader_;
  Setup setup_;
  CameraIntrinsics camera_;
  std::optional<LaserScan> scan_;   // the ranges alone
  std::optional<RgbdFrame> frame_;  // the depth alone
  std::string segmented_;
};

}  // namespace amiss::recording
