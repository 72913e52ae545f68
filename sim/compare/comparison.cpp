#include "sim/compare/comparison.h"

namespace hyrax {
namespace {

std::string input_text(const Input& input) {
  return std::string(name_of(input.action)) + " in frame " + std::to_string(input.frame);
}

}  // namespace

DifferenceClass class_of(const ContactChanges& contacts, const RunDistance& distance) {
  if (!contacts.is_none() || distance.has_other_walls()) return DifferenceClass::contacts;
  return distance.is_rounding() ? DifferenceClass::rounding : DifferenceClass::values;
}

std::optional<std::string> input_difference(const std::vector<Input>& a, const std::vector<Input>& b) {
  const auto [from, to] =
      std::ranges::mismatch(a, b, [](const Input& one, const Input& other) { return same_bits(one, other); });
  if (from == a.end() && to == b.end()) return std::nullopt;
  const std::string before = from == a.end() ? "none" : input_text(*from);
  const std::string after = to == b.end() ? "none" : input_text(*to);
  return "inputs differ: " + (before == after ? before + ": other values" : before + " -> " + after);
}

}  // namespace hyrax
