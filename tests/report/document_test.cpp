#include "report/document.hpp"

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

#include "core/temporary_folder.hpp"

namespace amiss::report {
namespace {

bool has(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

TEST(Document, HoldsWhatItWasGivenInOrderAndEscaped) {
  Document page("a < b");
  page.heading("one & two");
  page.begin_table({"x", "<y>"});
  page.row({"1", "\"2\""});
  page.row({"3", "4"}, RowStyle::kBad);
  page.row({"5", "6"}, RowStyle::kGroup);
  page.end_table();
  page.begin_details("more", true);
  page.preformatted("</pre>");
  page.end_details();
  page.drawing("<svg/>", "id-1", "drawn");
  const std::string html = page.to_html();
  std::size_t at = 0;
  for (const char* part :
       {"<title>a &lt; b</title>", "<h1>a &lt; b</h1>", "<h2>one &amp; two</h2>", "<th>x</th><th>&lt;y&gt;</th>",
        "<tr><td>1</td><td>&quot;2&quot;</td></tr>", "<tr class=\"bad\"><td>3</td>", "<tr class=\"group\"><td>5</td>",
        "</table>", "<details open><summary>more</summary>", "<pre>&lt;/pre&gt;</pre>", "</details>",
        "<figure id=\"id-1\"><svg/><figcaption>drawn", "</body></html>"}) {
    at = html.find(part, at);
    ASSERT_NE(at, std::string::npos) << part;
  }
  EXPECT_TRUE(has(html, "default-src 'none'"));
  for (const char* word : {"http:", "https:", "<script", "src="}) EXPECT_FALSE(has(html, word)) << word;
}

TEST(Document, PicturesAreInsideAndNoWiderThanAsked) {
  const test::TemporaryFolder folder;
  const auto size_of = [&](int width_px) {
    Document page("pictures");
    page.picture(folder.path() / "wide.png", "wide & high", width_px);
    const std::string html = page.to_html();
    EXPECT_TRUE(has(html, "<img alt=\"wide &amp; high\" src=\"data:image/jpeg;base64,/9j/"));
    return html.size();
  };
  cv::Mat noise(400, 1200, CV_8UC3);
  cv::randu(noise, 0, 255);
  cv::imwrite((folder.path() / "wide.png").string(), noise);
  EXPECT_GT(size_of(1200), 2 * size_of(600));
  EXPECT_EQ(size_of(1200), size_of(5000)) << "never enlarged";
  Document page("none");
  page.picture(folder.path() / "none.png", "lost");
  EXPECT_TRUE(has(page.to_html(), "<p>lost: none.png is not there</p>"));
}

}  // namespace
}  // namespace amiss::report
