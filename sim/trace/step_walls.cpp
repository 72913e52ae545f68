#include "sim/trace/step_program.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <tuple>

#include "sim/trace/decision_tree.h"
#include "sim/trace/step_draw.h"

namespace hyrax {
namespace {

bool is_in_x(Wall wall) { return wall == Wall::left || wall == Wall::right; }

// What an expression says of a position: `factor` times it, and a sum of sizes.
struct Meaning {
  StepNumberBits depends_on = 0;
  char axis = '\0';                // 'x' or 'y' of a position.
  double factor = 0.0;             // Below 0: the position grows where this falls.
  std::array<double, 5> sum = {};  // Factors of the sizes in their order; a constant. Of one that is no sum
                                   // of sizes those of the window, about.

  template <class... Number>
  [[nodiscard]] bool has(Number... numbers) const {
    return (depends_on & bits_of(numbers...)) != 0;
  }
  [[nodiscard]] bool has_others() const { return (depends_on & ~kSizeBits) != 0; }  // That are no sizes.
  [[nodiscard]] bool has_window() const { return sum[0] != 0.0 || sum[1] != 0.0; }
  [[nodiscard]] bool is_zero() const { return depends_on == 0 && sum[4] == 0.0; }
  [[nodiscard]] bool is_bound() const { return is_zero() || (depends_on != 0 && !has_others()); }

  void add(const Meaning& other, double times) {
    axis = axis == '\0' ? other.axis : axis;
    factor += times * other.factor;
    for (std::size_t part = 0; part < sum.size(); ++part) sum[part] += times * other.sum[part];
  }
};

class Meanings {
  static constexpr std::size_t kFirstSize = static_cast<std::size_t>(StepNumber::window_width);

 public:
  explicit Meanings(const TracedStep& step) : dependencies_(dependencies_of(step)) {
    for (const StepPath& path : step.paths_of(CoreFunction::update))
      for (std::size_t member = 0; member < 2; ++member) ends_[member].insert(path.members[member]);
    for (const Expression& expression : step.expressions) add(expression);
  }

  [[nodiscard]] const Meaning& of(StepIndex expression) const { return meanings_[expression]; }

 private:
  void add(const Expression& expression) {
    const auto index = static_cast<StepIndex>(meanings_.size());
    Meaning meaning{.depends_on = dependencies_[index]};
    const auto operand = [&](std::size_t place) -> const Meaning& { return of(expression.operands[place]); };
    const bool is_fused = expression.op == Operator::call && expression.name == "fma";
    switch (expression.op) {
      case Operator::constant:
        meaning.sum[4] = expression.value;
        break;
      case Operator::argument:
        if (expression.name == "x" || expression.name == "y") meaning.axis = expression.name[0];
        meaning.factor = meaning.axis == '\0' ? 0.0 : 1.0;
        for (std::size_t size = 0; size < 4; ++size)
          meaning.sum[size] = meaning.has(static_cast<StepNumber>(kFirstSize + size)) ? 1.0 : 0.0;
        break;
      case Operator::negate:
      case Operator::to_real:
      case Operator::to_single:
        meaning.add(operand(0), expression.op == Operator::negate ? -1.0 : 1.0);
        break;
      case Operator::add:
        if (operand(0).axis == '\0' || operand(1).axis == '\0' || operand(0).axis == operand(1).axis)
          for (const std::size_t place : {0U, 1U}) meaning.add(operand(place), 1.0);
        for (const std::size_t place : {0U, 1U})
          if (operand(place).is_bound()) take_clamped(operand(1 - place), meaning);
        break;
      case Operator::multiply:
      case Operator::divide:
        for (const std::size_t place : {0U, 1U}) {
          const double by = operand(place).sum[4];
          if (operand(place).depends_on != 0 || by == 0.0) continue;
          if (expression.op == Operator::multiply) meaning.add(operand(1 - place), by);
          if (expression.op == Operator::divide && place == 1) meaning.add(operand(0), 1.0 / by);
          break;
        }
        break;
      default:
        if (is_fused) meaning.add(operand(2), 1.0);
        if (is_fused && operand(2).is_bound()) take_clamped(meaning, meaning);
    }
    if (!meaning.has_others() && meaning.sum == std::array<double, 5>{})
      for (const StepIndex each : expression.used_operands())
        if (of(each).has_window()) meaning.sum = of(each).sum;
    if (meaning.factor == 0.0) meaning.axis = '\0';
    // Where a path ends is a position, however it was calculated: a reflected one is no negated one.
    for (std::size_t member = 0; member < 2; ++member)
      if (ends_[member].contains(index) && meaning.has_others() && expression.op != Operator::argument) {
        meaning.axis = "xy"[member];
        meaning.factor = 1.0;
        meaning.sum = {};
      }
    meanings_.push_back(meaning);
  }

