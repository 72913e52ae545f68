// What comparing two runs found.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "sim/compare/run_distance.h"
#include "sim/scenario/schedule.h"
#include "sim/trajectory/columns.h"
#include "sim/trajectory/row.h"

namespace hyrax {

/// Of two numbers as their bits: how many representable ones lie between them, plus one.
template <class Bits>
[[nodiscard]] constexpr std::uint64_t bits_between(Bits a, Bits b) {
  // Maps numbers to integers in the same order.
  const auto ordered = [](Bits bits) {
    constexpr Bits kSign = Bits{1} << (8 * sizeof(Bits) - 1);
    return (bits & kSign) != 0 ? kSign - (bits - kSign) : bits + kSign;
  };
  const Bits low = ordered(a);
  const Bits high = ordered(b);
  return low < high ? high - low : low - high;
}

/// How many representable numbers of the type lie between a and b, plus one; 0 for equal values, +0 and -0
/// among them. Nothing where either is NaN.
[[nodiscard]] constexpr std::optional<std::uint64_t> ulps_between(double a, double b) {
  if (a != a || b != b) return std::nullopt;
  return bits_between(std::bit_cast<std::uint64_t>(a), std::bit_cast<std::uint64_t>(b));
}
[[nodiscard]] constexpr std::optional<std::uint64_t> ulps_between(float a, float b) {
  if (a != a || b != b) return std::nullopt;
  return bits_between(std::bit_cast<std::uint32_t>(a), std::bit_cast<std::uint32_t>(b));
}

/// Of a difference, the widest that applies; in order, the narrowest first.
enum class DifferenceClass {
  rounding,  ///< Every row within the limits of RunDistance::is_rounding.
  values,    ///< The same walls at the same steps, first and last, but more than that.
  contacts,  ///< A contact moved, appeared or vanished.
  shape,     ///< Other length, missing data, another scenario.
};
inline constexpr std::array<DifferenceClass, 4> kDifferenceClasses = {
    DifferenceClass::rounding, DifferenceClass::values, DifferenceClass::contacts, DifferenceClass::shape};
[[nodiscard]] constexpr std::string_view name_of(DifferenceClass difference) {
  constexpr std::array<std::string_view, 4> kNames = {"rounding", "values", "contacts", "shape"};
  return kNames[static_cast<std::size_t>(difference)];
}

/// The fields of a row, in the order in which a difference is looked for.
struct RowField {
  std::string_view name;
  double (*value)(const Row&);
};
inline constexpr std::array<RowField, 7> kRowFields = {{
    {"t", [](const Row& row) { return row.t_s; }},
    {"dt", [](const Row& row) { return row.dt_s; }},
    {"x", [](const Row& row) { return row.x_px; }},
    {"y", [](const Row& row) { return row.y_px; }},
    {"vx", [](const Row& row) { return row.vx_px_per_s; }},
    {"vy", [](const Row& row) { return row.vy_px_per_s; }},
    {"contact", [](const Row& row) { return static_cast<double>(row.contact); }},
}};
/// Whether it is the name of the last one, whose values are bytes of flags.
[[nodiscard]] constexpr bool is_contact_field(std::string_view field) {
  return field == kRowFields.back().name;
}

/// Distance of two values of a field in units in the last place. Nothing where either is NaN, and nothing for
/// "contact": a set of flags has no such distance.
[[nodiscard]] constexpr std::optional<std::uint64_t> ulps_of(std::string_view field, double expected,
                                                             double actual) {
  return is_contact_field(field) ? std::nullopt : ulps_between(expected, actual);
}

/// Where two runs part.
struct Divergence {
  std::int64_t step = 0;  ///< Row number.
  /// One of kRowFields, or "contacts/" and one of kContactQuantities, or "state" if only a digest is known.
  std::string field;
  std::optional<double> expected;  ///< Unknown if only a row check or a digest is kept.
  std::optional<double> actual;
  /// As ulps_of; nothing where a value is unknown.
  [[nodiscard]] std::optional<std::uint64_t> ulps() const {
    return expected && actual ? ulps_of(field, *expected, *actual) : std::nullopt;
  }
};

/// Whether two values of the run have the same bits. A NaN agrees with nothing, itself included.
[[nodiscard]] inline bool agrees(double expected, double actual) {
  return same_bits(expected, actual) && !std::isnan(expected);
}

/// Whether a quantity of two contacts agrees. An overshoot that neither run knows does.
[[nodiscard]] inline bool agrees(const ContactColumn& quantity, const Contact& expected,
                                 const Contact& actual) {
  const double a = *quantity.number(expected), b = *quantity.number(actual);
  return agrees(a, b) || (&quantity == &kContactQuantities.back() && std::isnan(a) && std::isnan(b));
}

struct ContactCounts {
  std::int64_t moved = 0, vanished = 0, appeared = 0;
  bool is_cut = false;  ///< At least so many: ContactChanges::is_cut.
  [[nodiscard]] std::int64_t total() const { return moved + vanished + appeared; }
  ContactCounts& operator+=(const ContactCounts& more) {
    moved += more.moved, vanished += more.vanished, appeared += more.appeared;
    is_cut |= more.is_cut;
    return *this;
  }
};

/// How the contacts of two runs differ. A moved contact is one of the same wall at another step.
template <class C>
struct ContactChangesOf {
  struct Moved {
    C from;
    C to;
  };
  std::vector<Moved> moved = {};
  std::vector<C> only_a = {};
  std::vector<C> only_b = {};
  /// A list holds no more (kContactsRecordedMax), and is compared up to its end; or of a wall none are
  /// compared.
  bool is_cut = false;
  [[nodiscard]] bool is_none() const { return total() == 0; }
  [[nodiscard]] std::int64_t total() const { return counts().total(); }
  [[nodiscard]] ContactCounts counts() const {
    return {std::ssize(moved), std::ssize(only_a), std::ssize(only_b), is_cut};
  }
};
using ContactChanges = ContactChangesOf<Contact>;

/// How a run ended.
struct RunEnd {
  Row row = {};
  bool is_rest_known = true;  ///< Else the rows that say when it settled are not known.
  std::optional<double> settled_since_s = {};
};

/// Two runs, as one differs from the other; every text and document about it is made of this.
struct Comparison {
  bool agrees = true;
  std::optional<DifferenceClass> difference;  ///< Where they do not agree.
  std::string shape;                          ///< What differs in shape, a sentence.
  std::string physics;  ///< How the names of the physics models differ, a sentence; sets no class.
  std::optional<Divergence> first;
  ContactChanges contacts;
  Distance distance;
  RunEnd expected_end;
  RunEnd actual_end;
  std::vector<Row> expected_around;  ///< Rows near the first divergence, as far as they are known.
  std::vector<Row> actual_around;

