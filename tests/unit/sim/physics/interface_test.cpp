// The core's interface is the paper's: names, signatures, constants.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <concepts>
#include <cstdint>
#include <type_traits>

#include "sim/physics/physics.h"

namespace {

// Constant expressions of type double, as `static constexpr` in the listing makes them.
[[maybe_unused]] constexpr std::array kConstants{physics::GRAVITY, physics::RESTITUTION, physics::AIR_DRAG,
                                                 physics::GROUND_FRICTION, physics::REST_THRESHOLD};
static_assert(std::same_as<decltype(kConstants), const std::array<double, 5>>);

static_assert(std::is_same_v<decltype(&physics::update), void (physics::*)(double, int, int, int, int)>);
static_assert(std::is_same_v<decltype(&physics::x), double (physics::*)() const>);
static_assert(std::is_same_v<decltype(&physics::y), double (physics::*)() const>);
static_assert(std::is_same_v<decltype(&physics::vx), double (physics::*)() const>);
static_assert(std::is_same_v<decltype(&physics::vy), double (physics::*)() const>);
static_assert(std::is_same_v<decltype(&physics::setPos), void (physics::*)(double, double)>);
static_assert(std::is_same_v<decltype(&physics::setVelocity), void (physics::*)(double, double)>);
static_assert(std::is_same_v<decltype(&physics::resetVelocity), void (physics::*)()>);

static_assert(std::is_default_constructible_v<physics>);
static_assert(std::is_constructible_v<physics, double, double>);
static_assert(std::is_constructible_v<physics, double, double, double>);
static_assert(std::is_constructible_v<physics, double, double, double, double>);
static_assert(std::is_trivially_copyable_v<physics> && sizeof(physics) == 4 * sizeof(double));

// By their bits: EXPECT_EQ takes -0.0 for 0.0.
void expect_state(const physics& body, const std::array<double, 4>& state) {
  using Bits = std::array<std::uint64_t, 4>;
  EXPECT_EQ(std::bit_cast<Bits>(std::array{body.x(), body.y(), body.vx(), body.vy()}),
            std::bit_cast<Bits>(state));
}

TEST(PhysicsInterface, ConstructorsAndSettersSetWhatTheyName) {
  expect_state({}, {0.0, 0.0, 0.0, 0.0});
  expect_state({3.0, 4.0}, {3.0, 4.0, 0.0, 0.0});
  physics body(1.0, 2.0, 3.0, 4.0);
  expect_state(body, {1.0, 2.0, 3.0, 4.0});
  body.setPos(5.0, 6.0);
  expect_state(body, {5.0, 6.0, 3.0, 4.0});
  body.setVelocity(7.0, 8.0);
  expect_state(body, {5.0, 6.0, 7.0, 8.0});
  body.resetVelocity();
  expect_state(body, {5.0, 6.0, 0.0, 0.0});
}

}  // namespace
