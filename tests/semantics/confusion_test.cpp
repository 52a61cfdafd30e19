#include "semantics/confusion.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "core/result.hpp"
#include "core/temporary_folder.hpp"

namespace amiss::semantics {
namespace {

using C = SemanticClass;

Confusion sample() {
  Confusion confusion;
  const std::vector<C> truth{C::kWall, C::kWall, C::kWall, C::kTable, C::kTable, C::kUnlabelled};
  const std::vector<C> labelled{C::kWall, C::kWall, C::kTable, C::kTable, C::kUnlabelled, C::kBed};
  confusion.add(truth, labelled);
  return confusion;
}

TEST(Confusion, IouByHand) {
  const Confusion confusion = sample();
  EXPECT_EQ(confusion.total(), 5U);  // what has no true class is left out
  EXPECT_DOUBLE_EQ(confusion.iou(C::kWall).value(), 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(confusion.iou(C::kTable).value(), 1.0 / 3.0);
  EXPECT_FALSE(confusion.iou(C::kBed).has_value());
  EXPECT_DOUBLE_EQ(confusion.mean_iou(), 0.5);
  EXPECT_DOUBLE_EQ(confusion.accuracy(), 0.6);
}

TEST(Confusion, OfNothing) {
  EXPECT_EQ(Confusion().mean_iou(), 0.0);
  EXPECT_EQ(Confusion().accuracy(), 0.0);
}

TEST(Confusion, FileReadsBack) {
  const amiss::test::TemporaryFolder folder;
  save_confusion(folder.path() / "confusion.tsv", sample());
  EXPECT_EQ(load_confusion(folder.path() / "confusion.tsv"), sample());
}

TEST(Confusion, BrokenFilesNameTheLine) {
  const auto why = [](const std::string& text) {
    try {
      (void)parse_confusion(text, "c.tsv");
    } catch (const InputError& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_NE(why("").find("c.tsv"), std::string::npos);
  EXPECT_NE(why("true\twall\nwall\tmany\n").find("c.tsv:2: 'many'"), std::string::npos);
  EXPECT_NE(why("true\twall\nwall\t-1\n").find("c.tsv:2: '-1'"), std::string::npos);
  EXPECT_NE(why("true\twall\nwall\t1\t2\n").find("c.tsv:2: 3 cells"), std::string::npos);
  EXPECT_NE(why("true\twal\n").find("c.tsv:1: 'wal'"), std::string::npos);
  EXPECT_NE(why("wall\ttable\n").find("c.tsv:1"), std::string::npos);
}

TEST(Confusion, DifferentLengthsAreRefused) {
  Confusion confusion;
  EXPECT_THROW(confusion.add(std::vector<C>{C::kWall}, std::vector<C>{}), ArgumentError);
}

}  // namespace
}  // namespace amiss::semantics
