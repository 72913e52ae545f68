#include "sim/trace/step_text.h"

#include <bit>
#include <charconv>
#include <cmath>

#include "sim/trace/step_grammar.h"

namespace hyrax {
namespace {

// By the bits: what std::to_chars makes of subnormals is the library's choice.
std::string hex_of(double value) {
  if (!std::isfinite(value)) return std::isnan(value) ? "nan" : "inf";
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const auto biased = static_cast<int>(bits >> 52);
  std::string digits;
  for (std::uint64_t rest = bits << 12; rest != 0; rest <<= 4) digits += "0123456789abcdef"[rest >> 60];
  const int exponent = bits == 0 ? 0 : biased == 0 ? -1022 : biased - 1023;
  return std::string(biased == 0 ? "0x0" : "0x1") + (digits.empty() ? "" : ".") + digits + "p" +
         (exponent < 0 ? "" : "+") + std::to_string(exponent);
}

template <class Number>
std::string shortest(Number value) {
  if (!std::isfinite(value)) return std::isnan(value) ? "nan" : "inf";
  char text[64];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::string constant_text(const Expression& constant) {
  if (constant.kind == NumberKind::whole) return std::to_string(static_cast<std::int64_t>(constant.value));
  const bool is_single = constant.kind == NumberKind::single;
  return (is_single ? shortest(static_cast<float>(constant.value)) : shortest(constant.value)) + "{" +
         hex_of(constant.value) + "}" + (is_single ? "f" : "");
}

class Writer {
 public:
  explicit Writer(const TracedStep& step) : step_(step) {
    names_.reserve(step.expressions.size());
    std::size_t operations = 0;
    for (const Expression& expression : step.expressions)
      names_.push_back(expression.op == Operator::argument ? expression.name
                       : expression.op == Operator::constant
                           ? constant_text(expression)
                           : std::string("e").append(std::to_string(operations++)));
  }

  std::string text() {
    text_ = kStepFirstLine;
    text_ += "\nmembers:";
    for (const NumberKind kind : step_.members) text_ += " " + std::string(name_of(kind));
    text_ += "\n";
    for (std::size_t index = 0; index < step_.expressions.size(); ++index) write_expression(index);
    for (std::size_t index = 0; index < step_.comparisons.size(); ++index) {
      const StepComparison& comparison = step_.comparisons[index];
      text_ += std::string("c").append(std::to_string(index)) + ": " + name(comparison.left) + " " +
               std::string(sign_of(comparison.relation)) + " " + name(comparison.right) + "\n";
    }
    for (std::size_t function = 0; function < kCoreFunctions; ++function)
      for (const StepPath& path : step_.paths[function]) write_path(kCoreFunctionNames[function], path);
    return text_ + checksum_line(text_);
  }

 private:
  const std::string& name(std::int32_t index) const { return names_[static_cast<std::size_t>(index)]; }

  void write_expression(std::size_t index) {
    const Expression& expression = step_.expressions[index];
    if (expression.op == Operator::constant) return;
    text_ += names_[index] + ": " + std::string(name_of(expression.kind));
    if (expression.op != Operator::argument) text_ += " = " + right_side(expression);
    text_ += "\n";
  }

  std::string right_side(const Expression& expression) const {
    const auto operand = [&](std::size_t place) -> const std::string& {
      return name(expression.operands[place]);
    };
    if (expression.op == Operator::negate) return "-" + operand(0);
    if (const char sign = sign_of(expression.op); sign != '\0') {
      // A constant reads better behind what it is added to or multiplied with.
      const bool is_swapped =
          is_commutative(expression.op) &&
          step_.expressions[static_cast<std::size_t>(expression.operands[0])].op == Operator::constant;
      return operand(is_swapped ? 1 : 0) + " " + sign + " " + operand(is_swapped ? 0 : 1);
    }
    std::string text(expression.op == Operator::call ? std::string_view(expression.name)
                                                     : conversion_name(expression.op));
    for (std::size_t place = 0; place < 3 && expression.operands[place] >= 0; ++place)
      text += (place == 0 ? "(" : ", ") + operand(place);
    return text + ")";
  }

  void write_path(std::string_view function, const StepPath& path) {
    text_ += std::string(function) + ":";
    for (const StepOutcome& outcome : path.outcomes)
      text_ += std::string(outcome.holds ? " c" : " !c") + std::to_string(outcome.comparison);
    text_ += " =";
    for (const std::int32_t member : path.members) text_ += " " + name(member);
    text_ += "\n";
  }

  const TracedStep& step_;
  std::vector<std::string> names_;  // By expression: as others refer to it.
  std::string text_;
};

}  // namespace

std::string checksum_line(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char byte : text) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
  std::string line = "checksum: ";
  for (int shift = 60; shift >= 0; shift -= 4) line += "0123456789abcdef"[hash >> shift & 15];
  return line + "\n";
}

std::string step_text(const TracedStep& step) { return Writer(step).text(); }

}  // namespace hyrax
