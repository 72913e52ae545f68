// The words and signs of `hyrax-step/1`, for its writer and its reader.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "sim/trace/traced_step.h"

namespace hyrax {

inline constexpr std::string_view kStepFirstLine = "hyrax-step/1";
inline constexpr std::array<std::string_view, 3> kNumberKindNames = {"real", "single", "whole"};
inline constexpr std::array<std::string_view, 3> kRelationSigns = {"<", "<=", "=="};
inline constexpr std::array<std::string_view, 3> kConversionNames = {"to_real", "to_single", "to_whole"};
inline constexpr std::string_view kOperatorSigns = "+*/%";  ///< From Operator::add on.

constexpr std::string_view name_of(NumberKind kind) {
  return kNumberKindNames[static_cast<std::size_t>(kind)];
}
constexpr std::string_view sign_of(Relation relation) {
  return kRelationSigns[static_cast<std::size_t>(relation)];
}
constexpr bool is_binary(Operator op) { return op >= Operator::add && op <= Operator::remainder; }
/// '\0' of what is not binary.
constexpr char sign_of(Operator op) {
  return is_binary(op)
             ? kOperatorSigns[static_cast<std::size_t>(op) - static_cast<std::size_t>(Operator::add)]
             : '\0';
}
/// REQUIRES: one of to_real .. to_whole.
constexpr std::string_view conversion_name(Operator op) {
  return kConversionNames[static_cast<std::size_t>(op) - static_cast<std::size_t>(Operator::to_real)];
}

/// The last line, of all before it (FNV-1a, 64 bits): tells a text that was cut short or edited by hand.
[[nodiscard]] std::string checksum_line(std::string_view text);

}  // namespace hyrax
