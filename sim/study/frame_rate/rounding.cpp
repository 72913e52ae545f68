// The drawn fling by a traced step, beside the same operations in wider arithmetic.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/reference/double_double.h"
#include "sim/study/frame_rate/frame_rate.h"
#include "sim/trace/expression_text.h"
#include "sim/trace/step_program.h"

namespace hyrax {
namespace {

using Wide = DoubleDouble;
using Long = long double;

// A function of <cmath>, which only `long double` has wider.
Wide called(const std::string& function, const std::array<Wide, 3>& of) {
  const Long a = static_cast<Long>(of[0].hi) + static_cast<Long>(of[0].lo);
  const Long b = static_cast<Long>(of[1].hi) + static_cast<Long>(of[1].lo);
  const auto wide = [](Long value) {
    const auto high = static_cast<double>(value);
    return Wide{high, static_cast<double>(value - static_cast<Long>(high))};
  };
#define HYRAX_ONE(name, is_fixed) \
  if (function == #name) return wide(std::name(a));
#define HYRAX_TWO(name, is_fixed) \
  if (function == #name) return wide(std::name(a, b));
  HYRAX_TRACE_FUNCTIONS(HYRAX_ONE, HYRAX_TWO)
#undef HYRAX_ONE
#undef HYRAX_TWO
  return of[0] * of[1] + of[2];  // fma.
}

Wide operated(const Expression& e, const std::array<Wide, 3>& of) {
  const Wide as_rounded{operation_of(e)(of[0].hi, of[1].hi, of[2].hi), 0.0};
  if (e.kind == NumberKind::whole) return as_rounded;
  const Wide value = e.op == Operator::negate     ? -of[0]
                     : e.op == Operator::add      ? of[0] + of[1]
                     : e.op == Operator::multiply ? of[0] * of[1]
                     : e.op == Operator::divide   ? of[0] / of[1]
                     : e.op == Operator::call     ? called(e.name, of)
                                                  : of[0];             // A conversion.
  return std::isfinite(value.hi + value.lo) ? value : as_rounded;  // Double-double ends at 1e290.
}

struct WideStep {
  const TracedStep& step;
  std::vector<Wide> members = {};
  std::vector<Wide> values = {};  // By expression.
  const StepPath* path = nullptr;

  // Plays update along the path that its own comparisons decide. @param rounded the values of the rounded
  // step, of which arguments and constants are taken.
  void play(std::span<const double> rounded) {
    values.clear();
    for (const Expression& e : step.expressions) {
      std::array<Wide, 3> of;
      std::ranges::transform(e.used_operands(), of.begin(),
                             [&](StepIndex operand) { return values[operand]; });
      const bool is_leaf = e.op == Operator::constant || e.op == Operator::argument;
      values.push_back(is_leaf ? Wide{rounded[values.size()], 0.0} : operated(e, of));
      for (std::size_t member = 0; member < members.size() && e.op == Operator::argument; ++member)
        if (e.name == member_name(member)) values.back() = members[member];
    }
    for (const StepPath& each : step.paths_of(CoreFunction::update))
      if (std::ranges::all_of(each.outcomes, [&](const StepOutcome& outcome) {
            const StepComparison& asked = step.comparisons[outcome.comparison];
            return holds(asked.relation, (values[asked.left] + -values[asked.right]).hi, 0.0) ==
                   outcome.holds;
          }))
        path = &each;
    for (std::size_t member = 0; member < members.size(); ++member)
      members[member] = values[path->members[member]];
  }

  // The first value that the path needs and that is off by more than this part of itself; kNoIndex: none.
  [[nodiscard]] StepIndex first_off(std::span<const double> rounded, double part, double least) const {
    std::vector<std::uint8_t> is_needed(values.size());
    for (const StepIndex member : path->members) is_needed[member] = true;
    for (const StepOutcome& outcome : path->outcomes)
      is_needed[step.comparisons[outcome.comparison].left] =
          is_needed[step.comparisons[outcome.comparison].right] = true;
    StepIndex first = kNoIndex;
    for (auto index = static_cast<StepIndex>(values.size()); index-- > 0;) {
      if (!is_needed[index]) continue;
      for (const StepIndex operand : step.expressions[index].used_operands()) is_needed[operand] = true;
      const double off = std::fabs((values[index] + -rounded[index]).hi);
      if (off > part * std::max(std::fabs(values[index].hi), least)) first = index;
    }
    return first;
  }
};

}  // namespace

bool has_float(const StepProgram& step) {
  return std::ranges::count(step.step().expressions, NumberKind::single, &Expression::kind) > 0;
}

Rounding rounding_of(const StepProgram& program, double rate_hz, double duration_s) {
  const double half_digits = has_float(program) ? 0x1p-12 : 0x1p-26;
  const double least = has_float(program) ? 0x1p-126 : 0x1p-1022;  // The smallest normal number.
  const StepArguments arguments = {1.0 / rate_hz, kDesktop.right_px, kDesktop.bottom_px, 0.0, 0.0};
  TracedBody body(program, kDrawnFling);
  WideStep wide{program.step()};
  for (const double member : body.members()) wide.members.push_back({member, 0.0});
  Rounding rounding{.rate_hz = rate_hz};
  std::vector<double> values;
  for (std::int64_t row = 1; static_cast<double>(row) <= std::ceil(duration_s * rate_hz); ++row) {
    program.evaluate(body.members(), arguments, values);
    const StepIndex path = program.run(CoreFunction::update, body.members(), arguments);
    wide.play(values);
    const bool is_other = wide.path != &program.step().paths_of(CoreFunction::update)[path];
    if (is_other && rounding.other_path_from < 0) rounding.other_path_from = row;
    if (rounding.other_path_from < 0 && rounding.lost_row < 0)
      if (const StepIndex lost = wide.first_off(values, half_digits, least); lost != kNoIndex) {
        rounding.lost_row = row;
        rounding.lost = expression_text(program.step(), lost);
      }
    const double off_px = std::hypot((wide.members[0] + -body.x()).hi, (wide.members[1] + -body.y()).hi);
    if (off_px > rounding.largest_px) rounding.largest_row = row;
    rounding.largest_px = std::max(rounding.largest_px, off_px);
  }
  return rounding;
}

}  // namespace hyrax
