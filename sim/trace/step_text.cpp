#include "sim/trace/step_text.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <span>
#include <utility>

#include "sim/trace/decision_tree.h"

namespace hyrax {
namespace {

constexpr std::string_view kFirstLine = "hyrax-step/1\n";
constexpr std::array<std::string_view, 3> kConversionNames = {"to_real", "to_single", "to_whole"};
// A step of 4,096 paths has a tenth of it.
constexpr std::size_t kTextBytesMax = 1 << 22;
constexpr char kOfCore = '$';  // Before the names of a core that describes itself.
constexpr double kSingleMax = static_cast<double>(std::numeric_limits<float>::max());

// The last line, of all before it (FNV-1a, 64 bits): tells a text that was cut short or edited by hand.
std::string checksum_line(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char byte : text) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
  std::string line = "checksum: ";
  for (int shift = 60; shift >= 0; shift -= 4) line += "0123456789abcdef"[hash >> shift & 15];
  return line + "\n";
}

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

std::string_view conversion_name(Operator op) {
  return kConversionNames[static_cast<std::size_t>(op) - static_cast<std::size_t>(Operator::to_real)];
}

class Writer {
 public:
  explicit Writer(const TracedStep& step) : step_(step) {
    names_.reserve(step.expressions.size());
    std::size_t operations = 0;
    for (const Expression& expression : step.expressions)
      names_.push_back(expression.op == Operator::argument ? of_core(expression.name)
                       : expression.op == Operator::constant
                           ? constant_text(expression)
                           : std::string("e").append(std::to_string(operations++)));
  }

  std::string text() {
    text_ = kFirstLine;
    text_ += "members:";
    for (std::size_t member = 0; member < step_.members.size(); ++member) {
      text_ += " " + std::string(name_of(step_.members[member]));
      if (step_.describes_itself()) text_ += "=" + step_.member_names[member];
    }
    text_ += "\n";
    for (std::size_t index = 0; index < step_.expressions.size(); ++index) write_expression(index);
    for (std::size_t index = 0; index < step_.comparisons.size(); ++index) {
      const StepComparison& comparison = step_.comparisons[index];
      text_ += std::string("c").append(std::to_string(index)) + ": " + name(comparison.left) + " " +
               std::string(sign_of(comparison.relation)) + " " + name(comparison.right) + "\n";
    }
    for (std::size_t function = 0; function < step_.paths.size(); ++function)
      for (const StepPath& path : step_.paths[function])
        write_path(step_.describes_itself() ? of_core(step_.function_names[function])
                                            : std::string(kCoreFunctionNames[function]),
                   path);
    return text_ + checksum_line(text_);
  }

 private:
  const std::string& name(StepIndex index) const { return names_[index]; }
  // What a core names itself may be `e0` or `members`, too.
  [[nodiscard]] std::string of_core(const std::string& name) const {
    return step_.describes_itself() ? kOfCore + name : name;
  }

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
    if (const std::string sign(sign_of(expression.op)); !sign.empty()) {
      // A constant reads better behind what it is added to or multiplied with.
      const bool is_swapped =
          is_commutative(expression.op) && step_.expressions[expression.operands[0]].op == Operator::constant;
      return operand(is_swapped ? 1 : 0) + " " + sign + " " + operand(is_swapped ? 0 : 1);
    }
    std::string text(expression.op == Operator::call ? expression.name : conversion_name(expression.op));
    for (const StepIndex each : expression.used_operands())
      text.append(text.find('(') == text.npos ? "(" : ", ").append(name(each));
    return text + ")";
  }

  void write_path(const std::string& function, const StepPath& path) {
    text_ += function + ":";
    for (const StepOutcome& outcome : path.outcomes)
      text_ += std::string(outcome.holds ? " c" : " !c") + std::to_string(outcome.comparison);
    text_ += " =";
    for (const StepIndex member : path.members) text_ += " " + name(member);
    text_ += "\n";
  }

  const TracedStep& step_;
  std::vector<std::string> names_;  // By expression: as others refer to it.
  std::string text_;
};

template <class Integer>
std::optional<Integer> number_of(std::string_view digits, int base = 10) {
  Integer value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, base);
  if (error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  return value;
}

// Of what hex_of writes; other spellings are found when the text is written again. From integers: libc++
// reads no real numbers, and these are the same bits whatever this machine's arithmetic does.
std::optional<double> real_of(std::string_view hex) {
  if (hex == "inf") return std::numeric_limits<double>::infinity();
  if (hex == "nan") return std::numeric_limits<double>::quiet_NaN();
  const std::size_t p = hex.find('p');
  if (p == std::string_view::npos || p < 3 || hex.size() < p + 3) return std::nullopt;
  std::string digits(hex.substr(std::min<std::size_t>(p, 4), p - std::min<std::size_t>(p, 4)));
  digits.resize(13, '0');
  const auto fraction = number_of<std::uint64_t>(digits, 16);
  const auto exponent = number_of<int>(hex.substr(p + (hex[p + 1] == '+' ? 2 : 1)));
  if (!fraction || !exponent || *exponent < -1022 || *exponent > 1023) return std::nullopt;
  const auto biased = static_cast<std::uint64_t>(hex[2] == '1' ? *exponent + 1023 : 0);
  return std::bit_cast<double>(biased << 52 | *fraction);
}

