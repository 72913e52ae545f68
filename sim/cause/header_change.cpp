#include "sim/cause/header_change.h"
#include "sim/trace/step_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <set>

namespace hyrax {
namespace {

// Changes are found by a table of pairs of statements.
constexpr std::size_t kStatementsMax = 4000;

// Tokens up to `;`, `{`, `}` or a label's `:`, or a directive of the preprocessor; `for (...; ...; ...) {` is
// one, and so is `double a{1.0};`.
struct HeaderStatement {
  std::vector<std::string_view> tokens;
  std::int64_t line = 0;

  bool operator==(const HeaderStatement& other) const { return tokens == other.tokens; }
  [[nodiscard]] bool opens() const { return tokens.back() == "{"; }
  [[nodiscard]] bool closes() const { return tokens.back() == "}"; }
  // With a blank where the header has any.
  [[nodiscard]] std::string text() const {
    std::string joined(tokens.front());
    for (std::size_t next = 1; next < tokens.size(); ++next) {
      const std::string_view before = tokens[next - 1];
      const bool is_tight = before.data() + before.size() == tokens[next].data();
      joined.append(is_tight ? "" : " ").append(tokens[next]);
    }
    return joined;
  }
};

bool is_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         static_cast<unsigned char>(c) >= 0x80;
}

class HeaderReader {
 public:
  explicit HeaderReader(std::string_view text) : text_(text) {}

  std::vector<HeaderStatement> statements() {
    while (!text_.empty()) {
      if (const std::size_t gap = length_of_gap(text_); gap > 0) {
        const bool ends_directive = is_directive_ && text_.front() == '\n';
        take(gap);
        if (ends_directive) close();
        continue;
      }
      if (open_.tokens.empty()) {
        open_.line = line_;
        is_directive_ = text_.front() == '#';
      }
      const std::string_view token = take(length_of_token(text_));
      open_.tokens.push_back(token);
      parentheses_ += token == "(" ? 1 : token == ")" ? -1 : 0;
      if (token == "{" && (braces_ > 0 || begins_value())) ++braces_;
      const bool is_brace = braces_ == 0 && (token == "{" || token == "}");
      if (token == "}" && braces_ > 0) --braces_;
      const bool is_label = token == ":" && open_.tokens.size() == 2;  // As `public:`.
      const bool is_end = token == ";" && parentheses_ <= 0 && braces_ == 0;
      if (!is_directive_ && (is_label || is_end || is_brace)) close();
    }
    close();
    return std::move(statements_);
  }

 private:
  void close() {
    if (!open_.tokens.empty()) statements_.push_back(std::move(open_));
    open_ = {};
    parentheses_ = braces_ = 0;
    is_directive_ = false;
  }

  // Whether the `{` that was read last is that of an initial value: of a declaration, not of a class or a
  // block.
  [[nodiscard]] bool begins_value() const {
    const auto& tokens = open_.tokens;
    if (tokens.size() < 2) return false;
    if (tokens[tokens.size() - 2] == "=") return true;
    return is_word(tokens[tokens.size() - 2].front()) && tokens.size() > 2 &&
           std::ranges::none_of(tokens, [](std::string_view token) {
             return token == "(" || token == "class" || token == "struct" || token == "union" ||
                    token == "enum" || token == "namespace";
           });
  }

  std::string_view take(std::size_t length) {
    const std::string_view taken = text_.substr(0, length);
    line_ += std::ranges::count(taken, '\n');
    text_.remove_prefix(length);
    return taken;
  }

  // Of a blank or a comment; 0: a token comes next.
  static std::size_t length_of_gap(std::string_view rest) {
    for (const std::string_view joined : {"\\\n", "\\\r\n"})
      if (rest.starts_with(joined)) return joined.size();
    if (rest.starts_with("//")) {
      std::size_t end = 0;
      do end = std::min(rest.find('\n', end + 1), rest.size());
      while (end < rest.size() &&
             (rest.substr(0, end).ends_with('\\') || rest.substr(0, end).ends_with("\\\r")));
      return end;
    }
    if (rest.starts_with("/*")) return std::min(rest.find("*/", 2), rest.size() - 2) + 2;
    return std::string_view(" \t\r\n").find(rest.front()) == std::string_view::npos ? 0 : 1;
  }

