// Looks for what makes a core's results depend on more than x, y, vx, vy and the arguments of a call, and for
// constants that its class does not have.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "sim/motion/state.h"

namespace hyrax {

/// See LibraryCore::defect. Plays the same flings in different ways that must give the same rows.
template <class Core>
class DefectSearch {
 public:
  /// The first defect found; empty: none.
  [[nodiscard]] std::string search() const {
    const std::vector<State> once = rows([](Core&) {});
    const auto differs = [&once](const std::vector<State>& other) { return first_difference(once, other); };
    if (const auto step = differs(rows([](Core&) {})); step >= 0)
      return "does not repeat: a fling played twice differs" + at(step);
    if (const auto step = differs(rows_beside_another()); step >= 0)
      return "shares state between bodies: a fling differs if another body moves too" + at(step);
    if (const auto step = differs(rows([](Core& body) { read(body); })); step >= 0)
      return "is changed by its getters: a fling differs if x(), y(), vx() and vy() are called between "
             "steps" +
             at(step);
    const auto by_setters = [](auto set) {
      return [set](Core& body) {
        const State state = state_of(body);
        body = made({-1.0, -2.0, -3.0, -4.0});
        set(body, state);
      };
    };
    const std::vector<State> position_first = rows(by_setters([](Core& body, const State& s) {
      body.setPos(s.x_px, s.y_px);
      body.setVelocity(s.vx_px_per_s, s.vy_px_per_s);
    }));
    const std::vector<State> velocity_first = rows(by_setters([](Core& body, const State& s) {
      body.resetVelocity();
      body.setVelocity(s.vx_px_per_s, s.vy_px_per_s);
      body.setPos(s.x_px, s.y_px);
    }));
    if (const auto step = first_difference(position_first, velocity_first); step >= 0)
      return "depends on the order of its setters: setPos before setVelocity or after it differs" + at(step);
    if (const auto step = differs(rows([](Core& body) { body = made(state_of(body)); })); step >= 0)
      return "keeps state between calls beyond x, y, vx and vy: a fling differs if its body is made again "
             "from "
             "these four numbers" +
             at(step);
    if (sizeof(Core) > 4 * sizeof(double))
      return "can keep state between calls beyond x, y, vx and vy: an object has " +
             std::to_string(sizeof(Core)) + " bytes, four doubles have " + std::to_string(4 * sizeof(double));
    return "";
  }

 private:
  // More steps than a counter of a thousand, in frames of two lengths, with contacts of all walls and rest.
  static constexpr std::ptrdiff_t kSteps = 1'500;
  static constexpr State kFlings[] = {{100.0, 100.0, 900.0, -1200.0},
                                      {1700.3, 900.7, 2600.1, -1900.9},
                                      {800.1, 0.0, -1500.3, 700.7},
                                      {5.5, 950.25, -90.0, -60.0}};

  static State state_of(const Core& body) { return {body.x(), body.y(), body.vx(), body.vy()}; }
  static Core made(const State& state) {
    return Core(state.x_px, state.y_px, state.vx_px_per_s, state.vy_px_per_s);
  }
  static void read(const Core& body) {
    for (int times = 0; times < 3; ++times) {
      volatile double value = body.vy();
      value = body.vx();
      value = body.y();
      value = body.x();
      static_cast<void>(value);
    }
  }
  static void advance(Core& body, std::ptrdiff_t step) {
    body.update(step % 7 == 3 ? 1.0 / 144.0 : 1.0 / 60.0, 1920, 1080, 128, 128);
  }

  // @param between called after each step.
  template <class Between>
  static std::vector<State> rows(const Between& between) {
    std::vector<State> rows;
    for (const State& fling : kFlings) {
      Core body = made(fling);
      for (std::ptrdiff_t step = 0; step < kSteps; ++step) {
        advance(body, step);
        between(body);
        rows.push_back(state_of(body));
      }
    }
    return rows;
  }

  static std::vector<State> rows_beside_another() {
    Core other = made({300.0, 300.0, -700.0, 100.0});
    return rows([&other](Core&) { advance(other, 0); });
  }

  static std::ptrdiff_t first_difference(const std::vector<State>& a, const std::vector<State>& b) {
    for (std::size_t row = 0; row < a.size(); ++row)
      if (!same_bits(a[row], b[row])) return static_cast<std::ptrdiff_t>(row);
    return -1;
  }
  static std::string at(std::ptrdiff_t row) { return " from step " + std::to_string(row % kSteps + 1); }
};

/// LibraryCore::lacking.
template <class Class>
std::string lacking_constants() {
  constexpr bool has_gravity = requires { Class::GRAVITY + 0.0; };
  constexpr bool has_restitution = requires { Class::RESTITUTION + 0.0; };
  constexpr bool has_drag = requires { Class::AIR_DRAG + 0.0; };
  constexpr bool has_friction = requires { Class::GROUND_FRICTION + 0.0; };
  constexpr bool has_threshold = requires { Class::REST_THRESHOLD + 0.0; };
  std::string names;
  for (const auto& [has, name] : {std::pair(has_gravity, "GRAVITY"),
                                  {has_restitution, "RESTITUTION"},
                                  {has_drag, "AIR_DRAG"},
                                  {has_friction, "GROUND_FRICTION"},
                                  {has_threshold, "REST_THRESHOLD"}})
    if (!has) names += (names.empty() ? "" : ", ") + std::string(name);
  return names;
}

}  // namespace hyrax
