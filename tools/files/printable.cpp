#include "tools/files/printable.h"

namespace hyrax {
namespace {

constexpr char kDigits[] = "0123456789abcdef";

unsigned byte_at(std::string_view text, std::size_t at) { return static_cast<unsigned char>(text[at]); }

void append_hex(std::string& into, std::string_view prefix, unsigned byte) {
  into.append(prefix).append({kDigits[byte >> 4], kDigits[byte & 15u]});
}

// Bytes of the UTF-8 character at `at`; 0 where there is none (RFC 3629: no overlong form, no surrogate).
std::size_t utf8_length(std::string_view text, std::size_t at) {
  const unsigned first = byte_at(text, at);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4 || at + length > text.size()) return 0;
  for (std::size_t next = at + 1; next < at + length; ++next)
    if ((byte_at(text, next) & 0xc0u) != 0x80) return 0;
  const unsigned second = byte_at(text, at + 1);
  const bool is_overlong = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
  const bool is_beyond = (first == 0xed && second > 0x9f) || (first == 0xf4 && second > 0x8f);
  return is_overlong || is_beyond ? 0 : length;
}

std::string escaped(std::string_view text, std::string_view kept) {
  std::string shown;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = utf8_length(text, at);
    const unsigned byte = byte_at(text, at);
    const bool is_c1 = length == 2 && byte == 0xc2 && byte_at(text, at + 1) < 0xa0;
    if (length == 0)
      append_hex(shown, "\\x", byte);
    else if (is_c1)
      append_hex(shown, "\\u00", byte_at(text, at + 1));
    else if ((byte < 0x20 || byte == 0x7f) && kept.find(text[at]) == std::string_view::npos)
      append_hex(shown, "\\u00", byte);
    else
      shown += text.substr(at, length);
    at += length == 0 ? 1 : length;
  }
  return shown;
}

}  // namespace

std::string printable(std::string_view text) { return escaped(text, ""); }

std::string printable_lines(std::string_view text) { return escaped(text, "\n\t"); }

std::string shell_word(std::string_view path) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./,:@%+=";
  std::string word = path.starts_with('-') ? "./" : "";
  word += path;
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  const bool needs_escapes = printable(word) != word;
  std::string quoted = needs_escapes ? "$'" : "'";
  for (const char letter : word) {
    const unsigned byte = static_cast<unsigned char>(letter);
    if (!needs_escapes)
      quoted += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
    else if (byte < 0x20 || byte >= 0x7f)
      append_hex(quoted, "\\x", byte);
    else
      quoted.append(letter == '\'' || letter == '\\' ? "\\" : "").append(1, letter);
  }
  return quoted + "'";
}

}  // namespace hyrax
