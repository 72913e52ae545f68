// The sentences on what changed in a core that describes itself, and in its runs.
#include "tools/described/core_verdict.h"

#include <gtest/gtest.h>

#include "tools/app/library/difference_group.h"
#include "tools/described/judged_run.h"

namespace hyrax {
namespace {

TEST(DescribedCoreVerdict, NamesAChangedDefaultAndTheLinesOfAChangedStep) {
  const auto change = [](const char* detail, std::int64_t line) {
    DescribedChange made;
    made.detail = detail;
    made.line = line;
    return made;
  };
  DescribedCoreVerdict verdict;
  EXPECT_EQ(verdict.sentence(), "");
  verdict.changes = {change("gravity = 1000;", 7), change("vy *= -0.6;", 18)};
  EXPECT_EQ(verdict.sentence(), "the core changed at lines 7 and 18");
  verdict.changes.push_back(change("gravity 980 -> 1000", 0));
  EXPECT_EQ(verdict.sentence(), "gravity 980 -> 1000") << "the step is the same";
  verdict.differences.resize(1);
  EXPECT_EQ(verdict.sentence(), "gravity 980 -> 1000; the core changed at lines 7 and 18");
}

TEST(DescribedDifferences, AreSaidOfTheRowsThatAreKnown) {
  DescribedRun known, unknown;
  for (DescribedRun* const run : {&known, &unknown}) {
    run->comparison.emplace();
    run->comparison->difference = DifferenceClass::values;
    run->comparison->has_px = true;
  }
  known.comparison->distance.largest = WorstDistance{0.25, 3, 0.5};
  EXPECT_EQ(consequence_sentence(make_group({}, {&known})),
            "Values differ, contacts do not (class values): at most 0.25 px apart, no contact moved.");
  unknown.comparison->distance.has_unknown_rows = true;
  unknown.comparison->contacts.moved = 2;
  EXPECT_EQ(
      consequence_sentence(make_group({}, {&known, &unknown})),
      "Values differ (class values): at most 0.25 px apart where the rows are known, 2 contacts moved.");
}

}  // namespace
}  // namespace hyrax
