// One contract for every way to move the sprite; the shipped core is one of them, behind it.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "sim/core/core.h"
#include "sim/motion/state.h"
#include "sim/reference/exact_fling.h"

namespace hyrax {

/// Moves one body, frame by frame or from impact to impact. Not by Replay, which plays cores: a method need
/// not be one (it may have no row at a wall, choose its own steps, or fail), and its time is measured.
class Method {
 public:
  Method() = default;
  Method(const Method&) = delete;
  Method& operator=(const Method&) = delete;
  virtual ~Method() = default;

  /// @param goes_on after another stage of the same run: a sprite that slid on the ground goes on sliding.
  virtual void start(const State& motion, const Bounds& bounds, bool goes_on) = 0;
  /// Plays the frames, each of its dt >= 0. False if the method failed: then it has no state any more.
  [[nodiscard]] virtual bool play(std::span<const double> frames_s) = 0;
  [[nodiscard]] virtual State motion() const = 0;
  /// Impacts since the start, if the method computes their times; null: they show only in its rows.
  [[nodiscard]] virtual const std::vector<ExactImpact>* impacts() const { return nullptr; }
};

/// The error of a method in free flight, against the fixed laws, ...
struct Divergent {};  ///< ... does not vanish with the frame.
struct Convergent {   ///< ... goes as this power of the frame.
  int order = 1;
};
struct Exact {                       ///< ... is rounding, at every frame,
  bool meets_walls_exactly = false;  ///< and of whole flings as well.
  bool is_reference = false;         ///< All others are measured against it; it is not ranked.
};
struct Adaptive {  ///< ... is set by a tolerance: the method chooses steps of its own within the frame.
  double tolerance = 0.0;
};
using Accuracy = std::variant<Divergent, Convergent, Exact, Adaptive>;

/// A method's names and how it is made.
struct MethodKind {
  std::string name;         ///< As a key: "paper".
  std::string label = {};   ///< For readers: "the paper's step".
  std::string family = {};  ///< Common to an adaptive method's tolerances: "GSL rk4"; else empty.
  Accuracy accuracy = {};
  bool meets_walls = true;
  std::function<std::unique_ptr<Method>()> make = {};

  [[nodiscard]] bool is_adaptive() const { return std::holds_alternative<Adaptive>(accuracy); }
  [[nodiscard]] bool is_reference() const {
    const auto* const exact = std::get_if<Exact>(&accuracy);
    return exact != nullptr && exact->is_reference;
  }
};

/// The paper's step, first of all, its rate-normalised variant, classical steps, sub-steps and the exact
/// ones. They refer to the core. All except the paper's solve the fixed laws; those that look at walls once a
/// frame meet them as the paper's step does, except that the friction on a sprite lying on the ground is
/// taken by time.
[[nodiscard]] std::vector<MethodKind> frame_methods(const Core& core);

/// Each of GSL's steppers at several tolerances, without walls. Quick: fewer tolerances, and without the
/// stepper (rk1imp) that takes as long as all others together.
[[nodiscard]] std::vector<MethodKind> gsl_methods(const Core& core, bool is_quick);

}  // namespace hyrax
