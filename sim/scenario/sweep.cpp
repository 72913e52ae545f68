#include "sim/scenario/sweep.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "sim/scenario/frame_clock.h"
#include "sim/scenario/schedule.h"
#include "sim/scenario/split_mix64.h"

namespace hyrax {
namespace {

// A whole double in the type of the key; 2^64 is the largest seed.
SweepNumber in_kind(ScenarioNumberKind kind, double value) {
  if (kind == ScenarioNumberKind::real) return value;
  if (kind == ScenarioNumberKind::integer) return static_cast<std::int64_t>(value);
  return value >= 0x1p64 ? ~std::uint64_t{0} : static_cast<std::uint64_t>(value);
}

SweepNumber in_kind(ScenarioNumberKind kind, std::int64_t value) {
  if (kind == ScenarioNumberKind::real) return static_cast<double>(value);
  if (kind == ScenarioNumberKind::seed) return static_cast<std::uint64_t>(value);
  return value;
}

void set(const NumberField& field, const SweepNumber& number) {
  std::visit([](auto* at, auto value) { *at = static_cast<std::remove_pointer_t<decltype(at)>>(value); },
             field.at, number);
}

// Without events, frames depend on one another only in their number, which a duration gives.
bool has_dependent_keys(const Sweep& sweep) {
  Scenario base = sweep.base;
  if (base.events.empty() && !std::holds_alternative<double>(base.length)) return false;
  return std::any_of(sweep.vary.begin(), sweep.vary.end(), [&](const VariedKey& key) {
    const auto field = number_at(base, key.pointer);
    return field && field->is_timing;
  });
}

bool is_consistent(const Scenario& scenario) {
  if (std::holds_alternative<double>(scenario.length) && !(base_dt_s(scenario.clock) > 0.0)) return false;
  const std::int64_t steps = step_count(scenario);
  return steps <= kStepsMax && (scenario.events.empty() || schedule_events(scenario, steps).faulty.empty());
}

}  // namespace

double value_of(const GridAxis& grid, std::int64_t index) {
  assert(index >= 0 && index < grid.count);
  if (grid.count == 1) return grid.low;
  if (index == grid.count - 1) return grid.high;
  return grid.low +
         ((grid.high - grid.low) * static_cast<double>(index)) / static_cast<double>(grid.count - 1);
}

SweepNumber value_of(const Sweep& sweep, std::size_t key, std::int64_t member) {
  assert(key < sweep.vary.size() && member >= 0 && member < sweep.members);
  const auto& [pointer, kind, variation] = sweep.vary[key];
  if (std::holds_alternative<MemberNumber>(variation)) return in_kind(kind, member);
  if (const auto* const grid = std::get_if<GridAxis>(&variation))
    return in_kind(kind, value_of(*grid, member / grid->repeats % grid->count));
  const double u = split_mix64_unit(sweep.seed, static_cast<std::uint64_t>(member) * sweep.vary.size() + key);
  if (const auto* const choice = std::get_if<ChoiceDraw>(&variation))
    return choice->values[static_cast<std::size_t>(u * static_cast<double>(choice->values.size()))];
  const auto& range = std::get<UniformDraw>(variation);
  if (kind == ScenarioNumberKind::real) return range.low + (range.high - range.low) * u;
  // Far from 0 the sum can round up to high + 1.
  return in_kind(kind, std::min(std::floor(range.low + (range.high - range.low + 1.0) * u), range.high));
}

std::vector<SweepNumber> extremes_of(const Sweep& sweep, std::size_t key) {
  const auto& [pointer, kind, variation] = sweep.vary[key];
  if (const auto* const choice = std::get_if<ChoiceDraw>(&variation)) return choice->values;
  if (const auto* const range = std::get_if<UniformDraw>(&variation))
    return {in_kind(kind, range->low), in_kind(kind, range->high)};
  if (const auto* const grid = std::get_if<GridAxis>(&variation))
    return {in_kind(kind, grid->low), in_kind(kind, grid->high)};
  return {in_kind(kind, std::int64_t{0}), in_kind(kind, sweep.members - 1)};
}

double as_double(const SweepNumber& number) {
  return std::visit([](auto value) { return static_cast<double>(value); }, number);
}

SweepMembers::SweepMembers(const Sweep& sweep) : sweep_(sweep), scenario_(sweep.base) {
  for (const VariedKey& key : sweep.vary) {
    const auto field = number_at(scenario_, key.pointer);
    assert(field);
    fields_.push_back(*field);
  }
}

const Scenario& SweepMembers::scenario(std::int64_t member) {
  for (std::size_t key = 0; key < fields_.size(); ++key) set(fields_[key], value_of(sweep_, key, member));
  return scenario_;
}

std::optional<std::int64_t> first_inconsistent_member(const Sweep& sweep) {
  if (!has_dependent_keys(sweep)) return std::nullopt;
  SweepMembers members(sweep);
  for (std::int64_t member = 0; member < sweep.members; ++member)
    if (!is_consistent(members.scenario(member))) return member;
  return std::nullopt;
}

}  // namespace hyrax