template <std::size_t kSize>
std::optional<std::size_t> index_in(const std::array<std::string_view, kSize>& words, std::string_view word) {
  const auto place = std::ranges::find(words, word);
  if (place == words.end()) return std::nullopt;
  return static_cast<std::size_t>(place - words.begin());
}

bool is_name(std::string_view word) {
  return !word.empty() && word.size() <= 64 && !(word[0] >= '0' && word[0] <= '9') &&
         std::ranges::all_of(
             word, [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; });
}

// The step as the text has it, so that every number is one of the step. Spelling and order are not looked at:
// whether that is the text of it in order, its caller finds out.
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
  using Words = std::span<const std::string_view>;

  bool read_line(std::string_view line) {
    const std::string_view name = line.substr(0, line.find(':'));
    std::vector<std::string_view> words;
    for (std::size_t at = name.size() + 2, end = 0; at <= line.size(); at = end + 1) {
      end = std::min(line.find(' ', at), line.size());
      words.push_back(line.substr(at, end - at));
    }
    if (name == "members") return read_members(words);
    const bool is_of_core = name.starts_with(kOfCore);
    if (is_of_core && words.size() > 1) return read_path(words, function_of_core(name.substr(1)));
    if (const auto function = index_in(kCoreFunctionNames, name))
      return !step_.describes_itself() && read_path(words, *function);
    if (name.starts_with('c') && number_of<std::size_t>(name.substr(1)) == step_.comparisons.size())
      return read_comparison(words);
    return read_expression(name, words);
  }

  bool read_members(Words words) {
    const bool is_of_core = !words.empty() && words[0].find('=') != std::string_view::npos;
    for (const std::string_view word : words) {
      const std::size_t end = is_of_core ? std::min(word.find('='), word.size() - 1) : word.size();
      const auto kind = index_in(kNumberKindNames, word.substr(0, end));
      if (!kind || step_.members.size() == kStepMembersMax + (is_of_core ? kStepContactsMax : 0))
        return false;
      step_.members.push_back(static_cast<NumberKind>(*kind));
      if (is_of_core) step_.member_names.emplace_back(word.substr(end + 1));
    }
    if (is_of_core) step_.paths.clear();
    return is_of_core || step_.members.size() >= 4;
  }

  // Functions come in their order.
  std::size_t function_of_core(std::string_view name) {
    if (step_.paths.empty() || step_.function_names.back() != name) {
      step_.function_names.emplace_back(name);
      step_.paths.emplace_back();
    }
    return step_.paths.size() - 1;
  }

  // "real", of an argument; "real = e1 + e2", "real = -e1", "real = fma(e1, e2, e3)".
  bool read_expression(std::string_view name, Words words) {
    const auto kind = words.empty() ? std::nullopt : index_in(kNumberKindNames, words[0]);
    const bool is_of_core = name.starts_with(kOfCore);
    if (!kind || is_of_core != (words.size() == 1 && step_.describes_itself()) ||
        (!is_of_core && !is_name(name)))
      return false;
    Expression expression{.op = Operator::argument, .kind = static_cast<NumberKind>(*kind)};
    if (words.size() == 1)
      expression.name = name.substr(is_of_core ? 1 : 0);
    else if (words.size() < 3 || !read_operation(words.subspan(2), expression))
      return false;
    return names_.try_emplace(std::string(name), add(expression)).second;
  }

  bool read_operation(Words words, Expression& expression) {
    if (words[0].starts_with('-')) {
      expression.op = Operator::negate;
      return read_operand(words[0].substr(1), expression, 0) && has_one_kind(expression);
    }
    if (words.size() != 3 || words[1].size() != 1) return read_call(words, expression);
    const std::size_t sign = kOperatorSigns.find(words[1]);
    if (sign == std::string_view::npos) return false;
    expression.op = static_cast<Operator>(static_cast<std::size_t>(Operator::add) + sign);
    if (expression.op == Operator::remainder && expression.kind != NumberKind::whole) return false;
    return read_operand(words[0], expression, 0) && read_operand(words[2], expression, 1) &&
           has_one_kind(expression);
  }

  bool read_call(Words words, Expression& expression) {
    const std::string_view name = words[0].substr(0, words[0].find('('));
    if (!is_name(name) || name.size() == words[0].size() || words.size() > expression.operands.size())
      return false;
    for (std::size_t place = 0; place < words.size(); ++place) {
      const std::string_view word = words[place].substr(place == 0 ? name.size() + 1 : 0);
      if (word.empty() || !read_operand(word.substr(0, word.size() - 1), expression, place)) return false;
    }
    const auto conversion = index_in(kConversionNames, name);
    expression.op = Operator::call;
    if (!conversion) expression.name = name;
    if (!conversion) return true;
    expression.op = static_cast<Operator>(static_cast<std::size_t>(Operator::to_real) + *conversion);
    return words.size() == 1 && static_cast<std::size_t>(expression.kind) == *conversion;  // Alike in order.
  }

  bool read_operand(std::string_view word, Expression& expression, std::size_t place) {
    expression.operands[place] = reference(word);
    return expression.operands[place] != kNoIndex;
  }

  // Of a name that stands above, or a constant; kNoIndex: of nothing.
  StepIndex reference(std::string_view word) {
    if (const auto named = names_.find(word); named != names_.end()) return named->second;
    if (const auto known = constants_.find(word); known != constants_.end()) return known->second;
    const std::optional<Expression> constant = constant_of(word);
    return constant ? constants_.emplace(std::string(word), add(*constant)).first->second : kNoIndex;
  }

  // "128", "0.5{0x1p-1}", "0.5{0x1p-1}f".
  static std::optional<Expression> constant_of(std::string_view word) {
    const std::size_t brace = word.find('{');
    if (brace == std::string_view::npos) {
      const auto whole = number_of<std::int64_t>(word);
      if (!whole || *whole < 0 || *whole > std::int64_t{1} << 31) return std::nullopt;
      return Expression{.kind = NumberKind::whole, .value = static_cast<double>(*whole)};
    }
    const bool is_single = word.ends_with('f');
    const auto value = real_of(word.substr(brace + 1, word.find('}') - brace - 1));
    if (!value || (is_single && std::isfinite(*value) && *value > kSingleMax)) return std::nullopt;
    return Expression{.kind = is_single ? NumberKind::single : NumberKind::real, .value = *value};
  }

  bool read_comparison(Words words) {
    const auto relation = words.size() == 3 ? index_in(kRelationSigns, words[1]) : std::nullopt;
    if (!relation) return false;
    const StepComparison comparison{reference(words[0]), reference(words[2]),
                                    static_cast<Relation>(*relation)};
    step_.comparisons.push_back(comparison);
    return comparison.left != kNoIndex && comparison.right != kNoIndex &&
           kind_of(comparison.left) == kind_of(comparison.right);
  }

  bool read_path(Words words, std::size_t function) {
    StepPath path;
    const auto equals = std::ranges::find(words, "=");
    for (const std::string_view word : Words(words.begin(), equals)) {
      const bool holds = word.starts_with('c');
      const auto comparison =
          number_of<StepIndex>(word.substr(std::min<std::size_t>(word.size(), holds ? 1 : 2)));
      if (!comparison || *comparison >= step_.comparisons.size()) return false;
      path.outcomes.push_back({*comparison, holds});
    }
    for (const std::string_view word : Words(equals, words.end()).subspan(equals == words.end() ? 0 : 1)) {
      const StepIndex member = reference(word);
      const std::size_t place = path.members.size();
      if (member == kNoIndex || place == step_.members.size() || kind_of(member) != step_.members[place])
        return false;
      path.members.push_back(member);
    }
    step_.paths[function].push_back(std::move(path));
    return step_.paths[function].back().members.size() == step_.members.size() &&
           step_.paths[function].size() <= kStepPathsMax;
  }

  StepIndex add(const Expression& expression) {
    step_.expressions.push_back(expression);
    return static_cast<StepIndex>(step_.expressions.size() - 1);
  }
  [[nodiscard]] NumberKind kind_of(StepIndex index) const { return step_.expressions[index].kind; }
  [[nodiscard]] bool has_one_kind(const Expression& expression) const {
    return std::ranges::all_of(expression.used_operands(),
                               [&](StepIndex operand) { return kind_of(operand) == expression.kind; });
  }

  TracedStep step_;
  std::map<std::string, StepIndex, std::less<>> names_;      // Of arguments and operations.
  std::map<std::string, StepIndex, std::less<>> constants_;  // By their text.
};

}  // namespace

