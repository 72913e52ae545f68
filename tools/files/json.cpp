#include "tools/files/json.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include "tools/files/failure.h"
#include "tools/files/printable.h"

namespace hyrax {
namespace {

// At the byte before offset `end`; columns are counted in bytes.
[[noreturn]] void fail(std::string_view text, const std::string& source, std::size_t end,
                       const std::string& sentence) {
  const std::string_view before = text.substr(0, std::max<std::size_t>(std::min(end, text.size()), 1) - 1);
  const auto line = 1 + std::ranges::count(before, '\n');
  const std::size_t line_begin = before.rfind('\n') + 1;  // 0 on the first line.
  refuse_input(source + ": line " + std::to_string(line) + ", column " +
               std::to_string(before.size() - line_begin + 1) + ": " + sentence);
}

// The parser quotes the whole token it was reading, of any length and with any bytes. Only its end is
// reported, in printable characters.
std::string with_short_quote(std::string reason) {
  constexpr std::string_view kQuote = "last read: '";
  constexpr std::size_t kShownMax = 40;
  const std::size_t quote = reason.find(kQuote);
  if (quote == std::string::npos) return reason;
  const std::size_t begin = quote + kQuote.size();
  const std::size_t expected = reason.rfind("'; expected ");
  const std::size_t end = expected != std::string::npos && expected >= begin ? expected : reason.size() - 1;
  for (std::size_t at = begin; at < end; ++at)
    if ((static_cast<unsigned char>(reason[at]) & 0x80u) != 0) reason[at] = '?';
  if (end - begin > kShownMax) reason.replace(begin, end - begin - kShownMax, "...");
  return reason;
}

// nlohmann-json reports "[json.exception...] parse error at line 1, column 2: syntax error ...".
std::string plain_reason(std::string_view what) {
  const std::size_t syntax = what.find("syntax error");
  if (syntax != std::string_view::npos)
    return with_short_quote("not JSON: " + std::string(what.substr(syntax)));
  const std::size_t bracket = what.find("] ");
  return bracket == std::string_view::npos ? std::string(what) : std::string(what.substr(bracket + 2));
}

// The text of a number in its parts.
struct Decimal {
  std::string_view digits;  // With the point.
  std::size_t point;        // Where it is, or would be. The parser writes it as the locale does.
  std::int64_t tens;        // The exponent.
};

Decimal decimal_of(std::string_view text) {
  const std::size_t end = std::min(text.find_first_of("eE"), text.size());
  std::string_view exponent = text.substr(std::min(end + 1, text.size()));
  if (exponent.starts_with('+')) exponent.remove_prefix(1);
  std::int64_t tens = 0;
  const auto read = std::from_chars(exponent.data(), exponent.data() + exponent.size(), tens);
  // One that is too large is that of a zero: any other number is beyond binary64.
  if (read.ec == std::errc::result_out_of_range) tens = std::numeric_limits<std::int64_t>::min();
  return {text.substr(0, end), std::min(text.find_first_not_of("-0123456789"), end), tens};
}

// Whether it has the value of an integer, as 1.50e1 has: no digit but zeros lies below 1.
bool has_no_fraction(const Decimal& number) {
  const std::size_t last = number.digits.find_last_of("123456789");
  if (last == number.digits.npos) return true;
  const auto digits_below_one = static_cast<std::int64_t>(last) - static_cast<std::int64_t>(number.point) +
                                (last < number.point ? 1 : 0);
  return digits_below_one <= number.tens;
}

// Its digits as an integer, if they fit. REQUIRES: has_no_fraction(number), its size is 1 .. 1e20.
template <class Integer>
std::optional<Integer> integer_of(const Decimal& number) {
  std::string digits(number.digits);
  if (number.point < digits.size()) digits.erase(number.point, 1);
  digits.resize(static_cast<std::size_t>(static_cast<std::int64_t>(number.point) + number.tens), '0');
  Integer integer = 0;
  const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), integer);
  return read.ec == std::errc() ? std::optional(integer) : std::nullopt;
}

// Behind the bracket that opens the first part of that level. REQUIRES: JSON up to there.
std::size_t end_of_level(std::string_view text, int level) {
  std::size_t at = 0;
  bool is_in_text = false;
  for (int depth = 0; depth < level && at < text.size(); ++at) {
    const char here = text[at];
    if (here == '"') is_in_text = !is_in_text;
    if (is_in_text && here == '\\') ++at;
    if (is_in_text) continue;
    if (here == '[' || here == '{') ++depth;
    if (here == ']' || here == '}') --depth;
  }
  return at;
}

