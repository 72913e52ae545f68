// Which core is the candidate and which the base, wherever a card names them.
#include "tools/hyrax-compare/card_report.h"

#include <gtest/gtest.h>

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
  EXPECT_EQ(card_text(some_card(), headers),
            "new/candidate.h against old/base.h\n  a library of 2\n  library\n"
            "  consequence     no bit differs\n");
  const Json json = parse_json(card_json(some_card(), headers), "card");
  EXPECT_EQ(*json.find("candidate")->get<std::string>(), "new/candidate.h");
  EXPECT_EQ(*json.find("base")->get<std::string>(), "old/base.h");
  EXPECT_NE(json.find("library"), nullptr);
  const ShownResult shown = shown_card(some_card(), headers);
  EXPECT_EQ(shown.title, "candidate.h against base.h");
  EXPECT_EQ(shown.subtitle, "a library of 2");
  EXPECT_EQ(std::get<std::string>(shown.verdict.text[0]), "no bit differs");
  EXPECT_EQ(std::get<Table>(shown.verdict.text[1]).name, "card");
  EXPECT_EQ(shown.tables[0].name, "changes");
  EXPECT_EQ(shown.figures[0].title, "rest");
  EXPECT_EQ(shown.origin, (std::vector<std::pair<std::string, std::string>>{{"candidate", "new/candidate.h"},
                                                                            {"base", "old/base.h"}}));
  EXPECT_EQ(shown_card(some_card(), {"old/physics.h", "new/physics.h"}).title,
            "physics.h: candidate against base");
}

}  // namespace
}  // namespace hyrax
