// A recorded run as an MRPT rawlog, from front to back.
//
// in: rawlog that a RawlogWriter made for a replay, whole or broken off     out: entries in the order in which they
// happened, as they were to the last bit
// InputError names the file and what is wrong: a rawlog without what a replay needs, a message that is cut short, depth
// that does not fit its image.
#pragma once

#include "recording/rawlog_reader.hpp"
#include "recording/source.hpp"

namespace amiss::recording {

class RawlogRecording final : public Source {
 public:
  /// Reads the setup and the documents.
  explicit RawlogRecording(const std::filesystem::path& file);

  [[nodiscard]] const Setup& setup() const override { return setup_; }
  [[nodiscard]] const std::map<std::string, std::string>& documents() const override { return documents_; }
  std::optional<Entry> next() override;
  [[nodiscard]] bool complete() const override { return reader_.complete(); }

 private:
  void keep(RawlogObject& object);
  void keep_frame(const RawlogFrame& frame, const std::vector<std::uint32_t>& rest);
  std::optional<Entry> entry_of(const RawlogData& data);

  std::filesystem::path path_;
  RawlogReader reader_;
  Setup setup_;
  std::map<std::string, std::string> documents_;
  std::optional<RawlogObject> first_;  // after setup and documents
  std::optional<RawlogFrame> rounded_;
  std::optional<LaserScan> scan_;   // the ranges alone
  std::optional<RgbdFrame> frame_;  // the depth alone
  std::string segmented_;
};

}  // namespace amiss::recording
