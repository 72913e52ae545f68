// What the study of needs says of parts, against the replay, which knows nothing of parts.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/core/core.h"
#include "sim/core/shipped_core.h"
#include "sim/replay/replay.h"
#include "sim/study/needs/needs.h"
#include "tests/unit/sim/study/clocks.h"
#include "tools/files/scenario_reader.h"

namespace hyrax {
namespace {

// Compares the replay's rows with a script's, and gathers the walls that the replay touches.
class ReplayedRows final : public RowSink {
 public:
  explicit ReplayedRows(const Scenario& scenario) {
    const Script script = script_of(scenario);
    play(script, *shipped_core().constants, AllParts(),
         [this](const ScriptFrame& frame) { script_.push_back(frame); });
    Replay run(shipped_core(), scenario, *this);
    run.play_to(std::ssize(script_));
    run.finish();
  }
  [[nodiscard]] Wants wants() const override { return {.rows_every = 1}; }
  void rows(const Columns& batch) override {
    for (std::size_t index = 0; index < batch.size(); ++index) {
      const Row row = batch.row(index);
      if (row.step == 0) continue;
      contacts_ = static_cast<std::uint8_t>(contacts_ | row.contact);
      const ScriptFrame& frame = script_.at(static_cast<std::size_t>(row.step) - 1);
      const State& script = frame.to;
      EXPECT_TRUE(same_bits(script.x_px, row.x_px) && same_bits(script.y_px, row.y_px) &&
                  same_bits(script.vx_px_per_s, row.vx_px_per_s) &&
                  same_bits(script.vy_px_per_s, row.vy_px_per_s))
          << "row " << row.step;
      // What clamps without moving the sprite by a bit is no contact to the replay.
      EXPECT_EQ(frame.contact & 15 & row.contact, row.contact & 15) << "row " << row.step;
    }
  }
  [[nodiscard]] bool touched(Wall wall) const { return touches(contacts_, wall); }
  [[nodiscard]] bool touched_any() const {
    return std::ranges::any_of(kWalls, [this](Wall wall) { return touched(wall); });
  }

 private:
  std::vector<ScriptFrame> script_;
  std::uint8_t contacts_ = 0;
};

// A wall is exercised if and only if the replay has a contact with it; friction and the rest rule only with a
// ground contact, restitution only with a contact.
bool agrees(const PartNeed& part, const ReplayedRows& replayed) {
  if (!part.model_part) return true;
  const bool is_exercised = part.need != Need::not_exercised;
  switch (*part.model_part) {
    case Part::left_wall:
      return is_exercised == replayed.touched(Wall::left);
    case Part::right_wall:
      return is_exercised == replayed.touched(Wall::right);
    case Part::top_wall:
      return is_exercised == replayed.touched(Wall::top);
    case Part::ground:
      return is_exercised == replayed.touched(Wall::ground);
    case Part::friction:
    case Part::rest_rule:
      return !is_exercised || replayed.touched(Wall::ground);
    case Part::restitution:
      return !is_exercised || replayed.touched_any();
    case Part::gravity:
    case Part::drag:
      return true;
  }
  return false;
}

// Long runs are cut: the script that parts are left out of is, too.
constexpr std::int64_t kFramesMax = 5'000;

std::vector<Scenario> library() {
  std::vector<Scenario> scenarios;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(std::string(HYRAX_SOURCE_DIR) + "/scenarios")) {
    if (entry.path().extension() != ".json") continue;
    Scenario scenario = load_scenario(entry.path().string());
    const auto* const length = std::get_if<std::int64_t>(&scenario.length);
    if (length == nullptr || *length <= kFramesMax) scenarios.push_back(std::move(scenario));
  }
  return scenarios;
}

TEST(NeedsOfTheLibrary, AgreeWithTheWallsThatTheReplayTouches) {
  const std::vector<Scenario> scenarios = library();
  EXPECT_GT(scenarios.size(), 60u);
  for (const Scenario& scenario : scenarios) {
    SCOPED_TRACE(scenario.name);
    const ReplayedRows replayed(scenario);
    NeedsOptions options;
    options.cost.repetitions = 1;
    const ScenarioNeeds needs =
        study_needs(shipped_core(), scenario, options,
                    [now_ns = std::int64_t{0}]() mutable { return now_ns += 100'000; });
    for (const PartNeed& part : needs.parts)
      EXPECT_TRUE(agrees(part, replayed)) << part.part << ", " << name_of(part.need);
  }
}

TEST(NeedsOfTheLibrary, WouldNotAgreeIfAWallWereMistaken) {
  const ReplayedRows first_fling(
      load_scenario(std::string(HYRAX_SOURCE_DIR) + "/scenarios/flings/first-fling.json"));
  const auto with = [&](Part part, Need need) {
    return agrees({.part = "", .model_part = part, .difference = {}, .need = need}, first_fling);
  };
  for (const Part part : {Part::right_wall, Part::ground}) {
    EXPECT_TRUE(with(part, Need::below));
    EXPECT_FALSE(with(part, Need::not_exercised));
  }
  for (const Part part : {Part::left_wall, Part::top_wall}) {
    EXPECT_TRUE(with(part, Need::not_exercised));
    EXPECT_FALSE(with(part, Need::below));
  }
}

}  // namespace
}  // namespace hyrax
