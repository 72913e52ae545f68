#include "sim/trace/listing_step.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/trace/numbered.h"
#include "sim/trace/step_difference.h"
#include "sim/trace/step_text.h"

namespace hyrax {
namespace {

constexpr std::size_t kListingMembers = 4;

// The operations of the listing, in its order.
class ListingBuilder {
 public:
  // A constant that is NaN is not known: an argument of the paper's name takes its place.
  explicit ListingBuilder(const Constants& constants) {
    for (std::size_t place = 0; place < kConstantFields.size(); ++place) {
      const double value = constants.*kConstantFields[place];
      constants_[place] = std::isnan(value) ? argument(kPaperNames[place]) : constant(value);
    }
  }

  TracedStep step() {
    add_update();
    const std::array<Index, 4> members = {argument("x"), argument("y"), argument("vx"), argument("vy")};
    const auto [x, y, vx, vy] = members;
    add_path(CoreFunction::construct, {},
             {argument("start_x"), argument("start_y"), argument("start_vx"), argument("start_vy")});
    add_path(CoreFunction::set_position, {}, {argument("new_x"), argument("new_y"), vx, vy});
    add_path(CoreFunction::set_velocity, {}, {x, y, argument("new_vx"), argument("new_vy")});
    add_path(CoreFunction::reset_velocity, {}, {x, y, constant(0.0), constant(0.0)});
    return canonical(step_);
  }

 private:
  using Index = StepIndex;
  // What an axis is after its walls: where it was found so.
  struct Case {
    std::vector<StepOutcome> outcomes;
    Index position = kNoIndex;
    Index speed = kNoIndex;
    bool is_ground = false;
  };

  Index add(Expression expression) {
    step_.expressions.push_back(std::move(expression));
    return static_cast<Index>(step_.expressions.size() - 1);
  }
  Index argument(std::string_view name, NumberKind kind = NumberKind::real) {
    return add({.op = Operator::argument, .kind = kind, .name = std::string(name)});
  }
  Index constant(double value) { return add({.op = Operator::constant, .value = value}); }
  Index apply(Operator op, Index a, Index b = kNoIndex) {
    return add({.op = op, .operands = {a, b, kNoIndex}});
  }
  Index product(Index a, Index b) { return apply(Operator::multiply, a, b); }
  Index sum(Index a, Index b) { return apply(Operator::add, a, b); }
  Index compare(Index left, Index right) {
    step_.comparisons.push_back({left, right, Relation::less});
    return static_cast<Index>(step_.comparisons.size() - 1);
  }
  void add_path(CoreFunction function, std::vector<StepOutcome> outcomes, std::vector<Index> members) {
    step_.paths[static_cast<std::size_t>(function)].push_back({std::move(outcomes), std::move(members)});
  }

  Index bound(std::string_view window, std::string_view sprite) {
    const auto whole = [&](Operator op, Index a, Index b = kNoIndex) {
      return add({.op = op, .kind = NumberKind::whole, .operands = {a, b, kNoIndex}});
    };
    const Index size = whole(Operator::negate, argument(sprite, NumberKind::whole));
    return apply(Operator::to_real, whole(Operator::add, argument(window, NumberKind::whole), size));
  }

  // Free, at the near wall (0), and at the far one.
  std::vector<Case> cases_of(Index position, Index speed, Index far) {
    const Index zero = constant(0.0);
    const Index is_near = compare(position, zero);
    const Index is_far = compare(far, position);
    const Index turned = product(apply(Operator::negate, speed), constants_[2]);
    return {{{{is_near, false}, {is_far, false}}, position, speed},
            {{{is_near, true}}, zero, turned},
            {{{is_near, false}, {is_far, true}}, far, turned, true}};
  }

