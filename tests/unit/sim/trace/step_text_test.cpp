#include "sim/trace/step_text.h"

#include <gtest/gtest.h>

#include <limits>

#include "recording.h"

namespace hyrax {
namespace {

using namespace recording;

std::string text_of(const Update& update) { return step_text(canonical(record(update))); }
std::string text_of_sum(const std::function<Real(const Body&, const Frame&)>& x) {
  return text_of([&](Body& body, const Frame& frame) { body.x = x(body, frame); });
}

TEST(StepText, IsOneForStepsOfTheSameBits) {
  const auto is_same = [](const auto& a, const auto& b) { return text_of_sum(a) == text_of_sum(b); };
  using In = const Body&;
  using At = const Frame&;
  EXPECT_TRUE(is_same([](In b, At) { return b.x + b.vx; }, [](In b, At) { return b.vx + b.x; }));
  EXPECT_TRUE(
      is_same([](In b, At) { return -b.vx * Real(0.6); }, [](In b, At) { return -(b.vx * Real(0.6)); }));
  EXPECT_TRUE(
      is_same([](In b, At) { return b.vx * Real(-0.6); }, [](In b, At) { return -b.vx * Real(0.6); }));
  EXPECT_TRUE(is_same([](In b, At) { return -b.vx / b.vy; }, [](In b, At) { return b.vx / -b.vy; }));
  EXPECT_TRUE(is_same([](In b, At) { return -(-b.vx); }, [](In b, At) { return b.vx; }));
  EXPECT_TRUE(is_same([](In b, At) { return b.x - b.vx * Real(-2.0); },
                      [](In b, At) { return b.x + b.vx * Real(2.0); }));
  EXPECT_FALSE(is_same([](In b, At) { return -(b.x - b.vx); }, [](In b, At) { return b.vx - b.x; }));
  EXPECT_FALSE(
      is_same([](In b, At) { return b.x + b.vx + b.vy; }, [](In b, At) { return b.x + (b.vx + b.vy); }));
  EXPECT_FALSE(is_same([](In b, At) { return b.x + Real(0.0); }, [](In b, At) { return b.x + Real(-0.0); }));
  EXPECT_FALSE(is_same([](In, At f) { return to_real(f.window_width / Whole(2)); },
                       [](In, At f) { return to_real(f.window_width) / Real(2.0); }));
  // The quotient of the least int and -1 is none.
  EXPECT_FALSE(is_same([](In, At f) { return to_real(-f.window_width / Whole(2)); },
                       [](In, At f) { return to_real(-(f.window_width / Whole(2))); }));
}

TEST(StepText, IsOneHoweverAConditionIsWritten) {
  const std::string less = text_of([](Body& body, const Frame&) {
    if (body.x < body.vx && !(body.y == body.vy)) body.x = body.vy;
  });
  EXPECT_EQ(text_of([](Body& body, const Frame&) {
              if (body.vx > body.x && !(body.vy == body.y)) body.x = body.vy;
            }),
            less);
  EXPECT_NE(text_of([](Body& body, const Frame&) {
              if (body.x <= body.vx && !(body.y == body.vy)) body.x = body.vy;
            }),
            less);
}

TEST(StepText, MergesComparisonsThatAreOne) {
  EXPECT_EQ(text_of([](Body& body, const Frame&) {
              if (body.x * body.y < 1.0) body.vx = 1.0;
              if (body.y * body.x < 1.0) body.vy = 2.0;
            }),
            text_of([](Body& body, const Frame&) {
              if (body.x * body.y < 1.0) {
                body.vx = 1.0;
                body.vy = 2.0;
              }
            }));
}

// The listing's walls in x; both are asked first where they are flags.
template <bool kHasFlags>
void meet_walls(Body& body, const Frame& frame) {
  const Real right = to_real(frame.window_width - frame.sprite_width);
  const auto is_left = [x = body.x] { return x < 0.0; };
  const auto is_right = [x = body.x, right] { return x > right; };
  if (kHasFlags) {
    is_right();
    is_left();
  }
  if (!is_left() && !is_right()) return;
  body.x = is_left() ? Real(0.0) : right;
  body.vx = -body.vx;
}

TEST(StepText, HasNoComparisonThatDecidesNothing) {
  EXPECT_EQ(record(meet_walls<true>).paths_of(CoreFunction::update).size(), 4u);
  EXPECT_EQ(text_of(meet_walls<true>), text_of(meet_walls<false>));
  // Three, of which one is asked where others were found so.
  const std::string speed = text_of([](Body& body, const Frame&) { body.vy = body.vx; });
  EXPECT_EQ(text_of([](Body& body, const Frame&) {
              if (body.x < body.y) static_cast<void>(body.vx < body.vy || body.x < body.vx);
              body.vy = body.vx;
            }),
            speed);
}

TEST(StepText, OfTwoConditionsOfOneEffectTheFirstIsKept) {
  const auto either = [](const std::function<bool(const Body&)>& asks) {
    return text_of([&](Body& body, const Frame&) {
      if (asks(body)) body.vx = 0.0;
    });
  };
  const auto asks_both = [](const Body& body) {
    const bool is_left = body.x < 0.0, is_high = body.y < 0.0;
    return is_left || is_high;
  };
  const auto asks_both_turned = [](const Body& body) {
    const bool is_high = body.y < 0.0, is_left = body.x < 0.0;
    return is_high || is_left;
  };
  const std::string text = either([](const Body& body) { return body.x < 0.0 || body.y < 0.0; });
  EXPECT_EQ(either(asks_both), text);
  EXPECT_EQ(either(asks_both_turned), text);
}

// Where a comparison is left out, those that remain must lead to one path each: `c ? a && b : b && a`.
TEST(StepText, StaysATreeOfDecisions) {
  const TracedStep step = canonical(record([](Body& body, const Frame&) {
    const auto a = [&] { return body.y < 1.0; };
    const auto b = [&] { return body.vy < 1.0; };
    if (body.x < 0.0)
      body.vx = a() ? (b() ? 1.0 : 2.0) : 3.0;
    else
      body.vx = b() ? (a() ? 1.0 : 4.0) : 5.0;
  }));
  EXPECT_EQ(step.paths_of(CoreFunction::update).size(), 6u);
  EXPECT_EQ(read_step(step_text(step)), step);
}

TEST(StepText, OfEarlierVersionsHasComparisonsThatDecideNothing) {
  const TracedStep recorded = record(meet_walls<true>);
  const std::string text = step_text(in_order(recorded));
  ASSERT_NE(text, step_text(canonical(recorded)));
  EXPECT_EQ(read_step(text), canonical(recorded));
}

TEST(StepText, ReadsWhatItWrites) {
  const double tiny = std::numeric_limits<double>::denorm_min();
  const auto some = [&](Body& body, const Frame& frame) {
    const Single single = to_single(body.vx) * Single(static_cast<double>(0.1f));
    if (to_real(single) < Real(std::numeric_limits<double>::infinity()))
      body.vx = to_real(single / Single(3e-45));
    if (frame.window_width % Whole(7) == Whole(-2147483648.0)) body.vy = fma(body.x, body.y, body.vx);
    body.x = pow(body.x, Real(tiny)) + Real(-std::numeric_limits<double>::max());
    body.y = Real(std::numeric_limits<double>::quiet_NaN());
    body.vy = body.vy + to_real(to_whole(sqrt(body.vx) / Real(1e22)));
  };
  for (const TracedStep& raw : {record_listing(), record(some)}) {
    const TracedStep step = canonical(raw);
    const std::string text = step_text(step);
    const std::optional<TracedStep> read = read_step(text);
    EXPECT_EQ(step_text(read.value()), text);
    EXPECT_EQ(canonical(step).comparisons, step.comparisons);
    EXPECT_EQ(step_text(canonical(step)), text);
  }
}

// With the checksum put right, as one who edits by hand might.
std::string with_checksum(const std::string& text) {
  const std::string body = text.substr(0, text.rfind("checksum: "));
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char byte : body) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
  char line[32];
  std::snprintf(line, sizeof line, "checksum: %016llx\n", static_cast<unsigned long long>(hash));
  return body + line;
}

TEST(StepText, RefusesEveryDamagedByteAndEveryCut) {
  const std::string text = step_text(canonical(record_listing()));
  ASSERT_EQ(with_checksum(text), text);
  for (std::size_t place = 0; place < text.size(); ++place) {
    EXPECT_FALSE(read_step(text.substr(0, place))) << place;
    for (const int flip : {1, 2, 16, 32, 128}) {
      std::string damaged = text;
      damaged[place] = static_cast<char>(damaged[place] ^ flip);
      EXPECT_FALSE(read_step(damaged)) << place << " " << flip;
    }
  }
  EXPECT_FALSE(read_step(text + "\n"));
  EXPECT_FALSE(read_step(text + text));
}

TEST(StepText, ReadsNothingButCanonicalTextsHoweverTheChecksumIsMade) {
  const std::string text = step_text(canonical(record_listing()));
  int read_back = 0;
  for (std::size_t place = 0; place < text.rfind("checksum: "); ++place)
    for (const int flip : {1, 8}) {
      std::string edited = text;
      edited[place] = static_cast<char>(edited[place] ^ flip);
      edited = with_checksum(edited);
      if (const std::optional<TracedStep> step = read_step(edited)) {
        EXPECT_EQ(step_text(*step), edited);
        ++read_back;
      }
    }
  EXPECT_LT(read_back, 200);
  // Without a line some outcomes lead to no path.
  const std::size_t line = text.find("\nupdate:");
  EXPECT_FALSE(read_step(with_checksum(text.substr(0, line) + text.substr(text.find('\n', line + 1)))));
}

}  // namespace
}  // namespace hyrax
