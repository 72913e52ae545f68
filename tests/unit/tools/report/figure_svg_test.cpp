#include "tools/report/figure_svg.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/unit/tools/report/picture_faults.h"
#include "tools/report/look.h"
#include "tools/report/plot_scale.h"

namespace hyrax {
namespace {

PlotScale scale_of(const Axis& axis, const std::vector<double>& values, double length_px = 400.0) {
  PlotScale scale(axis, values);
  scale.place(0.0, length_px, 80.0);
  return scale;
}

std::string ticks_of(const Axis& axis, const std::vector<double>& values, double length_px = 400.0) {
  std::string texts;
  for (const Tick& tick : scale_of(axis, values, length_px).ticks()) texts += " " + tick.text;
  return texts;
}

TEST(PlotScale, TicksAreRoundDistinctAndWithinTheEnds) {
  EXPECT_EQ(ticks_of({.low = 0.0, .high = 11'000.0}, {}), " 0 5,000 10,000");
  EXPECT_EQ(ticks_of({.low = 0.5996, .high = 0.6004, .decimals = 2}, {}),
            " 0.5996 0.5998 0.6000 0.6002 0.6004")
      << "more decimals than asked for, or two were the same";
  EXPECT_EQ(ticks_of({.low = -3.0, .high = 3.0}, {}), " −2 0 2");
  EXPECT_EQ(ticks_of({.low = 5.31, .high = 5.47}, {}, 180.0), " 5.35 5.40 5.45") << "one gives no scale";
  const Axis powers{.is_logarithmic = true};
  EXPECT_EQ(ticks_of(powers, {2.0, 8.0}, 300.0), " 2 5 10");
  EXPECT_EQ(ticks_of(powers, {1e-9, 1e5}, 700.0), " 10⁻⁸ 10⁻⁶ 10⁻⁴ 0.01 1 100 10,000");
  EXPECT_EQ(ticks_of(powers, {}, 300.0), " 1 10") << "no data";
  EXPECT_EQ(ticks_of({}, {7.0}, 200.0), " 5 10") << "one value";
}

TEST(PlotScale, TicksEndWhereNumbersAreFarApart) {
  const Axis huge{.low = 1e19, .high = 1e19 + 4096.0};
  const std::vector<Tick> ticks = scale_of(huge, {}).ticks();
  EXPECT_GE(ticks.size(), 2u);
  EXPECT_LE(ticks.size(), 6u);
  for (std::size_t index = 1; index < ticks.size(); ++index) EXPECT_LT(ticks[index - 1].at, ticks[index].at);
}

TEST(PlotScale, ZeroHasATickOnALogarithmicAxisWhereThereIsOneAndNoneBelow) {
  const Axis axis{.is_logarithmic = true, .zero_at = 1e-4};
  EXPECT_EQ(ticks_of(axis, {0.0, 1.0}), " 0 0.001 0.01 0.1 1");
  EXPECT_EQ(ticks_of(axis, {0.05, 1.0}), " 0.1 1") << "no data is 0";
  const Axis rounding{.is_logarithmic = true, .zero_at = 0.1, .zero_text = "≤ 0.1"};
  EXPECT_TRUE(ticks_of(rounding, {1e-14, 100.0}).starts_with(" ≤ 0.1 "));
  EXPECT_EQ(scale_of(rounding, {1e-14, 100.0}).at(1e-14), scale_of(rounding, {1e-14, 100.0}).at(0.1));
}

TEST(PlotScale, EqualScalesLeaveAnAxisWhoseEndsAreGiven) {
  const Axis axis, given{.low = 0.0, .high = 10.0};
  PlotScale fixed = scale_of(given, {}), y = scale_of(axis, {0.0, 10.0}, 100.0);
  PlotScale::make_equal(fixed, y);
  EXPECT_EQ(fixed.at(10.0), 400.0);
}

TEST(PlotScale, AStripTakesTheDataFarBelowTheRest) {
  const Axis axis{.is_logarithmic = true, .strip_below = 1e-8};
  EXPECT_TRUE(scale_of(axis, {1e-9, 1.01e-7, 1.0}).end_of_strip());
  EXPECT_FALSE(scale_of(axis, {1.0, 10.0}).end_of_strip());
  EXPECT_FALSE(scale_of(axis, {1e-9, 1e-7, 1.0}).end_of_strip()) << "nothing is empty between them";
  EXPECT_FALSE(scale_of(axis, {1e-10, 1e-9}).end_of_strip()) << "there is no rest";
}

TEST(Look, TextHasContrastAndSeriesDiffer) {
  for (const Tone tone : {Tone::ink, Tone::quiet, Tone::vermilion, Tone::orange, Tone::blue, Tone::green,
                          Tone::purple, Tone::sky_blue, Tone::lavender}) {
    const std::string colour = colour_of(tone), card = colour_named("card");
    EXPECT_GE(contrast_of(colour, card), 4.5) << name_of(tone);
    EXPECT_GE(contrast_of(dark_of(colour), dark_of(card)), 4.5) << name_of(tone);
  }
  for (const auto& [good, bad] :
       {std::pair("good", "bad"), {"fill-good", "fill-bad"}, {"good-tint", "bad-tint"}})
    for (const bool is_dark : {false, true}) {
      const auto hue = [is_dark = is_dark](const std::string& name) {  // Green less red.
        const std::string colour = is_dark ? dark_of(colour_named(name)) : colour_named(name);
        return std::stoi(colour.substr(3, 2), nullptr, 16) - std::stoi(colour.substr(1, 2), nullptr, 16);
      };
      EXPECT_GT(hue(good), 0) << good;
      EXPECT_LT(hue(bad), 0) << bad;
    }
}

// Each fault is found in a picture that has it.
TEST(PictureFaults, FindsOverlapsCutTextsAndPaleOnes) {
  struct Text {
    SvgPoint at;
    const char* text;
    Tone tone = Tone::ink;
  };
  const auto first_fault = [](const std::vector<Text>& texts) {
    Sheet sheet{200, 100};
    for (const Text& each : texts) sheet.svg.text(each.at, each.text, {.tone = each.tone});
    const std::vector<std::string> faults = picture_faults(svg_text("t", sheet));
    return faults.empty() ? "" : faults.front();
  };
  EXPECT_EQ(first_fault({{{20, 20}, "one"}, {{20, 50}, "two"}}), "");
  EXPECT_EQ(first_fault({{{20, 20}, "one"}, {{25, 24}, "two"}}), "overlap: one and two");
  EXPECT_EQ(first_fault({{{180, 20}, "long text"}}), "cut: long text");
  EXPECT_EQ(first_fault({{{20, 20}, "pale", Tone::hairline}}), "pale: pale");
  EXPECT_EQ(picture_faults("<svg><style>svg{height:auto}</style></svg>").size(), 1u);
  const Series one{.name = "a", .x = {1}, .y = {1}};
  EXPECT_EQ(shared_looks({one, one}).size(), 1u);
}

}  // namespace
}  // namespace hyrax
