#include "sim/trace/expression_text.h"

#include <charconv>

namespace hyrax {
namespace {

constexpr std::size_t kTextMax = 72;
// A shared expression is written wherever it is used, so a step's text could grow without limit.
constexpr int kNodesMax = 200;

enum class Binding { sum, product, sign, whole };

class Printer {
 public:
  Printer(const TracedStep& step, const NumberNames& names) : step_(step), names_(names) {}

  std::string text(StepIndex index, Binding outside) {
    const Expression& e = at(index);
    if (++nodes_ > kNodesMax) return "...";
    switch (e.op) {
      case Operator::argument:
        return e.name;
      case Operator::constant:
        return number(e.value);
      case Operator::negate:
        return bracketed(std::string("-").append(text(e.operands[0], Binding::sign)), Binding::sign, outside);
      case Operator::add:
        return bracketed(sum(e), Binding::sum, outside);
      case Operator::to_real:
        return text(e.operands[0], outside);
      case Operator::to_single:
        return call("float", e);
      case Operator::to_whole:
        return call("int", e);
      case Operator::call:
        return call(e.name, e);
      default:
        return bracketed(product(e), Binding::product, outside);
    }
  }

 private:
  [[nodiscard]] const Expression& at(StepIndex index) const { return step_.expressions[index]; }
  // What a constant is multiplied with or added to comes first.
  [[nodiscard]] bool swaps(const Expression& e) const {
    const Operator first = at(e.operands[0]).op;
    return first == Operator::constant ||
           (first == Operator::negate && at(e.operands[1]).op != Operator::negate);
  }

  [[nodiscard]] std::string number(double value) const {
    if (const auto name = names_.find(value); name != names_.end()) return name->second;
    char digits[64];
    return {digits, std::to_chars(digits, digits + sizeof digits, value).ptr};
  }

  std::string sum(const Expression& e) {
    const bool is_swapped = swaps(e);
    const StepIndex second = e.operands[is_swapped ? 0 : 1];
    const std::string first = text(e.operands[is_swapped ? 1 : 0], Binding::sum);
    if (at(second).op == Operator::negate)
      return first + " - " + text(at(second).operands[0], Binding::product);
    return first + " + " + text(second, Binding::product);
  }

  std::string product(const Expression& e) {
    const bool is_swapped = e.op == Operator::multiply && swaps(e);
    const std::string first = text(e.operands[is_swapped ? 1 : 0], Binding::product);
    return first + " " + std::string(sign_of(e.op)) + " " +
           text(e.operands[is_swapped ? 0 : 1], Binding::sign);
  }

  std::string call(std::string written, const Expression& e) {
    written += "(";
    for (const StepIndex operand : e.used_operands())
      written.append(written.back() == '(' ? "" : ", ").append(text(operand, Binding::sum));
    return written + ")";
  }

  static std::string bracketed(const std::string& written, Binding binding, Binding outside) {
    return binding < outside ? std::string("(").append(written).append(")") : written;
  }

  const TracedStep& step_;
  const NumberNames& names_;
  int nodes_ = 0;
};

std::string shortened(const std::string& text) {
  if (text.size() <= kTextMax) return text;
  const std::size_t half = (kTextMax - 5) / 2;
  return text.substr(0, half) + " ... " + text.substr(text.size() - half);
}

}  // namespace

std::string expression_text(const TracedStep& step, StepIndex expression, const NumberNames& names) {
  return shortened(Printer(step, names).text(expression, Binding::sum));
}

std::string comparison_text(const TracedStep& step, StepIndex comparison, const NumberNames& names) {
  const StepComparison& c = step.comparisons[comparison];
  const std::string left = expression_text(step, c.left, names);
  const std::string right = expression_text(step, c.right, names);
  const Expression& first = step.expressions[c.left];
  const bool starts_constant =
      first.op == Operator::constant ||
      (first.op == Operator::negate && step.expressions[first.operands[0]].op == Operator::constant);
  if (!starts_constant) return left + " " + std::string(sign_of(c.relation)) + " " + right;
  if (c.relation == Relation::equal) return right + " == " + left;
  return right + (c.relation == Relation::less ? " > " : " >= ") + left;
}

}  // namespace hyrax
