// The page's own files, compiled into the program from share/web/dist: no network and no folder is needed to show it.
#pragma once

#include <span>
#include <string_view>

namespace amiss::page {

struct Asset {
  std::string_view route, content_type, bytes;
};

/// index.html at "/", app.js, app.css and the licences of what is in the bundle.
[[nodiscard]] std::span<const Asset> bundle();
/// The bytes of one of them; empty where there is none.
[[nodiscard]] std::string_view bundled(std::string_view route);

}  // namespace amiss::page