  static std::size_t length_of_token(std::string_view rest) {
    const bool is_number = (rest[0] >= '0' && rest[0] <= '9') ||
                           (rest[0] == '.' && rest.size() > 1 && rest[1] >= '0' && rest[1] <= '9');
    std::size_t length = 1;
    if (is_number) {
      const auto is_exponent = [&](std::size_t at) {
        return (rest[at] == '+' || rest[at] == '-') &&
               std::string_view("eEpP").find(rest[at - 1]) != std::string_view::npos;
      };
      while (length < rest.size() &&
             (is_word(rest[length]) || rest[length] == '.' || rest[length] == '\'' || is_exponent(length)))
        ++length;
    } else if (is_word(rest[0])) {
      while (length < rest.size() && is_word(rest[length])) ++length;
    } else if (rest[0] == '"' || rest[0] == '\'') {
      while (length < rest.size() && rest[length] != rest[0] && rest[length] != '\n')
        length += rest[length] == '\\' ? 2 : 1;
      length = std::min(length + 1, rest.size());
    } else {
      for (const std::string_view pair :
           {"::", "->", "++", "--", "+=", "-=", "*=", "/=", "%=", "==", "!=", "<=", ">=", "&&", "||"})
        if (rest.starts_with(pair)) length = 2;
    }
    return length;
  }

  std::string_view text_;  // That is left.
  std::int64_t line_ = 1;
  bool is_directive_ = false;
  int parentheses_ = 0;  // Open in this statement,
  int braces_ = 0;       // and those of initial values.
  HeaderStatement open_;
  std::vector<HeaderStatement> statements_;
};

std::optional<double> number_of(std::string_view token) {
  std::string digits(token);
  std::erase(digits, '\'');
  const bool is_hex = digits.starts_with("0x") || digits.starts_with("0X");
  double value = 0.0;
  const auto [end, error] =
      std::from_chars(digits.data() + (is_hex ? 2 : 0), digits.data() + digits.size(), value,
                      is_hex ? std::chars_format::hex : std::chars_format::general);
  const std::string_view suffix(end, static_cast<std::size_t>(digits.data() + digits.size() - end));
  const bool is_float = suffix == "f" || suffix == "F";
  if (error != std::errc() || !(suffix.empty() || is_float || suffix == "l" || suffix == "L"))
    return std::nullopt;
  return is_float ? static_cast<double>(static_cast<float>(value)) : value;
}

// `... NAME = NUMBER ;` or `... NAME{NUMBER};`, the number perhaps with a sign; its value as the type has it.
std::optional<HeaderConstant> constant_of(const HeaderStatement& statement) {
  const auto& tokens = statement.tokens;
  const auto is = [](std::initializer_list<std::string_view> words) {
    return [words](std::string_view token) { return std::ranges::find(words, token) != words.end(); };
  };
  const auto begin = std::ranges::find_if(tokens, is({"=", "{", "("}));
  if (begin == tokens.begin() || std::find_if(tokens.begin(), begin, is({"constexpr", "const"})) == begin)
    return std::nullopt;
  std::vector<std::string_view> number;
  std::copy_if(begin, tokens.end(), std::back_inserter(number), [&](std::string_view token) {
    return !is({"=", "{", "(", "}", ")", ";"})(token);
  });
  const bool is_negative = !number.empty() && number.front() == "-";
  if (number.size() != (is_negative ? 2 : 1)) return std::nullopt;
  std::optional<double> value = number_of(number.back());
  if (!value) return std::nullopt;
  if (std::find(tokens.begin(), begin, "float") != begin)
    value = static_cast<double>(static_cast<float>(*value));
  return HeaderConstant{std::string(*(begin - 1)), is_negative ? -*value : *value};
}

HeaderChange changed(const HeaderStatement& from, const HeaderStatement& to) {
  const auto old_constant = constant_of(from), new_constant = constant_of(to);
  if (old_constant && new_constant && old_constant->name == new_constant->name &&
      old_constant->value != new_constant->value)
    return {HeaderChangeKind::constant,
            fmt::format("{} {} -> {}", new_constant->name, old_constant->value, new_constant->value), to.line,
            *old_constant, *new_constant};
  return {HeaderChangeKind::altered, fmt::format("{} -> {}", from.text(), to.text()), to.line, {}, {}};
}

// Statements that only one header has, between two that both have.
struct HeaderGap {
  std::vector<HeaderStatement> removed, added;