  // A move from a bound to which an earlier part of the step clamped the position.
  static void take_clamped(const Meaning& move, Meaning& meaning) {
    const bool has_x = move.has(StepNumber::x, StepNumber::vx);
    if (meaning.axis != '\0' || !move.has(StepNumber::dt) || has_x == move.has(StepNumber::y, StepNumber::vy))
      return;
    meaning.axis = has_x ? 'x' : 'y';
    meaning.factor = 1.0;
    meaning.sum = {};
  }

  std::vector<StepNumberBits> dependencies_;
  std::array<std::set<StepIndex>, 2> ends_;
  std::vector<Meaning> meanings_;
};

// A comparison of a position with a bound.
struct WallComparison {
  Wall wall = Wall::left;
  bool beyond = false;  // The outcome that decides so.
  StepIndex position = kNoIndex;
  StepIndex bound = kNoIndex;
  double scale = 1.0;                 // How much the sides differ for each pixel.
  bool is_for_large_sprites = false;  // An upper bound of 0.
};

class WallFinder {
 public:
  explicit WallFinder(const TracedStep& step) : step_(step), meanings_(step) {
    for (std::size_t index = 0; index < step.comparisons.size(); ++index)
      walls_.push_back(wall_of(step.comparisons[index]));
    leave_out_old_positions();
    for (const StepPath& path : step.paths_of(CoreFunction::update)) {
      contacts_.push_back(contacts_of(path));
      evaluated_.push_back(evaluated_by(step, path));
    }
    depths_.resize(step.expressions.size());
    for (std::size_t index = 0; index < depths_.size(); ++index)
      for (const StepIndex operand : step.expressions[index].used_operands())
        depths_[index] = std::max(depths_[index], depths_[operand] + 1);
  }

  std::vector<std::vector<PathContact>> find() {
    const std::vector<StepPath>& paths = step_.paths_of(CoreFunction::update);
    std::vector<std::vector<PathContact>> found = contacts_;
    for (std::size_t path = 0; path < paths.size(); ++path) {
      std::vector<std::pair<std::size_t, PathContact>> ordered;  // By the number of walls before each.
      for (PathContact contact : contacts_[path]) {
        const std::optional<std::size_t> before =
            asks_once(paths[path], contact.wall) ? path_before(path, contact.wall) : std::nullopt;
        if (before) contact.before = velocity_after(paths[*before]);
        ordered.emplace_back(before ? contacts_[*before].size() : 0, contact);
      }
      std::ranges::stable_sort(ordered, {}, [](const auto& entry) { return entry.first; });
      VelocityIndices next;  // At the wall that follows.
      for (std::size_t place = ordered.size(); place-- > 0; next = found[path][place].before) {
        found[path][place] = ordered[place].second;
        found[path][place].after = next.vx == kNoIndex ? velocity_after(paths[path]) : next;
      }
    }
    return found;
  }

 private:
  [[nodiscard]] const Meaning& meaning(StepIndex expression) const { return meanings_.of(expression); }

  static VelocityIndices velocity_after(const StepPath& path) { return {path.members[2], path.members[3]}; }

  // Where a wall is asked for the new position, it is not met by the one before the step.
  void leave_out_old_positions() {
    const auto is_old = [&](const WallComparison& wall) {
      return step_.expressions[wall.position].op == Operator::argument;
    };
    std::set<Wall> asked;
    for (const auto& wall : walls_)
      if (wall && !is_old(*wall)) asked.insert(wall->wall);
    for (auto& wall : walls_)
      if (wall && is_old(*wall) && asked.contains(wall->wall)) wall.reset();
  }

  // Whether a position is compared with 0 as with a lower bound, by the same relation: `position < 0` beside
  // `0 < position`. Beside `0 <= position` it asks the same.
  [[nodiscard]] bool is_left_of_zero(StepIndex position, Relation relation) const {
    return std::any_of(step_.comparisons.begin(), step_.comparisons.end(), [&](const StepComparison& other) {
      return other.left == position && other.relation == relation && meaning(other.right).is_zero();
    });
  }

