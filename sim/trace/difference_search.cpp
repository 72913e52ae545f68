#include "sim/trace/step_difference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "sim/trace/step_draw.h"
#include "sim/trace/step_program.h"

namespace hyrax {
namespace {

constexpr int kRepairsMax = 12;  // Conditions that are put right, one after the other, for one path.
constexpr int kTurnsMax = 8;     // Of the secant method.
constexpr std::int64_t kFlingFrames = 600;  // Played where a row does not hold all members.

bool is_state(StepNumber number) { return number < StepNumber::dt; }

// The number that is `ulps` further.
double moved_by_ulps(double value, int ulps) {
  for (; ulps > 0; --ulps) value = std::nextafter(value, HUGE_VAL);
  for (; ulps < 0; ++ulps) value = std::nextafter(value, -HUGE_VAL);
  return value;
}

double moved(StepNumber number, double value, int ulps) {
  return limited(number, is_size(number) ? value + ulps : moved_by_ulps(value, ulps));
}

// A step that is changed until it takes a path, and from there to either side of the conditions.
class Search {
 public:
  // @param owner plays the step that has the difference, `other` the other one.
  Search(const StepDifference& difference, const StepProgram& owner, const StepProgram& other,
         std::uint64_t seed, std::int64_t steps_max)
      : difference_(difference),
        owner_(owner),
        other_(other),
        step_(owner.step()),
        draw_(step_, other.step(), seed),
        steps_max_(steps_max),
        dependencies_(dependencies_of(step_)) {
    for (std::size_t path = 0; path < difference.is_on_path.size(); ++path)
      if (difference.is_on_path[path]) paths_.push_back(path);
  }

  DifferenceSearch run() {
    if (paths_.empty()) return result_;
    for (std::size_t round = 0; !is_done(); ++round) {
      // Of four rounds one is not directed. Sizes and rates are real in the first ones, then in every other.
      const bool is_real = round < 400 || round % 2 == 0;
      if (round % 4 == 3) {
        for (int draw = 0; draw < 16 && !is_done(); ++draw) {
          now_ = draw_.numbers(is_real);
          check();
        }
        continue;
      }
      now_ = draw_.numbers(is_real);
      const StepPath& path = step_.paths_of(CoreFunction::update)[paths_[draw_.below(paths_.size())]];
      if (check() || !take(path, is_real)) continue;
      explore(path, is_real);
    }
    return result_;
  }

 private:
  [[nodiscard]] bool is_done() const { return result_.found || result_.steps_tried >= steps_max_; }

  // Takes both steps from `now_`. Returns whether that ended the search.
  bool check() {
    const StepInput input = input_of(now_);
    TracedBody owner(owner_, input.world.state);
    TracedBody other(other_, input.world.state);
    const bool has_further = !owner.further_members().empty() || !other.further_members().empty();
    DifferenceWatch watch;
    for (std::int64_t frame = 1; frame <= (has_further ? kFlingFrames : 1); ++frame) {
      const BodyPair before{owner, other};
      owner.update(input);
      other.update(input);
      ++result_.steps_tried;
      const State a = {owner.x(), owner.y(), owner.vx(), owner.vy()};
      const State b = {other.x(), other.y(), other.vx(), other.vy()};
      if (!is_finite(a) && !is_finite(b)) break;
      const bool is_decided = watch.take(difference_, input, before, {owner, other});
      result_.further_members |= watch.further_members();
      if (is_decided) {
        result_.found = input;
        result_.frames = frame;
        break;
      }
      // It goes on from the accepted step's row, as a library is played: other differences may change rows.
      (difference_.is_in_accepted ? other : owner).set_row(difference_.is_in_accepted ? a : b);
    }
    return is_done();
  }

  void evaluate() {
    const StepInput input = input_of(now_);
    std::array<double, kStepMembersMax> members{};
    const State& state = input.world.state;
    owner_.run(CoreFunction::construct, members,
               {state.x_px, state.y_px, state.vx_px_per_s, state.vy_px_per_s, 0.0});
    owner_.evaluate(members, update_arguments(input.dt_s, input.world.window, input.world.sprite), values_);
    ++result_.steps_tried;
  }