  void flush(std::vector<HeaderChange>& changes) {
    const std::size_t both = std::min(removed.size(), added.size());
    for (std::size_t index = 0; index < both; ++index)
      changes.push_back(changed(removed[index], added[index]));
    for (std::size_t index = both; index < removed.size(); ++index)
      changes.push_back({HeaderChangeKind::removed, removed[index].text(), removed[index].line, {}, {}});
    for (std::size_t index = both; index < added.size(); ++index)
      changes.push_back({HeaderChangeKind::added, added[index].text(), added[index].line, {}, {}});
    removed.clear();
    added.clear();
  }
};

// Of one header, up to a statement: whether only it has each block that is open.
class OpenBlocks {
 public:
  void pass(const HeaderStatement& statement, bool is_own) {
    if (statement.opens()) is_own_.push_back(is_own);
    if (statement.closes() && !is_own_.empty()) is_own_.pop_back();
  }
  [[nodiscard]] bool ends_own(const HeaderStatement& statement) const {
    return statement.closes() && !is_own_.empty() && is_own_.back();
  }

 private:
  std::vector<bool> is_own_;
};

// "line 5", "lines 5, 8 and 9".
std::string lines_text(std::vector<std::int64_t> lines) {
  std::ranges::sort(lines);
  const std::int64_t last = lines.back();
  lines.pop_back();
  return lines.empty() ? fmt::format("line {}", last)
                       : fmt::format("lines {} and {}", fmt::join(lines, ", "), last);
}

}  // namespace

std::vector<HeaderConstant> header_constants(std::string_view header) {
  std::vector<HeaderConstant> constants;
  for (const HeaderStatement& statement : HeaderReader(header).statements())
    if (const auto constant = constant_of(statement)) constants.push_back(*constant);
  return constants;
}

std::vector<double> header_literals(std::string_view header) {
  std::vector<double> literals;
  for (const HeaderStatement& statement : HeaderReader(header).statements()) {
    if (constant_of(statement)) continue;
    for (const std::string_view token : statement.tokens)
      if (const std::optional<double> literal = number_of(token)) literals.push_back(*literal);
  }
  return literals;
}

NumberNames shared_names(std::string_view accepted, std::string_view program) {
  NumberNames names;
  const std::vector<double> literals = header_literals(program);
  std::set<double> ambiguous(literals.begin(), literals.end());
  ambiguous.insert({0.0, 1.0});
  const std::vector<HeaderConstant> others = header_constants(accepted);
  for (const HeaderConstant& constant : header_constants(program))
    if (std::ranges::find(others, constant) == others.end() ||
        !names.try_emplace(constant.value, constant.name).second)
      ambiguous.insert(constant.value);
  for (const double value : ambiguous) names.erase(value);
  return names;
}

