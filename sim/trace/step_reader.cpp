#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "sim/trace/decision_tree.h"
#include "sim/trace/step_grammar.h"
#include "sim/trace/step_text.h"

namespace hyrax {
namespace {

// A step of 4,096 paths has a tenth of it.
constexpr std::size_t kTextBytesMax = 1 << 22;
constexpr double kSingleMax = static_cast<double>(std::numeric_limits<float>::max());

template <std::size_t kSize>
std::optional<std::size_t> index_in(const std::array<std::string_view, kSize>& words, std::string_view word) {
  const auto place = std::find(words.begin(), words.end(), word);
  if (place == words.end()) return std::nullopt;
  return static_cast<std::size_t>(place - words.begin());
}

template <class Integer>
std::optional<Integer> integer_of(std::string_view digits) {
  Integer value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  return value;
}

// Of what hex_of writes (step_text.cpp); other spellings are found when the text is written again.
std::optional<double> number_of(std::string_view hex) {
  if (hex == "inf") return std::numeric_limits<double>::infinity();
  if (hex == "nan") return std::numeric_limits<double>::quiet_NaN();
  const std::size_t p = hex.find('p');
  if (p == std::string_view::npos || p < 3 || hex.size() < p + 3) return std::nullopt;
  const std::optional<int> exponent = integer_of<int>(hex.substr(p + (hex[p + 1] == '+' ? 2 : 1)));
  if (!exponent || *exponent < -1022 || *exponent > 1023) return std::nullopt;
  std::uint64_t fraction = 0;
  for (std::size_t digit = 0; digit < 13; ++digit) {
    std::uint64_t value = 0;
    if (digit + 4 < p) {
      const std::size_t found = std::string_view("0123456789abcdef").find(hex[digit + 4]);
      if (found == std::string_view::npos) return std::nullopt;
      value = found;
    }
    fraction = fraction << 4 | value;
  }
  const bool is_normal = hex[2] == '1';
  const auto biased = static_cast<std::uint64_t>(is_normal ? *exponent + 1023 : 0);
  return std::bit_cast<double>(biased << 52 | fraction);
}

// A line, read from its left.
class Line {
 public:
  explicit Line(std::string_view text) : text_(text) {}

  bool take(std::string_view expected) {
    if (!text_.starts_with(expected)) return false;
    text_.remove_prefix(expected.size());
    return true;
  }
  // Up to one of the characters of `ends`, or all.
  std::string_view take_until(std::string_view ends) {
    const std::string_view word = text_.substr(0, text_.find_first_of(ends));
    text_.remove_prefix(word.size());
    return word;
  }
  [[nodiscard]] bool is_empty() const { return text_.empty(); }

 private:
  std::string_view text_;
};

bool is_name(std::string_view word) {
  return !word.empty() && word.size() <= 64 && !(word[0] >= '0' && word[0] <= '9') &&
         std::all_of(word.begin(), word.end(),
                     [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; });
}

// The step as the text has it. Whether that is the text of it in order, its caller finds out.
class Reader {
 public:
  bool read(std::string_view text) {
    while (!text.empty()) {
      const std::size_t end = text.find('\n');
      if (end == std::string_view::npos || !read_line(text.substr(0, end))) return false;
      text.remove_prefix(end + 1);
    }
    return true;
  }
  [[nodiscard]] const TracedStep& step() const { return step_; }

 private:
  using Index = std::optional<std::int32_t>;

  bool read_line(std::string_view text) {
    Line line(text);
    const std::string_view name = line.take_until(":");
    if (!line.take(":")) return false;
    if (name == "members") return read_members(line);
    if (const auto function = index_in(kCoreFunctionNames, name)) return read_path(line, *function);
    if (name.starts_with('c') && integer_of<std::size_t>(name.substr(1)) == step_.comparisons.size())
      return read_comparison(line);
    if (!is_name(name) || !line.take(" ")) return false;
    const auto kind = index_in(kNumberKindNames, line.take_until(" "));
    if (!kind) return false;
    Expression expression{.kind = static_cast<NumberKind>(*kind)};
    if (line.is_empty()) {
      expression.op = Operator::argument;
      expression.name = name;
    } else if (!line.take(" = ") || !read_operation(line, expression)) {
      return false;
    }
    return names_.try_emplace(std::string(name), add(expression)).second;
  }

  bool read_members(Line& line) {
    while (line.take(" ")) {
      const auto kind = index_in(kNumberKindNames, line.take_until(" "));
      if (!kind || step_.members.size() == kStepMembersMax) return false;
      step_.members.push_back(static_cast<NumberKind>(*kind));
    }
    return step_.members.size() >= 4 && line.is_empty();
  }

  bool read_operation(Line& line, Expression& expression) {
    if (line.take("-")) {
      expression.op = Operator::negate;
      return take_operand(line, " ", expression, 0) && line.is_empty() && has_one_kind(expression);
    }
    Line call = line;
    const std::string_view name = call.take_until("( ");
    if (is_name(name) && call.take("(")) return read_call(call, name, expression);
    if (!take_operand(line, " ", expression, 0) || !line.take(" ")) return false;
    const std::string_view sign = line.take_until(" ");
    const std::size_t op = sign.size() == 1 ? kOperatorSigns.find(sign[0]) : std::string_view::npos;
    if (op == std::string_view::npos || !line.take(" ")) return false;
    expression.op = static_cast<Operator>(static_cast<std::size_t>(Operator::add) + op);
    if (expression.op == Operator::remainder && expression.kind != NumberKind::whole) return false;
    return take_operand(line, " ", expression, 1) && line.is_empty() && has_one_kind(expression);
  }

