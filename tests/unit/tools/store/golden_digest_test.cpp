// The text beside a golden file.
#include "tools/store/golden_digest.h"

#include <gtest/gtest.h>

#include "tests/unit/tools/store/stored_flings.h"
#include "tools/store/trajectory_format.h"

namespace hyrax {
namespace {

constexpr char kHash[] = "c0ea1a610d86b14114d3cef7071362e5";

StoredRun some_run() {
  StoredRun run;
  run.scenario = fling_at(60.0, 600);
  run.physics = "hyrax-physics/1";
  run.steps = 600;
  run.state_hash = kHash;
  Contact bounce;
  bounce.step = bounce.last_step = 110;
  bounce.wall = Wall::right;
  Contact rest;
  rest.step = 312;
  rest.last_step = 600;
  run.contacts = {bounce, rest};
  return run;
}

RunSummary some_summary() {
  RunSummary summary;
  summary.contacts = {0, 1, 0, 1};
  summary.final = {
      .step = 600, .t_s = 10.0, .x_px = 643.5, .y_px = 952.0, .vx_px_per_s = -0.0, .vy_px_per_s = 0.1};
  summary.at_rest_since_s = 5.25;
  return summary;
}

TEST(GoldenDigest, IsMadeToBeReadInAReview) {
  EXPECT_EQ(golden_digest_text(some_run(), some_summary(), "a longer throw"),
            "scenario: fling\n"
            "physics: hyrax-physics/1\n"
            "steps: 600\n"
            "state hash: c0ea1a610d86b14114d3cef7071362e5\n"
            "contacts: left 0, right 1, top 0, ground 1\n"
            "  110 right\n"
            "  312 .. 600 ground\n"
            "end: t 10 s\n"
            "  x  643.5 px  0x1.41cp+9\n"
            "  y  952 px  0x1.dcp+9\n"
            "  vx -0 px/s  -0x0p+0\n"
            "  vy 0.1 px/s  0x1.999999999999ap-4\n"
            "at rest since: 5.25 s\n"
            "reason: a longer throw\n");
}

TEST(GoldenDigest, SaysThatThereIsNoRest) {
  RunSummary restless = some_summary();
  restless.at_rest_since_s.reset();
  EXPECT_NE(golden_digest_text(some_run(), restless, "x").find("at rest since: never\n"), std::string::npos);
}

TEST(GoldenDigest, KeepsAReasonOfSeveralLinesInOne) {
  const std::string text = golden_digest_text(some_run(), some_summary(), "first\nstate hash: forged\nlast");
  EXPECT_TRUE(text.ends_with("reason: first state hash: forged last\n")) << text;
}

TEST(GoldenDigest, ShowsFirstAndLastOfManyContacts) {
  StoredRun run = some_run();
  run.contacts.clear();
  for (std::int64_t step = 1; step <= 1000; ++step) {
    Contact contact;
    contact.step = contact.last_step = step;
    run.contacts.push_back(contact);
  }
  const std::string text = golden_digest_text(run, some_summary(), "x");
  EXPECT_NE(text.find("  1 ground\n"), std::string::npos);
  EXPECT_NE(text.find("  20 ground\n  ... 960 more\n  981 ground\n"), std::string::npos) << text;
  EXPECT_NE(text.find("  1000 ground\n"), std::string::npos);
  EXPECT_LT(std::count(text.begin(), text.end(), '\n'), 60);
}

TEST(GoldenDigest, GivesItsReasonBack) {
  const std::string text = golden_digest_text(some_run(), some_summary(), "a longer throw", "wide");
  EXPECT_EQ(digest_reason(text), "a longer throw");
}

TEST(GoldenDigest, IsWholeWhereEveryLineIs) {
  const std::string text = golden_digest_text(some_run(), some_summary(), "x");
  EXPECT_EQ(digest_fault(text, text), std::nullopt);
}

TEST(GoldenDigest, TellsTheLineThatIsNotWhatBlessingWouldWrite) {
  const std::string text = golden_digest_text(some_run(), some_summary(), "x");
  EXPECT_EQ(digest_fault("scenario: fling\nphysics: hyrax-physics/2\n", text),
            "line 2: must be 'physics: hyrax-physics/1', is 'physics: hyrax-physics/2'");
  EXPECT_EQ(digest_fault(text + "more\n", text), "line 15: must be nothing, is 'more'");
  EXPECT_EQ(digest_fault(text.substr(0, text.size() - 1), text),
            "line 14: must be 'reason: x', is 'reason: x' without an end of line");
}

TEST(GoldenDigest, HasAFaultWhereverABitIsFlipped) {
  const std::string text = golden_digest_text(some_run(), some_summary(), "x");
  for (std::size_t place = 0; place < text.size(); ++place)
    for (int bit = 0; bit < 8; ++bit) {
      std::string damaged = text;
      damaged[place] = static_cast<char>(damaged[place] ^ 1 << bit);
      EXPECT_NE(digest_fault(damaged, text), std::nullopt) << place << " bit " << bit;
    }
}

}  // namespace
}  // namespace hyrax