std::vector<std::string> header_members(std::string_view header) {
  std::vector<std::string> declared;
  std::array<std::string, 4> returned;  // By x(), y(), vx() and vy().
  const std::string* getter = nullptr;
  std::size_t depth = 0, depth_of_class = 0;  // Of its members; 0: outside.
  for (const HeaderStatement& statement : HeaderReader(header).statements()) {
    const auto& tokens = statement.tokens;
    const auto has = [&](std::string_view token) { return std::ranges::find(tokens, token) != tokens.end(); };
    if (getter != nullptr && tokens.size() == 3 && tokens[0] == "return")
      returned[static_cast<std::size_t>(getter - returned.data())] = tokens[1];
    getter = nullptr;
    if (statement.closes() && depth-- == depth_of_class) depth_of_class = 0;
    if (depth_of_class != 0 && depth == depth_of_class) {
      for (const auto& [name, result] : {std::pair("x", 0), {"y", 1}, {"vx", 2}, {"vy", 3}})
        if (statement.opens() && has("(") && *(std::ranges::find(tokens, "(") - 1) == name)
          getter = &returned[static_cast<std::size_t>(result)];
      const bool is_of_number =
          tokens[0] == "double" || tokens[0] == "float" || tokens[0] == "int" || tokens[0] == "bool";
      if (is_of_number && tokens.back() == ";" && !has("("))
        for (std::size_t next = 1; next + 1 < tokens.size(); ++next)
          if (tokens[next - 1] == "," || next == 1) declared.emplace_back(tokens[next]);
    }
    if (statement.opens()) ++depth;
    if (has("class") && has("physics") && statement.opens()) depth_of_class = depth;
  }
  std::vector<std::string> members(returned.begin(), returned.end());
  for (const std::string& name : returned)
    if (std::erase(declared, name) != 1) return {};
  members.insert(members.end(), declared.begin(), declared.end());
  return members;
}

std::vector<HeaderChange> header_changes(std::string_view accepted, std::string_view current,
                                         const std::string& file) {
  const std::vector<HeaderStatement> from = HeaderReader(accepted).statements();
  const std::vector<HeaderStatement> to = HeaderReader(current).statements();
  std::size_t same = 0;  // Statements that both begin with.
  while (same < std::min(from.size(), to.size()) && from[same] == to[same]) ++same;
  const std::size_t rows = std::min(from.size() - same, kStatementsMax);
  const std::size_t columns = std::min(to.size() - same, kStatementsMax);
  // common[i][j]: how many statements the ends from i and from j have in common.
  std::vector<std::vector<std::uint16_t>> common(rows + 1, std::vector<std::uint16_t>(columns + 1));
  for (std::size_t i = rows; i-- > 0;)
    for (std::size_t j = columns; j-- > 0;)
      common[i][j] = from[same + i] == to[same + j] ? static_cast<std::uint16_t>(common[i + 1][j + 1] + 1)
                                                    : std::max(common[i + 1][j], common[i][j + 1]);
  std::vector<HeaderChange> changes;
  HeaderGap gap;
  OpenBlocks accepted_blocks, current_blocks;
  for (std::size_t i = 0, j = 0; i < rows || j < columns;) {
    bool is_same = i < rows && j < columns && from[same + i] == to[same + j];
    bool is_removed = j == columns || (i < rows && common[i + 1][j] >= common[i][j + 1]);
    if (is_same) {  // Of several `}`, the one of an added block is added, where as much remains in common.
      const bool ends_removed = accepted_blocks.ends_own(from[same + i]);
      const bool ends_added = current_blocks.ends_own(to[same + j]);
      is_removed = ends_removed;
      is_same =
          ends_removed == ends_added || (ends_removed ? common[i + 1][j] : common[i][j + 1]) < common[i][j];
    }
    if (is_same) gap.flush(changes);
    if (is_same || is_removed) {
      accepted_blocks.pass(from[same + i], !is_same);
      if (!is_same) gap.removed.push_back(from[same + i]);
      ++i;
    }
    if (is_same || !is_removed) {
      current_blocks.pass(to[same + j], !is_same);
      if (!is_same) gap.added.push_back(to[same + j]);
      ++j;
    }
  }
  gap.flush(changes);
  for (HeaderChange& change : changes) change.file = file;
  return changes;
}

