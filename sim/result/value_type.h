// The types of single values.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <variant>

namespace hyrax {

enum class ValueType : std::uint8_t {
  float64,
  float32,
  int8,
  int16,
  int32,
  int64,
  uint8,
  uint16,
  uint32,
  uint64,
  boolean
};
inline constexpr std::array<std::string_view, 11> kValueTypeNames = {
    "float64", "float32", "int8", "int16", "int32", "int64", "uint8", "uint16", "uint32", "uint64", "bool"};
[[nodiscard]] constexpr std::string_view name_of(ValueType type) {
  return kValueTypeNames[static_cast<std::size_t>(type)];
}
[[nodiscard]] constexpr bool is_floating(ValueType type) {
  return type == ValueType::float64 || type == ValueType::float32;
}
[[nodiscard]] constexpr bool is_signed_integer(ValueType type) {
  return type >= ValueType::int8 && type <= ValueType::int64;
}

/// Calls visit with a number of the type as files have it: of a bool a byte.
template <class Visit>
constexpr decltype(auto) visit_stored(ValueType type, const Visit& visit) {
  using Number = std::variant<double, float, std::int8_t, std::int16_t, std::int32_t, std::int64_t,
                              std::uint8_t, std::uint16_t, std::uint32_t, std::uint64_t>;
  constexpr std::array<Number, kValueTypeNames.size()> kNumbers = {
      double{},       float{},         std::int8_t{},   std::int16_t{},  std::int32_t{}, std::int64_t{},
      std::uint8_t{}, std::uint16_t{}, std::uint32_t{}, std::uint64_t{}, std::uint8_t{}};
  return std::visit(visit, kNumbers[static_cast<std::size_t>(type)]);
}

}  // namespace hyrax
