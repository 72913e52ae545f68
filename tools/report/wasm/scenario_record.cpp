#include "tools/report/wasm/scenario_record.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <iterator>
#include <limits>
#include <type_traits>
#include <utility>

#include "sim/scenario/numbers.h"

namespace hyrax {
namespace {

// The two directions of a record: a number is appended to it, or replaced by the next one of it.
struct Appending {
  std::vector<double> record = {};

  double operator()(double value) { return record.emplace_back(value); }
  [[nodiscard]] double items_max() const { return std::numeric_limits<double>::infinity(); }
  void fail() {}
};

struct Reading {
  std::span<const double> rest;
  bool is_good = true;

  /// Zeros after the end, or after anything else that no record holds.
  double operator()(double) {
    is_good = is_good && !rest.empty();
    if (!is_good) return 0.0;
    const double value = rest.front();
    rest = rest.subspan(1);
    return value;
  }
  /// Each item of a list has at least one number.
  [[nodiscard]] double items_max() const { return static_cast<double>(rest.size()); }
  void fail() { is_good = false; }
};

// A resize has numbers for both sizes, -1 for those of one that stays.
void give_both_sizes(Action& action) {
  constexpr Size kStays{-1, -1};
  if (auto* const resize = std::get_if<Resize>(&action))
    *resize = {resize->window.value_or(kStays), resize->sprite.value_or(kStays)};
}
void take_unchanged_sizes(Action& action) {
  if (auto* const resize = std::get_if<Resize>(&action))
    for (std::optional<Size>* const size : {&resize->window, &resize->sprite})
      if ((*size)->width_px < 0) size->reset();
}

// The layout: every part of a scenario in its place, whatever the direction.
template <class Direction>
class Layout {
 public:
  explicit Layout(Direction& direction) : direction_(direction) {}

  void part(Scenario& scenario) {
    part(scenario.window);
    part(scenario.sprite);
    for (double* const number : {&scenario.start.x_px, &scenario.start.y_px,
                                 &scenario.start_velocity.vx_px_per_s, &scenario.start_velocity.vy_px_per_s})
      part(*number);
    part(scenario.record_every);
    one_of(scenario.length);
    one_of(scenario.clock.base);
    part(scenario.clock.jitter);
    list(scenario.events);
  }

 private:
  template <class Number>
  void part(Number& number) {
    number = static_cast<Number>(direction_(static_cast<double>(number)));
  }
  void part(std::monostate&) { direction_(0.0); }
  void part(Size& size) {
    part(size.width_px);
    part(size.height_px);
  }
  void part(FixedRate& rate) { part(rate.rate_hz); }
  void part(FixedStep& step) { part(step.dt_s); }
  void part(RecordedSteps& trace) { list(trace.dt_s); }

  void part(std::optional<Jitter>& jitter) {
    if (direction_(jitter ? 1.0 : 0.0) == 0.0) return;
    if (!jitter) jitter.emplace();
    part(jitter->kind);
    part(jitter->amount);
    constexpr double kHalf = 4294967296.0;
    const double high = direction_(static_cast<double>(jitter->seed >> 32));
    const double low = direction_(static_cast<double>(jitter->seed & 0xFFFFFFFFu));
    if (!(high >= 0.0 && high < kHalf && low >= 0.0 && low < kHalf)) return direction_.fail();
    jitter->seed = static_cast<std::uint64_t>(high) << 32 | static_cast<std::uint64_t>(low);
  }

  void part(Event& event) {
    one_of(event.when);
    kind(event.action);
    give_both_sizes(event.action);
    std::array<double, 4> numbers{};  // Of every action; unused ones are 0.
    std::size_t next = 0;
    visit_numbers(event.action, [&](auto, const NumberField& field) { numbers[next++] = field.value(); });
    for (double& number : numbers) part(number);
    next = 0;
    visit_numbers(event.action, [&](auto, const NumberField& field) { field.set(numbers[next++]); });
    take_unchanged_sizes(event.action);
  }

  template <class Item>
  void list(std::vector<Item>& items) {
    const double count = direction_(static_cast<double>(items.size()));
    if (!(count >= 0.0 && count <= direction_.items_max())) return direction_.fail();
    items.resize(static_cast<std::size_t>(count));
    for (Item& item : items) part(item);
  }

  template <class... Kinds>
  void kind(std::variant<Kinds...>& value) {
    const double given = direction_(static_cast<double>(value.index()));
    double index = 0.0;
    const auto is_it = [&]<class Kind>(Kind kind) {
      if (index++ != given) return false;
      if (!std::holds_alternative<Kind>(value)) value = std::move(kind);
      return true;
    };
    if (!(is_it(Kinds{}) || ...)) direction_.fail();
  }
  template <class Variant>
  void one_of(Variant& value) {
    kind(value);
    std::visit([&](auto& held) { part(held); }, value);
  }

  Direction& direction_;
};

}  // namespace

std::vector<double> record_of(const Scenario& scenario) {
  Appending appending;
  Scenario unchanged = scenario;
  Layout(appending).part(unchanged);
  return std::move(appending.record);
}

std::optional<Scenario> scenario_of(std::span<const double> record) {
  Reading reading{record};
  Scenario scenario;
  Layout(reading).part(scenario);
  return reading.is_good && reading.rest.empty() ? std::optional(scenario) : std::nullopt;
}

std::size_t place_in_record(const Scenario& scenario, std::string_view pointer) {
  Scenario changed = scenario;
  const std::optional<NumberField> field = number_at(changed, pointer);
  assert(field);
  std::visit(
      [](auto* number) {
        if constexpr (std::is_same_v<decltype(number), std::uint64_t*>)
          *number ^= std::uint64_t{1} << 32;  // Of its halves the higher is first.
        else
          *number = *number == 2 ? 3 : 2;
      },
      field->at);
  const std::vector<double> before = record_of(scenario), after = record_of(changed);
  const auto place = std::mismatch(before.begin(), before.end(), after.begin(), after.end()).first;
  return static_cast<std::size_t>(std::distance(before.begin(), place));
}

}  // namespace hyrax