std::string change_text(const HeaderChange& change, std::string_view header) {
  return fmt::format("line {:<4} {}: {}{}", change.line,
                     kHeaderChangeNames[static_cast<std::size_t>(change.kind)], change.detail,
                     change.file == header ? "" : fmt::format(" ({})", change.file));
}

Table changes_table(const std::vector<HeaderChange>& changes) {
  const auto number = [&](const std::string& name, HeaderConstant HeaderChange::*constant) {
    return column_of(name, "", "of a constant", changes, [constant](const HeaderChange& change) {
      return change.kind == HeaderChangeKind::constant ? (change.*constant).value
                                                       : std::numeric_limits<double>::quiet_NaN();
    });
  };
  const auto kind = [](const HeaderChange& change) {
    return kHeaderChangeNames[static_cast<std::size_t>(change.kind)];
  };
  return {"changes",
          "what changed in the header",
          {column_of("kind", "", "constant, or a statement", changes, kind),
           column_of("detail", "", "what changed", changes, &HeaderChange::detail),
           column_of("file", "", "in which the line is", changes, &HeaderChange::file),
           column_of("line", "", "of what was removed, in the base", changes, &HeaderChange::line),
           number("from", &HeaderChange::from), number("to", &HeaderChange::to),
           column_of("scenarios", "", "that it reproduces alone", changes, [](const HeaderChange& change) {
             return change.scenarios ? static_cast<double>(*change.scenarios)
                                     : std::numeric_limits<double>::quiet_NaN();
           })}};
}

std::string changes_sentence(const std::vector<HeaderChange>& changes, std::string_view header) {
  std::vector<std::string> parts;
  std::map<std::pair<std::string, bool>, std::vector<std::int64_t>>
      lines_of;  // By file, the program's first.
  for (const HeaderChange& change : changes) {
    if (change.kind == HeaderChangeKind::constant) {
      parts.push_back(change.detail);
      continue;
    }
    const std::string file = change.file == header ? "" : change.file;
    auto& lines = lines_of[{file, change.kind == HeaderChangeKind::removed}];
    if (std::ranges::find(lines, change.line) == lines.end()) lines.push_back(change.line);
  }
  std::vector<std::string> places;
  places.reserve(lines_of.size());
  for (const auto& [place, lines] : lines_of)
    places.push_back(lines_text(lines) + (place.first.empty() ? place.second ? " of the accepted header" : ""
                                          : place.second      ? " of the accepted " + place.first
                                                              : " of " + place.first));
  if (!places.empty()) parts.push_back(fmt::format("the core changed at {}", fmt::join(places, ", and at ")));
  return fmt::format("{}", fmt::join(parts, "; "));
}

StepProof prove_equal(const std::string& base_name, const CoreRecord& base, const CoreRecord& core) {
  StepProof proof{.is_complete = !base.step.empty() && !core.step.empty()};
  // Texts of two versions of the program may differ in comparisons that decide nothing.
  const auto is_same_step = [&] {
    const std::optional<TracedStep> base_step = read_step(base.step);
    return base_step && base_step == read_step(core.step);
  };
  proof.is_equal = proof.is_complete && (base.step == core.step || is_same_step());
  if (!proof.is_complete)
    proof.why = core.step.empty()
                    ? std::string(core.why_incomplete)
                    : fmt::format("the step of {} is not complete: {}", base_name, base.why_incomplete);
  else if (!proof.is_equal)
    proof.why = "its step is another one; no step is known whose bits differ";
  return proof;
}

TracedStep with_constants(const TracedStep& step, const std::map<double, double>& values) {
  // Constants are never negative: of a negative one the step has the negation.
  std::map<double, double> of_magnitude;
  for (const auto& [from, to] : values) of_magnitude[std::fabs(from)] = std::signbit(from) ? -to : to;
  TracedStep changed = step;
  for (Expression& expression : changed.expressions)
    if (const auto value = of_magnitude.find(expression.value);
        expression.op == Operator::constant && value != of_magnitude.end())
      expression.value = value->second;
  return canonical(changed);
}

}  // namespace hyrax
