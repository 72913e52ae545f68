// The core's interface is the paper's: names, signatures, constants.
#include <gtest/gtest.h>

#include <bit>
#include <concepts>
#include <cstdint>
#include <type_traits>

#include "sim/physics/physics.h"

namespace {

template <class Constant>
constexpr bool is_double_constant = std::same_as<Constant, const double>;

static_assert(is_double_constant<decltype(physics::GRAVITY)>);
static_assert(is_double_constant<decltype(physics::RESTITUTION)>);
static_assert(is_double_constant<decltype(physics::AIR_DRAG)>);
static_assert(is_double_constant<decltype(physics::GROUND_FRICTION)>);
static_assert(is_double_constant<decltype(physics::REST_THRESHOLD)>);

// Constant expressions, as `static constexpr` in the listing makes them.
[[maybe_unused]] constexpr double kConstants[] = {physics::GRAVITY, physics::RESTITUTION, physics::AIR_DRAG,
                                                  physics::GROUND_FRICTION, physics::REST_THRESHOLD};

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

// Positive zero; EXPECT_EQ accepts -0.0 as well.
bool is_plain_zero(double value) { return std::bit_cast<std::uint64_t>(value) == 0; }

TEST(PhysicsInterface, StartsAtRestAtTheOriginByDefault) {
  const physics body;
  EXPECT_TRUE(is_plain_zero(body.x()));
  EXPECT_TRUE(is_plain_zero(body.y()));
  EXPECT_TRUE(is_plain_zero(body.vx()));
  EXPECT_TRUE(is_plain_zero(body.vy()));
}

TEST(PhysicsInterface, StartsAtRestAtAGivenPosition) {
  const physics body(3.0, 4.0);
  EXPECT_EQ(body.x(), 3.0);
  EXPECT_EQ(body.y(), 4.0);
  EXPECT_TRUE(is_plain_zero(body.vx()));
  EXPECT_TRUE(is_plain_zero(body.vy()));
}

TEST(PhysicsInterface, SettersSetWhatTheyName) {
  physics body(1.0, 2.0, 3.0, 4.0);
  body.setPos(5.0, 6.0);
  EXPECT_EQ(body.x(), 5.0);
  EXPECT_EQ(body.y(), 6.0);
  EXPECT_EQ(body.vx(), 3.0);
  EXPECT_EQ(body.vy(), 4.0);
  body.setVelocity(7.0, 8.0);
  EXPECT_EQ(body.x(), 5.0);
  EXPECT_EQ(body.vx(), 7.0);
  EXPECT_EQ(body.vy(), 8.0);
}

TEST(PhysicsInterface, ResetStopsTheBodyWhereItIs) {
  physics body(1.0, 2.0, 3.0, 4.0);
  body.resetVelocity();
  EXPECT_EQ(body.x(), 1.0);
  EXPECT_EQ(body.y(), 2.0);
  EXPECT_EQ(body.vx(), 0.0);
  EXPECT_EQ(body.vy(), 0.0);
}

}  // namespace
