// The core of a class that moves the sprite. Few sources include it: one for each such class.
#pragma once

#include <memory>
#include <type_traits>

#include "sim/core/core.h"
#include "sim/core/stepper_of.h"
#include "sim/motion/state.h"

namespace hyrax {

template <class Class>
struct ClassCores {
  using Core = Class;

  // Not as a list: its numbers may be narrower.
  [[nodiscard]] Class make(const State& state) const {
    return Class(state.x_px, state.y_px, state.vx_px_per_s, state.vy_px_per_s);
  }
  [[nodiscard]] Constants constants() const requires HasPaperConstants<Class> {
    return constants_of<Class>();
  }
};

/// The core of a trivially copyable class with the interface of class physics (sim/physics/physics.h); it may
/// have further members. @param name of its model. @param record of the header that defines it.
template <class Class>
[[nodiscard]] Core core_of(std::string_view name, const CoreRecord& record) {
  static_assert(std::is_trivially_copyable_v<Class>,
                "hyrax: class physics must be trivially copyable: a run goes on with a copy of it");
  Core core{.name = name, .record = record};
  if constexpr (HasPaperConstants<Class>) {
    core.constants = constants_of<Class>();
    core.constant_names = constant_names_of<Class>();
  }
  if (record.is_listing) core.paper_match.constants = core.constants;
  core.stepper = std::make_shared<const StepperOf<ClassCores<Class>>>(
      ClassCores<Class>(),
      StepFacts{.is_listing = record.is_listing, .has_further_members = !record.is_listing});
  if (record.complete != nullptr) record.complete(core);
  return core;
}

}  // namespace hyrax
