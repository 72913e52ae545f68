// The summary of a golden file, and the checksums by which it is compared without reading it.
#include <gtest/gtest.h>

#include <functional>

#include "tests/unit/sim/compare/played_run.h"
#include "tests/unit/sim/result/described.h"
#include "tests/unit/tools/store/stored_flings.h"
#include "tests/unit/tools/store/temp_folder.h"
#include "tools/files/failure.h"
#include "tools/files/summary_text.h"
#include "tools/store/golden_summary.h"

namespace hyrax {
namespace {

constexpr char kContents[] = "0123456789abcdef0123456789abcdef";
constexpr char kFile[] = "fedcba9876543210fedcba9876543210";
constexpr char kHash[] = "c0ea1a610d86b14114d3cef7071362e5";

StoredRun some_run() {
  StoredRun run;
  run.scenario = fling_at(60.0, 600);
  run.physics = "hyrax-physics/1";
  run.steps = 600;
  run.state_hash = kHash;
  run.contacts = {{.step = 110,
                   .last_step = 110,
                   .wall = Wall::right,
                   .vx_before_px_per_s = 400.0,
                   .vy_before_px_per_s = -300.0},
                  {.step = 312, .last_step = 600}};
  return run;
}

Waypoints some_waypoints() {
  return {.apex = {.step = 67, .x_px = 1200.0, .y_px = 123.4567894},
          .at_seconds = {{.step = 60, .x_px = -1e-9, .y_px = -0.5}, {.step = 120, .x_px = 3.0, .y_px = 4.0}}};
}

RunSummary some_summary() {
  RunSummary summary;
  summary.contacts = {0, 1, 0, 1};
  summary.final = {
      .step = 600, .t_s = 10.0, .x_px = 643.5, .y_px = 952.0, .vx_px_per_s = -0.0, .vy_px_per_s = 0.1};
  summary.at_rest_since_s = 5.25;
  return summary;
}

std::string text_of(const StoredRun& run, const RunSummary& summary, const std::string& reason,
                    const std::string& margin = "") {
  return golden_summary_text(run, summary, some_waypoints(), reason, margin, {kContents, kFile, ""});
}

TEST(GoldenSummary, OfAShortRunAndOfOneWithManyContactsIsTheOneApproved) {
  StoredRun restless = some_run();
  restless.contacts.clear();
  for (std::int64_t step = 1; step <= 1000; ++step)
    restless.contacts.push_back({.step = step, .last_step = step});
  RunSummary unsettled = some_summary();
  unsettled.at_rest_since_s.reset();
  expect_approved("tests/unit/tools/store/golden_summary.txt",
                  text_of(some_run(), some_summary(), "a longer throw") + "\n" +
                      text_of(restless, unsettled, "several lines", "wide"));
}

TEST(GoldenSummary, HasItsChecksumsAndIsKnownByItsFirstLineItsStateHashAndItsLastLine) {
  const std::string text = text_of(some_run(), some_summary(), "a longer throw", "wide");
  EXPECT_TRUE(has_checksums(text, kContents, kFile));
  EXPECT_EQ(summary_file_checksum(text), kFile);
  EXPECT_FALSE(has_checksums(text, kFile, kFile));
  EXPECT_FALSE(has_checksums(text, kContents, kContents));
  EXPECT_FALSE(has_checksums("", kContents, kFile));
  EXPECT_TRUE(is_summary(text));
  EXPECT_FALSE(is_summary("notes\n" + text));
  EXPECT_FALSE(is_summary(text + "more\n"));
  EXPECT_FALSE(is_summary(std::string(text).replace(text.find(kHash), 1, "?")));
}

TEST(GoldenSummary, LosesItsChecksumIfAnyBitIsFlipped) {
  const std::string text = text_of(some_run(), some_summary(), "x");
  const std::size_t reason = text.find("reason: x") + 8;
  for (std::size_t place = 0; place < text.size(); ++place)
    for (int bit = 0; bit < 8; ++bit) {
      std::string damaged = text;
      damaged[place] = static_cast<char>(damaged[place] ^ 1 << bit);
      EXPECT_EQ(has_checksums(damaged, kContents, kFile), place == reason && damaged[place] != '\n')
          << place << " bit " << bit;
    }
}

TEST(SummaryFileChecksum, IsNotFoundInATruncatedOrLongerTextAndHasOnlyHexDigits) {
  const std::string text = text_of(some_run(), some_summary(), "x");
  std::vector<std::string> damaged = {text + "\n", text + "more\n"};
  for (std::size_t length = 0; length < text.size(); ++length) damaged.push_back(text.substr(0, length));
  for (const char wrong : {'g', 'A', ' ', '\n', '\0'})
    for (const std::size_t from_end : {2u, 17u, 33u})
      damaged.push_back(std::string(text).replace(text.size() - from_end, 1, 1, wrong));
  for (const std::string& each : damaged) EXPECT_EQ(summary_file_checksum(each), std::nullopt) << each;
}

using Change = std::function<void(StoredRun&)>;

// How many of the changes leave the hash of the contents unchanged.
std::size_t unseen(const StoredRun& run, const std::vector<Change>& changes) {
  return static_cast<std::size_t>(std::count_if(changes.begin(), changes.end(), [&](const Change& change) {
    StoredRun changed = run;
    change(changed);
    return contents_checksum(changed) == contents_checksum(run);
  }));
}

void one_ulp_up(double& value) { value = std::nextafter(value, std::numeric_limits<double>::infinity()); }

const std::vector<Change> kChangesOfAnyRun = {
    [](StoredRun& run) { run.scenario.record_every = 2; },
    [](StoredRun& run) { one_ulp_up(run.scenario.start.x_px); },
    [](StoredRun& run) { run.physics = "hyrax-physics/2"; },
    [](StoredRun& run) { run.steps += 1; },
    [](StoredRun& run) { run.state_hash.back() ^= 1; },
    [](StoredRun& run) { one_ulp_up(run.final.vy_px_per_s); },
    [](StoredRun& run) { run.final.contact ^= 1; },
    [](StoredRun& run) { run.contacts_total += 1; },
    [](StoredRun& run) { run.contacts.pop_back(); },
    [](StoredRun& run) { run.contacts.front().last_step += 1; },
    [](StoredRun& run) { one_ulp_up(run.contacts.front().overshoot_px); },
    [](StoredRun& run) { run.inputs.front().frame += 1; },
    [](StoredRun& run) { run.inputs.front().action = Grab{}; },
    [](StoredRun& run) { one_ulp_up(std::get<Hitch>(run.inputs.front().action).dt_s); },
};

TEST(ContentsChecksum, SeesEveryChangeOfAShortRunAndOfALongOne) {
  Scenario scenario = eventful_fling();
  StoredRun short_run = kept_run(scenario);
  short_run.final.vx_px_per_s = 0.0;
  scenario.length = std::int64_t{9000};
  StoredRun long_run = kept_run(scenario);
  for (StoredRun* const run : {&short_run, &long_run}) EXPECT_EQ(unseen(*run, kChangesOfAnyRun), 0u);
  EXPECT_EQ(unseen(short_run, {[](StoredRun& run) { one_ulp_up(run.rows.t_s[7]); },
                               [](StoredRun& run) { run.final.vx_px_per_s = -0.0; }}),
            0u);
  EXPECT_EQ(unseen(long_run, {[](StoredRun& run) { run.blocks[1].count += 1; },
                              [](StoredRun& run) { run.blocks[0].digest[3] ^= 1; },
                              [](StoredRun& run) { one_ulp_up(run.blocks[2].keyframe.row.t_s); },
                              [](StoredRun& run) { one_ulp_up(run.blocks[2].keyframe.timeline.comp_s); },
                              [](StoredRun& run) { run.blocks[1].keyframe.timeline.frames += 1; },
                              [](StoredRun& run) { run.blocks[1].keyframe.window.width_px += 1; },
                              [](StoredRun& run) { run.blocks[1].keyframe.is_held = true; }}),
            0u);
}

TEST(ContentsChecksum, IgnoresNamesAndDescriptionsAndWhetherContactsAreHeld) {
  const StoredRun run = kept_run(eventful_fling());
  EXPECT_GT(run.contacts.size(), 0u);
  const std::vector<Change> changes = {[](StoredRun& changed) { changed.scenario.name = "other"; },
                                       [](StoredRun& changed) { changed.scenario.description = "other"; },
                                       [](StoredRun& changed) { changed.scenario.schema = "other"; },
                                       [](StoredRun& changed) { changed.scenario.expect = Expect{}; },
                                       [&](StoredRun& changed) {
                                         changed.contacts.clear();
                                         changed.replay_contacts = [&](const auto& take) {
                                           for (const Contact& contact : run.contacts) take(contact);
                                         };
                                       }};
  EXPECT_EQ(unseen(run, changes), changes.size());
}

TEST(FileChecksum, IsThatOfTheBytesOfAFile) {
  const TempFolder folder;
  for (const char* const none : {"missing", "."})
    EXPECT_THROW(static_cast<void>(file_checksum(folder.at(none))), Failure);
  write_bytes(folder.at("empty"), "");
  EXPECT_EQ(file_checksum(folder.at("empty")), "99aa06d3014798d86001c324468d497f");  // XXH3-128 of nothing.
  std::string bytes;  // More than are read at once.
  for (std::size_t place = 0; place < 200'001; ++place) bytes += static_cast<char>(place * place >> 7);
  write_bytes(folder.at("long"), bytes);
  EXPECT_EQ(file_checksum(folder.at("long")), hex(digest(std::as_bytes(std::span(bytes)))));
}

}  // namespace
}  // namespace hyrax
