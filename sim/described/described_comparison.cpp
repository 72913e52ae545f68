#include "sim/described/described_comparison.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

#include "sim/described/scripted_body.h"

namespace hyrax {
namespace {

// Of two words of the type; infinite where it is not a number.
double difference_of(ValueType type, Word a, Word b) {
  if (a == b) return 0.0;
  if (!is_floating(type)) return static_cast<double>(is_less(type, a, b) ? b - a : a - b);
  const double difference = std::fabs(number_of(type, a) - number_of(type, b));
  return std::isnan(difference) ? std::numeric_limits<double>::infinity() : difference;
}

bool is_nan(ValueType type, Word word) { return is_floating(type) && std::isnan(number_of(type, word)); }

std::optional<std::uint64_t> ulps_of(ValueType type, Word a, Word b) {
  if (!is_floating(type)) return std::nullopt;
  if (type == ValueType::float32) return ulps_between(value_of<float>(a), value_of<float>(b));
  return ulps_between(value_of<double>(a), value_of<double>(b));
}

bool agrees(ValueType type, Word a, Word b, const Tolerance& tolerance) {
  if (is_nan(type, a)) return false;
  if (a == b || !is_floating(type)) return a == b;
  const std::optional<std::uint64_t> ulps = ulps_of(type, a, b);
  if (tolerance.ulps && ulps && *ulps <= static_cast<std::uint64_t>(*tolerance.ulps)) return true;
  return Tolerance{tolerance.abs, tolerance.rel, {}}.accepts(number_of(type, a), number_of(type, b));
}

// What stands for a state or a mode, not for a quantity.
bool is_discrete(const ValueInfo& value) {
  if (is_floating(value.type)) return false;
  return value.type == ValueType::boolean || !value.names.empty() || value.unit.empty();
}

// How far values of one name differ over a run, against how large they are.
struct Deviation {
  double largest = 0.0;
  DescribedWorst worst = {};

  void add(std::int64_t step, Word a, Word b) {
    const ValueType type = worst.value.type;
    largest = std::max({largest, std::fabs(number_of(type, a)), std::fabs(number_of(type, b))});
    const bool has_nan = is_nan(type, a) || is_nan(type, b);
    const double difference = has_nan ? std::numeric_limits<double>::infinity() : difference_of(type, a, b);
    if (difference > worst.abs) worst = {worst.value, step, difference, ulps_of(type, a, b)};
  }
  [[nodiscard]] bool is_rounding() const {
    const double relative = worst.value.type == ValueType::float32 ? 1e-5 : 1e-9;
    return worst.abs == 0.0 ||
           (is_floating(worst.value.type) && worst.abs <= relative * std::max(1.0, largest));
  }
};

const ValueInfo kTime{.name = "t", .unit = "s"};
const ValueInfo kFrameTime{.name = "dt", .unit = "s"};

class RunMeter {
 public:
  RunMeter(const Description& description, const Tolerance& tolerance)
      : description_(description),
        tolerance_(tolerance),
        values_(description.state.values),
        pairs_(position_pairs(description)),
        deviations_({{0.0, {kTime}}, {0.0, {kFrameTime}}}) {
    for (const ValueInfo& value : values_) deviations_.push_back({0.0, {value}});
    for (std::size_t index = 0; index < values_.size(); ++index) {
      max_[values_[index].unit] = 0.0;
      const auto is_of = [index](const PositionPair& pair) { return pair.x == index || pair.y == index; };
      if (values_[index].unit == "px" && std::ranges::none_of(pairs_, is_of)) others_px_.push_back(index);
    }
  }

  // Of two rows of one step: what the class depends on.
  void compare(const KeptRow& a, const KeptRow& b) {
    note(a, deviations_[0], word_of(a.t_s), word_of(b.t_s));
    note(a, deviations_[1], word_of(a.dt_s), word_of(b.dt_s));
    has_other_dt_ = has_other_dt_ || !same_bits(a.dt_s, b.dt_s);
    for (std::size_t index = 0; index < values_.size(); ++index)
      note(a, deviations_[index + 2], a.state[index], b.state[index]);
    for (std::size_t index = 0; index < a.contacts.size(); ++index) {
      if (a.contacts[index] == b.contacts[index]) continue;
      has_other_contacts_ = true;
      set_first(a, {.name = description_.contacts[index], .type = ValueType::boolean}, a.contacts[index],
                b.contacts[index]);
    }
  }

