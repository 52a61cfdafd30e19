#include "page/bundle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "core/files.hpp"

namespace amiss::page {
namespace {

namespace fs = std::filesystem;

const fs::path kWeb = fs::path(AMISS_SOURCE_DIR) / "share" / "web";

TEST(Bundle, IsWhatStandsInDist) {
  EXPECT_EQ(bundled("/"), load_bytes(kWeb / "dist" / "index.html"));
  EXPECT_EQ(bundled("/app.js"), load_bytes(kWeb / "dist" / "app.js"));
  EXPECT_EQ(bundled("/app.css"), load_bytes(kWeb / "dist" / "app.css"));
  EXPECT_EQ(bundled("/licences.txt"), load_bytes(kWeb / "dist" / "LICENSES.txt"));
  EXPECT_EQ(bundled("/app.map"), "");
}

/// As share/web/build.mjs does it.
TEST(Bundle, WasMadeFromItsSources) {
  std::vector<std::string> names{"build.mjs", "package-lock.json"};
  for (const auto& entry : fs::directory_iterator(kWeb / "src")) {
    names.push_back("src/" + entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  std::string sources;
  for (const std::string& name : names) sources += name + "\n" + load_bytes(kWeb / name);
  const std::string stamp = "/* amiss sources sha256 " + sha256(sources) + " */";
  EXPECT_EQ(bundled("/app.js").substr(0, stamp.size()), stamp) << "run `npm ci && node build.mjs` in share/web";
}

TEST(Bundle, NamesTheLicencesOfWhatIsInside) {
  const std::string_view licences = bundled("/licences.txt");
  EXPECT_NE(licences.find("three 0."), std::string_view::npos);
  EXPECT_NE(licences.find("The MIT License"), std::string_view::npos);
}

TEST(Bundle, AsksNobodyElse) {
  for (const Asset& asset : bundle()) {
    if (asset.route == "/licences.txt") continue;
    for (const char* word : {"src=\"http", "href=\"http", "url(http", "@import", "sourceMappingURL"}) {
      EXPECT_EQ(asset.bytes.find(word), std::string_view::npos) << asset.route << ": " << word;
    }
  }
}

}  // namespace
}  // namespace amiss::page
