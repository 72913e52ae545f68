#include "tools/store/trajectory_format.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "sim/scenario/numbers.h"

namespace hyrax {
namespace {

// By code. A resize has two; each other kind has the name of its action.
constexpr std::array<std::string_view, 8> kNames = {"fling",         "place", "stop", "resize-window",
                                                    "resize-sprite", "hitch", "grab", "release"};

std::string_view record_name(const Action& action) {
  const auto* const resize = std::get_if<Resize>(&action);
  if (resize == nullptr) return name_of(action);
  assert(resize->window.has_value() != resize->sprite.has_value());
  return resize->window ? "resize-window" : "resize-sprite";
}

// Of a record of that name, its numbers 0.
Action action_of(std::string_view name) {
  if (name == "resize-window") return Resize{Size{}, {}};
  if (name == "resize-sprite") return Resize{{}, Size{}};
  const auto kind = std::find(kActionNames.begin(), kActionNames.end(), name);
  return make_action(static_cast<std::size_t>(kind - kActionNames.begin()));
}

// The numbers of the action, and those of its record.
template <class Visit>
void visit_both(Action& action, InputRecord& record, const Visit& visit) {
  double* number = &record.a;
  visit_numbers(action, [&](std::string_view, const NumberField& field) {
    visit(field, *number);
    number = &record.b;
  });
}

}  // namespace

std::span<const std::string_view> input_kind_names() { return kNames; }

InputRecord record_of(const Input& input) {
  const auto code = std::find(kNames.begin(), kNames.end(), record_name(input.action)) - kNames.begin();
  InputRecord record{input.frame, static_cast<std::uint8_t>(code)};
  Action action = input.action;
  visit_both(action, record, [](const NumberField& field, double& number) { number = field.value(); });
  return record;
}

// A number that is outside its limits, or is none of the kind's, is another one in the input's own record.
std::optional<Input> input_of(const InputRecord& record) {
  if (record.kind >= kNames.size()) return std::nullopt;
  Input input{record.frame, action_of(kNames[record.kind])};
  InputRecord numbers = record;
  visit_both(input.action, numbers, [](const NumberField& field, double& number) {
    const bool is_whole = !std::holds_alternative<double*>(field.at);
    if (!is_whole || (number >= 0.0 && number <= kWindowSideMax_px)) field.set(number);
  });
  const InputRecord again = record_of(input);
  const bool is_same = same_bits(again.a, record.a) && same_bits(again.b, record.b);
  return is_same ? std::optional(input) : std::nullopt;
}

}  // namespace hyrax