  [[nodiscard]] std::optional<WallComparison> wall_of(const StepComparison& comparison) const {
    if (comparison.relation == Relation::equal) return std::nullopt;
    const bool is_left_position = meaning(comparison.left).axis != '\0';
    WallComparison wall{.position = is_left_position ? comparison.left : comparison.right,
                        .bound = is_left_position ? comparison.right : comparison.left};
    const Meaning& position = meaning(wall.position);
    const Meaning& bound = meaning(wall.bound);
    if (position.axis == '\0' || bound.has_others()) return std::nullopt;
    // Solved for the position: it is low or high where the comparison holds.
    Meaning solved;
    solved.add(bound, 1.0 / position.factor);
    solved.add(Meaning{.sum = position.sum}, -1.0 / position.factor);
    const auto& sum = solved.sum;
    const bool has_sizes = std::any_of(sum.begin(), sum.begin() + 4, [](double size) { return size != 0.0; });
    if (!has_sizes && (sum[4] != 0.0 || (bound.depends_on != 0 && bound.sum == Meaning().sum)))
      return std::nullopt;
    wall.scale = std::fabs(position.factor);
    const bool holds_low = is_left_position == (position.factor > 0.0);
    const bool has_upper_bound = sum[position.axis == 'x' ? 0 : 1] >= 0.5;
    // A bound that is 0 since the sprite is larger than the window is compared from above, beside the
    // comparison from below.
    wall.is_for_large_sprites = !has_upper_bound && !holds_low && position.factor > 0.0 &&
                                is_left_of_zero(wall.position, comparison.relation);
    const bool is_upper = has_upper_bound || wall.is_for_large_sprites;
    wall.wall =
        position.axis == 'x' ? (is_upper ? Wall::right : Wall::left) : (is_upper ? Wall::ground : Wall::top);
    wall.beyond = is_upper != holds_low;
    return wall;
  }

  // Whether the path has decided, by sizes in x or in y, that the window is the smaller side.
  [[nodiscard]] bool has_large_sprite(const StepPath& path, bool in_x) const {
    return std::any_of(path.outcomes.begin(), path.outcomes.end(), [&](const StepOutcome& outcome) {
      const StepComparison& sizes = step_.comparisons[outcome.comparison];
      const Meaning& left = meaning(sizes.left);
      const Meaning& right = meaning(sizes.right);
      if (sizes.relation == Relation::equal || !left.is_bound() || !right.is_bound()) return false;
      const double window = left.sum[in_x ? 0 : 1] - right.sum[in_x ? 0 : 1];
      return left.has_window() != right.has_window() && window != 0.0 && (window > 0.0) == outcome.holds;
    });
  }

  [[nodiscard]] std::vector<PathContact> contacts_of(const StepPath& path) const {
    std::vector<PathContact> contacts;
    for (const StepOutcome& outcome : path.outcomes) {
      const std::optional<WallComparison>& wall = walls_[outcome.comparison];
      if (!wall || wall->beyond != outcome.holds) continue;
      if (wall->is_for_large_sprites && !has_large_sprite(path, is_in_x(wall->wall))) continue;
      // A position that was set to 0 is beyond the bound at which the path ends.
      const StepIndex end = path.members[is_in_x(wall->wall) ? 0 : 1];
      const bool is_set = wall->is_for_large_sprites && meaning(end).is_bound() && meaning(end).has_window();
      if (const auto before = std::ranges::find(contacts, wall->wall, &PathContact::wall);
          before != contacts.end()) {  // Of two positions beyond it neither is how far.
        if (before->position != wall->position && !is_set)
          before->scale = std::numeric_limits<double>::quiet_NaN();
        continue;
      }
      contacts.push_back({.wall = wall->wall,
                          .position = is_set ? wall->bound : wall->position,
                          .bound = is_set ? end : wall->bound,
                          .scale = is_set ? 1.0 : wall->scale});
    }
    std::ranges::sort(contacts, {}, &PathContact::wall);
    return contacts;
  }

  static bool has(const std::vector<PathContact>& contacts, Wall wall) {
    return std::ranges::find(contacts, wall, &PathContact::wall) != contacts.end();
  }

