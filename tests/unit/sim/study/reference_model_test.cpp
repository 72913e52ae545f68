// By which laws a core's runs are measured, and which constants the reference allows.
#include "sim/study/reference_model.h"

#include <gtest/gtest.h>

#include "sim/trajectory/physics_model.h"

namespace hyrax {
namespace {

constexpr Constants kOthers{.gravity_px_per_s2 = 900.0,
                            .restitution = 0.7,
                            .air_drag = 0.99,
                            .ground_friction = 0.5,
                            .rest_threshold_px_per_s = 4.0};

TEST(ReferenceModel, HasTheConstantsOfACoreOfItsOwnModelAndThePapersTableOfAnyOther) {
  const Model own = reference_model("mine/1", kOthers);
  EXPECT_TRUE(same_bits({own.gravity_px_per_s2, own.restitution, own.air_drag, own.ground_friction,
                         own.rest_threshold_px_per_s},
                        kOthers));
  EXPECT_EQ(own.model_rate_hz, 60.0);
  EXPECT_EQ(reference_model(kPhysicsModel, kOthers).air_drag, 0.999) << "a changed constant is an error";
  EXPECT_EQ(reference_model("mine/1", {}).air_drag, 0.999);
}

TEST(WhyNotMeasurable, NamesTheConstantAndWhatIsAllowed) {
  struct Case {
    double Constants::*constant;
    double value;
    const char* why_not;
  };
  for (const auto& [constant, value, why_not] :
       {Case{&Constants::gravity_px_per_s2, 0.0, ""},
        {&Constants::gravity_px_per_s2, -1.0, "GRAVITY: must be 0 .. 1000000000000 (found -1)"},
        {&Constants::air_drag, 0.5, ""},
        {&Constants::air_drag, 1.0, ""},
        {&Constants::air_drag, 0.499, "AIR_DRAG: must be 0.5 .. 1 (found 0.499)"},
        {&Constants::air_drag, 1.001, "AIR_DRAG: must be 0.5 .. 1 (found 1.001)"},
        {&Constants::restitution, 1.0, ""},
        {&Constants::restitution, 1.1, "RESTITUTION: must be 0 .. 1 (found 1.1)"},
        {&Constants::ground_friction, 0.0, ""},
        {&Constants::ground_friction, -0.5, "GROUND_FRICTION: must be 0 .. 1 (found -0.5)"},
        {&Constants::rest_threshold_px_per_s, 1e12, ""},
        {&Constants::rest_threshold_px_per_s, 2e12,
         "REST_THRESHOLD: must be 0 .. 1000000000000 (found 2000000000000)"}}) {
    Constants constants = kOthers;
    constants.*constant = value;
    EXPECT_EQ(why_not_measurable(constants), why_not);
  }
}

}  // namespace
}  // namespace hyrax
