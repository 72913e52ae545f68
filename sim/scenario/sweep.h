// Many scenarios that differ in some numbers, as a plain value: the members of a sweep.
//
// The file format `hyrax-sweep/1` says the same in JSON; tools/files reads and writes it.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "sim/scenario/numbers.h"
#include "sim/scenario/scenario.h"

namespace hyrax {

/// One of `count` parts: every number k with k mod count = index.
struct WorkPart {
  std::int64_t index = 0;
  std::int64_t count = 1;
  bool operator==(const WorkPart&) const = default;

  [[nodiscard]] std::int64_t member(std::int64_t row) const { return index + row * count; }
  /// How many of the numbers 0 .. members - 1 are in this part.
  [[nodiscard]] std::int64_t rows(std::int64_t members) const {
    return index < members ? (members - index - 1) / count + 1 : 0;
  }
};

inline constexpr std::int64_t kMembersMax = 1'000'000'000'000;

/// A number of a scenario in the type of its key: double, std::int64_t, or std::uint64_t for a seed, true or
/// false.
using SweepNumber = std::variant<double, std::int64_t, std::uint64_t>;
/// A whole number as one of that kind. REQUIRES: the kind has it.
[[nodiscard]] SweepNumber in_kind(ScenarioNumberKind kind, std::int64_t value);

/// Drawn: `low + (high - low) * u`; for an integer key or a seed `floor(low + (high - low + 1) * u)` in exact
/// arithmetic, both ends included.
struct UniformDraw {
  SweepNumber low;   ///< In the type of the key, as all numbers here.
  SweepNumber high;  ///< >= low.
};
/// Drawn: entry `floor(u * n)`.
struct ChoiceDraw {
  std::vector<SweepNumber> values;  ///< At least one.
};
/// `count` values from low to high; every combination of all grids is played.
struct GridAxis {
  SweepNumber low;
  SweepNumber high;        ///< >= low; if whole, `high - low` is a multiple of `count - 1`.
  std::int64_t count = 1;  ///< >= 1.
  std::int64_t repeats =
      1;  ///< Consecutive members that share a value: product of the counts of later grids.
};
/// Value `index` of a grid: `low + ((high - low) * index) / (count - 1)`, and `high` itself at the end.
[[nodiscard]] SweepNumber value_of(const GridAxis& grid, std::int64_t index);

/// The member's number itself.
struct MemberNumber {};

struct VariedKey {
  std::string pointer;  ///< JSON Pointer into the scenario.
  ScenarioNumberKind kind = ScenarioNumberKind::real;
  std::variant<UniformDraw, ChoiceDraw, GridAxis, MemberNumber> variation;
  std::vector<std::string> names = {};  ///< Of the values 0, 1, ..., as files may give them.
};

/// What is computed of every member.
enum class Keep : std::uint8_t { final, contacts, at_rest, extremes, state_hash };
inline constexpr std::array<std::string_view, 5> kKeepNames = {"final", "contacts", "at_rest", "extremes",
                                                               "state_hash"};
class KeepSet {
 public:
  void add(Keep keep) { set_.set(static_cast<std::size_t>(keep)); }
  [[nodiscard]] bool has(Keep keep) const { return set_.test(static_cast<std::size_t>(keep)); }
  /// Those of them that are among these.
  [[nodiscard]] KeepSet only(std::initializer_list<Keep> these) const {
    KeepSet kept;
    for (const Keep keep : these)
      if (has(keep)) kept.add(keep);
    return kept;
  }

 private:
  std::bitset<kKeepNames.size()> set_;
};

/// What a sweep says of the scenarios of any core.
struct SweepPlan {
  std::int64_t members = 1;     ///< 1 .. kMembersMax; a multiple of the product of all grids' counts.
  std::uint64_t seed = 0;       ///< Of the draws.
  std::vector<VariedKey> vary;  ///< Sorted by the bytes of their pointers.
  KeepSet keep;
};

struct Sweep : SweepPlan {
  Scenario base;  ///< Member 0, without `expect`: every varied key exists in it.
};

/// The value of key `key` in a member. A draw takes u_(member * K + key) of the sweep's seed, with K keys
/// (sim/scenario/split_mix64.h). REQUIRES: key < vary.size(), 0 <= member < members.
[[nodiscard]] SweepNumber value_of(const SweepPlan& sweep, std::size_t key, std::int64_t member);

/// How far a whole number lies above a lower one. REQUIRES: both of one type, low <= high.
[[nodiscard]] std::uint64_t whole_distance(const SweepNumber& low, const SweepNumber& high);

/// Every value that a key can have lies between these; of a choice, all its values.
[[nodiscard]] std::vector<SweepNumber> extremes_of(const SweepPlan& sweep, std::size_t key);

[[nodiscard]] double as_double(const SweepNumber& number);

/// Names a member's scenario after the base's and the member.
void name_member(ScenarioHead& scenario, std::int64_t member);

/// The scenarios of a sweep's members, one at a time. Refers to the sweep.
class SweepMembers {
 public:
  /// REQUIRES: every varied key exists in the base.
  explicit SweepMembers(const Sweep& sweep);
  SweepMembers(const SweepMembers&) = delete;
  SweepMembers& operator=(const SweepMembers&) = delete;

  /// The scenario of a member, valid until the next call.
  [[nodiscard]] const Scenario& scenario(std::int64_t member);

 private:
  const Sweep& sweep_;
  Scenario scenario_;
  std::vector<NumberField> fields_;
};

/// The first member that is not a valid scenario because of numbers that depend on one another: more than
/// kStepsMax frames, a duration with frames of no length, an event without a frame. Members are looked at one
/// by one, and only if keys vary that this can depend on.
/// REQUIRES: every number is within its own limits.
[[nodiscard]] std::optional<std::int64_t> first_inconsistent_member(const Sweep& sweep);

}  // namespace hyrax
