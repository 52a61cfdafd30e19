// The parts that a data set is made of, each a job for a process of its own: the map of a room, where objects lie in it
// on each visit, and the recording of one visit.
// Folder, parameters, seed -> names of the jobs that are still to be done; name -> exit status (commands.hpp).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "dataset_rooms.hpp"
#include "reference_cache.hpp"

namespace amiss::app {

class DatasetJobs {
 public:
  DatasetJobs(std::filesystem::path out, const DatasetSettings& settings, std::uint64_t seed, bool rawlog);

  [[nodiscard]] std::vector<std::string> preparations(const std::vector<world::RoomPlan>& plans) const;
  [[nodiscard]] std::vector<std::string> visits(const std::vector<world::RoomPlan>& plans) const;
  /// ArgumentError for a name that is none of the above.
  [[nodiscard]] int run(const std::string& job) const;
  /// The folders of all recordings of these rooms.
  [[nodiscard]] std::vector<std::filesystem::path> recordings(const std::vector<world::RoomPlan>& plans) const;
  /// "big_room/scene5: 4 of 15 objects found a place" of each visit that has fewer than it should.
  [[nodiscard]] std::vector<std::string> shortfalls(const std::vector<world::RoomPlan>& plans) const;
  /// "31 recordings with 260 objects"
  [[nodiscard]] std::string summary(const std::vector<world::RoomPlan>& plans) const;

 private:
  [[nodiscard]] std::filesystem::path placement(const std::string& room, std::size_t visit) const;
  [[nodiscard]] std::filesystem::path recording(const std::string& room, std::size_t visit) const;
  [[nodiscard]] bool all_placed(const world::RoomPlan& plan) const;
  [[nodiscard]] std::optional<PreparedReference> reference(const DatasetRoom& room) const;
  [[nodiscard]] int map(const DatasetRoom& room) const;
  [[nodiscard]] int place(const DatasetRoom& room, std::size_t visits) const;
  [[nodiscard]] int record(const DatasetRoom& room, std::size_t visit) const;

  std::filesystem::path out_;
  DatasetSettings settings_;
  std::uint64_t seed_;
  bool rawlog_;
  Resources resources_;
};

}  // namespace amiss::app
