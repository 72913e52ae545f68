#include "tools/files/state_hash_text.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <vector>

#include "tools/files/json.h"

namespace hyrax {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";

// Part of a text: from `begin` up to, but without, `end`.
struct Span {
  std::size_t begin = 0;
  std::size_t end = 0;
};

struct Member {
  std::string key;
  Span value;
};

// An object in a JSON text.
struct ObjectText {
  std::size_t begin = 0;  // Of its "{".
  std::vector<Member> members;

  [[nodiscard]] const Member* find(std::string_view key) const {
    const auto found = std::ranges::find(members, key, &Member::key);
    return found == members.end() ? nullptr : &*found;
  }
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

ObjectText object_at(std::string_view text, std::size_t begin) {
  assert(text[begin] == '{');
  ObjectText object{begin, {}};
  for (std::size_t at = skip_blanks(text, begin + 1); text[at] != '}'; at = skip_blanks(text, at)) {
    const std::size_t key_end = end_of_string(text, at);
    const Json key = parse_json(text.substr(at, key_end - at), "key");
    const std::size_t value = skip_blanks(text, skip_blanks(text, key_end) + 1);
    object.members.push_back({*key.get<std::string>(), {value, end_of_value(text, value)}});
    at = skip_blanks(text, object.members.back().value.end);
    if (text[at] == ',') ++at;
  }
  return object;
}

std::string replaced(std::string_view text, const Span& span, const std::string& by) {
  return std::string(text.substr(0, span.begin)) + by + std::string(text.substr(span.end));
}

// A further member behind the last one, in the way in which the first one is written.
std::string with_member(std::string_view text, const ObjectText& object, const std::string& member) {
  const std::size_t inside = object.begin + 1;
  if (object.members.empty())
    return replaced(text, {inside, inside}, std::string(" ").append(member).append(" "));
  const std::size_t at = object.members.back().value.end;
  const std::string_view lead = text.substr(inside, skip_blanks(text, inside) - inside);
  return replaced(text, {at, at}, std::string(",").append(lead).append(member));
}

}  // namespace

std::string with_state_hash(std::string_view text, std::string_view hash) {
  const std::string value = '"' + std::string(hash) + '"';
  const ObjectText scenario = object_at(text, skip_blanks(text, 0));
  const Member* const expect = scenario.find("expect");
  const std::string member = "\"state_hash\": " + value;
  if (expect == nullptr) return with_member(text, scenario, "\"expect\": { " + member + " }");
  const ObjectText expected = object_at(text, expect->value.begin);
  const Member* const state_hash = expected.find("state_hash");
  return state_hash == nullptr ? with_member(text, expected, member)
                               : replaced(text, state_hash->value, value);
}

}  // namespace hyrax
