// What is asked of a `class physics`, its type forgotten.
#pragma once

#include <array>
#include <cstddef>
#include <new>
#include <type_traits>

#include "sim/trace/operation.h"

namespace hyrax::trace {

/// Of a header compiled with these numbers for `double` and `int`.
template <class Real, class Whole>
struct CoreCalls {
  std::size_t size_bytes = 0;
  bool is_trivially_copyable = false;
  void (*call)(CoreFunction function, void* body, const Real* numbers, const Whole* sizes) = nullptr;
  std::array<Real, 4> (*read)(const void* body) = nullptr;  ///< x, y, vx, vy.
};

/// Calls a function of a core that is constructed already.
template <class Physics, class Real, class Whole>
void call_function(CoreFunction function, Physics& body, const Real* numbers, const Whole* sizes) {
  if (function == CoreFunction::update) body.update(numbers[0], sizes[0], sizes[1], sizes[2], sizes[3]);
  if (function == CoreFunction::set_position) body.setPos(numbers[0], numbers[1]);
  if (function == CoreFunction::set_velocity) body.setVelocity(numbers[0], numbers[1]);
  if (function == CoreFunction::reset_velocity) body.resetVelocity();
}

template <class Physics, class Real, class Whole>
CoreCalls<Real, Whole> calls_of() {
  return {.size_bytes = sizeof(Physics),
          .is_trivially_copyable = std::is_trivially_copyable_v<Physics>,
          .call =
              [](CoreFunction function, void* memory, const Real* numbers, const Whole* sizes) {
                if (function == CoreFunction::construct)
                  new (memory) Physics(numbers[0], numbers[1], numbers[2], numbers[3]);
                else
                  trace::call_function(function, *static_cast<Physics*>(memory), numbers, sizes);
              },
          .read =
              [](const void* memory) {
                const Physics& body = *static_cast<const Physics*>(memory);
                return std::array<Real, 4>{body.x(), body.y(), body.vx(), body.vy()};
              }};
}

}  // namespace hyrax::trace
