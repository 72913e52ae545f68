#include "sim/scenario/sweep.h"

#include <algorithm>
#include <cassert>

#include "sim/scenario/frame_clock.h"
#include "sim/scenario/schedule.h"
#include "sim/scenario/split_mix64.h"

namespace hyrax {
namespace {

// Of a whole number, modulo 2^64.
std::uint64_t as_bits(const SweepNumber& number) {
  return std::visit([](auto value) { return static_cast<std::uint64_t>(value); }, number);
}

// A whole number so much above another one.
SweepNumber higher(const SweepNumber& low, std::uint64_t distance) {
  const std::uint64_t sum = as_bits(low) + distance;
  if (std::holds_alternative<std::int64_t>(low)) return static_cast<std::int64_t>(sum);
  return sum;
}

// floor((distance + 1) * part / 2^53), exactly: the product has up to 117 bits. REQUIRES: part < 2^53.
std::uint64_t share_of(std::uint64_t distance, std::uint64_t part) {
  constexpr std::uint64_t kLowHalf = 0xFFFFFFFF;
  const std::uint64_t lowest = (distance & kLowHalf) * (part & kLowHalf);
  const std::uint64_t middle = (distance >> 32) * (part & kLowHalf) + (lowest >> 32);
  const std::uint64_t other_middle = (distance & kLowHalf) * (part >> 32) + (middle & kLowHalf);
  const std::uint64_t low = (other_middle << 32 | (lowest & kLowHalf)) + part;
  const std::uint64_t carry = low < part ? 1 : 0;
  const std::uint64_t high = (distance >> 32) * (part >> 32) + (middle >> 32) + (other_middle >> 32) + carry;
  return high << 11 | low >> 53;
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

SweepNumber in_kind(ScenarioNumberKind kind, std::int64_t value) {
  if (kind == ScenarioNumberKind::real) return static_cast<double>(value);
  if (kind == ScenarioNumberKind::integer) return value;
  return static_cast<std::uint64_t>(value);
}

std::uint64_t whole_distance(const SweepNumber& low, const SweepNumber& high) {
  return as_bits(high) - as_bits(low);
}

SweepNumber value_of(const GridAxis& grid, std::int64_t index) {
  assert(index >= 0 && index < grid.count);
  if (grid.count == 1) return grid.low;
  if (index == grid.count - 1) return grid.high;
  const std::int64_t steps = grid.count - 1;
  if (const auto* const low = std::get_if<double>(&grid.low))
    return *low +
           ((std::get<double>(grid.high) - *low) * static_cast<double>(index)) / static_cast<double>(steps);
  const std::uint64_t step = whole_distance(grid.low, grid.high) / static_cast<std::uint64_t>(steps);
  return higher(grid.low, step * static_cast<std::uint64_t>(index));
}

SweepNumber value_of(const SweepPlan& sweep, std::size_t key, std::int64_t member) {
  assert(key < sweep.vary.size() && member >= 0 && member < sweep.members);
  const auto& [pointer, kind, variation, names] = sweep.vary[key];
  if (std::holds_alternative<MemberNumber>(variation)) return in_kind(kind, member);
  if (const auto* const grid = std::get_if<GridAxis>(&variation))
    return value_of(*grid, member / grid->repeats % grid->count);
  const std::uint64_t draw = static_cast<std::uint64_t>(member) * sweep.vary.size() + key;
  const double u = split_mix64_unit(sweep.seed, draw);
  if (const auto* const choice = std::get_if<ChoiceDraw>(&variation))
    return choice->values[static_cast<std::size_t>(u * static_cast<double>(choice->values.size()))];
  const auto& [low, high] = std::get<UniformDraw>(variation);
  if (const auto* const real = std::get_if<double>(&low)) return *real + (std::get<double>(high) - *real) * u;
  return higher(low, share_of(whole_distance(low, high), split_mix64(sweep.seed, draw) >> 11));
}

std::vector<SweepNumber> extremes_of(const SweepPlan& sweep, std::size_t key) {
  const auto& [pointer, kind, variation, names] = sweep.vary[key];
  if (const auto* const choice = std::get_if<ChoiceDraw>(&variation)) return choice->values;
  if (const auto* const range = std::get_if<UniformDraw>(&variation)) return {range->low, range->high};
  if (const auto* const grid = std::get_if<GridAxis>(&variation)) return {grid->low, grid->high};
  return {in_kind(kind, std::int64_t{0}), in_kind(kind, sweep.members - 1)};
}

double as_double(const SweepNumber& number) {
  return std::visit([](auto value) { return static_cast<double>(value); }, number);
}

void name_member(ScenarioHead& scenario, std::int64_t member) {
  const std::string suffix = "-member-" + std::to_string(member);
  scenario.name = scenario.name.substr(0, static_cast<std::size_t>(kNameLengthMax) - suffix.size()) + suffix;
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
