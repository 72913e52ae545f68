#include "sim/trace/step_difference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "recording.h"
#include "sim/trace/expression_text.h"
#include "sim/trace/step_text.h"

namespace hyrax {
namespace {

using namespace recording;

using Edit = std::function<void(Listing&)>;

TracedStep edited(const Edit& edit) {
  Listing listing;
  edit(listing);
  return canonical(record(listing));
}

struct Change {
  const char* name;
  Edit edit;
};

// What happens to a body where a condition holds.
using Condition = std::function<bool(const Body&, const Frame&)>;
Edit before_move(const Condition& condition, const std::function<void(Body&)>& then) {
  return [=](Listing& listing) {
    listing.before_move = [=](Body& body, const Frame& frame) {
      if (condition(body, frame)) then(body);
    };
  };
}
Edit at_walls(const Condition& condition, const std::function<void(Body&)>& then) {
  return [=](Listing& listing) {
    listing.before_walls = [=](Body& body, const Frame& frame) {
      if (condition(body, frame)) then(body);
    };
  };
}
Edit slower_where(const Condition& condition) {
  return before_move(condition, [](Body& body) { body.vx = body.vx * Real(0.5); });
}
Edit stops_where(const Condition& condition) {
  return at_walls(condition, [](Body& body) { body.vy = 0.0; });
}
Edit right_wall_if(const Condition& condition) {
  return [=](Listing& listing) { listing.extra_right = condition; };
}
Edit rest_if(const Condition& condition) {
  return [=](Listing& listing) { listing.extra_ground = condition; };
}

Real right(const Frame& frame) { return to_real(frame.window_width - frame.sprite_width); }
Real bottom(const Frame& frame) { return to_real(frame.window_height - frame.sprite_height); }

using B = const Body&;
using F = const Frame&;

const std::vector<Change>& changes() {
  static const std::vector<Change> all = {
      {"speed limit", slower_where([](B b, F) { return b.vx > 9000.0; })},
      {"slow stops", slower_where([](B b, F) { return fabs(b.vx) < 0.001; })},
      {"equal speeds", slower_where([](B b, F) { return b.vx == b.vy; })},
      {"right wall near the top", right_wall_if([](B b, F) { return b.y >= 50.0; })},
      {"rest when slow in x", rest_if([](B b, F) { return b.vx > -600.0; })},
      {"width 2560", slower_where([](B, F f) { return f.window_width == Whole(2560); })},
      {"height 1440", slower_where([](B, F f) { return f.window_height == Whole(1440); })},
      {"a width nobody has", slower_where([](B, F f) { return f.window_width == Whole(771234); })},
      {"bound of 1", slower_where([](B, F f) { return right(f) == 1.0; })},
      {"sprite of 77", slower_where([](B, F f) { return f.sprite_width == Whole(77); })},
      {"sprite larger than the window",
       slower_where([](B, F f) { return right(f) < 0.0 && bottom(f) < 0.0; })},
      {"many pixels", slower_where([](B, F f) { return f.window_width * f.window_height > Whole(9e6); })},
      {"dt of 100 to 120 ms", slower_where([](B, F f) { return f.dt > 0.1 && f.dt < 0.12; })},
      {"dt of 7.77 ms", slower_where([](B, F f) { return f.dt == 0.00777; })},
      {"dt of 0", slower_where([](B, F f) { return f.dt == 0.0; })},
      {"very long frames", slower_where([](B, F f) { return f.dt > 1e6; })},
      {"144 Hz", slower_where([](B, F f) { return f.dt > 1.0 / 144.5 && f.dt < 1.0 / 143.5; })},
      {"far outside", slower_where([](B b, F) { return b.x > 1e5; })},
      {"a circle of 1 px", slower_where([](B b, F) {
         return (b.x - Real(960.0)) * (b.x - Real(960.0)) + (b.y - Real(540.0)) * (b.y - Real(540.0)) < 1.0;
       })},
      {"a negative zero", slower_where([](B b, F) { return Real(1.0) / b.vy == -HUGE_VAL; })},
      {"exactly on the left wall", at_walls([](B b, F) { return b.x == 0.0; },
                                            [](Body& b) { b.vx = -b.vx * Real(0.6); })},
      {"corner", slower_where([](B b, F f) { return b.x > right(f) && b.y > bottom(f); })},
      {"four conditions", stops_where([](B b, F f) {
         return b.vx > 1000.0 && b.vy < -1000.0 && b.y < 100.0 && f.dt > 0.02;
       })},
      {"drag of slow frames", [](Listing& l) {
         l.before_drag = [](Body& b, F f) {
           if (f.dt > 0.5) b.vx = b.vx * pow(Real(0.999), f.dt * Real(60.0));
         };
       }},
      {"one fused operation where it is rare", [](Listing& l) {
         l.before_walls = [](Body& b, F f) {
           if (b.x > right(f) && b.y < 0.0) b.y = fma(b.vy, f.dt, b.y);
         };
       }},
      {"three equalities",
       slower_where([](B, F f) {
         return f.window_width == Whole(2560) && f.sprite_width == Whole(96) && f.dt == 1.0 / 165.0;
       })},
      {"a place", stops_where([](B b, F) {
         return b.x > 100.0 && b.x < 100.5 && b.y > 100.0 && b.y < 100.5;
       })},
      {"speed in a band",
       slower_where([](B b, F) {
         return sqrt(b.vx * b.vx + b.vy * b.vy) > 5000.0 && sqrt(b.vx * b.vx + b.vy * b.vy) < 5001.0;
       })},
      {"exactly on the ground", stops_where([](B b, F f) { return b.y == bottom(f) && b.vy > 0.0; })},
      {"every seventh width", slower_where([](B, F f) { return f.window_width % Whole(7) == Whole(3); })},
      {"no motion", slower_where([](B b, F f) { return b.x + b.vx * f.dt == b.x && b.vx > 1.0; })},
      {"windows of one ratio",
       slower_where([](B, F f) { return f.window_width * Whole(9) == f.window_height * Whole(16); })},
      {"whole pixels", stops_where([](B b, F) { return to_real(to_whole(b.x)) == b.x; })},
      {"subnormal speeds", slower_where([](B b, F) { return b.vx > 0.0 && b.vx < 1e-308; })},
      {"zeros", [](Listing& l) { l.at_end = [](Body& b, F) { b.x = b.x + Real(0.0); }; }},
      {"gravity by an ulp", [](Listing& l) { l.gravity = 1200.0000000000002; }},
      {"rest threshold", [](Listing& l) { l.threshold = 5.0000001; }},
      {"friction", [](Listing& l) { l.friction = 0.81; }}};
  return all;
}

std::vector<std::string> texts_of(const Edit& edit) {
  const StepPair pair(canonical(record_listing()), edited(edit));
  std::vector<std::string> texts;
  for (const StepDifference& difference : pair.differences())
    texts.push_back((difference.is_in_accepted ? "- " : "+ ") + difference.text);
  return texts;
}

TEST(StepDifferences, OfEqualStepsAreNone) {
  const StepPair pair(canonical(record_listing()), edited([](Listing&) {}));
  EXPECT_TRUE(pair.differences().empty());
  EXPECT_TRUE(pair.are_setters_equal());
}

TEST(StepDifferences, AreTheInnermostOnes) {
  using Texts = std::vector<std::string>;
  EXPECT_EQ(texts_of([](Listing& l) { l.gravity = 1250.0; }), (Texts{"- dt * 1200", "+ dt * 1250"}));
  EXPECT_EQ(texts_of(before_move([](B b, F) { return b.vx > 9000.0; }, [](Body& b) { b.vx = 9000.0; })),
            (Texts{"+ vx * 0.999 > 9000", "+ dt * 9000"}));
  EXPECT_EQ(texts_of([](Listing& l) { l.threshold = 6.0; }),
            (Texts{"- fabs(-((vy + dt * 1200) * 0.999 * 0.6)) < 5",
                   "+ fabs(-((vy + dt * 1200) * 0.999 * 0.6)) < 6"}));
}

TEST(ExpressionText, IsAsAHeaderWouldHaveIt) {
  using Value = std::function<Real(B, F)>;
  const auto written = [](const Value& value, const NumberNames& names = {}) {
    const TracedStep step =
        canonical(record([&](Body& body, const Frame& frame) { body.x = value(body, frame); }));
    return expression_text(step, step.paths_of(CoreFunction::update)[0].members[0], names);
  };
  EXPECT_EQ(written([](B b, F) { return b.x - b.y; }), "x - y");
  EXPECT_EQ(written([](B b, F) { return b.x - (b.y - b.vx); }), "x - (y - vx)");
  EXPECT_EQ(written([](B b, F) { return Real(2.0) * (b.x + Real(3.0)); }), "(x + 3) * 2");
  EXPECT_EQ(written([](B b, F) { return Real(1.0) / (b.x * b.y); }), "1 / (x * y)");
  EXPECT_EQ(written([](B b, F) { return -(b.x / b.y); }), "-(x / y)");
  EXPECT_EQ(written([](B b, F f) { return pow(b.x, f.dt); }), "pow(x, dt)");
  EXPECT_EQ(written([](B b, F) { return to_real(to_whole(b.x) % Whole(7)); }), "int(x) % 7");
  EXPECT_EQ(written([](B b, F) { return to_real(to_single(b.x + b.y)); }), "float(x + y)");
  EXPECT_EQ(written([](B, F f) { return f.dt * Real(1200.0); }, {{1200.0, "GRAVITY"}}), "dt * GRAVITY");
  EXPECT_EQ(written([](B b, F f) {
              Real sum = b.x;
              for (const double number : {1.5, 2.5, 3.5, 4.5, 5.5, 6.5, 7.5, 8.5})
                sum = f.dt * sum + Real(number);
              return sum;
            }),
            "dt * (dt * (dt * (dt * (dt * (dt  ... + 4.5) + 5.5) + 6.5) + 7.5) + 8.5");
}

TEST(ComparisonText, HasItsNumberAtTheRight) {
  const auto written = [](const Condition& condition) {
    const TracedStep step = canonical(record([&](Body& body, const Frame& frame) {
      if (condition(body, frame)) body.x = 0.0;
    }));
    return comparison_text(step, 0, {{-5.0, "LOW"}});
  };
  EXPECT_EQ(written([](B b, F) { return b.x > 50.0; }), "x > 50");
  EXPECT_EQ(written([](B b, F) { return b.x >= 50.0; }), "x >= 50");
  EXPECT_EQ(written([](B b, F) { return b.x < 50.0; }), "x < 50");
  EXPECT_EQ(written([](B b, F) { return b.x <= -5.0; }), "x <= -5");
  EXPECT_EQ(written([](B b, F) { return b.x > -5.0; }), "x > -5");
  EXPECT_EQ(written([](B b, F) { return b.x == 50.0; }), "x == 50");
  EXPECT_EQ(written([](B b, F) { return b.x <= b.y; }), "x <= y");
}

TEST(StepDifferences, AreFoundWhereBothStepsCalculateAndCompareTheSame) {
  const auto update = [](bool swaps) {
    return canonical(record([=](Body& body, const Frame& frame) {
      const Real a = body.vx * frame.dt;
      const Real b = body.vy * frame.dt;
      const bool is_low = body.x < body.y;
      body.x = is_low != swaps ? a : b;
      body.y = is_low != swaps ? b : a;
    }));
  };
  const StepPair pair(update(false), update(true));
  ASSERT_FALSE(pair.differences().empty());
  EXPECT_TRUE(pair.search(0, 1, 1000).found);
}

TEST(StepDifferences, OfSettersAreApart) {
  const TracedStep listing = canonical(record_listing());
  TracedStep other = listing;
  const auto set_velocity = static_cast<std::size_t>(CoreFunction::set_velocity);
  std::swap(other.paths[set_velocity][0].members[2], other.paths[set_velocity][0].members[3]);
  const StepPair pair(listing, canonical(other));
  EXPECT_TRUE(pair.differences().empty());
  EXPECT_FALSE(pair.are_setters_equal());
}

std::vector<TracedBody> bodies_of(const StepPair& pair, const State& start) {
  std::vector<TracedBody> bodies;
  for (const auto& program : pair.programs()) bodies.emplace_back(*program, start);
  return bodies;
}

void notice(const StepPair& pair, const StepInput& input, std::vector<bool>& noticed) {
  std::vector<TracedBody> bodies = bodies_of(pair, input.world.state);
  std::vector<DifferenceWatch> watches(noticed.size());
  pair.notice(input, bodies, watches, noticed);
}

// By difference, of a step from this input alone.
std::vector<bool> noticed_from(const StepPair& pair, const StepInput& input) {
  std::vector<bool> noticed(pair.differences().size());
  notice(pair, input, noticed);
  return noticed;
}

std::vector<std::string> texts_of(const StepPair& pair, const std::vector<bool>& noticed) {
  std::vector<std::string> texts;
  for (std::size_t index = 0; index < noticed.size(); ++index)
    if (noticed[index]) texts.push_back(pair.differences()[index].text);
  return texts;
}

TEST(StepDifferences, AreNoticedOnlyWhereTheyAreEvaluated) {
  const StepPair pair(canonical(record_listing()), edited([](Listing& l) { l.friction = 0.81; }));
  EXPECT_TRUE(
      texts_of(pair, noticed_from(pair, {{{100, 100, 300, 0}, {1000, 1000}, {64, 64}}, 0.01})).empty());
  // Of the four not those of a contact with a wall as well.
  EXPECT_EQ(texts_of(pair, noticed_from(pair, {{{100, 936, 300, 0}, {1000, 1000}, {64, 64}}, 0.01})).size(),
            2u);
}

// Gravity changes every row. x is compared with the left wall in every step, which decides on it alone; so is
// a width.
TEST(StepDifferences, AreNoticedOnlyWhereTheyDecideBesideAnother) {
  const StepPair left(canonical(record_listing()), edited([](Listing& l) {
                        l.gravity = 1250.0;
                        l.before_walls = [](Body& body, const Frame&) {
                          if (body.x <= 0.0) body.vx = body.vx + 7.0;
                        };
                      }));
  const StepInput in_flight{{{100, 100, 300, 0}, {1000, 1000}, {64, 64}}, 0.01};
  const StepInput at_the_left{{{0, 100, 0, 0}, {1000, 1000}, {64, 64}}, 0.01};
  const StepInput at_the_ground{{{100, 935.9, 300, 0}, {1000, 1000}, {64, 64}}, 0.01};
  const std::vector<std::string> gravity = {"dt * 1200", "dt * 1250"};
  EXPECT_EQ(texts_of(left, noticed_from(left, in_flight)), gravity);
  EXPECT_EQ(texts_of(left, noticed_from(left, at_the_ground)), gravity) << "by friction vx differs, too";
  EXPECT_EQ(noticed_from(left, at_the_left), std::vector<bool>(left.differences().size(), true));
  const StepPair small(canonical(record_listing()), edited([](Listing& l) {
                         l.gravity = 1250.0;
                         l.at_end = [](Body& body, const Frame& frame) {
                           if (frame.window_width < Whole(500)) body.vy *= 0.5;
                         };
                       }));
  StepInput in_small = in_flight;
  EXPECT_EQ(texts_of(small, noticed_from(small, in_flight)), gravity);
  in_small.world.window.width_px = 400;
  EXPECT_EQ(texts_of(small, noticed_from(small, in_small)).size(), 3u) << "of all that both have operands of";
}

TEST(StepDifferences, WithoutEffectAreNotNoticedByALaterRow) {
  const StepPair pair(canonical(record_listing()),
                      edited([](Listing& l) { l.friction = 0.81, l.restitution = 0.61; }));
  const StepInput lying{{{100, 936, 0, 0}, {1000, 1000}, {64, 64}}, 0.001};
  const StepInput at_the_left{{{0.5, 100, -300, 0}, {1000, 1000}, {64, 64}}, 0.01};
  std::vector<DifferenceWatch> watches(pair.differences().size());
  std::vector<bool> noticed(watches.size());
  std::vector<TracedBody> lies = bodies_of(pair, lying.world.state),
                          flies = bodies_of(pair, at_the_left.world.state);
  pair.notice(lying, lies, watches, noticed);
  EXPECT_TRUE(texts_of(pair, noticed).empty());
  pair.notice(at_the_left, flies, watches, noticed);
  EXPECT_FALSE(texts_of(pair, noticed).empty());
  EXPECT_EQ(noticed, noticed_from(pair, at_the_left));
}

// A fifth member that counts steps, and slows the body down after some.
struct CountingBody : Body {
  Whole steps;
};
TracedStep counting(int steps_max, int counts = 1) {
  return canonical(record_of<CountingBody>([=](CountingBody& body, const Frame& frame) {
    Listing()(body, frame);
    if (body.steps > steps_max) body.vx *= 0.5;
    body.steps += counts;
  }));
}

TEST(StepDifferences, AreNoticedWhereWhatFurtherMembersHoldShowsThem) {
  const StepInput input{{{100, 100, 300, 0}, {1000, 1000}, {64, 64}}, 0.01};
  for (const auto& [current, shown_by] : {std::pair(counting(5), 5), std::pair(counting(3, 2), 3)}) {
    const StepPair pair(counting(3), current);
    std::vector<TracedBody> bodies = bodies_of(pair, input.world.state);
    std::vector<DifferenceWatch> watches(pair.differences().size());
    std::vector<bool> noticed(watches.size());
    for (int step = 1; step <= shown_by; ++step) {
      pair.notice(input, bodies, watches, noticed);
      EXPECT_EQ(std::count(noticed.begin(), noticed.end(), true), step == shown_by ? 2 : 0);
    }
  }
}

// Gravity changes every row; what the fifth member makes of it another one shows.
TEST(StepDifferences, OfFurtherMembersAreNoticedWhereThoseDecideBesideAnother) {
  const auto counting_with = [](int counts, double gravity) {
    return canonical(record_of<CountingBody>([=](CountingBody& body, const Frame& frame) {
      Listing listing;
      listing.gravity = gravity;
      listing(body, frame);
      if (body.steps > 3) body.vx *= 0.5;
      body.steps += counts;
    }));
  };
  const StepPair pair(counting_with(1, 1200.0), counting_with(2, 1250.0));
  const StepInput input{{{100, 100, 300, 0}, {1000, 1000}, {64, 64}}, 0.01};
  std::vector<TracedBody> bodies = bodies_of(pair, input.world.state);
  std::vector<DifferenceWatch> watches(pair.differences().size());
  std::vector<bool> noticed(watches.size());
  for (const std::size_t count : {2U, 2U, 4U}) {
    pair.notice(input, bodies, watches, noticed);
    EXPECT_EQ(texts_of(pair, noticed).size(), count);
  }
}

// A fifth member that turns with vx, and is kept below a turn; with `is_used` it slows the body down.
TracedStep turning(double rate, bool is_used) {
  struct TurningBody : Body {
    Real turned = 0.0;
  };
  return canonical(record_of<TurningBody>([=](TurningBody& body, const Frame& frame) {
    Listing()(body, frame);
    body.turned += body.vx * rate * frame.dt;
    if (body.turned > 6.25) body.turned -= 6.25;
    if (is_used) body.vx += 1e-9 * body.turned;
  }));
}

TEST(UnrecordedMembers, AreThoseOnWhichNoRowDepends) {
  EXPECT_EQ(unrecorded_members(turning(0.5, false)), ~MemberBits{0b1111});
  EXPECT_EQ(unrecorded_members(turning(0.5, true)), ~MemberBits{0b11111});
  EXPECT_EQ(unrecorded_members(counting(3)), ~MemberBits{0b11111}) << "decides between ends";
  EXPECT_EQ(unrecorded_members(canonical(record_listing())), ~MemberBits{0b1111});
  const StepPair pair(turning(0.5, false), turning(0.25, false));
  for (std::size_t index = 0; index < pair.differences().size(); ++index) {
    const DifferenceSearch search = pair.search(index, 1, 10'000);
    EXPECT_FALSE(search.found) << pair.differences()[index].text;
    EXPECT_EQ(search.further_members, MemberBits{0b10000}) << pair.differences()[index].text;
    EXPECT_EQ(search.further_members & pair.unrecorded(), search.further_members);
  }
}

// What is a difference of the step and none of any result.
bool has_no_effect(const std::string& text) {
  return text == "0 + 0" || text == "window_width - sprite_width + 0";
}

TEST(StepSearch, FindsAStepForEveryConditionalChange) {
  const TracedStep listing = canonical(record_listing());
  for (const Change& change : changes()) {
    const StepPair pair(listing, edited(change.edit));
    EXPECT_FALSE(pair.differences().empty()) << change.name;
    std::vector<bool> noticed(pair.differences().size());
    for (std::size_t index = 0; index < noticed.size(); ++index) {
      if (noticed[index] || has_no_effect(pair.differences()[index].text)) continue;
      const DifferenceSearch search = pair.search(index, 1, 100'000);
      ASSERT_TRUE(search.found) << change.name << ": " << pair.differences()[index].text;
      EXPECT_EQ(search.frames, 1);
      notice(pair, *search.found, noticed);
      EXPECT_TRUE(noticed[index]) << change.name;
    }
  }
}

TEST(StepSearch, StaysWithinWhatScenariosAllowAndItsSteps) {
  const TracedStep listing = canonical(record_listing());
  const std::vector<Condition> none = {[](B b, F) { return b.vx > 2e12; },
                                       [](B b, F) { return b.x < -1e12; },
                                       [](B, F f) { return f.dt > 1e9; },
                                       [](B, F f) { return f.dt < 0.0; },
                                       [](B, F f) { return f.window_width > Whole(1e6); },
                                       [](B, F f) { return f.window_height < Whole(0); },
                                       [](B, F f) { return f.sprite_width < Whole(1); },
                                       [](B, F f) { return f.sprite_height > Whole(1e6); }};
  for (const Condition& condition : none) {
    const StepPair pair(listing, edited(slower_where(condition)));
    ASSERT_FALSE(pair.differences().empty());
    const DifferenceSearch search = pair.search(0, 1, 20'000);
    EXPECT_FALSE(search.found);
    EXPECT_GE(search.steps_tried, 20'000);
    EXPECT_LT(search.steps_tried, 20'020);
  }
}

TEST(StepSearch, PlaysFlingsWhereThereAreFurtherMembers) {
  const TracedStep a = counting(100);
  const std::optional<TracedStep> read = read_step(step_text(a));
  const StepPair pair(read.value(), counting(200));
  ASSERT_EQ(pair.differences().size(), 2u);
  const DifferenceSearch search = pair.search(0, 1, 20'000);
  ASSERT_TRUE(search.found);
  EXPECT_GT(search.frames, 100);
  EXPECT_LE(search.frames, 201);
}

}  // namespace
}  // namespace hyrax
