#include "tools/report/wasm/scenario_record.h"

#include <array>
#include <utility>

#include "sim/scenario/numbers.h"

namespace hyrax {
namespace {

constexpr std::size_t kActionNumbers = 4;  // Of each action; unused ones are 0.

// A resize has numbers for both sizes, -1 for those of one that stays.
constexpr Size kStays{-1, -1};

Action with_both_sizes(Action action) {
  if (auto* const resize = std::get_if<Resize>(&action))
    *resize = {resize->window.value_or(kStays), resize->sprite.value_or(kStays)};
  return action;
}

// Reads numbers one after another; after the end it gives zeros and is no longer good.
class RecordReader {
 public:
  explicit RecordReader(std::span<const double> record) : rest_(record) {}

  double number() {
    if (rest_.empty()) is_good_ = false;
    if (!is_good_) return 0.0;
    const double value = rest_.front();
    rest_ = rest_.subspan(1);
    return value;
  }
  template <class Integer>
  Integer integer() {
    return static_cast<Integer>(number());
  }
  /// A count of items that are still to come, each of at least one number.
  std::size_t count() {
    const double value = number();
    if (value >= 0.0 && value <= static_cast<double>(rest_.size())) return static_cast<std::size_t>(value);
    is_good_ = false;
    return 0;
  }
  Size size() {
    const auto width_px = integer<std::int32_t>();
    return {width_px, integer<std::int32_t>()};
  }
  void fail() { is_good_ = false; }
  [[nodiscard]] bool is_read() const { return is_good_ && rest_.empty(); }

 private:
  std::span<const double> rest_;
  bool is_good_ = true;
};

std::optional<Size> unless_it_stays(const std::optional<Size>& size) {
  return size && size->width_px >= 0 ? size : std::nullopt;
}

Action read_action(RecordReader& reader) {
  const double kind = reader.number();
  std::array<double, kActionNumbers> numbers{};
  for (double& number : numbers) number = reader.number();
  if (!(kind >= 0.0 && kind < static_cast<double>(kActionNames.size()))) {
    reader.fail();
    return Stop{};
  }
  Action action = with_both_sizes(make_action(static_cast<std::size_t>(kind)));
  std::size_t next = 0;
  visit_numbers(action, [&](std::string_view, const NumberField& field) { field.set(numbers[next++]); });
  if (auto* const resize = std::get_if<Resize>(&action))
    *resize = {unless_it_stays(resize->window), unless_it_stays(resize->sprite)};
  return action;
}

constexpr double kHalf = 4294967296.0;

void add_clock(std::vector<double>& record, const Clock& clock) {
  record.push_back(static_cast<double>(clock.base.index()));
  if (const auto* rate = std::get_if<FixedRate>(&clock.base)) record.push_back(rate->rate_hz);
  if (const auto* step = std::get_if<FixedStep>(&clock.base)) record.push_back(step->dt_s);
  if (const auto* trace = std::get_if<RecordedSteps>(&clock.base)) {
    record.push_back(static_cast<double>(trace->dt_s.size()));
    record.insert(record.end(), trace->dt_s.begin(), trace->dt_s.end());
  }
  record.push_back(clock.jitter ? 1.0 : 0.0);
  if (!clock.jitter) return;
  const std::uint64_t seed = clock.jitter->seed;
  for (const double number : {static_cast<double>(clock.jitter->kind), clock.jitter->amount,
                              static_cast<double>(seed >> 32), static_cast<double>(seed & 0xFFFFFFFFu)})
    record.push_back(number);
}

Clock read_clock(RecordReader& reader) {
  Clock clock;
  switch (reader.integer<int>()) {
    case 0:
      clock.base = FixedRate{reader.number()};
      break;
    case 1:
      clock.base = FixedStep{reader.number()};
      break;
    case 2: {
      RecordedSteps trace;
      trace.dt_s.resize(reader.count());
      for (double& dt_s : trace.dt_s) dt_s = reader.number();
      clock.base = std::move(trace);
      break;
    }
    default:
      reader.fail();
  }
  if (reader.integer<int>() == 0) return clock;
  Jitter& jitter = clock.jitter.emplace();
  jitter.kind = static_cast<Jitter::Kind>(reader.integer<int>());
  jitter.amount = reader.number();
  const double high = reader.number();
  const double low = reader.number();
  if (!(high >= 0.0 && high < kHalf && low >= 0.0 && low < kHalf)) {
    reader.fail();
    return clock;
  }
  jitter.seed = static_cast<std::uint64_t>(high) << 32 | static_cast<std::uint64_t>(low);
  return clock;
}

void add_length(std::vector<double>& record, const Scenario& scenario) {
  record.push_back(static_cast<double>(scenario.length.index()));
  if (const auto* steps = std::get_if<std::int64_t>(&scenario.length))
    record.push_back(static_cast<double>(*steps));
  else if (const auto* duration_s = std::get_if<double>(&scenario.length))
    record.push_back(*duration_s);
  else
    record.push_back(0.0);
}

void read_length(RecordReader& reader, Scenario& scenario) {
  const auto kind = reader.integer<int>();
  const double length = reader.number();
  if (kind == 1) scenario.length = static_cast<std::int64_t>(length);
  if (kind == 2) scenario.length = length;
}

void add_event(std::vector<double>& record, const Event& event) {
  const auto* step = std::get_if<std::int64_t>(&event.when);
  record.push_back(step != nullptr ? 0.0 : 1.0);
  record.push_back(step != nullptr ? static_cast<double>(*step) : std::get<double>(event.when));
  record.push_back(static_cast<double>(event.action.index()));
  const std::size_t end = record.size() + kActionNumbers;
  Action action = with_both_sizes(event.action);
  visit_numbers(action, [&](std::string_view, const NumberField& field) { record.push_back(field.value()); });
  record.resize(end, 0.0);
}

Event read_event(RecordReader& reader) {
  Event event;
  const bool is_step = reader.number() == 0.0;
  const double when = reader.number();
  if (is_step)
    event.when = static_cast<std::int64_t>(when);
  else
    event.when = when;
  event.action = read_action(reader);
  return event;
}

}  // namespace

std::vector<double> record_of(const Scenario& scenario) {
  std::vector<double> record = {double(scenario.window.width_px),
                                double(scenario.window.height_px),
                                double(scenario.sprite.width_px),
                                double(scenario.sprite.height_px),
                                scenario.start.x_px,
                                scenario.start.y_px,
                                scenario.start_velocity.vx_px_per_s,
                                scenario.start_velocity.vy_px_per_s,
                                static_cast<double>(scenario.record_every)};
  add_length(record, scenario);
  add_clock(record, scenario.clock);
  record.push_back(static_cast<double>(scenario.events.size()));
  for (const Event& event : scenario.events) add_event(record, event);
  return record;
}

std::optional<Scenario> scenario_of(std::span<const double> record) {
  RecordReader reader(record);
  Scenario scenario;
  scenario.window = reader.size();
  scenario.sprite = reader.size();
  scenario.start.x_px = reader.number();
  scenario.start.y_px = reader.number();
  scenario.start_velocity.vx_px_per_s = reader.number();
  scenario.start_velocity.vy_px_per_s = reader.number();
  scenario.record_every = reader.integer<std::int64_t>();
  read_length(reader, scenario);
  scenario.clock = read_clock(reader);
  const std::size_t events = reader.count();
  for (std::size_t event = 0; event < events; ++event) scenario.events.push_back(read_event(reader));
  if (!reader.is_read()) return std::nullopt;
  return scenario;
}

}  // namespace hyrax
