#include "page/bundle.hpp"

#include <array>

// The assembler puts the files in as they are, which costs no time to compile.
#define AMISS_INCLUDE_FILE(name, file)                                                                                \
  __asm__(".section .rodata\n.global amiss_page_" #name "_begin\n.global amiss_page_" #name "_end\namiss_page_" #name \
          "_begin:\n.incbin \"" AMISS_WEB_DIST "/" file "\"\namiss_page_" #name "_end:\n.byte 0\n.previous\n");       \
  extern "C" const char amiss_page_##name##_begin[], amiss_page_##name##_end[]

AMISS_INCLUDE_FILE(index, "index.html");
AMISS_INCLUDE_FILE(script, "app.js");
AMISS_INCLUDE_FILE(style, "app.css");
AMISS_INCLUDE_FILE(licences, "LICENSES.txt");

namespace amiss::page {

namespace {

std::string_view between(const char* begin, const char* end) { return {begin, static_cast<std::size_t>(end - begin)}; }

}  // namespace

std::span<const Asset> bundle() {
  static const std::array<Asset, 4> assets{{
      {"/", "text/html; charset=utf-8", between(amiss_page_index_begin, amiss_page_index_end)},
      {"/app.js", "text/javascript; charset=utf-8", between(amiss_page_script_begin, amiss_page_script_end)},
      {"/app.css", "text/css; charset=utf-8", between(amiss_page_style_begin, amiss_page_style_end)},
      {"/licences.txt", "text/plain; charset=utf-8", between(amiss_page_licences_begin, amiss_page_licences_end)},
  }};
  return assets;
}

std::string_view bundled(std::string_view route) {
  for (const Asset& asset : bundle()) {
    if (asset.route == route) return asset.bytes;
  }
  return {};
}

}  // namespace amiss::page