  bool read_call(Line& line, std::string_view name, Expression& expression) {
    std::size_t operands = 0;
    do {
      if (operands == expression.operands.size() || !take_operand(line, ",)", expression, operands))
        return false;
      ++operands;
    } while (line.take(", "));
    if (!line.take(")") || !line.is_empty()) return false;
    const auto conversion = index_in(kConversionNames, name);
    if (!conversion) {
      expression.op = Operator::call;
      expression.name = name;
      return true;
    }
    expression.op =
        static_cast<Operator>(static_cast<std::size_t>(Operator::to_real) + *conversion);  // Kinds alike.
    return operands == 1 && static_cast<std::size_t>(expression.kind) == *conversion;
  }

  bool take_operand(Line& line, std::string_view ends, Expression& expression, std::size_t place) {
    const Index index = take_reference(line, ends);
    if (index) expression.operands[place] = *index;
    return index.has_value();
  }

  // A name that stands above, or a constant.
  Index take_reference(Line& line, std::string_view ends) {
    const std::string_view word = line.take_until(ends);
    const auto named = names_.find(word);
    if (named != names_.end()) return named->second;
    const auto known = constants_.find(word);
    if (known != constants_.end()) return known->second;
    const std::optional<Expression> constant = constant_of(word);
    if (!constant) return std::nullopt;
    return constants_.emplace(std::string(word), add(*constant)).first->second;
  }

  static std::optional<Expression> constant_of(std::string_view word) {
    Expression constant{.op = Operator::constant};
    const std::size_t brace = word.find('{');
    if (brace == std::string_view::npos) {
      const auto whole = integer_of<std::int64_t>(word);
      if (!whole || *whole < 0 || *whole > std::int64_t{1} << 31) return std::nullopt;
      constant.kind = NumberKind::whole;
      constant.value = static_cast<double>(*whole);
      return constant;
    }
    const bool is_single = word.ends_with("}f");
    if (!is_single && !word.ends_with('}')) return std::nullopt;
    const std::size_t end = word.size() - (is_single ? 2 : 1);
    const std::optional<double> value =
        end > brace ? number_of(word.substr(brace + 1, end - brace - 1)) : std::nullopt;
    if (!value || (is_single && std::isfinite(*value) && *value > kSingleMax)) return std::nullopt;
    constant.kind = is_single ? NumberKind::single : NumberKind::real;
    constant.value = *value;
    return constant;
  }

  bool read_comparison(Line& line) {
    if (!line.take(" ")) return false;
    const Index left = take_reference(line, " ");
    if (!left || !line.take(" ")) return false;
    const auto relation = index_in(kRelationSigns, line.take_until(" "));
    if (!relation || !line.take(" ")) return false;
    const Index right = take_reference(line, " ");
    if (!right || !line.is_empty() || kind_of(*left) != kind_of(*right)) return false;
    step_.comparisons.push_back({static_cast<Relation>(*relation), *left, *right});
    return true;
  }

  bool read_path(Line& line, std::size_t function) {
    StepPath path;
    while (line.take(" ") && !line.take("=")) {
      const bool holds = !line.take("!");
      if (!line.take("c")) return false;
      const auto comparison = integer_of<std::uint32_t>(line.take_until(" "));
      if (!comparison || *comparison >= step_.comparisons.size()) return false;
      path.outcomes.push_back({static_cast<std::int32_t>(*comparison), holds});
    }
    while (line.take(" ")) {
      const Index member = take_reference(line, " ");
      const std::size_t place = path.members.size();
      if (!member || place == step_.members.size() || kind_of(*member) != step_.members[place]) return false;
      path.members.push_back(*member);
    }
    step_.paths[function].push_back(std::move(path));
    return line.is_empty() && step_.paths[function].back().members.size() == step_.members.size() &&
           step_.paths[function].size() <= kStepPathsMax;
  }

  std::int32_t add(const Expression& expression) {
    step_.expressions.push_back(expression);
    return static_cast<std::int32_t>(step_.expressions.size() - 1);
  }
  [[nodiscard]] NumberKind kind_of(std::int32_t index) const {
    return step_.expressions[static_cast<std::size_t>(index)].kind;
  }
  [[nodiscard]] bool has_one_kind(const Expression& expression) const {
    return std::all_of(expression.operands.begin(), expression.operands.end(), [&](std::int32_t operand) {
      return operand < 0 || kind_of(operand) == expression.kind;
    });
  }

  TracedStep step_;
  std::map<std::string, std::int32_t, std::less<>> names_;      // Of arguments and operations.
  std::map<std::string, std::int32_t, std::less<>> constants_;  // By their text.
};

}  // namespace

std::optional<TracedStep> read_step(std::string_view text) {
  const std::size_t end = text.rfind("checksum: ");
  if (text.size() > kTextBytesMax || end == std::string_view::npos) return std::nullopt;
  const std::string_view body = text.substr(0, end);
  if (text.substr(end) != checksum_line(body)) return std::nullopt;
  const std::string first_line = std::string(kStepFirstLine) + "\n";
  Reader reader;
  if (!body.starts_with(first_line) || !reader.read(body.substr(first_line.size()))) return std::nullopt;
  const TracedStep written = in_order(reader.step());
  if (step_text(written) != text) return std::nullopt;
  TracedStep step = canonical(written);
  for (const std::vector<StepPath>& paths : step.paths)
    if (!make_decision_tree(paths)) return std::nullopt;
  return step;
}

}  // namespace hyrax
