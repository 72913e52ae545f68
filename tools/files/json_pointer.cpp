#include "tools/files/json_pointer.h"

#include <algorithm>
#include <charconv>
#include <vector>

#include "tools/files/failure.h"
#include "tools/files/printable.h"

namespace hyrax {
namespace {

[[noreturn]] void fail_at(const std::string& source, std::string_view pointer, const std::string& sentence) {
  refuse_input((source.empty() ? "" : source + ": ") + printable(std::string(pointer) + ": " + sentence));
}

std::vector<std::string> tokens_of(std::string_view pointer, const std::string& source) {
  if (std::count(pointer.begin(), pointer.end(), '/') > kJsonNestingMax)
    fail_at(source, pointer.substr(0, 40), "nested more than " + std::to_string(kJsonNestingMax) + " levels");
  std::vector<std::string> tokens;
  for (std::size_t at = 0; at < pointer.size(); ++at) {
    const std::string_view escape = pointer.substr(at, 2);
    const bool is_escape = escape == "~1" || escape == "~0";
    if (pointer[at] == '/')
      tokens.emplace_back();
    else if (tokens.empty())
      fail_at(source, pointer, "is not a JSON Pointer; it must begin with '/', as in /clock/rate_hz");
    else if (pointer[at] == '~' && !is_escape)
      fail_at(source, pointer, "is not a JSON Pointer; '~' is written ~0");
    else
      tokens.back() += !is_escape ? pointer[at] : escape == "~1" ? '/' : '~';
    if (is_escape) ++at;
  }
  return tokens;
}

Json* element_at(Json::Array& array, const std::string& token) {
  if (token == "-") return &array.emplace_back();
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), index);
  const bool is_index = error == std::errc() && end == token.data() + token.size() &&
                        (token.size() == 1 || !token.starts_with('0'));
  return is_index && index < array.size() ? &array[index] : nullptr;
}

Json* member_at(Json& parent, const std::string& token) {
  if (parent.is_null()) parent = Json::Object();
  if (auto* array = parent.get<Json::Array>()) return element_at(*array, token);
  auto* object = parent.get<Json::Object>();
  if (object == nullptr) return nullptr;
  for (auto& [key, value] : *object)
    if (key == token) return &value;
  return &object->emplace_back(token, Json()).second;
}

}  // namespace

std::string pointer_to(const std::string& pointer, std::string_view token) {
  std::string text = pointer + "/";
  for (const char& c : token) text += c == '~' ? "~0" : c == '/' ? "~1" : std::string_view(&c, 1);
  return text;
}

void set_at(Json& document, std::string_view pointer, Json value, const std::string& source) {
  Json* at = &document;
  for (const std::string& token : tokens_of(pointer, source)) {
    at = member_at(*at, token);
    if (at == nullptr) fail_at(source, pointer, "does not exist (found no '" + token + "')");
  }
  *at = std::move(value);
}

}  // namespace hyrax