std::string step_text(const TracedStep& step) { return Writer(step).text(); }

namespace {

// In order. Nothing: its checksum is another, or it is no text of a step.
std::optional<TracedStep> step_in(std::string_view text) {
  const std::size_t end = text.rfind("checksum: ");
  if (text.size() > kTextBytesMax || end == std::string_view::npos) return std::nullopt;
  const std::string_view body = text.substr(0, end);
  if (text.substr(end) != checksum_line(body)) return std::nullopt;  // Before the work of reading it.
  Reader reader;
  if (!body.starts_with(kFirstLine) || !reader.read(body.substr(kFirstLine.size()))) return std::nullopt;
  return in_order(reader.step());
}

std::optional<TracedStep> with_trees(TracedStep step) {
  for (const std::vector<StepPath>& paths : step.paths)
    if (!make_decision_tree(paths)) return std::nullopt;
  return step;
}

}  // namespace

std::optional<TracedStep> read_step(std::string_view text) {
  const std::optional<TracedStep> step = step_in(text);
  return step && step_text(*step) == text ? with_trees(canonical(*step)) : std::nullopt;
}

std::optional<TracedStep> read_own_step(std::string_view text) {
  const std::optional<TracedStep> step = step_in(text);
  return step ? with_trees(canonical(*step)) : std::nullopt;
}

}  // namespace hyrax
