#include "sim/core/traced_stepper.h"

#include <algorithm>

#include "sim/core/contact_stepper.h"
#include "sim/core/stepper_of.h"
#include "sim/scenario/apply.h"
#include "sim/trace/step_program.h"
#include "sim/trace/step_text.h"
#include "sim/trajectory/physics_model.h"

namespace hyrax {
namespace {

bool has_further(TracedBody& body) { return !body.further_members().empty(); }
bool has_same_bytes(TracedBody& a, TracedBody& b) {
  return std::ranges::equal(std::as_bytes(a.further_members()), std::as_bytes(b.further_members()));
}

}  // namespace

std::vector<TracedBody> TracedStepper::take_bodies(CoreBody& body) const {
  std::vector<TracedBody> bodies;
  for (const auto& step : steps_) bodies.emplace_back(*step, body.state);
  for (auto traced = bodies.rbegin(); traced != bodies.rend(); ++traced) {
    if (!has_further(*traced)) continue;
    TracedBody kept = *traced;
    const std::span<std::byte> bytes = std::as_writable_bytes(kept.members());
    if (body.object.size() < bytes.size()) break;
    const auto begin = body.object.end() - std::ssize(bytes);
    std::copy(begin, body.object.end(), bytes.begin());
    body.object.erase(begin, body.object.end());
    if (same_bits({kept.x(), kept.y(), kept.vx(), kept.vy()}, body.state)) *traced = kept;
  }
  return bodies;
}

void TracedStepper::keep_bodies(std::vector<TracedBody>& bodies, const State& row,
                                std::vector<std::byte>& object) {
  for (TracedBody& traced : bodies) {
    if (!has_further(traced)) continue;
    traced.set_row(row);
    const std::span<const std::byte> bytes = std::as_bytes(traced.members());
    object.insert(object.end(), bytes.begin(), bytes.end());
  }
}

void TracedStepper::play(const Stretch& stretch, CoreBody& body, RestAnchor& rest, RowBlock& rows,
                         StretchLog& log) const {
  const State from = body.state;
  std::vector<TracedBody> bodies = take_bodies(body);
  CoreBody anchor;
  std::vector<TracedBody> anchor_bodies;
  Stretch played = stretch;
  if (stretch.anchor != nullptr) {
    anchor = *stretch.anchor;
    anchor_bodies = take_bodies(anchor);
    played.anchor = &anchor;
  }
  const std::size_t first_row = rows.size();
  StepperOver::play(played, body, rest, rows, log);
  if (!stretch.is_held) tell(stretch, from, bodies, first_row, rows, log);
  keep_bodies(bodies, body.state, body.object);
  // The rows may repeat themselves where a body does not.
  log.met_anchor = log.met_anchor && std::ranges::equal(bodies, anchor_bodies, has_same_bytes);
}

void TracedStepper::apply(const Action& action, Keyframe& now) const {
  CoreBody body{state_of(now.row), std::move(now.core_object)};
  std::vector<TracedBody> bodies = take_bodies(body);
  struct Body : TracedBody {
    Size window;
    Size sprite;
    bool is_held;
  };
  for (TracedBody& traced : bodies) {
    Body moved{traced, now.window, now.sprite, now.is_held};
    hyrax::apply(action, moved);
    traced = static_cast<const TracedBody&>(moved);
  }
  now.core_object = std::move(body.object);
  StepperOver::apply(action, now);
  keep_bodies(bodies, state_of(now.row), now.core_object);
}

namespace {

struct TracedCores {
  using Core = TracedBody;

  std::shared_ptr<const StepProgram> program;

  [[nodiscard]] TracedBody make(const State& state) const { return {*program, state}; }
};

// The walls with which no path compares a position.
std::uint8_t others_of(const StepProgram& program) {
  return static_cast<std::uint8_t>(kAllWalls & ~program.walls());
}

}  // namespace

std::optional<Core> traced_core(const TracedStep& step) {
  const auto program = make_step_program(step);
  if (!program) return std::nullopt;
  const StepFacts facts{.has_further_members = step.members.size() > kMembersOfRows};
  Core core{.name = kPhysicsModel, .walls_of_rows = others_of(*program)};
  core.stepper = std::make_shared<const StepperOf<TracedCores>>(TracedCores{program}, facts);
  if (core.walls_of_rows != 0)
    core.stepper = std::make_shared<const ContactStepper>(core.stepper, program, std::nullopt);
  return core;
}

void complete_by_step(Core& core) {
  const std::optional<TracedStep> step = read_step(core.record.step);
  core.paper_match =
      step ? match_paper(*step)
           : PaperMatch{.difference = "a step that is not known: " + std::string(core.record.why_incomplete)};
  // Then the stepper's own contacts, those of the paper's step with the constants of its class, are right.
  const bool is_listing =
      core.constants && core.paper_match.constants && same_bits(*core.constants, *core.paper_match.constants);
  if (!is_listing) core.constant_names = {};  // The step has other numbers than its class.
  if (!is_paper_model(core.name) || !core.constants) core.constants = core.paper_match.constants;
  if (is_listing) return;
  const auto program = step ? make_step_program(*step) : nullptr;
  core.walls_of_rows = program ? others_of(*program) : kAllWalls;
  core.stepper =
      std::make_shared<const ContactStepper>(core.stepper, program, program ? std::nullopt : core.constants);
}

}  // namespace hyrax
