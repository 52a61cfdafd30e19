// A run folder as a page sees it: the timeline that a Recorder left (also of a run that goes on or was killed) and the
// files that a server may show. InputError naming the file when there is no timeline or it is broken; a last line
// that was not written whole is left out.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "page/events.hpp"
#include "page/server.hpp"
#include "page/story.hpp"

namespace amiss::page {

[[nodiscard]] std::vector<std::string> load_timeline(const std::filesystem::path& folder);
/// The timeline as a story (see story.hpp).
[[nodiscard]] Story load_story(const std::filesystem::path& folder);
[[nodiscard]] std::string load_picture(const std::filesystem::path& folder, Slice slice);
[[nodiscard]] std::vector<ServedFile> served_files(const std::filesystem::path& folder);

}  // namespace amiss::page
