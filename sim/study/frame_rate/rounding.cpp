// The drawn fling by a traced step, beside the same operations in wider arithmetic.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string_view>
#include <vector>

#include "sim/reference/double_double.h"
#include "sim/study/frame_rate/frame_rate.h"
#include "sim/trace/expression_text.h"
#include "sim/trace/step_program.h"
#include "sim/trajectory/run_summary.h"

namespace hyrax {
namespace {

using Long = long double;
using LongFunction = Long (*)(Long, Long, Long);

// Null: a fused multiply-add, or no function.
LongFunction long_function(std::string_view called) {
#define HYRAX_ONE(name, is_fixed) \
  if (called == #name) return [](Long a, Long, Long) -> Long { return std::name(a); };
#define HYRAX_TWO(name, is_fixed) \
  if (called == #name) return [](Long a, Long b, Long) -> Long { return std::name(a, b); };
  HYRAX_TRACE_FUNCTIONS(HYRAX_ONE, HYRAX_TWO)
#undef HYRAX_ONE
#undef HYRAX_TWO
  return nullptr;
}

// What an operation makes of wider operands. Where these are too large for double-double, of their halves.
DoubleDouble widely(const Expression& e, const DoubleDouble& a, const DoubleDouble& b,
                    const DoubleDouble& c) {
  const DoubleDouble as_rounded{operation_of(e)(a.hi, b.hi, c.hi), 0.0};
  if (e.kind == NumberKind::whole) return as_rounded;
  DoubleDouble value = a;  // As of a conversion.
  if (e.op == Operator::negate) value = -a;
  if (e.op == Operator::add) value = a + b;
  if (e.op == Operator::multiply) value = a * b;
  if (e.op == Operator::divide) value = a / b;
  if (const LongFunction function = long_function(e.name); function != nullptr) {
    const auto as_long = [](const DoubleDouble& wide) {
      return static_cast<Long>(wide.hi) + static_cast<Long>(wide.lo);
    };
    const Long result = function(as_long(a), as_long(b), as_long(c));
    value.hi = static_cast<double>(result);
    value.lo = static_cast<double>(result - static_cast<Long>(value.hi));
  } else if (e.op == Operator::call) {
    value = a * b + c;
  }
  return std::isfinite(value.hi) && std::isfinite(value.lo) ? value : as_rounded;
}

// A body moved by the update of a step, in wider arithmetic.
class WideBody {
 public:
  WideBody(const TracedStep& step, std::span<const double> members)
      : step_(step), values_(step.expressions.size()) {
    for (const double member : members) members_.push_back({member, 0.0});
  }

  /// @param rounded the values of a rounded body, of which arguments and constants are taken. False: some
  /// value is not finite.
  bool update(std::span<const double> rounded) {
    for (StepIndex index = 0; index < values_.size(); ++index) {
      const Expression& e = step_.expressions[index];
      std::array<DoubleDouble, 3> operands;
      for (std::size_t place = 0; place < e.used_operands().size(); ++place)
        operands[place] = values_[e.operands[place]];
      const bool is_leaf = e.op == Operator::constant || e.op == Operator::argument;
      values_[index] =
          is_leaf ? DoubleDouble{rounded[index], 0.0} : widely(e, operands[0], operands[1], operands[2]);
      for (std::size_t member = 0; member < members_.size() && e.op == Operator::argument; ++member)
        if (e.name == member_name(member)) values_[index] = members_[member];
    }
    const auto& paths = step_.paths_of(CoreFunction::update);
    path_ = static_cast<StepIndex>(
        std::ranges::find_if(paths,
                             [&](const StepPath& path) {
                               return std::ranges::all_of(path.outcomes, [&](const StepOutcome& outcome) {
                                 const StepComparison& asked = step_.comparisons[outcome.comparison];
                                 return holds(asked.relation,
                                              (values_[asked.left] + -values_[asked.right]).hi,
                                              0.0) == outcome.holds;
                               });
                             }) -
        paths.begin());
    if (path_ >= paths.size()) return false;
    for (std::size_t member = 0; member < members_.size(); ++member)
      members_[member] = values_[paths[path_].members[member]];
    return true;
  }

  /// Of the last update.
  [[nodiscard]] StepIndex path() const { return path_; }
  [[nodiscard]] double off(std::size_t member, double rounded) const {
    return (members_[member] + -rounded).hi;
  }
  /// The first value that the path needs and that differs by more than this part of itself; kNoIndex: none.
  [[nodiscard]] StepIndex first_off(std::span<const double> rounded, double part, double least) const {
    const StepPath& path = step_.paths_of(CoreFunction::update)[path_];
    std::vector<bool> is_needed(values_.size());
    for (const StepIndex member : path.members) is_needed[member] = true;
    for (const auto& [comparison, holds] : path.outcomes)
      is_needed[step_.comparisons[comparison].left] = is_needed[step_.comparisons[comparison].right] = true;
    StepIndex first = kNoIndex;
    for (StepIndex index = static_cast<StepIndex>(values_.size()); index-- > 0;) {
      if (!is_needed[index]) continue;
      for (const StepIndex operand : step_.expressions[index].used_operands()) is_needed[operand] = true;
      const double value = values_[index].hi;
      if (std::fabs((values_[index] + -rounded[index]).hi) > part * std::max(std::fabs(value), least))
        first = index;
    }
    return first;
  }

 private:
  const TracedStep& step_;
  std::vector<DoubleDouble> members_, values_;
  StepIndex path_ = kNoIndex;
};

}  // namespace

bool has_float(const StepProgram& step) {
  return std::ranges::count(step.step().expressions, NumberKind::single, &Expression::kind) > 0;
}

TracedLanding play_traced(const StepProgram& program, double rate_hz, double duration_s) {
  const bool is_float = has_float(program);
  const double half_digits = is_float ? 0x1p-12 : 0x1p-26;
  const double least = is_float ? 0x1p-126 : 0x1p-1022;  // The smallest normal number.
  const World world{
      .state = kDrawnFling,
      .window = {static_cast<int>(kDesktop.right_px) + 128, static_cast<int>(kDesktop.bottom_px) + 128},
      .sprite = {128, 128}};
  const double dt_s = 1.0 / rate_hz;
  TracedBody body(program, world.state);
  WideBody wide(program.step(), body.members());
  TracedLanding landing;
  landing.rate_hz = rate_hz;
  RestAnchor rest{body.x(), body.y(), 0.0};
  std::vector<double> values;
  const double rows = std::ceil(duration_s * rate_hz);
  for (std::int64_t row = 1; static_cast<double>(row) <= rows; ++row) {
    program.evaluate(body.members(), update_arguments(dt_s, world.window, world.sprite), values);
    body.update({world, dt_s});
    if (!wide.update(values)) break;
    if (landing.other_path_from < 0 && wide.path() != body.path()) landing.other_path_from = row;
    if (landing.other_path_from < 0 && landing.lost_row < 0)
      if (const StepIndex off = wide.first_off(values, half_digits, least); off != kNoIndex) {
        landing.lost_row = row;
        landing.lost = expression_text(program.step(), off);
      }
    if (const double off_px = std::hypot(wide.off(0, body.x()), wide.off(1, body.y()));
        off_px > landing.rounding_px) {
      landing.rounding_px = off_px;
      landing.rounding_row = row;
    }
    if (rest.moves_to(body.x(), body.y())) rest.t_s = static_cast<double>(row) * dt_s;
  }
  landing.end = {body.x(), body.y(), body.vx(), body.vy()};
  landing.time_s = rest.at_rest_since_s(rows * dt_s).value_or(kNotGiven);
  return landing;
}

}  // namespace hyrax
