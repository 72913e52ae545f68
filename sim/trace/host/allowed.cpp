#include "sim/trace/host/allowed.h"

#include <algorithm>
#include <array>
#include <set>
#include <span>
#include <vector>

#include "sim/trace/operation.h"

namespace hyrax::trace {
namespace {

using Words = std::vector<std::string_view>;

// Whether one of the words of a list, which are divided by '|', is as asked.
template <class Is>
bool is_any(std::string_view list, const Is& is) {
  while (!list.empty()) {
    const std::size_t end = std::min(list.find('|'), list.size());
    if (is(list.substr(0, end))) return true;
    list.remove_prefix(std::min(end + 1, list.size()));
  }
  return false;
}
bool is_in(std::string_view word, std::string_view list) {
  return is_any(list, [&](std::string_view each) { return word == each; });
}
bool begins_as(std::string_view word, std::string_view list) {
  return is_any(list, [&](std::string_view begin) { return word.starts_with(begin); });
}

#define HYRAX_TRACE_NAME(name, is_fixed) #name "|"
// Functions that the object may leave to others: those of <cmath> that are recorded, copies of what
// containers hold; and, by what their names begin with, allocation, exceptions, assertions, the arithmetic of
// wide integers.
constexpr std::string_view kFunctions = HYRAX_TRACE_FUNCTIONS(
    HYRAX_TRACE_NAME, HYRAX_TRACE_NAME) "fma|sincos|ldexp|memcpy|memmove|memset|memcmp|strlen|abort";
#undef HYRAX_TRACE_NAME
constexpr std::string_view kSymbols =
    "hyrax::trace::|operator new|operator delete|std::__throw_|std::__glibcxx_assert_fail|"
    "std::__cxx11::basic_string<|std::ios_base::Init::|std::exception::|std::logic_error::|"
    "std::runtime_error::|std::out_of_range::|std::invalid_argument::|std::domain_error::|std::range_error::|"
    "std::length_error::|std::terminate()|typeinfo for |vtable for std::|vtable for __cxxabiv1::|__cxa_|"
    "__gxx_personality|__assert_fail|__dso_handle|__stack_chk_fail|__tls_get_addr|__udiv|__umod|__div|__mod|"
    "__mul|__fix|__float|_Unwind_Resume|_GLOBAL_OFFSET_TABLE_";
// What a compiler's checks of a program add to it.
constexpr std::string_view kOfSanitizers =
    "__asan|__unnamed|__odr_asan|__ubsan|__tsan|__sanitizer|__sancov|__start___sancov|__stop___sancov|__gcov|"
    "__llvm|__prof";
constexpr std::string_view kVariables = "std::__ioinit|DW.ref.|guard variable for ";
constexpr std::string_view kSectionsOfVariables = ".bss|.data|.tbss|.tdata";

// Words that read the bits of numbers, or change how the compiler calculates.
constexpr std::string_view kRefusedWords =
    "memcpy|memmove|memcmp|mempcpy|bcopy|bit_cast|as_bytes|as_writable_bytes|reinterpret_cast|union|volatile|"
    "asm|target_clones|FP_CONTRACT";
// Of names that are the compiler's or the system's.
constexpr std::string_view kReservedNames =
    "__assert_fail|__PRETTY_FUNCTION__|__FUNCTION__|__func__|__extension__|__attribute__|__inline|__inline__|"
    "__restrict|__restrict__|__always_inline__|__forceinline|__unused__|__null";
constexpr std::string_view kBuiltins =
    "__builtin_nan|__builtin_inf|__builtin_huge|__builtin_expect|__builtin_unreachable|__builtin_assume";
constexpr std::string_view kAfterParameters = "const|noexcept|override|final|requires|mutable|try";

bool may_call(std::string_view symbol) {
  const bool is_single = symbol.ends_with('f') && is_in(symbol.substr(0, symbol.size() - 1), kFunctions);
  return is_single || is_in(symbol, kFunctions) || begins_as(symbol, kSymbols) ||
         begins_as(symbol, kOfSanitizers);
}

// Fields of a line of `nm`, from its last to its name, which may have any sign.
std::array<std::string_view, 7> fields_of(std::string_view line) {
  std::array<std::string_view, 7> fields{};
  for (std::size_t field = 6; field > 0 && !line.empty(); --field) {
    const std::size_t bar = std::min(line.rfind('|'), line.size());
    fields[field] = line.substr(std::min(bar + 1, line.size()));
    line = line.substr(0, bar);
  }
  fields[0] = line;
  for (std::string_view& field : fields) {
    while (field.starts_with(' ')) field.remove_prefix(1);
    while (field.ends_with(' ')) field.remove_suffix(1);
  }
  return fields;
}

std::string_view next_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

std::optional<std::string> why_not_linked(std::string_view symbols) {
  bool has_main = false;
  std::optional<std::string> calls;
  while (!symbols.empty()) {
    const auto [name, value, kind, type, size, line, section] = fields_of(next_line(symbols));
    has_main |= name == "main" && type == "FUNC";
    const bool is_variable = (type == "OBJECT" || type == "TLS") &&
                             begins_as(section, kSectionsOfVariables) && !section.starts_with(".data.rel.ro");
    if (is_variable && !begins_as(name, kVariables) && !begins_as(name, kOfSanitizers))
      return "memory outside the body: " + std::string(name);
    const bool is_outside = kind == "U" || ((kind == "w" || kind == "v") && section.starts_with("*UND*"));
    if (is_outside && !may_call(name) && !calls)
      calls = "the step calls " + std::string(name.substr(0, name.find('(')));
  }
  if (!has_main)
    return "memory outside the body cannot be ruled out: `nm` does not list the symbols of its object";
  return calls;
}

bool is_of_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '$' ||
         static_cast<unsigned char>(c) >= 0x80;
}

// Words and signs; texts in quotes are one.
void add_words(std::string_view line, Words& words) {
  while (!line.empty()) {
    std::size_t length = 1;
    if (line[0] == '"' || line[0] == '\'') {
      while (length < line.size() && line[length] != line[0]) length += line[length] == '\\' ? 2 : 1;
      length = std::min(length + 1, line.size());
    } else if (is_of_word(line[0])) {
      while (length < line.size() && is_of_word(line[length])) ++length;
    }
    if (std::string_view(" \t\r\v\f").find(line[0]) == std::string_view::npos)
      words.push_back(line.substr(0, length));
    line.remove_prefix(length);
  }
}

struct HeaderWords {
  Words own;                          // Of the header, and of the files of the project that it includes.
  std::set<std::string_view> others;  // Beginning with `_`, of all other files.
};

HeaderWords words_of(std::string_view program, std::string_view header) {
  HeaderWords words;
  const std::string name = " \"" + std::string(header) + "\" 1";
  std::vector<bool> is_own;  // Of the files that are open. What a system's macro becomes is the file's own.
  while (!program.empty()) {
    const std::string_view line = next_line(program);
    if (line.starts_with("# ") && line.size() > 2 && line[2] >= '0' && line[2] <= '9') {
      const std::string_view flags = line.substr(line.rfind('"') + 1);
      const bool is_inside = !is_own.empty() && is_own.back();
      if (flags.starts_with(" 1"))
        is_own.push_back((is_inside || line.find(name) != std::string_view::npos) &&
                         flags.find('3') == std::string_view::npos);
      else if (flags.starts_with(" 2") && !is_own.empty())
        is_own.pop_back();
      continue;
    }
    Words read;
    const bool is_inside = !is_own.empty() && is_own.back();
    add_words(line, is_inside ? words.own : read);
    for (const std::string_view word : read)
      if (word.starts_with('_')) words.others.insert(word);
  }
  return words;
}

// Whether a cast of a pointer or reference ends at this `)`: an operand follows.
bool ends_cast(const Words& words, std::size_t place) {
  if (place == 0 || place + 1 == words.size() || words[place] != ")") return false;
  if (words[place - 1] != "*" && words[place - 1] != "&") return false;
  const std::string_view next = words[place + 1];
  return next == "&" || next == "(" || next == "*" || (is_of_word(next[0]) && !is_in(next, kAfterParameters));
}

std::optional<std::string> why_not_written(const HeaderWords& words) {
  for (std::size_t place = 0; place < words.own.size(); ++place) {
    const std::string_view word = words.own[place];
    const std::string_view next = place + 1 < words.own.size() ? words.own[place + 1] : "";
    const bool is_reserved = word.starts_with("__") || (next == "(" && words.others.contains(word));
    const bool is_refused = is_in(word, kRefusedWords) || (word == "void" && next == "*") ||
                            (word == "optimize" && next == "(") ||
                            (is_reserved && !is_in(word, kReservedNames) && !begins_as(word, kBuiltins));
    if (is_refused) return "the step uses " + std::string(word == "void" ? "void*" : word);
    if (ends_cast(words.own, place)) return "the step uses a cast to a pointer or a reference";
  }
  return std::nullopt;
}

std::string without_renaming(std::string_view word) {
  constexpr std::string_view kTraced = "hyrax_traced_";
  std::string name(word);
  for (std::size_t at = 0; (at = name.find(kTraced)) != std::string::npos;) name.erase(at, kTraced.size());
  return name;
}

}  // namespace

std::optional<std::string> why_not_allowed(const HeaderOutput& output) {
  const HeaderWords compiled = words_of(output.compiled, output.header);
  const Words traced = words_of(output.traced, output.header).own;
  if (compiled.own.empty()) return "the preprocessor does not give the header's text";
  if (auto why = why_not_linked(output.symbols)) return why;
  if (auto why = why_not_written(compiled)) return why;
  const auto [own, other] = std::ranges::mismatch(compiled.own, traced, {}, {}, without_renaming);
  if (own == compiled.own.end() && other == traced.end()) return std::nullopt;
  return "its text depends on how it is compiled: `" + std::string(own == compiled.own.end() ? "" : *own) +
         "`, where it is traced `" + (other == traced.end() ? "" : without_renaming(*other)) + "`";
}

}  // namespace hyrax::trace