class Builder : public nlohmann::json_sax<nlohmann::json> {
 public:
  Builder(std::string_view text, const std::string& source) : text_(text), source_(source), parsed_(text) {}

  Json parse() {
    while (!nlohmann::json::sax_parse(parsed_.begin(), parsed_.end(), this)) {
      open_.clear();
      numbers_ = 0;
    }
    return std::move(document_);
  }

  bool null() override { return add(Json()); }
  bool boolean(bool value) override { return add(value); }
  // The only signed integer text of value 0 is "-0": as a double it keeps its sign.
  bool number_integer(std::int64_t value) override { return value == 0 ? add(-0.0) : add(value); }
  bool number_unsigned(std::uint64_t value) override { return add(value); }
  bool number_float(double value, const std::string& text) override {
    if (const auto overflow = overflows_.find(numbers_++); overflow != overflows_.end())
      return add(RoundedNumber{overflow->second.front() == '-' ? -HUGE_VAL : HUGE_VAL, overflow->second});
    const Decimal number = decimal_of(text);
    if (!has_no_fraction(number))
      return std::floor(value) == value ? add(RoundedNumber{value, text}) : add(value);
    if (value >= 0x1p53 && value <= 0x1p64)
      if (const auto integer = integer_of<std::uint64_t>(number)) return add(*integer);
    if (value <= -0x1p53 && value >= -0x1p63)
      if (const auto integer = integer_of<std::int64_t>(number)) return add(*integer);
    return add(value);
  }
  bool string(std::string& value) override { return add(std::move(value)); }
  bool binary(nlohmann::json::binary_t&) override { return false; }
  bool start_object(std::size_t) override { return open(Json::Object()); }
  bool key(std::string& value) override {
    key_ = std::move(value);
    return true;
  }
  bool end_object() override { return close(); }
  bool start_array(std::size_t) override { return open(Json::Array()); }
  bool end_array() override { return close(); }
  // At a number beyond binary64 the parser stops. It is replaced by a zero of the same length, and the text
  // parsed again.
  bool parse_error(std::size_t position, const std::string& token,
                   const nlohmann::json::exception& error) override {
    constexpr int kNumberOverflow = 406;
    constexpr std::size_t kOverflowsMax = 20;  // Each costs the time of one parse.
    if (error.id == kNumberOverflow) {
      if (overflows_.size() == kOverflowsMax)
        fail(text_, source_, position, "number is too large (found " + shortened(token) + ")");
      overflows_.emplace(numbers_, token);
      parsed_.replace(position - token.size(), token.size(), "0e" + std::string(token.size() - 2, '0'));
      return false;
    }
    fail(text_, source_, position, plain_reason(error.what()));
  }

 private:
  bool add(Json value) {
    place(std::move(value));
    return true;
  }
  bool open(Json container) {
    if (open_.size() >= kJsonNestingMax)
      fail(text_, source_, end_of_level(text_, kJsonNestingMax + 1),
           "nested more than " + std::to_string(kJsonNestingMax) + " levels");
    open_.push_back(place(std::move(container)));
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }
  // Elements do not move while the last element of their parent is open, so the address stays valid.
  Json* place(Json value) {
    if (open_.empty()) {
      document_ = std::move(value);
      return &document_;
    }
    if (auto* array = open_.back()->get<Json::Array>()) return &array->emplace_back(std::move(value));
    return &open_.back()->get<Json::Object>()->emplace_back(std::move(key_), std::move(value)).second;
  }

  std::string_view text_;
  const std::string& source_;
  std::string parsed_;
  std::map<std::size_t, std::string> overflows_;  // The texts, by the count of numbers before them.
  std::size_t numbers_ = 0;                       // With a point or an exponent, or beyond 64 bits.
  Json document_;
  std::vector<Json*> open_;
  std::string key_;
};

