#include "sim/compare/comparison.h"

#include <algorithm>

namespace hyrax {
namespace {

bool is_before(const Contact& a, const Contact& b) {
  if (a.step != b.step) return a.step < b.step;
  return a.wall != b.wall ? a.wall < b.wall : a.last_step < b.last_step;
}

// The last contact of a list that is full: what such a run has after it is not known. Null if neither is.
const Contact* last_known(const std::vector<Contact>& a, const std::vector<Contact>& b) {
  const Contact* last = nullptr;
  for (const std::vector<Contact>* const contacts : {&a, &b})
    if (std::ssize(*contacts) >= kContactsRecordedMax &&
        (last == nullptr || is_before(contacts->back(), *last)))
      last = &contacts->back();
  return last;
}

// The contacts of `a` at that wall, none after `last`, that `b` does not have.
std::vector<Contact> missing_in(const std::vector<Contact>& a, const std::vector<Contact>& b, Wall wall,
                                const Contact* last) {
  std::vector<Contact> missing;
  auto other = b.begin();
  for (const Contact& contact : a) {
    if (contact.wall != wall || (last != nullptr && is_before(*last, contact))) continue;
    other = std::find_if_not(other, b.end(), [&](const Contact& c) { return is_before(c, contact); });
    if (other == b.end() || !has_same_steps(*other, contact))
      missing.push_back(contact);
    else
      ++other;  // It is the counterpart of one contact, not of two.
  }
  return missing;
}

std::string input_text(const Input& input) {
  return std::string(name_of(input.action)) + " in frame " + std::to_string(input.frame);
}

}  // namespace

DifferenceClass class_of(const ContactChanges& contacts, const RunDistance& distance) {
  if (!contacts.is_none() || distance.has_other_walls()) return DifferenceClass::contacts;
  return distance.is_rounding() ? DifferenceClass::rounding : DifferenceClass::values;
}

ContactChanges contact_changes(const std::vector<Contact>& a, const std::vector<Contact>& b) {
  const Contact* const last = last_known(a, b);
  ContactChanges changes;
  changes.is_cut = last != nullptr;
  for (const Wall wall : kWalls) {
    const std::vector<Contact> gone = missing_in(a, b, wall, last);
    const std::vector<Contact> come = missing_in(b, a, wall, last);
    const std::size_t pairs = std::min(gone.size(), come.size());
    for (std::size_t pair = 0; pair < pairs; ++pair) changes.moved.push_back({gone[pair], come[pair]});
    changes.only_a.insert(changes.only_a.end(), gone.begin() + static_cast<std::ptrdiff_t>(pairs),
                          gone.end());
    changes.only_b.insert(changes.only_b.end(), come.begin() + static_cast<std::ptrdiff_t>(pairs),
                          come.end());
  }
  return changes;
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
