// ROS 1 bags (format 2.0), record by record: http://wiki.ros.org/Bags/Format/2.0, read by a parser of our own.
// in: a file     out: connections and messages as bytes. Chunks may be plain, bz2 or lz4; the index at the end is not
// needed, so that bags that were not closed are read as far as they go.
// Errors: InputError naming the file and the place in it: lengths that lead out of the file, fields that are missing,
// chunks that do not unpack to the size that they promise.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace amiss::dataset {

struct BagConnection {
  std::string topic, type;
};

/// Where a message is, to be read again.
struct BagPlace {
  std::uint64_t chunk = 0;         // of the chunk's record in the file; of the message's own one outside of chunks
  std::uint64_t at = 0, size = 0;  // in the unpacked chunk, or in the file
  bool in_chunk = true;
};

class BagFile {
 public:
  explicit BagFile(std::filesystem::path file);

  using Visitor = std::function<void(const BagConnection&, const BagPlace&, std::string_view message)>;
  /// All messages in the order of the file, read once from its beginning to its end.
  void each(const Visitor& visit) const;
  [[nodiscard]] std::string read(const BagPlace& place) const;
  /// The unpacked chunk whose record is at this place.
  [[nodiscard]] std::string chunk(std::uint64_t at) const;

  [[nodiscard]] static bool is_bag(const std::filesystem::path& file);

 private:
  std::filesystem::path file_;
};

}  // namespace amiss::dataset
