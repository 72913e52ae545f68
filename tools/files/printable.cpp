#include "tools/files/printable.h"

#include "tools/files/utf8.h"

namespace hyrax {
namespace {

void append_hex(std::string& into, std::string_view prefix, unsigned byte) {
  constexpr char kDigits[] = "0123456789abcdef";
  into.append(prefix).append({kDigits[byte >> 4], kDigits[byte & 15u]});
}

std::string escaped(std::string_view text, std::string_view kept) {
  std::string shown;
  for (std::size_t at = 0, bytes = 0; at < text.size(); at += bytes) {
    const Utf8Character character = utf8_character(text, at);
    bytes = character.bytes;
    const bool is_control =
        (character.code >= 0 && character.code < 0x20) || (character.code >= 0x7f && character.code < 0xa0);
    if (character.code < 0)
      append_hex(shown, "\\x", static_cast<unsigned char>(text[at]));
    else if (is_control && kept.find(text[at]) == std::string_view::npos)
      append_hex(shown, "\\u00", static_cast<unsigned>(character.code));
    else
      shown += text.substr(at, bytes);
  }
  return shown;
}

}  // namespace

std::string printable(std::string_view text) { return escaped(text, ""); }

std::string printable_lines(std::string_view text) { return escaped(text, "\n\t"); }

}  // namespace hyrax
