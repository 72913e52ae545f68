// What an author may pass to see(...), and what a body makes of it.
#include <gtest/gtest.h>
#include <array>
#include <cstdint>
#include <vector>

#include "tests/unit/sim/described/core_for_test.h"

namespace hyrax {
namespace {

enum class FormPose : std::uint8_t { sit, run, jump };
enum PlainGear : std::int8_t { kReverse = -1, kNeutral, kFirst };

enum class FormSide : bool { left, right };
struct Sided {
  // Members with the names of lists, which they are not.
  struct inputs {};
  enum class actions {};
  int contacts = 0;
  static void parameters(int /*unused*/) {}
  FormSide side = FormSide::right, other = FormSide::left;
  void step(double /*dt_s*/) { other = side; }
  void state(auto&& see) {
    see("side", side, {"left", "right"});
    see("other", other, {FormSide::left, FormSide::right});
  }
};

struct Grain {
  double x = 0.0;
  bool is_on = true;
  void state(auto&& see) {
    see("x_px", x);
    see("is_on", is_on);
  }
};
struct Strange {
  float q = 0.5F;
};

struct AllForms {
  std::vector<bool> bits{true, false};
  std::vector<Grain> grains{2};
  std::array<std::array<int, 2>, 2> grid{{{1, 2}, {3, 4}}};
  double plain[2] = {1.0, 2.0};
  const double constant = 3.0;
  FormPose pose = FormPose::run;
  PlainGear gear = kReverse;
  std::uint8_t byte = 200;
  std::int64_t big = std::int64_t{-1} << 62;
  float real = 0.1F;
  Strange strange = {};
  double dt = 0.0;

  void step(double dt_s) { dt += dt_s; }

