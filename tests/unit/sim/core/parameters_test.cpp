// A run with a scenario's parameters is that of a core that has them as its own constants.
#include <gtest/gtest.h>

#include "sim/core/core_of.h"
#include "sim/core/listing_core.h"
#include "sim/core/shipped_core.h"
#include "sim/reference/model.h"
#include "sim/replay/replay.h"
#include "sim/trace/listing_step.h"
#include "tests/unit/sim/replay/some_flings.h"

namespace hyrax {
namespace {

constexpr Constants kOthers{.gravity_px_per_s2 = 980.5,
                            .restitution = 0.75,
                            .air_drag = 0.9985,
                            .ground_friction = 0.65,
                            .rest_threshold_px_per_s = 12.0};

std::vector<Parameter> named(const Constants& constants) {
  std::vector<Parameter> parameters;
  for (std::size_t place = 0; place < kPaperNames.size(); ++place)
    parameters.push_back({std::string(kPaperNames[place]), constants.*kConstantFields[place]});
  return parameters;
}

std::string hash_of(const Core& core, const Scenario& scenario) {
  return hex(replay(core, scenario).state_hash);
}

TEST(Parameters, GiveTheBitsOfTheirConstants) {
  for (const Scenario& scenario : {eventful_fling(), fling_at(144.0, 3000)}) {
    const Core played = with_parameters(shipped_core(), named(kOthers)).value();
    EXPECT_EQ(hash_of(played, scenario), hash_of(listing_core(kOthers), scenario));
    EXPECT_NE(hash_of(played, scenario), hash_of(shipped_core(), scenario)) << "the control";
    EXPECT_TRUE(same_bits(played.constants.value(), kOthers));
    EXPECT_EQ(played.name, shipped_core().name);
    EXPECT_EQ(played.record.checksum(), shipped_core().record.checksum());
  }
}

TEST(Parameters, AloneChangeOneConstantEach) {
  const Constants own = shipped_core().constants.value();
  for (std::size_t place = 0; place < kPaperNames.size(); ++place) {
    Constants changed = own;
    changed.*kConstantFields[place] = kOthers.*kConstantFields[place];
    const Core played = with_parameters(shipped_core(), {named(kOthers)[place]}).value();
    EXPECT_TRUE(same_bits(played.constants.value(), changed)) << kPaperNames[place];
    EXPECT_EQ(hash_of(played, eventful_fling()), hash_of(listing_core(changed), eventful_fling()));
  }
}

TEST(Parameters, OfTheCoresOwnValuesChangeNoBit) {
  const Core played = with_parameters(shipped_core(), named(shipped_core().constants.value())).value();
  EXPECT_EQ(hash_of(played, eventful_fling()), hash_of(shipped_core(), eventful_fling()));
  EXPECT_EQ(with_parameters(shipped_core(), {})->stepper, shipped_core().stepper);
}

// Not those of the parameters that it was made with before.
TEST(Parameters, LeaveTheOtherConstantsTheCoresOwn) {
  const Core first = with_parameters(shipped_core(), named(kOthers)).value();
  EXPECT_EQ(with_parameters(first, first.parameters)->stepper, first.stepper);
  EXPECT_EQ(with_parameters(first, {{"GRAVITY", 980.5}})->constants->restitution, 0.6);
  EXPECT_EQ(with_parameters(first, {})->stepper, shipped_core().stepper);
}

TEST(Parameters, NeedAKnownNameAndThePapersStep) {
  EXPECT_FALSE(with_parameters(shipped_core(), {{"GRAVTY", 980.0}}));
  EXPECT_FALSE(with_parameters(shipped_core(), {{"", 980.0}}));
  Core other = shipped_core();
  other.paper_match = {.difference = "dt * 2"};
  EXPECT_FALSE(with_parameters(other, {{"GRAVITY", 980.0}}));
  Constants ignored;
  EXPECT_EQ(set_parameters({{"GRAVITY", 1.0}, {"SPIN", 2.0}}, kPaperNames, ignored)->name, "SPIN");
}

struct Narrow {
  static constexpr float GRAVITY = 1200.0F;
  static constexpr double RESTITUTION = 0.6, AIR_DRAG = 0.999, GROUND_FRICTION = 0.8, REST_THRESHOLD = 5.0;
};

TEST(Parameters, DoNotReplaceAConstantOfAnotherType) {
  EXPECT_EQ(constant_names_of<Narrow>(),
            (ConstantNames{"", "AIR_DRAG", "RESTITUTION", "GROUND_FRICTION", "REST_THRESHOLD"}));
}

TEST(Parameters, AreMeasuredByTheirConstants) {
  const Model model = reference_model("hyrax-physics/1", kOthers, {{"GRAVITY", 980.5}});
  EXPECT_EQ(model.gravity_px_per_s2, 980.5);
  EXPECT_EQ(model.restitution, 0.6) << "a changed constant of the paper's model is an error";
  EXPECT_EQ(reference_model("mine/1", kOthers, {{"PULL", 980.5}}).restitution, 0.75);
}

}  // namespace
}  // namespace hyrax
