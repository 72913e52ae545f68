#include "sim/explain/fitted_constant.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "sim/explain/step_site.h"
#include "sim/motion/listing.h"

namespace hyrax {
namespace {

constexpr std::size_t kStepsFitted = 32;
constexpr double kLargest = 1e300;

// Doubles as integers in the same order, so that intervals can be searched by their bits.
std::int64_t ordered(double value) {
  const auto bits = std::bit_cast<std::int64_t>(value);
  return bits < 0 ? std::numeric_limits<std::int64_t>::min() - bits : bits;
}
double from_ordered(std::int64_t place) {
  return std::bit_cast<double>(place < 0 ? std::numeric_limits<std::int64_t>::min() - place : place);
}

// Numbers, both ends included.
struct NumberInterval {
  double low = -kLargest;
  double high = kLargest;
  std::size_t steps = 0;  // That are not the listing's, and given by these numbers.
  [[nodiscard]] bool is_empty() const { return !(low <= high); }
};
NumberInterval common(const NumberInterval& a, const NumberInterval& b) {
  return {std::max(a.low, b.low), std::min(a.high, b.high), a.steps + b.steps};
}

// The listing with a number of our choice at some statements.
class FreeConstant {
 public:
  FreeConstant(const StepStatements& base, const StepSites& places) : step_(base) {
    const std::vector<StepSite> all = sites_of(step_);
    for (const std::size_t place : places) factors_.push_back(&all[place].statement());
    base_ = factors_.front()->factor;
  }

  [[nodiscard]] double base() const { return base_; }
  [[nodiscard]] bool is_threshold() const { return factors_.front()->form == Statement::Form::stop; }
  [[nodiscard]] Component target() const { return factors_.front()->target; }
  [[nodiscard]] const StepStatements& step_with(double number) {
    for (Statement* const statement : factors_) statement->factor = number;
    return step_;
  }
  [[nodiscard]] bool gives(double number, const ObservedStep& observed) {
    return hyrax::gives(step_with(number), observed);
  }
  // The target after the step.
  [[nodiscard]] double result(double number, const ObservedStep& observed) {
    State state = observed.before;
    StatementRun(observed.dt_s, observed.bounds)(step_with(number), state);
    return at(state, target());
  }