std::string quoted(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string scalar(const Json& json) {
  if (const auto* truth = json.get<bool>()) return *truth ? "true" : "false";
  if (const auto* text = json.get<std::string>()) return quoted(*text);
  if (const auto* integer = json.get<std::int64_t>()) return std::to_string(*integer);
  if (const auto* integer = json.get<std::uint64_t>()) return std::to_string(*integer);
  if (const auto* number = json.get<RoundedNumber>()) return number->text;
  const auto* number = json.get<double>();
  if (number == nullptr) return "null";
  if (std::isfinite(*number)) return to_text(*number);
  return std::isnan(*number) ? "\"NaN\"" : *number > 0.0 ? "\"Infinity\"" : "\"-Infinity\"";
}

// Appends documents; members down to a depth have lines of their own.
struct Writer {
  int depth_indented;
  std::string text = {};

  void write(const Json& json, int depth) {
    if (const auto* array = json.get<Json::Array>())
      write_members("[", "]", *array, depth, [&](const Json& element) { write(element, depth + 1); });
    else if (const auto* object = json.get<Json::Object>())
      write_members("{ ", " }", *object, depth, [&](const auto& member) {
        text += quoted(member.first) + ": ";
        write(member.second, depth + 1);
      });
    else
      text += scalar(json);
  }

  // The brackets with their blanks, which an empty or an indented list does without.
  void write_members(std::string_view open, std::string_view close, const auto& members, int depth,
                     const auto& write_member) {
    const bool is_indented = depth < depth_indented && !members.empty();
    const auto new_line = [&](int at) { text.append("\n").append(static_cast<std::size_t>(2 * at), ' '); };
    if (is_indented || members.empty()) {
      open = open.substr(0, 1);
      close = close.substr(close.size() - 1);
    }
    text += open;
    for (const auto& member : members) {
      if (&member != &members.front()) text += is_indented ? "," : ", ";
      if (is_indented) new_line(depth + 1);
      write_member(member);
    }
    if (is_indented) new_line(depth);
    text += close;
  }
};

}  // namespace

double Json::number() const {
  assert(is_number());
  if (const auto* value = get<double>()) return *value;
  if (const auto* rounded = get<RoundedNumber>()) return rounded->value;
  if (const auto* value = get<std::int64_t>()) return static_cast<double>(*value);
  return static_cast<double>(*get<std::uint64_t>());
}

bool Json::is_whole() const {
  return is_number() && get<RoundedNumber>() == nullptr && std::floor(number()) == number();
}

const Json* Json::find(std::string_view key) const {
  const auto* object = get<Object>();
  if (object == nullptr) return nullptr;
  for (const auto& [name, value] : *object)
    if (name == key) return &value;
  return nullptr;
}

Json parse_json(std::string_view text, const std::string& source) {
  if (text.starts_with("\xEF\xBB\xBF"))
    fail(text, source, 1, "begins with a byte-order mark; save it as UTF-8 without one");
  // The parser would stop at a zero byte and ignore the rest.
  if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos)
    fail(text, source, zero + 1, "not JSON: holds a zero byte; save it as UTF-8");
  // What the parser says of it depends on its version.
  if (text.empty()) fail(text, source, 1, "not JSON: unexpected end of input");
  return Builder(text, source).parse();
}

std::string to_text(const Json& json, int depth_indented) {
  Writer writer{depth_indented};
  writer.write(json, 0);
  return std::move(writer.text);
}

std::string to_text(double value) {
  char text[32];
  const auto [end, error] = std::to_chars(text, text + sizeof text, value);
  return std::string(text, end);
}

// By hand: versions of std::to_chars differ in how they write a subnormal number.
std::string hex_float(double value) {
  const std::string sign = std::signbit(value) ? "-" : "";
  if (!std::isfinite(value)) return sign + (std::isnan(value) ? "nan" : "inf");
  constexpr int kFractionBits = 52;
  const auto bits = std::bit_cast<std::uint64_t>(std::fabs(value));
  const auto biased = static_cast<int>(bits >> kFractionBits);
  std::string fraction;
  for (int shift = kFractionBits - 4; shift >= 0; shift -= 4)
    fraction += "0123456789abcdef"[bits >> shift & 0xF];
  fraction.erase(fraction.find_last_not_of('0') + 1);
  const int exponent = biased > 0 ? biased - 1023 : fraction.empty() ? 0 : -1022;
  return sign + (biased > 0 ? "0x1" : "0x0") + (fraction.empty() ? "" : "." + fraction) +
         (exponent < 0 ? "p-" : "p+") + std::to_string(std::abs(exponent));
}

}  // namespace hyrax
