// The published vectors, as C++ tests read them.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "tools/files/json.h"
#include "tools/files/text_file.h"

namespace hyrax {

/// The entries of one section of vectors.json.
inline const Json::Array& vectors(std::string_view section) {
  static const std::string path = std::string(HYRAX_SOURCE_DIR) + "/tests/oracle/vectors.json";
  static const Json document = parse_json(read_text_file(path), path);
  return *document.find(section)->get<Json::Array>();
}

inline const std::string& text_of(const Json& entry, std::string_view key) {
  return *entry.find(key)->get<std::string>();
}

/// A double from exact hexadecimal text.
inline double exact(const Json& text) { return std::strtod(text.get<std::string>()->c_str(), nullptr); }
inline double exact(const Json& entry, std::string_view key) { return exact(*entry.find(key)); }

inline std::vector<double> exact_list(const Json& entry, std::string_view key) {
  std::vector<double> values;
  for (const Json& text : *entry.find(key)->get<Json::Array>()) values.push_back(exact(text));
  return values;
}

/// 64 bits from hexadecimal text.
inline std::uint64_t bits_of(const Json& entry, std::string_view key) {
  return std::strtoull(text_of(entry, key).c_str(), nullptr, 16);
}

inline std::int64_t integer_of(const Json& entry, std::string_view key) {
  return static_cast<std::int64_t>(entry.find(key)->number());
}

}  // namespace hyrax
