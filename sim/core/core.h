// The one value through which a core is used.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/core_record.h"
#include "sim/core/stepper.h"
#include "sim/trace/listing_step.h"

namespace hyrax {

/// A class that moves the sprite, as a plain value: made of any class with the interface of class physics
/// (core_of.h), of a traced step (traced_stepper.h) or of constants (listing_core.h). A program's `main`
/// makes its own and passes it on.
struct Core {
  /// Of its model: kPhysicsModel, or that of a core of one's own (sim/trajectory/physics_model.h).
  std::string_view name = {};
  /// Its header and its step, as text.
  CoreRecord record = {};
  /// Whether its step is the paper's with constants of its own, by that text.
  PaperMatch paper_match = {};
  /// By which its runs are measured as the paper's model: those of a class of that name, whatever its step,
  /// or of another core, or class with other names, with the paper's step. Nothing: they cannot be.
  std::optional<Constants> constants = {};
  /// What scenarios call its constants, if its step is the paper's; an empty one is not known.
  ConstantNames constant_names = {};
  /// Of one that with_parameters made (sim/core/listing_core.h): the scenario's, and the core without them.
  std::vector<Parameter> parameters = {};
  std::shared_ptr<const Core> own = {};
  /// A contact byte: those whose contacts the rows tell; of others the step's comparisons decide.
  std::uint8_t walls_of_rows = 0;
  std::shared_ptr<const Stepper> stepper = {};

  /// walls_of_rows: "from the rows"; of some walls "left, top from the rows"; empty of none.
  [[nodiscard]] std::string sources() const;
  /// One call of update, or several with one dt. REQUIRES, of all functions here: bounds that are whole
  /// numbers within the range of int.
  [[nodiscard]] State step(const State& body, double dt_s, const Bounds& bounds) const {
    return stepper->steps(body, dt_s, bounds, 1);
  }
  [[nodiscard]] State steps(const State& body, double dt_s, const Bounds& bounds, std::int64_t count) const {
    return stepper->steps(body, dt_s, bounds, count);
  }
  /// Calls of update through the frames, each in so many equal parts.
  [[nodiscard]] State played(const State& body, std::span<const double> frames_s, const Bounds& bounds,
                             int parts = 1) const {
    return stepper->played(body, frames_s, bounds, parts);
  }
  /// One call of update without walls. REQUIRES: constants.
  [[nodiscard]] State flight(const State& body, double dt_s) const;
};

}  // namespace hyrax
