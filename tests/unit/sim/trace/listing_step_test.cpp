#include "sim/trace/listing_step.h"
#include "sim/core/core.h"
#include "sim/core/shipped_core.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <limits>
#include <utility>

#include "recording.h"

namespace hyrax {
namespace {

using namespace recording;

constexpr Constants kShipped = {physics::GRAVITY, physics::RESTITUTION, physics::AIR_DRAG,
                                physics::GROUND_FRICTION, physics::REST_THRESHOLD};

// How the listing stands to the paper's as a test changes it.
PaperMatch match_with(const std::function<void(Listing&)>& change) {
  Listing listing;
  change(listing);
  return match_paper(canonical(record(listing)));
}

std::string difference_with(const std::function<void(Listing&)>& change) {
  const PaperMatch paper_match = match_with(change);
  EXPECT_FALSE(paper_match.constants);
  return paper_match.difference;
}

void set(Listing& listing, const Constants& to) {
  listing.gravity = to.gravity_px_per_s2;
  listing.restitution = to.restitution;
  listing.drag = to.air_drag;
  listing.friction = to.ground_friction;
  listing.threshold = to.rest_threshold_px_per_s;
}

TEST(ListingStep, IsTheShippedHeadersStep) {
  EXPECT_EQ(step_text(listing_step(kShipped)), shipped_core().record.step);
  EXPECT_EQ(step_text(listing_step(kShipped)), step_text(canonical(record_listing())));
  std::ifstream accepted(HYRAX_SOURCE_DIR "/golden/core/step.txt", std::ios::binary);
  EXPECT_EQ(step_text(listing_step(kShipped)), std::string(std::istreambuf_iterator<char>(accepted), {}));
  Constants other = kShipped;
  other.ground_friction = 0.79;
  EXPECT_NE(step_text(listing_step(other)), shipped_core().record.step);
}

TEST(ListingStep, GivesTheConstantsOfAnyCoreOfItsShape) {
  const Constants cores[] = {kShipped,
                             {980.0, 0.75, 0.9985, 0.65, 12.0},
                             {-1200.0, 0.6, 0.999, 0.8, 5.0},
                             {0.0, 0.6, 0.999, 0.8, 5.0},
                             {5.0, 5.0, 5.0, 5.0, 5.0},
                             {0.8, 0.6, 0.8, 0.6, 0.8},
                             {1200.0, -0.6, -0.999, -0.8, -5.0},
                             {1200.0, 0.6, 0.999, 0.6, 0.0},
                             {1.0, 0.0, 1.0, 0.0, 1.0},
                             {1e300, 1e-300, 5e-324, 0.1, 0.2}};
  for (const Constants& core : cores) {
    const PaperMatch paper_match = match_with([&](Listing& listing) { set(listing, core); });
    EXPECT_TRUE(same_bits(paper_match.constants.value(), core)) << core.gravity_px_per_s2;
  }
}

TEST(ListingStep, NamesTheFirstExpressionOfAnotherStep) {
  EXPECT_EQ(difference_with([](Listing& listing) {
              listing.gravity = 980.0;
              listing.before_move = [](Body& body, const Frame& frame) {
                body.vx = body.vx + Real(3.0) * frame.dt;
              };
            }),
            "dt * 3");
  EXPECT_EQ(difference_with([](Listing& listing) {
              listing.restitution = 0.9;
              listing.extra_right = [](const Body& body, const Frame&) { return body.y < 500.0; };
            }),
            "y + dt * ((vy + dt * 1200) * 0.999) < 500");
}

TEST(ListingStep, NamesAConstantThatIsNotKnown) {
  const std::pair<double Constants::*, const char*> names[] = {
      {&Constants::gravity_px_per_s2, "GRAVITY"},
      {&Constants::air_drag, "AIR_DRAG"},
      {&Constants::restitution, "RESTITUTION"},
      {&Constants::ground_friction, "GROUND_FRICTION"},
      {&Constants::rest_threshold_px_per_s, "REST_THRESHOLD"}};
  for (const auto& [field, name] : names) {
    Constants constants = kShipped;
    constants.*field = std::numeric_limits<double>::quiet_NaN();
    const TracedStep step = listing_step(constants);
    EXPECT_EQ(std::ranges::count(step.expressions, name, &Expression::name), 1) << name;
  }
}

TEST(ListingStep, NamesWhatIsMissing) {
  EXPECT_EQ(match_paper(canonical(record([](Body& body, const Frame& frame) {
              body.vx = body.vx * Real(0.5);
              body.x = body.x + body.vx * frame.dt;
            }))).difference,
            "the paper's x + dt * (vx * 0.5) < 0 is missing");
}

TEST(ListingStep, AllowsFurtherMembersThatNothingReads) {
  TracedStep step = listing_step({980.0, 0.6, 0.999, 0.8, 5.0});
  step.members.push_back(NumberKind::whole);
  const auto count = static_cast<StepIndex>(step.expressions.size());
  step.expressions.push_back({.op = Operator::argument, .kind = NumberKind::whole, .name = "member_5"});
  for (std::vector<StepPath>& paths : step.paths)
    for (StepPath& path : paths) path.members.push_back(count);
  const PaperMatch paper_match = match_paper(canonical(step));
  EXPECT_EQ(paper_match.constants.value().gravity_px_per_s2, 980.0);
  // As soon as one is read, the step is another.
  step.comparisons.push_back({count, count, Relation::equal});
  for (StepPath& path : step.paths[static_cast<std::size_t>(CoreFunction::update)])
    path.outcomes.push_back({static_cast<StepIndex>(step.comparisons.size() - 1), true});
  EXPECT_EQ(match_paper(canonical(step)).difference, "member_5 == member_5");
}

TEST(ListingStep, SettersArePartOfTheShape) {
  TracedStep step = listing_step(kShipped);
  StepPath& path = step.paths[static_cast<std::size_t>(CoreFunction::set_velocity)].front();
  std::swap(path.members[2], path.members[3]);
  EXPECT_EQ(match_paper(canonical(step)).difference, "what the constructor or a setter does");
}

}  // namespace
}  // namespace hyrax
