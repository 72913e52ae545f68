#include "sim/reference/model.h"

#include <gtest/gtest.h>

#include "sim/physics/physics.h"

namespace hyrax {
namespace {

// The reference has its own copy of the paper's constants; this test alone compares it with the core's.
TEST(Model, HasTheConstantsOfTheShippedCore) {
  const Model model;
  EXPECT_EQ(model.gravity_px_per_s2, physics::GRAVITY);
  EXPECT_EQ(model.air_drag, physics::AIR_DRAG);
  EXPECT_EQ(model.restitution, physics::RESTITUTION);
  EXPECT_EQ(model.ground_friction, physics::GROUND_FRICTION);
  EXPECT_EQ(model.rest_threshold_px_per_s, physics::REST_THRESHOLD);
}

}  // namespace
}  // namespace hyrax
