#include "tools/files/printable.h"

#include <array>
#include <cassert>
#include <cstdio>

namespace hyrax {
namespace {

void append_hex(std::string& into, std::string_view prefix, unsigned number, unsigned digits) {
  into += prefix;
  while (digits > 0) into += "0123456789abcdef"[number >> 4 * --digits & 15u];
}

std::string escaped(std::string_view text, std::string_view kept) {
  std::string shown;
  for (std::size_t at = 0, bytes = 0; at < text.size(); at += bytes) {
    const Utf8Character character = utf8_character(text, at);
    bytes = character.bytes;
    if (character.code < 0)
      append_hex(shown, "\\x", static_cast<unsigned char>(text[at]), 2);
    else if (is_control(character.code) && kept.find(text[at]) == std::string_view::npos)
      append_hex(shown, "\\u", static_cast<unsigned>(character.code), 4);
    else
      shown += text.substr(at, bytes);
  }
  return shown;
}

// What messages name, and what they name instead; see name_program.
std::string documented_name;
std::string own_name;

}  // namespace

bool is_control(std::int32_t code) {
  const auto is_in = [code](std::int32_t first, std::int32_t last) { return code >= first && code <= last; };
  return is_in(0, 0x1F) || is_in(0x7F, 0x9F) || code == 0x61C || is_in(0x200E, 0x200F) ||
         is_in(0x2028, 0x202E) || is_in(0x2066, 0x2069);
}

Utf8Character utf8_character(std::string_view text, std::size_t at) {
  assert(at < text.size());
  const auto lead = static_cast<unsigned char>(text[at]);
  if (lead < 0x80) return {1, lead};
  const std::size_t bytes = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || at + bytes > text.size()) return {};
  std::int32_t code = lead & (0x7F >> bytes);
  for (std::size_t next = at + 1; next < at + bytes; ++next) {
    const auto byte = static_cast<unsigned char>(text[next]);
    if ((byte & 0xC0) != 0x80) return {};
    code = code << 6 | (byte & 0x3F);
  }
  constexpr std::int32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool is_surrogate = code >= 0xD800 && code <= 0xDFFF;
  if (code < kLeast[bytes] || code > 0x10FFFF || is_surrogate) return {};
  return {bytes, code};
}

std::string printable(std::string_view text) { return escaped(text, ""); }

std::string printable_lines(std::string_view text) { return escaped(text, "\n\t"); }

std::string shortened(std::string_view text) {
  constexpr std::size_t kBytesMax = 60;
  if (text.size() <= kBytesMax) return std::string(text);
  std::size_t size = kBytesMax;
  while (size > 0 && (static_cast<unsigned char>(text[size]) & 0xC0u) == 0x80u) --size;
  return std::string(text.substr(0, size)) + "...";
}

std::string size_text(std::uint64_t bytes) {
  constexpr std::array kUnits = {" KiB", " MiB", " GiB", " TiB", " PiB", " EiB"};
  if (bytes < 1024) return std::to_string(bytes) + " bytes";
  std::size_t unit = 0;
  while (unit + 1 < kUnits.size() && bytes >> (10 * (unit + 2)) > 0) ++unit;
  const std::uint64_t tenths = (bytes >> (10 * unit)) * 10 >> 10;
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + kUnits.at(unit);
}

void print_text(std::string_view text) { std::fputs(printable_lines(text).c_str(), stdout); }

bool is_all_printed() { return std::fflush(stdout) == 0 && std::ferror(stdout) == 0; }

void name_program(const std::string& documented, const std::string& own) {
  documented_name = documented;
  own_name = own;
}

std::string with_own_name(std::string_view sentences) {
  std::string text(sentences);
  if (own_name.empty()) return text;
  for (std::size_t at = 0; (at = text.find(documented_name, at)) != std::string::npos; ++at) {
    const bool begins = at == 0 || std::string_view(" `\n").find(text[at - 1]) != std::string_view::npos;
    const std::size_t end = at + documented_name.size();
    if (begins && end < text.size() && (text[end] == ' ' || text[end] == ':'))
      text.replace(at, documented_name.size(), own_name);
  }
  return text;
}

void print_error(std::string_view sentences) {
  std::fputs((printable_lines(with_own_name(sentences)) + "\n").c_str(), stderr);
}

}  // namespace hyrax
