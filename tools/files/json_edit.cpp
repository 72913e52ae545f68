#include "tools/files/json_edit.h"

#include <algorithm>
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

std::string member_text(std::string_view key, const std::string& value) {
  return to_text(Json(key)) + ": " + value;
}

}  // namespace

std::string with_value(std::string_view text, const std::vector<std::string_view>& keys,
                       std::string_view value) {
  assert(!keys.empty());
  std::string added(value);
  Span place{skip_blanks(text, 0), 0};
  for (std::size_t depth = 0; depth < keys.size(); ++depth) {
    const ObjectText object = object_at(text, place.begin);
    const Member* const member = object.find(keys[depth]);
    if (member != nullptr) {
      place = member->value;
      continue;
    }
    for (std::size_t inner = keys.size() - 1; inner > depth; --inner)
      added = "{ " + member_text(keys[inner], added) + " }";
    return with_member(text, object, member_text(keys[depth], added));
  }
  return replaced(text, place, added);
}

std::string with_elements(std::string_view text, const std::vector<std::string_view>& keys,
                          const std::vector<std::string>& values) {
  Span place{skip_blanks(text, 0), 0};
  for (const std::string_view key : keys) place = object_at(text, place.begin).find(key)->value;
  if (text[place.begin] != '[') return replaced(text, place, values.front());
  std::string edited(text.substr(0, place.begin + 1));
  std::size_t at = place.begin + 1;
  for (const std::string& value : values) {
    const std::size_t begin =
        skip_blanks(text, text[skip_blanks(text, at)] == ',' ? skip_blanks(text, at) + 1 : at);
    edited.append(text.substr(at, begin - at)).append(value);
    at = end_of_value(text, begin);
  }
  return edited.append(text.substr(at));
}

}  // namespace hyrax
