#include "tools/report/wasm/scenario_record.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <iterator>
#include <type_traits>
#include <utility>

#include "sim/scenario/numbers.h"

namespace hyrax {
namespace {

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

// The layout: every part of a scenario in its place. A record is written, or read from its begin.
class Record {
 public:
  Record() = default;
  explicit Record(std::span<const double> read) : numbers_(read.begin(), read.end()), is_read_(true) {}

  /// Whether each number was read, and all were those of a scenario.
  [[nodiscard]] bool is_whole() const { return is_good_ && next_ == numbers_.size(); }
  [[nodiscard]] std::vector<double> numbers() && { return std::move(numbers_); }

  void part(Scenario& scenario) {
    part(scenario.window);
    part(scenario.sprite);
    visit_start(scenario.start, scenario.start_velocity,
                [&](auto, const NumberField& field) { part(*std::get<double*>(field.at)); });
    part(scenario.record_every);
    one_of(scenario.length);
    one_of(scenario.clock.base);
    part(scenario.clock.jitter);
    list(scenario.events);
  }

 private:
  // Appends the number, or takes the next one for it: zeros after the end, or after what no record holds.
  double pass(double number) {
    if (!is_read_) return numbers_.emplace_back(number);
    is_good_ = is_good_ && next_ < numbers_.size();
    return is_good_ ? numbers_[next_++] : 0.0;
  }

  template <class Number>
  void part(Number& number) {
    number = static_cast<Number>(pass(static_cast<double>(number)));
  }
  void part(std::monostate&) { pass(0.0); }
  void part(Size& size) {
    part(size.width_px);
    part(size.height_px);
  }
  void part(FixedRate& rate) { part(rate.rate_hz); }
  void part(FixedStep& step) { part(step.dt_s); }
  void part(RecordedSteps& trace) { list(trace.dt_s); }

  void part(std::optional<Jitter>& jitter) {
    if (pass(jitter ? 1.0 : 0.0) == 0.0) return;
    if (!jitter) jitter.emplace();
    part(jitter->kind);
    part(jitter->amount);
    constexpr double kHalf = 4294967296.0;
    const double high = pass(static_cast<double>(jitter->seed >> 32));
    const double low = pass(static_cast<double>(jitter->seed & 0xFFFFFFFFu));
    if (!(high >= 0.0 && high < kHalf && low >= 0.0 && low < kHalf)) return fail();
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
    const double count = pass(static_cast<double>(items.size()));
    // Each item has at least one number.
    if (is_read_ && !(count >= 0.0 && count <= static_cast<double>(numbers_.size() - next_))) return fail();
    items.resize(static_cast<std::size_t>(count));
    for (Item& item : items) part(item);
  }

  template <class... Kinds>
  void kind(std::variant<Kinds...>& value) {
    const double given = pass(static_cast<double>(value.index()));
    double index = 0.0;
    const auto is_it = [&]<class Kind>(Kind kind) {
      if (index++ != given) return false;
      if (!std::holds_alternative<Kind>(value)) value = std::move(kind);
      return true;
    };
    if (!(is_it(Kinds{}) || ...)) fail();
  }
  template <class Variant>
  void one_of(Variant& value) {
    kind(value);
    std::visit([&](auto& held) { part(held); }, value);
  }

  void fail() { is_good_ = false; }

  std::vector<double> numbers_ = {};
  bool is_read_ = false;
  std::size_t next_ = 0;
  bool is_good_ = true;
};

}  // namespace

std::vector<double> record_of(const Scenario& scenario) {
  Record writing;
  Scenario unchanged = scenario;
  writing.part(unchanged);
  return std::move(writing).numbers();
}

std::optional<Scenario> scenario_of(std::span<const double> record) {
  Record reading(record);
  Scenario scenario;
  reading.part(scenario);
  return reading.is_whole() ? std::optional(scenario) : std::nullopt;
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