  [[nodiscard]] double value(StepIndex expression) const { return values_[expression]; }
  [[nodiscard]] double gap(const StepComparison& comparison) const {
    return value(comparison.left) - value(comparison.right);
  }
  [[nodiscard]] bool holds(const StepComparison& comparison) const {
    return hyrax::holds(comparison.relation, value(comparison.left), value(comparison.right));
  }
  [[nodiscard]] const StepComparison& comparison_of(const StepOutcome& outcome) const {
    return step_.comparisons[outcome.comparison];
  }
  double& number(StepNumber which) { return now_[static_cast<std::size_t>(which)]; }

  // Changes `now_` until it takes the path: one condition after the other.
  bool take(const StepPath& path, bool keeps_real) {
    for (int repair = 0; repair < kRepairsMax && !is_done(); ++repair) {
      evaluate();
      std::vector<const StepOutcome*> wrong;
      for (const StepOutcome& outcome : path.outcomes)
        if (holds(comparison_of(outcome)) != outcome.holds) wrong.push_back(&outcome);
      if (wrong.empty()) return true;
      const StepOutcome& outcome = *wrong[draw_.below(wrong.size())];
      const StepComparison& comparison = comparison_of(outcome);
      const std::optional<StepNumber> which = number_to_change(comparison, keeps_real);
      if (!which) return false;
      const double before = number(*which);
      if (!solve(comparison, *which)) {
        number(*which) = nearest(comparison, *which, before);
        continue;
      }
      if (!step_aside(comparison, *which, outcome.holds)) number(*which) = before;
    }
    return false;
  }

  // One that the comparison depends on. Sizes and dt stay real where the state will do.
  std::optional<StepNumber> number_to_change(const StepComparison& comparison, bool keeps_real) {
    const unsigned bits = dependencies_[comparison.left] | dependencies_[comparison.right];
    std::array<StepNumber, kStepNumbers> candidates{};
    std::size_t count = 0;
    const bool only_state = keeps_real || draw_.below(4) != 0;
    for (const bool takes_all : {false, true}) {
      for (std::size_t index = 0; index < kStepNumbers; ++index) {
        const auto candidate = static_cast<StepNumber>(index);
        if ((bits >> index & 1u) != 0 && (takes_all || !only_state || is_state(candidate)))
          candidates[count++] = candidate;
      }
      if (count > 0) return candidates[draw_.below(count)];
    }
    return std::nullopt;
  }

  // How far a number is changed to see what that does.
  static double probe(StepNumber which, double value) {
    return is_size(which) ? 16.0 : std::max(std::fabs(value) * 0x1p-6, which == StepNumber::dt ? 1e-3 : 1.0);
  }

  // Where one number alone does not bring the sides together, as outside of a circle: the value with which
  // they are nearest, by a parabola through three. The value itself where that is no nearer.
  double nearest(const StepComparison& comparison, StepNumber which, double value) {
    const double change = probe(which, value);
    std::array<double, 3> gaps{};
    for (std::size_t place = 0; place < 3; ++place) {
      number(which) = value + (static_cast<double>(place) - 1.0) * change;
      evaluate();
      gaps[place] = gap(comparison);
    }
    const double vertex =
        limited(which, value - change * (gaps[2] - gaps[0]) / (2.0 * (gaps[2] - 2.0 * gaps[1] + gaps[0])));
    if (!std::isfinite(vertex)) return value;
    number(which) = vertex;
    evaluate();
    return std::fabs(gap(comparison)) < std::fabs(gaps[1]) ? vertex : value;
  }