  // The velocity at a wall is that with which a path ends that meets fewer walls and is otherwise alike, if
  // this path calculates it.
  [[nodiscard]] std::optional<std::size_t> path_before(std::size_t path, Wall wall) const {
    const std::vector<StepPath>& paths = step_.paths_of(CoreFunction::update);
    // Walls in x come before those in y where the expressions do not tell.
    const bool is_early = is_in_x(wall) && meets_x_first(path);
    std::optional<std::size_t> best;
    std::tuple<int, int, int> best_rank;
    for (std::size_t other = 0; other < paths.size(); ++other) {
      if (!meets_fewer(other, path, wall) || !leads_to(other, path) || is_of_nan(paths[other])) continue;
      const int walls = static_cast<int>(contacts_[other].size());
      const std::tuple<int, int, int> rank = {is_early ? -walls : walls,
                                              outcomes_alike(paths[other], paths[path]),
                                              depths_[magnitude(paths[other].members[2])]};
      if (best && !(best_rank < rank)) continue;
      best = other;
      best_rank = rank;
    }
    return best;
  }

  // Whether the path asks for the wall of one position. Of several parts of a step the velocities are not
  // told apart.
  [[nodiscard]] bool asks_once(const StepPath& path, Wall wall) const {
    std::set<StepIndex> positions;
    for (const StepOutcome& outcome : path.outcomes)
      if (const auto& asked = walls_[outcome.comparison]; asked && asked->wall == wall)
        positions.insert(asked->position);
    return positions.size() == 1;
  }

  // Whether a number is not equal to itself.
  [[nodiscard]] bool is_of_nan(const StepPath& path) const {
    return std::any_of(path.outcomes.begin(), path.outcomes.end(), [&](const StepOutcome& outcome) {
      const StepComparison& asked = step_.comparisons[outcome.comparison];
      return asked.relation == Relation::equal && asked.left == asked.right && !outcome.holds;
    });
  }

  // Whether the velocities at the end of `other` are calculated on `path`.
  [[nodiscard]] bool leads_to(std::size_t other, std::size_t path) const {
    const std::vector<StepIndex>& ends = step_.paths_of(CoreFunction::update)[other].members;
    return evaluated_[path][magnitude(ends[2])] && evaluated_[path][magnitude(ends[3])];
  }

  [[nodiscard]] bool meets_x_first(std::size_t path) const {
    for (std::size_t other = 0; other < contacts_.size(); ++other) {
      bool has_same_x = leads_to(other, path);
      for (const Wall wall : kWalls)
        has_same_x =
            has_same_x && has(contacts_[other], wall) == (is_in_x(wall) && has(contacts_[path], wall));
      if (has_same_x) return true;
    }
    return false;
  }

  // A sign is moved out of what is made of an expression.
  [[nodiscard]] StepIndex magnitude(StepIndex expression) const {
    const Expression& signed_one = step_.expressions[expression];
    return signed_one.op == Operator::negate ? signed_one.operands[0] : expression;
  }

  // Whether the walls of `other` are some of those of `path`, without `wall`.
  [[nodiscard]] bool meets_fewer(std::size_t other, std::size_t path, Wall wall) const {
    return std::all_of(contacts_[other].begin(), contacts_[other].end(), [&](const PathContact& contact) {
      return contact.wall != wall && has(contacts_[path], contact.wall);
    });
  }

  static int outcomes_alike(const StepPath& a, const StepPath& b) {
    int alike = 0;
    for (auto p = a.outcomes.begin(), q = b.outcomes.begin();
         p != a.outcomes.end() && q != b.outcomes.end();) {
      if (p->comparison == q->comparison) alike += p->holds == q->holds ? 1 : -1;
      const bool steps_p = p->comparison <= q->comparison;
      if (q->comparison <= p->comparison) ++q;
      if (steps_p) ++p;
    }
    return alike;
  }

  const TracedStep& step_;
  Meanings meanings_;
  std::vector<std::optional<WallComparison>> walls_;  // By comparison.
  std::vector<std::vector<PathContact>> contacts_;    // By path.
  std::vector<std::vector<bool>> evaluated_;
  std::vector<int> depths_;
};

}  // namespace

std::vector<std::vector<PathContact>> find_path_contacts(const TracedStep& step) {
  return WallFinder(step).find();
}

}  // namespace hyrax
