#include "tools/files/json_edit.h"

#include <cassert>

#include "tools/files/json.h"

namespace hyrax {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";

// Part of a text: from `begin` up to, but without, `end`.
struct Span {
  std::size_t begin = 0;
  std::size_t end = 0;
};

std::size_t skip_blanks(std::string_view text, std::size_t at) { return text.find_first_not_of(kBlanks, at); }

std::size_t end_of_string(std::string_view text, std::size_t at) {
  for (++at; text[at] != '"'; ++at)
    if (text[at] == '\\') ++at;
  return at + 1;
}

std::size_t end_of_value(std::string_view text, std::size_t at) {
  if (text[at] == '"') return end_of_string(text, at);
  if (text[at] != '{' && text[at] != '[') return text.find_first_of(" \t\r\n,]}", at);
  int depth = 0;
  do {
    if (text[at] == '"') {
      at = end_of_string(text, at);
      continue;
    }
    if (text[at] == '{' || text[at] == '[') ++depth;
    if (text[at] == '}' || text[at] == ']') --depth;
    ++at;
  } while (depth > 0);
  return at;
}

// The value of a member of the object at `at`.
std::size_t member_at(std::string_view text, std::size_t at, std::string_view key) {
  assert(text[at] == '{');
  for (at = skip_blanks(text, at + 1);; at = skip_blanks(text, at)) {
    const std::size_t key_end = end_of_string(text, at);
    const Json found = parse_json(text.substr(at, key_end - at), "key");
    at = skip_blanks(text, skip_blanks(text, key_end) + 1);
    if (*found.get<std::string>() == key) return at;
    at = skip_blanks(text, end_of_value(text, at));
    assert(text[at] == ',');
    ++at;
  }
}

std::vector<Span> element_spans(std::string_view text, const std::vector<std::string_view>& keys) {
  std::size_t at = skip_blanks(text, 0);
  for (const std::string_view key : keys) at = member_at(text, at, key);
  if (text[at] != '[') return {{at, end_of_value(text, at)}};
  std::vector<Span> spans;
  for (at = skip_blanks(text, at + 1); text[at] != ']'; at = skip_blanks(text, at)) {
    spans.push_back({at, end_of_value(text, at)});
    at = skip_blanks(text, spans.back().end);
    if (text[at] == ',') ++at;
  }
  return spans;
}

}  // namespace

std::vector<std::string> element_texts(std::string_view text, const std::vector<std::string_view>& keys) {
  std::vector<std::string> texts;
  for (const auto& [begin, end] : element_spans(text, keys))
    texts.emplace_back(text.substr(begin, end - begin));
  return texts;
}

std::string with_elements(std::string_view text, const std::vector<std::string_view>& keys,
                          const std::vector<std::string>& values) {
  const std::vector<Span> spans = element_spans(text, keys);
  assert(values.size() <= spans.size());
  std::string edited;
  std::size_t copied = 0;
  for (std::size_t index = 0; index < values.size() && index < spans.size(); ++index) {
    edited.append(text.substr(copied, spans[index].begin - copied)).append(values[index]);
    copied = spans[index].end;
  }
  return edited.append(text.substr(copied));
}

}  // namespace hyrax
