// Which core is the candidate and which the base, wherever a card names them.
#include "tools/hyrax-compare/card_report.h"

#include <gtest/gtest.h>

#include "tests/unit/sim/result/described.h"

namespace hyrax {
namespace {

Result some_card() {
  const Table lines{"card", "a library of 2", {{"line", "", "", std::vector<std::string>{"library"}}}};
  return {.tables = {{"changes", "what changed", {}}},
          .figures = {{.title = "rest"}},
          .verdict = {.text = {lines}, .brief = "no bit differs"},
          .summary = {{"library", "", {{"same", "1", "", std::vector{2.0}}}, JsonShape::one}}};
}

TEST(CardReport, NamesTheCandidateFirst) {
  const BeforeAfter<std::string> headers{.before = "old/base.h", .after = "new/candidate.h"};
  expect_approved("tests/unit/tools/report/card.txt",
                  card_text(some_card(), headers) + card_json(some_card(), headers) +
                      to_text(result_json(shown_card(some_card(), headers)), 1) + "\n");
  EXPECT_EQ(shown_card(some_card(), {"old/physics.h", "new/physics.h"}).title,
            "physics.h: candidate against base");
}

}  // namespace
}  // namespace hyrax
