#include "tools/store/input_record.h"

#include <array>
#include <cassert>

namespace hyrax {
namespace {

enum Code : std::uint8_t { fling, place, stop, resize_window, resize_sprite, hitch, grab, release };
constexpr std::array<std::string_view, 8> kNames = {"fling",         "place", "stop", "resize-window",
                                                    "resize-sprite", "hitch", "grab", "release"};

struct RecordOf {
  std::int64_t frame;

  InputRecord operator()(const Fling& action) const { return of(fling, action.velocity); }
  InputRecord operator()(const Place& action) const {
    return {frame, place, action.position.x_px, action.position.y_px};
  }
  InputRecord operator()(const Stop&) const { return {frame, stop}; }
  InputRecord operator()(const Resize& action) const {
    assert(action.window.has_value() != action.sprite.has_value());
    return action.window ? of(resize_window, *action.window) : of(resize_sprite, *action.sprite);
  }
  InputRecord operator()(const Hitch& action) const { return {frame, hitch, action.dt_s}; }
  InputRecord operator()(const Grab&) const { return {frame, grab}; }
  InputRecord operator()(const Release& action) const { return of(release, action.velocity); }

 private:
  InputRecord of(Code code, const Velocity& velocity) const {
    return {frame, code, velocity.vx_px_per_s, velocity.vy_px_per_s};
  }
  InputRecord of(Code code, const Size& size) const {
    return {frame, code, static_cast<double>(size.width_px), static_cast<double>(size.height_px)};
  }
};

// Numbers that are no pixels become another size, which input_of notices.
Size size_of(const InputRecord& record) {
  const auto pixels = [](double value) {
    return value >= 0.0 && value <= kWindowSideMax_px ? static_cast<std::int32_t>(value) : 0;
  };
  return {pixels(record.a), pixels(record.b)};
}

Action action_of(const InputRecord& record) {
  switch (static_cast<Code>(record.kind)) {
    case fling:
      return Fling{{record.a, record.b}};
    case place:
      return Place{{record.a, record.b}};
    case stop:
      return Stop{};
    case resize_window:
      return Resize{size_of(record), {}};
    case resize_sprite:
      return Resize{{}, size_of(record)};
    case hitch:
      return Hitch{record.a};
    case grab:
      return Grab{};
    case release:
      return Release{{record.a, record.b}};
  }
  return Stop{};
}

}  // namespace

std::span<const std::string_view> input_kind_names() { return kNames; }

InputRecord record_of(const Input& input) { return std::visit(RecordOf{input.frame}, input.action); }

std::optional<Input> input_of(const InputRecord& record) {
  if (record.kind >= kNames.size()) return std::nullopt;
  const Input input{record.frame, action_of(record)};
  const InputRecord again = record_of(input);
  const bool is_same = same_bits(again.a, record.a) && same_bits(again.b, record.b);
  return is_same ? std::optional(input) : std::nullopt;
}

}  // namespace hyrax
