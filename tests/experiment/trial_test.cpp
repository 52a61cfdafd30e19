#include "experiment/trial.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/result.hpp"
#include "core/temporary_folder.hpp"

namespace amiss::experiment {
namespace {

Spec spec() {
  Spec spec;
  spec.name = "test";
  spec.worlds = {"flat_90", "lab_30"};
  spec.methods = {"dynamic", "static"};
  spec.objects = {1, 3, 5, 7};
  spec.scatter_seed = 100;
  return spec;
}
const std::map<std::string, std::string> kKeys{{"flat_90", "a"}, {"lab_30", "b"}};

TEST(Trials, AreAllCombinationsWithDifferentIds) {
  const auto trials = trials_of(spec(), kKeys, "p");
  ASSERT_EQ(trials.size(), 160U);
  std::set<std::string> ids;
  for (const Trial& t : trials) ids.insert(t.id);
  EXPECT_EQ(ids.size(), 160U);
  EXPECT_EQ(trials_of(spec(), kKeys, "p"), trials);
}

TEST(Trials, OfABatchShareThePlacesOfTheirObjects) {
  std::map<std::pair<std::string, int>, std::set<std::uint64_t>> places, seeds;
  for (const Trial& t : trials_of(spec(), kKeys, "p")) {
    places[{t.world, t.objects}].insert(t.scatter_seed);
    seeds[{t.world, t.objects}].insert(t.seed);
  }
  for (const auto& [batch, scatter] : places) EXPECT_EQ(scatter.size(), 1U);
  for (const auto& [batch, view] : seeds) EXPECT_EQ(view.size(), 10U) << "view triangles differ from run to run";
}

TEST(Trials, IdsDependOnWorldKeyTimeLimitAndProgram) {
  const Trial before = trials_of(spec(), kKeys, "p").front();
  EXPECT_NE(trials_of(spec(), {{"flat_90", "c"}, {"lab_30", "b"}}, "p").front().id, before.id);
  EXPECT_EQ(trials_of(spec(), {{"flat_90", "a"}, {"lab_30", "c"}}, "p").front().id, before.id);
  EXPECT_NE(trials_of(spec(), kKeys, "q").front().id, before.id) << "a changed program resumes nothing of the old";
  Spec longer = spec();
  longer.time_limit_s += 1.0;
  EXPECT_NE(trials_of(longer, kKeys, "p").front().id, before.id);
}

TEST(Trials, ArgumentsSayAllThatTheTrialIs) {
  Spec with_params = spec();
  with_params.params = {{"search.look", "0.5"}};
  const Trial trial{"id", "lab_30", "static", 5, 7, 105};
  const auto arguments = arguments_of(trial, with_params, "out");
  for (const char* word : {"--world=lab_30", "--method=static", "--objects=5", "--seed=7", "--scatter-seed=105",
                           "--time-limit=3600", "--set=search.look=0.5", "--out=out", "--threads=1"}) {
    EXPECT_EQ(std::count(arguments.begin(), arguments.end(), word), 1) << word;
  }
}

TEST(Trials, PlanIsReadBack) {
  const auto trials = trials_of(spec(), kKeys, "p");
  EXPECT_EQ(parse_plan(to_tsv(trials), "plan.tsv"), trials);
}

TEST(Trials, BrokenPlansAreRefusedByLine) {
  const std::string plan = to_tsv(trials_of(spec(), kKeys, "p"));
  EXPECT_EQ(test::sentence_of<InputError>([] { (void)parse_plan("nothing", "plan.tsv"); }),
            "plan.tsv:1: is no plan of an experiment");
  const std::string cut = plan.substr(0, plan.size() - 8);
  EXPECT_NE(test::sentence_of<InputError>([&] { (void)parse_plan(cut, "plan.tsv"); }).find("plan.tsv:161: "),
            std::string::npos);
}

}  // namespace
}  // namespace amiss::experiment