  // Brings both sides of the comparison together, by one number: the secant method. Values are evaluated at
  // the end. Returns whether they came near.
  bool solve(const StepComparison& comparison, StepNumber which) {
    double first = number(which);
    evaluate();
    double first_gap = gap(comparison);
    const double change = probe(which, first);
    double second = limited(which, first + change);
    if (second == first) second = limited(which, first - change);
    for (int turn = 0; turn < kTurnsMax && first_gap != 0.0 && !is_done(); ++turn) {
      number(which) = second;
      evaluate();
      const double second_gap = gap(comparison);
      const double slope = (second_gap - first_gap) / (second - first);
      if (second_gap == 0.0) return true;
      if (!(std::fabs(slope) > 0.0) || !std::isfinite(slope)) return false;
      first = second;
      first_gap = second_gap;
      second = limited(which, second - second_gap / slope);
      if (second == first) break;
    }
    evaluate();
    const double scale =
        std::max({std::fabs(value(comparison.left)), std::fabs(value(comparison.right)), 1.0});
    return std::fabs(gap(comparison)) <= scale * (is_size(which) ? 1.0 : 1e-3);
  }

  // From where both sides are near, to where the comparison is as wanted: at the next number, or further.
  bool step_aside(const StepComparison& comparison, StepNumber which, bool wanted) {
    const double root = number(which);
    const bool is_near = draw_.below(3) == 0;
    for (int turn = 0; turn < 8 && !is_done(); ++turn) {
      double aside = root;
      if (is_near || comparison.relation == Relation::equal)
        aside = moved(which, root, (turn + 1) / 2 * (turn % 2 == 0 ? 1 : -1));
      else
        aside = root + (is_size(which)            ? draw_.of_any_size(0, 10)
                        : which == StepNumber::dt ? draw_.of_any_size(-12, 0)
                                                  : draw_.of_any_size(-6, 10));
      number(which) = limited(which, aside);
      evaluate();
      if (holds(comparison) == wanted) return true;
    }
    return false;
  }

  // `now_` is on the path: neighbours, and both sides of the conditions of the path.
  void explore(const StepPath& path, bool keeps_real) {
    const StepNumbers base = now_;
    if (check()) return;
    for (int turn = 0; turn < 4 && !is_done(); ++turn) {
      now_ = base;
      const auto which = static_cast<StepNumber>(draw_.below(keeps_real ? 4 : kStepNumbers));
      number(which) = limited(which, is_size(which) ? number(which) + draw_.of_any_size(0, 8)
                                                    : number(which) * (1.0 + draw_.of_any_size(-30, -2)));
      check();
    }
    for (int turn = 0; turn < 2 && !is_done() && !path.outcomes.empty(); ++turn) {
      now_ = base;
      const bool takes_own = turn == 0 && difference_.comparison != kNoIndex;
      const StepComparison& comparison =
          takes_own ? step_.comparisons[difference_.comparison]
                    : comparison_of(path.outcomes[draw_.below(path.outcomes.size())]);
      const std::optional<StepNumber> which = number_to_change(comparison, keeps_real);
      if (!which || !solve(comparison, *which)) continue;
      const double root = number(*which);
      for (int ulps = -2; ulps <= 2 && !is_done(); ++ulps) {
        number(*which) = moved(*which, root, ulps);
        check();
      }
    }
  }

  const StepDifference& difference_;
  const StepProgram& owner_;
  const StepProgram& other_;
  const TracedStep& step_;
  StepDraw draw_;
  std::int64_t steps_max_;
  std::vector<StepNumberBits> dependencies_;
  std::vector<std::size_t> paths_;
  StepNumbers now_{};
  std::vector<double> values_;
  DifferenceSearch result_;
};

}  // namespace

DifferenceSearch StepPair::search(std::size_t difference, std::uint64_t seed, std::int64_t steps_max) const {
  if (!programs_[0] || !programs_[1]) return {};
  const StepDifference& wanted = differences_[difference];
  const std::size_t owner = wanted.is_in_accepted ? 0 : 1;
  return Search(wanted, *programs_[owner], *programs_[1 - owner], seed, steps_max).run();
}

}  // namespace hyrax