  void state(auto&& see) {
    see("bits", bits);
    see("grains", grains);
    see("grid", grid, {0, 5});
    see("plain", plain, {0, 2e3});
    see("pose", pose, {"sit", "run", "jump"});
    see("pose_limited", pose, {FormPose::sit, FormPose::jump});
    see("gear", gear, {-1, 1});
    see("byte", byte, {0, 255});
    see("big", big);
    see("real_m", real, {0.1, 0.9});
    see(
        "spin_rad_per_s", [&] { return real; }, [&](float given) { real = given; }, {0, 1});
    see("strange", strange, [](auto& part, Strange& object) { part("q_m", object.q, {0.0, 1.0}); });
    see("dt_s", dt);
    see.undeclared("generator");
  }
  void inputs(auto&& see) { see("push", bits[0] ? plain[0] : plain[1]); }
  void actions(auto&& see) {
    see("mix", [&](float a, FormPose b, const int& c) { real = a, pose = b, big = c; }, {"a", "b", "c_px"});
    see("rack", [this]() noexcept { real = 9.0F; });
  }
  void contacts(auto&& see) const {
    see("first", static_cast<bool>(bits[0]));
    see("pointer", &real);
  }
  void outputs(auto&& see) const {
    see("twice", real * 2.0F);
    see("constant", constant);
    see("copies", grains);
    see("temporaries", std::vector<double>{1.0, 2.0});
  }
  void properties(auto&& see) const {
    see.always("a is so", real < 1.0F);
    see.sometimes("b is shown", bits[1]);
  }
};

const ValueInfo& value_named(const ValueList& list, std::string_view name) {
  for (const ValueInfo& value : list.values)
    if (value.name == name) return value;
  throw std::runtime_error("no value " + std::string(name));
}

// In no file is it true or false.
TEST(See, AnEnumOverBoolIsANumberWithNames) {
  const DescribedCore core = core_for_test<Sided>();
  const ValueInfo& side = value_named(core.description.state, "side");
  EXPECT_EQ(side.type, ValueType::uint8);
  EXPECT_EQ(side.initial, 1U);
  EXPECT_EQ(side.names, (std::vector<std::string>{"left", "right"}));
  EXPECT_EQ(value_named(core.description.state, "other").limits, (std::array<Word, 2>{0, 1}));
  EXPECT_EQ(description_fault(core, scenario_for_test(5)), std::nullopt);
  EXPECT_EQ(play(core, scenario_for_test(5), {}).final, (std::vector<Word>{1, 1}));
}

TEST(See, EveryFormIsListedWithNameTypeUnitDefaultLimitsAndNames) {
  const Description description = core_for_test<AllForms>().description;
  const ValueList& state = description.state;
  EXPECT_EQ(faults_of(description), std::vector<std::string>{});
  EXPECT_EQ(state.values.size(), 21U);
  EXPECT_EQ(value_named(state, "bits.1").type, ValueType::boolean);
  EXPECT_EQ(value_named(state, "bits.0").initial, 1U);
  EXPECT_EQ(value_named(state, "grains.1.x_px").unit, "px");
  EXPECT_EQ(value_named(state, "grid.1.0").initial, 3U);
  EXPECT_EQ(value_named(state, "grid.1.0").limits, (std::array<Word, 2>{0, 5}));
  EXPECT_EQ(value_named(state, "plain.0").limits, (std::array<Word, 2>{word_of(0.0), word_of(2e3)}));
  EXPECT_EQ(value_named(state, "pose").names, (std::vector<std::string>{"sit", "run", "jump"}));
  EXPECT_EQ(value_named(state, "pose_limited").limits, (std::array<Word, 2>{0, 2}));
  EXPECT_EQ(value_named(state, "gear").type, ValueType::int8);
  EXPECT_EQ(value_named(state, "gear").initial, word_of(std::int64_t{-1}));
  EXPECT_EQ(value_named(state, "byte").initial, 200U);
  EXPECT_EQ(value_named(state, "real_m").limits, (std::array<Word, 2>{word_of(0.1F), word_of(0.9F)}));
  EXPECT_EQ(value_named(state, "spin_rad_per_s").unit, "rad/s");
  EXPECT_EQ(value_named(state, "strange.q_m").type, ValueType::float32);
  EXPECT_EQ(state.ranges,
            (std::vector<RangeInfo>{
                {"bits", 2}, {"grains", 2}, {"grid", 2}, {"grid.0", 2}, {"grid.1", 2}, {"plain", 2}}));
  EXPECT_EQ(description.undeclared, std::vector<std::string>{"generator"});
  EXPECT_EQ(description.inputs.values.size(), 1U);
  ASSERT_EQ(description.actions.size(), 2U);
  EXPECT_EQ(description.actions[0].arguments[1].type, ValueType::uint8);
  EXPECT_EQ(description.actions[0].arguments[2].unit, "px");
  EXPECT_TRUE(description.actions[1].arguments.empty());
  EXPECT_EQ(description.contacts, (std::vector<std::string>{"first", "pointer"}));
  EXPECT_EQ(value_named(description.outputs, "twice").type, ValueType::float32);
  EXPECT_EQ(value_named(description.outputs, "copies.1.x_px").type, ValueType::float64);
  EXPECT_EQ(description.outputs.values.size(), 8U);
  EXPECT_EQ(description.properties, (std::vector<PropertyInfo>{{"a is so", true}, {"b is shown", false}}));
}

TEST(See, ABodyIsReadSetCopiedAndActedOn) {
  const DescribedCore core = core_for_test<AllForms>();
  const std::unique_ptr<DescribedBody> body = core.make();
  std::vector<Word> words(core.description.state.values.size());
  body->read(SettableList::state, words);
  for (std::size_t place = 0; place < words.size(); ++place)
    EXPECT_EQ(words[place], core.description.state.values[place].initial) << place;
  // Every value, then back: each bool turned, each other number moved within its type.
  std::vector<std::optional<Word>> given(words.size());
  for (std::size_t place = 0; place < words.size(); ++place) {
    const ValueType type = core.description.state.values[place].type;
    given[place] = type == ValueType::boolean ? 1 - words[place]
                   : is_floating(type)        ? word_of(0.75)
                                              : Word{1};
  }
  body->set(SettableList::state, given);
  const std::unique_ptr<DescribedBody> copy = body->copy();
  for (DescribedBody* each : {body.get(), copy.get()}) {
    each->read(SettableList::state, words);
    for (std::size_t place = 0; place < words.size(); ++place)
      EXPECT_EQ(words[place], *given[place]) << place;
  }
  body->act(0, std::vector<Word>{word_of(0.25F), word_of(FormPose::jump), word_of(-7)});
  body->step(0.5);
  body->read(SettableList::state, words);
  EXPECT_EQ(words.back(), word_of(1.25));
  EXPECT_EQ(words[12], word_of(FormPose::jump));
  MadeRows rows = {.dt_s = {0.5, 0.25},
                   .words = std::vector<Word>(2 * (1 + words.size())),
                   .outputs = std::vector<Word>(2 * 8),
                   .contacts = std::vector<std::uint8_t>(2 * 2),
                   .properties = std::vector<std::uint8_t>(2 * 2)};
  body->add_row(true, rows);
  body->act(1, {});
  body->add_row(false, rows);
  EXPECT_EQ(rows.count, 2U);
  EXPECT_EQ(rows.words[0], word_of(0.5));
  EXPECT_EQ(rows.words[words.size()], words.back());
  EXPECT_EQ(rows.words[words.size() + 1], word_of(0.25));
  EXPECT_EQ(rows.outputs[0], word_of(0.5F));
  EXPECT_EQ(rows.contacts, (std::vector<std::uint8_t>{0, 1, 0, 0}));
  EXPECT_EQ(rows.properties, (std::vector<std::uint8_t>{1, 1, 0, 1}));
}

struct MembersWithoutInitializer {
  double x;
  int count;
  void step(double dt_s) { x += dt_s; }
  void state(auto&& see) {
    see("x_px", x);
    see("count", count);
  }
};
TEST(See, AMemberWithoutInitializerIsZero) {
  for (const ValueInfo& value : core_for_test<MembersWithoutInitializer>().description.state.values)
    EXPECT_EQ(value.initial, 0U);
}

}  // namespace
}  // namespace hyrax