  // Of two rows of one time.
  void measure(const KeptRow& a, const KeptRow& b, double t_s) {
    const auto difference = [&](std::size_t index) {
      return difference_of(values_[index].type, a.state[index], b.state[index]);
    };
    double px = 0.0;
    for (std::size_t index = 0; index < values_.size(); ++index) {
      double& max = max_[values_[index].unit];
      max = std::max(max, difference(index));
    }
    for (const PositionPair& pair : pairs_)
      px = std::max(px, std::hypot(difference(pair.x), difference(pair.y)));
    for (const std::size_t index : others_px_) px = std::max(px, difference(index));
    take_larger(distance_.largest, {px, a.step, t_s});
  }
  void restart_at_equal_times() {
    for (auto& [unit, max] : max_) max = 0.0;
    distance_ = {.is_at_equal_times = true};
  }
  void set_left_out(std::int64_t frames) { distance_.frames_left_out = frames; }

  // The run between two rows: floating values on a straight line.
  [[nodiscard]] std::optional<KeptRow> between(const KeptRow& from, const KeptRow& to, double t_s) const {
    const double part = (t_s - from.t_s) / (to.t_s - from.t_s);
    KeptRow row = from;
    row.t_s = t_s;
    for (std::size_t index = 0; index < values_.size(); ++index) {
      if (!is_floating(values_[index].type)) continue;
      const double before = std::bit_cast<double>(from.state[index]);
      const double after = std::bit_cast<double>(to.state[index]);
      if (!std::isfinite(after)) return std::nullopt;
      row.state[index] = word_of(before + part * (after - before));
    }
    return row;
  }

  [[nodiscard]] bool has_other_dt() const { return has_other_dt_; }
  [[nodiscard]] DescribedComparison finish(const ContactCounts& contacts) const {
    DescribedComparison result{.first = first_,
                               .contacts = contacts,
                               .has_px = !pairs_.empty() || !others_px_.empty(),
                               .distance = distance_,
                               .max = max_};
    bool is_rounding = true;
    for (const Deviation& deviation : deviations_) {
      is_rounding = is_rounding && deviation.is_rounding();
      if (deviation.worst.abs > 0.0) result.worst.push_back(deviation.worst);
    }
    if (!first_ && contacts.total() == 0) return result;
    result.difference = has_other_contacts_ || contacts.total() > 0 ? DifferenceClass::contacts
                        : is_rounding                               ? DifferenceClass::rounding
                                                                    : DifferenceClass::values;
    return result;
  }

 private:
  void note(const KeptRow& row, Deviation& deviation, Word a, Word b) {
    deviation.add(row.step, a, b);
    const ValueInfo& value = deviation.worst.value;
    if (agrees(value.type, a, b, tolerance_)) return;
    has_other_contacts_ = has_other_contacts_ || is_discrete(value);
    set_first(row, value, a, b);
  }
  void set_first(const KeptRow& row, const ValueInfo& value, Word a, Word b) {
    if (!first_) first_ = {row.step, row.t_s, value, a, b};
  }

