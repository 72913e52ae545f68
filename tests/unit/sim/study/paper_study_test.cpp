// The study paper: verdicts that follow from numbers, and the comparison with expected verdicts.
#include <gtest/gtest.h>

#include <algorithm>

#include "sim/core/shipped_core.h"
#include "sim/study/paper/paper_claim.h"
#include "sim/study/study.h"

namespace hyrax {
namespace {

TEST(SpeedClaim, HoldsOnlyForAFastStep) {
  EXPECT_EQ(speed_claims(1.66e-5).front().verdict, ClaimVerdict::holds);
  EXPECT_EQ(speed_claims(1.67e-5).front().verdict, ClaimVerdict::does_not_hold);
}

// The measures must not depend on a start: neither the seed, nor how fast throws are, nor the frame rates.
TEST(AccuracyClaims, KeepTheirVerdictsWhateverTheStarts) {
  const std::vector<Claim> expected = accuracy_claims(shipped_core());
  std::uint64_t seed = 0;
  for (const double fastest_px_per_s : {500.0, 3000.0})
    for (const double slowest_hz : {8.0, 15.0, 40.0}) {
      seed = seed % 3 + 1;
      const std::vector<Claim> claims = accuracy_claims(
          shipped_core(), {.seed = seed, .fastest_px_per_s = fastest_px_per_s, .slowest_hz = slowest_hz});
      ASSERT_EQ(claims.size(), expected.size());
      for (std::size_t index = 0; index < claims.size(); ++index)
        EXPECT_EQ(claims[index].verdict, expected[index].verdict)
            << claims[index].id << ": " << claims[index].number << ", seed " << seed << ", "
            << fastest_px_per_s << " px/s, " << slowest_hz << " Hz";
    }
}

// One start can lock its bounces, or settle in one place by chance.
TEST(EnergyClaims, KeepTheirVerdictsWhateverTheStarts) {
  for (const std::uint64_t seed : {7u, 8u}) {
    const std::vector<Claim> claims = energy_claims(shipped_core(), {.seed = seed});
    EXPECT_EQ(claims[0].verdict, ClaimVerdict::does_not_hold);
    EXPECT_EQ(claims[1].verdict, ClaimVerdict::holds_when);
    EXPECT_NEAR(claims[1].number, 0.72, 0.12) << "explicit Euler is better in 258 of 1000";
    EXPECT_GT(claims[0].range.value().back(), 0.1) << "a start with vy = 0 has 0.018";
    EXPECT_TRUE(claims[1].range);
    EXPECT_EQ(frame_rate_claim(shipped_core(), {.seed = seed}).verdict, ClaimVerdict::does_not_hold);
  }
}

// A step takes 1 ns.
std::int64_t fake_now_ns() {
  static std::int64_t now_ns = 0;
  return now_ns += 2000;
}

Result run_paper(const std::optional<ExpectedVerdicts>& expected) {
  const auto paper = std::find_if(studies().begin(), studies().end(),
                                  [](const Study& study) { return study.name == "paper"; });
  return paper->run({.core = shipped_core(), .expected = expected, .now_ns = fake_now_ns});
}

// Without expected verdicts: run once.
const Result& plain_paper() {
  static const Result result = run_paper({});
  return result;
}

std::vector<std::string> values(const Table& table, const std::string& name) {
  for (const Column& column : table.columns)
    if (column.name == name) return std::get<std::vector<std::string>>(column.values);
  return {};
}

// The verdicts that this core has.
ExpectedVerdicts own_verdicts() {
  const Table& claims = plain_paper().tables.front();
  const std::vector<std::string> names = values(claims, "claim"), verdicts = values(claims, "verdict");
  ExpectedVerdicts expected{.path = "expected.json"};
  for (std::size_t row = 0; row < names.size(); ++row)
    expected.verdicts.emplace_back(names[row], verdicts[row]);
  return expected;
}

std::string& verdict_on(const std::string& name, ExpectedVerdicts& expected) {
  return std::find_if(expected.verdicts.begin(), expected.verdicts.end(),
                      [&](const auto& entry) { return entry.first == name; })
      ->second;
}

// The fields of one claim in the picture: section, sentence, verdict, expected (if there is a file), number.
std::vector<ListField> shown_claim(const Result& result, const std::string& name) {
  const std::vector<std::string> names = values(result.tables.front(), "claim");
  const auto row = static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
  return std::get<Listing>(result.figures.front().body).rows[row];
}

TEST(Paper, OnlyAnotherOrMissingVerdictIsBrokenAndColoured) {
  EXPECT_EQ(shown_claim(plain_paper(), "2.3-energy").size(), 4u);
  ExpectedVerdicts expected = own_verdicts();
  verdict_on("5-restitution", expected) = "not measured";
  verdict_on("5-air-drag", expected) = "does not hold";
  std::erase_if(expected.verdicts, [](const auto& entry) { return entry.first == "5-gravity"; });
  const Result result = run_paper(expected);
  EXPECT_EQ(result.verdict.broken,
            (std::vector<std::string>{
                "5-gravity: holds, but expected.json has no verdict for it",
                "5-restitution: holds, but expected.json expects: not measured (the core's value: 0.6)",
                "5-air-drag: holds, but expected.json expects: does not hold (the core's value: 0.999)"}));
  EXPECT_EQ(shown_claim(result, "5-restitution")[3].fill, Tone::hairline);
  EXPECT_EQ(shown_claim(result, "5-gravity")[3].text, "no verdict");
  const std::vector<ListField> drag = shown_claim(result, "5-air-drag");
  ASSERT_EQ(drag.size(), 5u);
  EXPECT_EQ(drag[2].fill, Tone::good);
  EXPECT_EQ(drag[3].text, "does not hold");
  EXPECT_EQ(drag[3].fill, Tone::bad);
  const ListField same = shown_claim(result, "2.2-stokes")[3];
  EXPECT_EQ(same.text, "holds when");
  EXPECT_EQ(same.fill, Tone::none);
}

TEST(Paper, UnknownClaimsAndVerdictsAreRefusedAllAtOnce) {
  ExpectedVerdicts expected = own_verdicts();
  expected.verdicts.insert(expected.verdicts.begin(), {"9-moon", "holds"});
  verdict_on("5-gravity", expected) = "maybe";
  expected.verdicts.emplace_back("9-sun", "maybe");
  try {
    (void)run_paper(expected);
    FAIL() << "not refused";
  } catch (const RequestRefused& refused) {
    EXPECT_STREQ(refused.what(),
                 "expected.json: /verdicts/5-gravity: unknown verdict (found maybe); allowed: holds, holds "
                 "when, does not hold, not measured\n"
                 "expected.json: /verdicts: unknown claim (found 9-moon, 9-sun); `hyrax-sim study paper` "
                 "prints all claims");
  }
}

TEST(Paper, TheClaimOnBouncesSaysThatThePositionStandsStill) {
  const ListField sentence = shown_claim(plain_paper(), "3.2.2-infinite-bounce")[1];
  EXPECT_NE(sentence.detail.find("the position stands still"), std::string::npos) << sentence.detail;
  EXPECT_LE(sentence.detail.size(), 122u) << "the picture has no room for more";
}

}  // namespace
}  // namespace hyrax
