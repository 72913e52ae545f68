#include "sim/trace/expression_text.h"

#include <charconv>

#include "sim/trace/step_grammar.h"

namespace hyrax {
namespace {

constexpr std::size_t kTextMax = 72;
// A shared expression is written wherever it is used, so a step's text could grow without limit.
constexpr int kNodesMax = 200;

enum class Binding { sum, product, sign, whole };

class Printer {
 public:
  Printer(const TracedStep& step, const NumberNames& names) : step_(step), names_(names) {}

  std::string text(std::int32_t index, Binding outside) {
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
        return conversion("float", e);
      case Operator::to_whole:
        return conversion("int", e);
      case Operator::call:
        return call(e);
      default:
        return bracketed(product(e), Binding::product, outside);
    }
  }

 private:
  [[nodiscard]] const Expression& at(std::int32_t index) const {
    return step_.expressions[static_cast<std::size_t>(index)];
  }
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
    const std::int32_t second = e.operands[is_swapped ? 0 : 1];
    const std::string first = text(e.operands[is_swapped ? 1 : 0], Binding::sum);
    if (at(second).op == Operator::negate)
      return first + " - " + text(at(second).operands[0], Binding::product);
    return first + " + " + text(second, Binding::product);
  }

  std::string product(const Expression& e) {
    const bool is_swapped = e.op == Operator::multiply && swaps(e);
    const std::string first = text(e.operands[is_swapped ? 1 : 0], Binding::product);
    return first + " " + sign_of(e.op) + " " + text(e.operands[is_swapped ? 0 : 1], Binding::sign);
  }

  std::string call(const Expression& e) {
    std::string written = e.name + "(";
    for (std::size_t place = 0; place < e.operands.size() && e.operands[place] >= 0; ++place)
      written.append(place == 0 ? "" : ", ").append(text(e.operands[place], Binding::sum));
    return written + ")";
  }

  std::string conversion(std::string written, const Expression& e) {
    return written.append("(").append(text(e.operands[0], Binding::sum)).append(")");
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

std::string expression_text(const TracedStep& step, std::int32_t expression, const NumberNames& names) {
  return shortened(Printer(step, names).text(expression, Binding::sum));
}

std::string comparison_text(const TracedStep& step, std::int32_t comparison, const NumberNames& names) {
  const StepComparison& c = step.comparisons[static_cast<std::size_t>(comparison)];
  const std::string left = expression_text(step, c.left, names);
  const std::string right = expression_text(step, c.right, names);
  const Expression& first = step.expressions[static_cast<std::size_t>(c.left)];
  const bool starts_constant =
      first.op == Operator::constant ||
      (first.op == Operator::negate &&
       step.expressions[static_cast<std::size_t>(first.operands[0])].op == Operator::constant);
  if (!starts_constant) return left + " " + std::string(sign_of(c.relation)) + " " + right;
  if (c.relation == Relation::equal) return right + " == " + left;
  return right + (c.relation == Relation::less ? " > " : " >= ") + left;
}

}  // namespace hyrax