  const Description& description_;
  Tolerance tolerance_;
  const std::vector<ValueInfo>& values_;  // Of the state.
  std::vector<PositionPair> pairs_;
  std::vector<std::size_t> others_px_;  // Values in px that are in no pair.
  std::vector<Deviation> deviations_;   // Of t, dt and the state.
  bool has_other_dt_ = false;
  bool has_other_contacts_ = false;
  std::optional<DescribedDivergence> first_;
  Distance distance_;
  std::map<std::string, double> max_;
};

using Places = std::vector<std::size_t>;

// The places, in either list, of what both have.
std::array<Places, 2> common_places(const auto& a, const auto& b, const auto& is_same) {
  std::array<Places, 2> places;
  for (std::size_t place = 0; place < a.size(); ++place)
    if (const auto found = std::ranges::find_if(b, [&](const auto& each) { return is_same(a[place], each); });
        found != b.end()) {
      places[0].push_back(place);
      places[1].push_back(static_cast<std::size_t>(found - b.begin()));
    }
  return places;
}

// A run with these values and contacts only.
ComparedSide part_of(const ComparedSide& side, const Places& values, const Places& contacts) {
  ComparedSide part{[=, rows = side.rows](DescribedRows& batch) {
                      rows(batch);
                      DescribedRows chosen{batch.step, batch.t_s, batch.dt_s, {}, {}};
                      for (std::size_t index = 0; index < batch.size(); ++index) {
                        const KeptRow row = batch.row(index);
                        for (const std::size_t place : values) chosen.state.push_back(row.state[place]);
                        for (const std::size_t place : contacts)
                          chosen.contacts.push_back(row.contacts[place]);
                      }
                      batch = std::move(chosen);
                    },
                    side.jumps,
                    {}};
  for (DescribedContact contact : side.contacts)
    if (const auto place = std::ranges::find(contacts, contact.contact); place != contacts.end()) {
      contact.contact = static_cast<std::size_t>(place - contacts.begin());
      part.contacts.push_back(contact);
    }
  return part;
}

std::string range_text(const ValueInfo& value, const std::array<Word, 2>& range) {
  const auto text = [&](Word word) {
    if (value.type == ValueType::boolean) return std::string(word != 0 ? "true" : "false");
    if (word < value.names.size()) return value.names[static_cast<std::size_t>(word)];
    if (is_floating(value.type)) return shortest_text(shown_number_of(value.type, word));
    return is_signed_integer(value.type) ? std::to_string(static_cast<std::int64_t>(word))
                                         : std::to_string(word);
  };
  return range[0] == range[1] ? text(range[0]) : text(range[0]) + " .. " + text(range[1]);
}

Expectation judge_final(const ValueInfo& value, const std::array<Word, 2>& range, Word measured) {
  Expectation verdict{"final/" + value.name, range_text(value, range), false, {}, {}};
  verdict.holds = !is_nan(value.type, measured) && !is_less(value.type, measured, range[0]) &&
                  !is_less(value.type, range[1], measured);
  if (value.type == ValueType::boolean)
    verdict.measured = measured != 0;
  else if (is_floating(value.type))
    verdict.measured = shown_number_of(value.type, measured);
  else if (const double number = number_of(value.type, measured);
           value.names.empty() && std::fabs(number) <= 1e15)
    verdict.measured = number;
  else
    verdict.measured = range_text(value, {measured, measured});
  if (std::holds_alternative<double>(verdict.measured))
    verdict.range = {number_of(value.type, range[0]), number_of(value.type, range[1])};
  return verdict;
}

}  // namespace

std::optional<std::uint64_t> DescribedDivergence::ulps() const {
  return expected && actual ? ulps_of(value.type, *expected, *actual) : std::nullopt;
}

DescribedComparison compare_runs(const Description& description, const ComparedSide& a, const ComparedSide& b,
                                 const Tolerance& tolerance) {
  RunMeter meter(description, tolerance);
  using Cursor = CursorOf<DescribedRows>;
  walk_by_step(Cursor(a.rows), Cursor(b.rows), [&](const KeptRow& row_a, const KeptRow& row_b) {
    meter.compare(row_a, row_b);
    meter.measure(row_a, row_b, row_a.t_s);
  });
  if (meter.has_other_dt()) {
    meter.restart_at_equal_times();
    using Walk = TimeWalk<DescribedRows>;
    meter.set_left_out(walk_times(
        Walk(a.rows, a.jumps), Walk(b.rows, b.jumps),
        [&](const KeptRow& from, const KeptRow& to, double t_s) { return meter.between(from, to, t_s); },
        [&](const KeptRow& row_a, const KeptRow& row_b, double t_s) { meter.measure(row_a, row_b, t_s); }));
  }
  return meter.finish(contact_counts(a.contacts, b.contacts));
}

DescribedComparison compare_common(const Description& description_a, const ComparedSide& a,
                                   const Description& description_b, const ComparedSide& b,
                                   const Tolerance& tolerance) {
  const auto [values_a, values_b] = common_places(
      description_a.state.values, description_b.state.values,
      [](const ValueInfo& x, const ValueInfo& y) { return x.name == y.name && x.type == y.type; });
  const auto [contacts_a, contacts_b] =
      common_places(description_a.contacts, description_b.contacts, std::equal_to());
  Description common;
  for (const std::size_t place : values_b) common.state.values.push_back(description_b.state.values[place]);
  for (const std::size_t place : contacts_b) common.contacts.push_back(description_b.contacts[place]);
  return compare_runs(common, part_of(a, values_a, contacts_a), part_of(b, values_b, contacts_b), tolerance);
}

DescribedComparison no_difference(const Description& description) {
  return RunMeter(description, {}).finish({});
}

DescribedComparison compare_blocks(const Description& description, const std::vector<DescribedBlock>& a,
                                   const std::vector<DescribedBlock>& b) {
  const auto [block_a, block_b] =
      std::ranges::mismatch(a, b, {}, &DescribedBlock::digest, &DescribedBlock::digest);
  if (block_a == a.end() && block_b == b.end()) return no_difference(description);
  const auto& values = description.state.values;
  DescribedComparison result{.difference = DifferenceClass::values, .distance = {.has_unknown_rows = true}};
  const DescribedKeyframe& from = block_a == a.end() ? block_b->keyframe : block_a->keyframe;
  DescribedDivergence& first = result.first.emplace();
  first = {from.step, from.timeline.time_s(), {.name = "state"}};
  if (block_a == a.end() || block_b == b.end()) return result;
  const auto [value_a, value_b] = std::ranges::mismatch(from.state, block_b->keyframe.state);
  if (value_a == from.state.end()) return result;
  first.value = values[static_cast<std::size_t>(value_a - from.state.begin())];
  first.expected = *value_a;
  first.actual = *value_b;
  return result;
}

ContactCounts contact_counts(std::vector<DescribedContact> a, std::vector<DescribedContact> b) {
  for (std::vector<DescribedContact>* const contacts : {&a, &b})
    std::ranges::sort(*contacts, {}, [](const DescribedContact& contact) { return order_of(contact); });
  return contact_changes(a, b).counts();
}

std::vector<TimedEvent> timed_events(const DescribedScenario& scenario, std::int64_t steps) {
  const std::vector<std::int64_t> frames = event_frames(scenario, step_count(scenario));
  std::vector<TimedEvent> events;
  for (std::size_t index = 0; index < frames.size(); ++index)
    if (frames[index] < steps) events.push_back({frames[index], &scenario.events[index].action});
  return events;
}

std::vector<std::int64_t> jump_frames(const DescribedScenario& scenario, std::int64_t steps) {
  std::vector<std::int64_t> frames;
  for (const TimedEvent& event : timed_events(scenario, steps))
    if (!std::holds_alternative<Hitch>(*event.action)) frames.push_back(event.frame);
  return frames;
}

std::vector<Expectation> judge(const Description& description, const DescribedExpect& expect,
                               const DescribedSummary& summary) {
  Judge judge;
  judge.is("finite", expect.finite, !(summary.early_end && summary.early_end->is_non_finite));
  for (const auto& [value, range] : expect.final)
    judge.add(judge_final(description.state.values[value], range, summary.final[value]));
  for (const auto& [contact, range] : expect.contacts)
    judge.within("contacts/" + description.contacts[contact], range,
                 static_cast<double>(summary.contacts[contact]));
  judge.within("at_rest_since_s", expect.at_rest_since_s, summary.at_rest_since_s);
  judge.equals("state_hash", expect.state_hash, hex(summary.state_hash));
  return judge.take();
}

}  // namespace hyrax
