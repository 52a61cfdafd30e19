#include "experiment/table_markup.hpp"

#include <gtest/gtest.h>

namespace amiss::experiment {
namespace {

const Table kTable{{"room", "f1"}, {{"a|b", "0.5"}, {"a|b", "0.6"}, {"<c>", "1"}}};

TEST(TableMarkup, MarkdownHasARuleAndEscapesItsLines) {
  EXPECT_EQ(to_markdown(kTable), "| room | f1 |\n| --- | --- |\n| a\\|b | 0.5 |\n| a\\|b | 0.6 |\n| <c> | 1 |\n");
}

TEST(TableMarkup, PageShowsGroupsAndEscapesTexts) {
  const std::string page = to_page("T & x", {"five < six"}, kTable);
  EXPECT_NE(page.find("<h1>T &amp; x</h1>"), std::string::npos);
  EXPECT_NE(page.find("<p>five &lt; six</p>"), std::string::npos);
  EXPECT_NE(page.find("<tr class=\"group\"><td>a|b</td><td>0.5</td></tr>\n<tr><td>a|b</td><td>0.6</td></tr>"),
            std::string::npos);
  EXPECT_NE(page.find("<tr class=\"group\"><td>&lt;c&gt;</td><td>1</td></tr>"), std::string::npos);
  EXPECT_EQ(page.find("src="), std::string::npos) << "nothing is loaded";
}

}  // namespace
}  // namespace amiss::experiment