  void add_update() {
    const auto [gravity, drag, restitution, friction, threshold] = constants_;
    const Index dt = argument("dt");
    const Index vx = product(argument("vx"), drag);
    const Index vy = product(sum(argument("vy"), product(gravity, dt)), drag);
    const std::vector<Case> x_cases =
        cases_of(sum(argument("x"), product(vx, dt)), vx, bound("window_width", "sprite_width"));
    std::vector<Case> y_cases =
        cases_of(sum(argument("y"), product(vy, dt)), vy, bound("window_height", "sprite_height"));
    Case rest = y_cases.back();
    const Index size =
        add({.op = Operator::call, .operands = {rest.speed, kNoIndex, kNoIndex}, .name = "fabs"});
    const Index is_slow = compare(size, threshold);
    y_cases.back().outcomes.push_back({is_slow, false});
    rest.outcomes.push_back({is_slow, true});
    rest.speed = constant(0.0);
    y_cases.push_back(rest);
    for (const Case& in_x : x_cases)
      for (const Case& in_y : y_cases) {
        std::vector<StepOutcome> outcomes = in_x.outcomes;
        outcomes.insert(outcomes.end(), in_y.outcomes.begin(), in_y.outcomes.end());
        add_path(CoreFunction::update, std::move(outcomes),
                 {in_x.position, in_y.position, in_y.is_ground ? product(in_x.speed, friction) : in_x.speed,
                  in_y.speed});
      }
  }

  TracedStep step_{.members = std::vector<NumberKind>(kListingMembers, NumberKind::real)};
  std::array<Index, kConstantFields.size()> constants_{};
};

TracedStep without_further_members(TracedStep step) {
  step.members.resize(kListingMembers);
  for (std::vector<StepPath>& paths : step.paths)
    for (StepPath& path : paths) path.members.resize(kListingMembers);
  return canonical(step);
}

// How many of the listing's operations and conditions the step does not have; then, negative, how many the
// listing has. Of two signs of a constant, that which the step has leaves no operation out: it has the less
// misfit.
std::pair<std::int64_t, std::int64_t> misfit(const TracedStep& listing, const TracedStep& step) {
  SharedNumbers shared;
  static_cast<void>(shared.of(step));  // Numbers from here on are of what only the listing has.
  const auto [expressions, comparisons] = shared.of(listing);
  std::int64_t count =
      std::ranges::count_if(comparisons, [&](StepIndex number) { return number >= step.comparisons.size(); });
  for (std::size_t index = 0; index < expressions.size(); ++index)
    if (expressions[index] >= step.expressions.size() && listing.expressions[index].op > Operator::constant)
      ++count;
  return {count, -std::ssize(listing.expressions)};
}

// One constant after the other: the number of the step's own with which the least of the listing is missing.
// NaN where none is better than none.
Constants fitted_constants(const TracedStep& step) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> numbers;
  for (const Expression& expression : step.expressions)
    if (expression.op == Operator::constant && expression.kind == NumberKind::real) {
      numbers.push_back(expression.value);
      numbers.push_back(-expression.value);
    }
  Constants constants{kUnknown, kUnknown, kUnknown, kUnknown, kUnknown};
  for (double Constants::*const field : kConstantFields) {
    auto least = misfit(ListingBuilder(constants).step(), step);
    double fitted = kUnknown;
    for (const double number : numbers) {
      constants.*field = number;
      const auto missing = misfit(ListingBuilder(constants).step(), step);
      if (missing >= least) continue;
      least = missing;
      fitted = number;
    }
    constants.*field = fitted;
  }
  return constants;
}

std::string difference_of(const TracedStep& step, const Constants& constants) {
  if (step.members != std::vector<NumberKind>(kListingMembers, NumberKind::real))
    return "x, y, vx and vy that are not double";
  const StepPair pair(ListingBuilder(constants).step(), step);
  const auto& differences = pair.differences();
  if (differences.empty()) return "what the constructor or a setter does";
  const auto own = std::ranges::find(differences, false, &StepDifference::is_in_accepted);
  return own != differences.end() ? own->text : "the paper's " + differences.front().text + " is missing";
}

}  // namespace

TracedStep listing_step(const Constants& constants) { return ListingBuilder(constants).step(); }

PaperMatch match_paper(const TracedStep& step) {
  const TracedStep listed = without_further_members(step);
  const Constants constants = fitted_constants(listed);
  if (step_text(listing_step(constants)) == step_text(listed)) return {.constants = constants};
  return {.difference = difference_of(listed, constants)};
}

}  // namespace hyrax
