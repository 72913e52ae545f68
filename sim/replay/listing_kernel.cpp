#include "sim/replay/listing_kernel.h"

#include "sim/motion/step.h"
#include "sim/replay/kernel_of.h"

namespace hyrax {
namespace {

class ListingCore {
 public:
  ListingCore(const Constants& constants, const State& state) : constants_(constants), state_(state) {}

  void update(double dt_s, int window_width_px, int window_height_px, int sprite_width_px,
              int sprite_height_px) {
    const Bounds bounds = bounds_of({window_width_px, window_height_px}, {sprite_width_px, sprite_height_px});
    ListingStep(constants_, AllParts{}, bounds)(state_, dt_s);
  }

  [[nodiscard]] double x() const { return state_.x_px; }
  [[nodiscard]] double y() const { return state_.y_px; }
  [[nodiscard]] double vx() const { return state_.vx_px_per_s; }
  [[nodiscard]] double vy() const { return state_.vy_px_per_s; }
  void setPos(double x_px, double y_px) {
    state_.x_px = x_px;
    state_.y_px = y_px;
  }
  void setVelocity(double vx_px_per_s, double vy_px_per_s) {
    state_.vx_px_per_s = vx_px_per_s;
    state_.vy_px_per_s = vy_px_per_s;
  }
  void resetVelocity() { setVelocity(0.0, 0.0); }

 private:
  Constants constants_;
  State state_;
};

class ListingCores {
 public:
  using Core = ListingCore;

  explicit ListingCores(const Constants& constants) : constants_(constants) {}
  [[nodiscard]] ListingCore make(const State& state) const { return {constants_, state}; }
  [[nodiscard]] Constants constants() const { return constants_; }

 private:
  Constants constants_;
};

}  // namespace

std::unique_ptr<const Kernel> listing_kernel(const Constants& constants) {
  return std::make_unique<KernelOf<ListingCores>>(ListingCores(constants));
}

}  // namespace hyrax