 private:
  StepStatements step_;
  std::vector<Statement*> factors_;
  double base_ = 0.0;
};

// A number that gives the step: of a threshold one beside the speed it is compared with, else by the secant
// rule, as results are linear in the number but for rounding.
std::optional<double> solution(FreeConstant& constant, const ObservedStep& observed) {
  State after = observed.after;
  const double wanted = at(after, constant.target());
  if (constant.is_threshold()) {
    const double speed = std::fabs(constant.result(constant.base(), observed));
    for (const double number : {std::nextafter(speed, kLargest), std::fabs(wanted)})
      if (constant.gives(number, observed)) return number;
    return std::nullopt;
  }
  double from = constant.base();
  double to = from == 0.0 ? 1e-3 : from * 1.001;
  for (int turn = 0; turn < 20; ++turn) {
    const double slope = (constant.result(to, observed) - constant.result(from, observed)) / (to - from);
    const double next = to + (wanted - constant.result(to, observed)) / slope;
    if (!std::isfinite(next) || next == to) break;
    from = to;
    to = next;
  }
  constexpr std::int64_t kBeside = 64;
  for (std::int64_t step = 0; step <= kBeside; ++step)
    for (const std::int64_t place : {ordered(to) + step, ordered(to) - step})
      if (constant.gives(from_ordered(place), observed)) return from_ordered(place);
  return std::nullopt;
}

// How far the numbers that give the step go on from one of them: outwards by doubling, then by halving.
double end_of(FreeConstant& constant, const ObservedStep& observed, double number, int direction) {
  const std::int64_t start = ordered(number);
  const auto number_at = [&](std::int64_t distance) { return from_ordered(start + direction * distance); };
  std::int64_t inside = 0;
  std::int64_t outside = 1;
  while (std::fabs(number_at(outside)) < kLargest && constant.gives(number_at(outside), observed)) {
    inside = outside;
    outside *= 2;
    if (outside > std::int64_t{1} << 60) return direction * kLargest;
  }
  if (!(std::fabs(number_at(outside)) < kLargest)) return direction * kLargest;
  while (outside - inside > 1) {
    const std::int64_t middle = inside + (outside - inside) / 2;
    (constant.gives(number_at(middle), observed) ? inside : outside) = middle;
  }
  return number_at(inside);
}

// The numbers that give the first steps of a run; nothing where there are none, or all are the listing's.
std::optional<NumberInterval> fit(FreeConstant& constant, const std::vector<ObservedStep>& steps) {
  NumberInterval interval;
  std::size_t fitted = 0;
  for (const ObservedStep& observed : steps) {
    if (fitted == kStepsFitted) break;
    // Of a threshold every step that meets it tells something, of a factor those that differ.
    const bool tells = constant.is_threshold()
                           ? !constant.gives(0.0, observed) || !constant.gives(kLargest, observed)
                           : !constant.gives(constant.base(), observed);
    if (!tells) continue;
    const bool differs = !constant.gives(constant.base(), observed);
    const std::optional<double> number = differs ? solution(constant, observed) : constant.base();
    if (!number) return std::nullopt;
    interval =
        common(interval, {end_of(constant, observed, *number, -1), end_of(constant, observed, *number, 1)});
    if (interval.is_empty()) return std::nullopt;
    ++fitted;
  }
  const bool has_base = interval.low <= constant.base() && constant.base() <= interval.high;
  return fitted == 0 || has_base ? std::nullopt : std::optional(interval);
}

// One number can always be made to give one step: a long one needs more of them.
bool is_confirmed(const NumberInterval& interval, double number) {
  constexpr std::size_t kShortText = 8;
  constexpr std::size_t kStepsAtLeast = 3;
  return interval.steps >= kStepsAtLeast || fmt::format("{}", number).size() <= kShortText;
}

// The intervals of all runs, those that meet joined.
std::vector<NumberInterval> joined_fits(FreeConstant& constant,
                                        const std::vector<const std::vector<ObservedStep>*>& runs) {
  std::vector<NumberInterval> joined;
  for (const std::vector<ObservedStep>* const steps : runs) {
    const std::optional<NumberInterval> interval = fit(constant, *steps);
    if (!interval) continue;
    const auto meets = std::ranges::find_if(
        joined, [&](const NumberInterval& other) { return !common(other, *interval).is_empty(); });
    if (meets == joined.end())
      joined.push_back(*interval);
    else
      *meets = common(*meets, *interval);
  }
  return joined;
}

// "left wall: RESTITUTION", or "RESTITUTION" where all statements of the constant are changed.
std::string name_at(const std::vector<StepSite>& all, const StepSites& places) {
  const Operation operation = all[places.front()].statement().operation;
  const auto uses = std::ranges::count_if(
      all, [&](const StepSite& site) { return site.statement().operation == operation; });
  std::string name;
  if (static_cast<std::size_t>(uses) != places.size())
    for (const std::size_t place : places)
      name += all[place].wall.empty()
                  ? fmt::format("{}: ", all[place].statement().target == Component::vx ? "vx" : "vy")
                  : std::string(all[place].wall);
  return name + std::string(constant_name_of(operation));
}

}  // namespace

std::vector<Candidate> fitted_candidates(const Constants& golden,
                                         const std::vector<const std::vector<ObservedStep>*>& runs) {
  StepStatements base = listing(golden);
  const std::vector<StepSite> all = sites_of(base);
  std::vector<Candidate> candidates;
  for (const StepSites& places : site_sets(all)) {
    const Operation operation = all[places.front()].statement().operation;
    double Constants::*const member = constant_of(operation);
    if (member == nullptr) continue;
    FreeConstant constant(base, places);
    const double sign = operation == Operation::restitution ? -1.0 : 1.0;
    for (const NumberInterval& interval : joined_fits(constant, runs)) {
      const double number = shortest_decimal(interval.low, interval.high);
      if (!is_confirmed(interval, number)) continue;
      const std::string detail =
          fmt::format("{} {} -> {}", name_at(all, places), golden.*member, sign * number);
      candidates.emplace_back(
          Cause{name_of(operation), CauseKind::constant, detail, golden.*member, sign * number},
          TieRank::other_constant, constant.step_with(number));
    }
  }
  std::ranges::stable_sort(candidates, {},
                           [](const Candidate& one) { return fmt::format("{}", *one.cause.to).size(); });
  return candidates;
}

}  // namespace hyrax
