// One contract for every way to move the sprite; the shipped core is one of them, behind it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "sim/motion/state.h"
#include "sim/study/exact_fling.h"

namespace hyrax {

/// Moves one body, frame by frame or from impact to impact.
class Method {
 public:
  Method() = default;
  Method(const Method&) = delete;
  Method& operator=(const Method&) = delete;
  virtual ~Method() = default;

  virtual void start(const State& motion, const Bounds& bounds) = 0;
  /// Plays the frames, each of its dt >= 0. False where the method failed: then it has no state any more.
  [[nodiscard]] virtual bool play(std::span<const double> frames_s) = 0;
  [[nodiscard]] virtual State motion() const = 0;
  /// Impacts since the start, of a method that knows their moments; null: they show in its rows alone.
  [[nodiscard]] virtual const std::vector<ExactImpact>* impacts() const { return nullptr; }
};

/// How a method approaches the fixed laws in free flight as its frames grow short.
struct Convergence {
  enum class Kind : std::uint8_t { none, with_order, exact, to_tolerance };
  Kind kind = Kind::none;
  int order = 0;  ///< Of with_order: error ~ dt^order.

  bool operator==(const Convergence&) const = default;
  /// As tables and JSON have it: the order, 0 where it does not converge, -1 exact but for rounding, -2 as good as
  /// its tolerance.
  [[nodiscard]] constexpr int code() const {
    return kind == Kind::exact ? -1 : kind == Kind::to_tolerance ? -2 : order;
  }
};
inline constexpr Convergence kNoConvergence{};
inline constexpr Convergence kExact{Convergence::Kind::exact};
inline constexpr Convergence kToTolerance{Convergence::Kind::to_tolerance};
[[nodiscard]] constexpr Convergence of_order(int order) { return {Convergence::Kind::with_order, order}; }

/// What a method is called and how it is made.
struct MethodKind {
  std::string name;   ///< As a key: "paper".
  std::string words;  ///< As people read it: "the paper's step".
  /// Of an adaptive method at several tolerances: what these have in common, as "GSL rk4"; else empty.
  std::string family = {};
  Convergence convergence = {};
  bool meets_walls = true;
  double tolerance = 0.0;  ///< Of an adaptive method, which needs no frames; 0: error follows the frame.
  std::function<std::unique_ptr<Method>()> make = {};
};

/// The paper's step, its rate-normalised variant, classical steps, sub-steps and the two exact ones. All
/// but the paper's solve the fixed laws; those that go by frames meet walls as the paper's step does, with
/// the friction of a sprite that lies taken by time.
[[nodiscard]] std::vector<MethodKind> frame_methods();

}  // namespace hyrax