  /// Distance of the final rows, where both runs have settled.
  [[nodiscard]] std::optional<double> rest_shift_px() const {
    if (!expected_end.settled_since_s || !actual_end.settled_since_s) return std::nullopt;
    return distance_px(state_of(expected_end.row), state_of(actual_end.row));
  }
};

/// The class of a difference in rows or contacts.
[[nodiscard]] DifferenceClass class_of(const ContactChanges& contacts, const RunDistance& distance);

/// By which contacts are in order: its first step, which one it is, its last step.
[[nodiscard]] inline auto order_of(const Contact& contact) {
  return std::tuple(contact.step, contact.wall, contact.last_step);
}

/// The changes from contacts `a` to `b`, both in order.
template <class C>
[[nodiscard]] ContactChangesOf<C> contact_changes(const std::vector<C>& a, const std::vector<C>& b) {
  const auto which = [](const C& contact) { return std::get<1>(order_of(contact)); };
  std::set<decltype(which(a.front()))> all;
  const C* last = nullptr;  // Of a list that is full: what such a run has after it is not known.
  for (const std::vector<C>* const contacts : {&a, &b}) {
    for (const C& contact : *contacts) all.insert(which(contact));
    if (std::ssize(*contacts) >= kContactsRecordedMax &&
        (last == nullptr || order_of(contacts->back()) < order_of(*last)))
      last = &contacts->back();
  }
  ContactChangesOf<C> changes{.is_cut = last != nullptr};
  for (const auto& each : all) {
    const auto missing_in = [&](const std::vector<C>& others, const std::vector<C>& contacts) {
      std::vector<C> missing;
      auto other = others.begin();
      for (const C& contact : contacts) {
        if (which(contact) != each || (last != nullptr && order_of(*last) < order_of(contact))) continue;
        other = std::find_if_not(other, others.end(),
                                 [&](const C& one) { return order_of(one) < order_of(contact); });
        if (other == others.end() || order_of(*other) != order_of(contact))
          missing.push_back(contact);
        else
          ++other;  // It is the counterpart of one contact, not of two.
      }
      return missing;
    };
    const std::vector<C> gone = missing_in(b, a), come = missing_in(a, b);
    const std::size_t pairs = std::min(gone.size(), come.size());
    for (std::size_t pair = 0; pair < pairs; ++pair) changes.moved.push_back({gone[pair], come[pair]});
    const auto begin = static_cast<std::ptrdiff_t>(pairs);
    changes.only_a.insert(changes.only_a.end(), gone.begin() + begin, gone.end());
    changes.only_b.insert(changes.only_b.end(), come.begin() + begin, come.end());
  }
  return changes;
}

/// The first input that differs, as "inputs differ: fling in frame 41 -> none"; nothing where none does.
[[nodiscard]] std::optional<std::string> input_difference(const std::vector<Input>& a,
                                                          const std::vector<Input>& b);

}  // namespace hyrax
