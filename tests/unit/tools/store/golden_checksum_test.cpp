// The checksums by which a golden file is compared without reading it.
#include "tools/store/golden_summary.h"

#include <gtest/gtest.h>

#include <functional>

#include "tests/unit/sim/compare/played_run.h"
#include "tests/unit/tools/store/temp_folder.h"
#include "tools/files/failure.h"

namespace hyrax {
namespace {

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

TEST(ContentsChecksum, SeesEveryChangeOfAShortRun) {
  StoredRun run = kept_run(eventful_fling());
  run.final.vx_px_per_s = 0.0;
  EXPECT_EQ(unseen(run, kChangesOfAnyRun), 0u);
  EXPECT_EQ(unseen(run, {[](StoredRun& changed) { one_ulp_up(changed.rows.t_s[7]); },
                         [](StoredRun& changed) { changed.final.vx_px_per_s = -0.0; }}),
            0u);
}

TEST(ContentsChecksum, SeesEveryChangeOfALongRun) {
  Scenario scenario = eventful_fling();
  scenario.length = std::int64_t{9000};
  const StoredRun run = kept_run(scenario);
  EXPECT_EQ(unseen(run, kChangesOfAnyRun), 0u);
  EXPECT_EQ(unseen(run, {[](StoredRun& changed) { changed.blocks[1].count += 1; },
                         [](StoredRun& changed) { changed.blocks[0].digest[3] ^= 1; },
                         [](StoredRun& changed) { one_ulp_up(changed.blocks[2].keyframe.row.t_s); },
                         [](StoredRun& changed) { one_ulp_up(changed.blocks[2].keyframe.timeline.comp_s); },
                         [](StoredRun& changed) { changed.blocks[1].keyframe.timeline.frames += 1; },
                         [](StoredRun& changed) { changed.blocks[1].keyframe.window.width_px += 1; },
                         [](StoredRun& changed) { changed.blocks[1].keyframe.is_held = true; }}),
            0u);
}

TEST(ContentsChecksum, IsTheSameWhetherContactsAreHeldOrNot) {
  const StoredRun run = kept_run(eventful_fling());
  StoredRun without = run;
  without.contacts.clear();
  without.replay_contacts = [&](const auto& take) {
    for (const Contact& contact : run.contacts) take(contact);
  };
  EXPECT_GT(run.contacts.size(), 0u);
  EXPECT_EQ(contents_checksum(without), contents_checksum(run));
}

TEST(ContentsChecksum, IgnoresNamesAndDescriptions) {
  const StoredRun run = kept_run(eventful_fling());
  const std::vector<Change> texts = {[](StoredRun& changed) { changed.scenario.name = "other"; },
                                     [](StoredRun& changed) { changed.scenario.description = "other"; },
                                     [](StoredRun& changed) { changed.scenario.schema = "other"; },
                                     [](StoredRun& changed) { changed.scenario.expect = Expect{}; }};
  EXPECT_EQ(unseen(run, texts), texts.size());
}

TEST(FileChecksum, IsThatOfTheBytesOfAFile) {
  const TempFolder folder;
  for (const char* const none : {"missing", "."})
    EXPECT_THROW(static_cast<void>(file_checksum(folder.at(none))), Failure);
  write_bytes(folder.at("empty"), "");
  EXPECT_EQ(file_checksum(folder.at("empty")), "99aa06d3014798d86001c324468d497f");  // XXH3-128 of nothing.
  write_bytes(folder.at("one"), "a golden file");
  write_bytes(folder.at("two"), "a golden fild");
  EXPECT_NE(file_checksum(folder.at("one")), file_checksum(folder.at("two")));
  std::string bytes;  // More than are read at once.
  for (std::size_t place = 0; place < 200'001; ++place) bytes += static_cast<char>(place * place >> 7);
  write_bytes(folder.at("long"), bytes);
  EXPECT_EQ(file_checksum(folder.at("long")), hex(digest(std::as_bytes(std::span(bytes)))));
}

}  // namespace
}  // namespace hyrax
