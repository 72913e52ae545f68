// Units, faults of names, pairs, and what differs between two descriptions.
#include <gtest/gtest.h>

#include "tests/unit/sim/described/core_for_test.h"

namespace hyrax {
namespace {

Description description_of(const std::vector<std::string>& names) {
  Description description;
  for (const std::string& name : names)
    description.state.values.push_back({.name = name, .unit = unit_of(name)});
  return description;
}

TEST(UnitOf, IsTheLongestKnownEndingOfTheLastPartThatIsNoNumber) {
  const std::pair<const char*, const char*> units[] = {{"x_px", "px"},
                                                       {"a.x_px", "px"},
                                                       {"x_px.0", "px"},
                                                       {"spin_rad_per_s", "rad/s"},
                                                       {"a_deg_per_s2", "deg/s^2"},
                                                       {"x_m", "m"},
                                                       {"wait_s", "s"},
                                                       {"tone_hz", "Hz"},
                                                       {"turns_per_s", ""},
                                                       {"hz_per_s", ""},
                                                       {"tone_hz_per_s", ""},
                                                       {"energy_px2_per_s2", ""},
                                                       {"px", ""},
                                                       {"a.b.3.4", ""},
                                                       {"v_m_per_s.1.2", "m/s"}};
  for (const auto& [name, unit] : units) EXPECT_EQ(unit_of(name), unit) << name;
}

TEST(FaultsOf, NamesAreToldAllAtOnce) {
  EXPECT_EQ(faults_of(description_of({"x", "x_px", "a.x_px", "xs.0", "b_2.13.q"})),
            std::vector<std::string>{});
  for (const char* name : {"", "X", "0", "0.x", ".x", "x.", "a..b", "a b", "_x", "a.-1", "\xc3\xa4"})
    EXPECT_EQ(faults_of(description_of({name})).size(), 1U) << name;
  EXPECT_EQ(faults_of(description_of({"t", "step", "x", "x", "Y"})),
            (std::vector<std::string>{"state 't': the name is reserved", "state 'step': the name is reserved",
                                      "state 'x': duplicate name",
                                      "state 'Y': a name is parts [a-z][a-z0-9_]* joined by dots"}));
  EXPECT_EQ(faults_of(description_of({})), std::vector<std::string>{"state: declares no value"});
  Description description = description_of({"x"});
  description.contacts = {"x"};
  description.actions = {{"hold", {}}, {"kick", {{.name = "a"}, {.name = "a"}}}, {"x", {}}};
  description.properties = {{"p", true}, {"p", false}};
  EXPECT_EQ(
      faults_of(description),
      (std::vector<std::string>{"contact 'x': duplicate name", "action 'hold': the name is reserved",
                                "argument of kick 'a': duplicate name", "property 'p': duplicate name"}));
}

TEST(FaultsOf, ADefaultIsWithinItsLimitsAndNames) {
  Description description = description_of({"x", "y"});
  ValueInfo& x = description.state.values[0];
  x.limits = {word_of(1.0), word_of(2.0)};
  EXPECT_EQ(faults_of(description), std::vector<std::string>{"state 'x': the default is outside the limits"});
  x.initial = word_of(2.0);
  EXPECT_TRUE(faults_of(description).empty());
  x.limits = {word_of(3.0), word_of(2.0)};
  EXPECT_EQ(faults_of(description),
            std::vector<std::string>{"state 'x': the low limit is above the high one"});
  x.limits.reset();
  ValueInfo& y = description.state.values[1];
  y.type = ValueType::int32;
  y.names = {"calm", "wild"};
  EXPECT_TRUE(faults_of(description).empty());
  y.initial = 2;
  EXPECT_EQ(faults_of(description), std::vector<std::string>{"state 'y': the default has no name"});
}

TEST(PositionPairs, AreNamesThatDifferInOneWord) {
  const Description description =
      description_of({"a.x_px", "a.y_px", "ball_x_px", "ball_y_px", "x_px.0", "x_px.1", "y_px.0", "y_px.1",
                      "vx_px_per_s", "vy_px_per_s", "alone.x_px", "x_m", "y_m", "x_px", "y_px"});
  std::vector<std::string> names;
  for (const PositionPair& pair : position_pairs(description)) {
    EXPECT_EQ(description.state.values[pair.y].unit, "px");
    names.push_back(description.state.values[pair.x].name + "," + description.state.values[pair.y].name +
                    "=" + pair.name);
  }
  EXPECT_EQ(names, (std::vector<std::string>{"a.x_px,a.y_px=a", "ball_x_px,ball_y_px=ball", "x_px.0,y_px.0=0",
                                             "x_px.1,y_px.1=1", "x_px,y_px="}));
}

TEST(DescriptionDifference, IsOneSentence) {
  const Description before = description_of({"a", "b", "c"});
  EXPECT_EQ(description_difference(before, before), "");
  EXPECT_EQ(description_difference(before, description_of({"a", "b", "c", "d"})), "value d was added");
  EXPECT_EQ(description_difference(before, description_of({"a", "c"})), "value b was removed");
  EXPECT_EQ(description_difference(before, description_of({"a", "q", "c"})), "value b was renamed q");
  EXPECT_EQ(description_difference(before, description_of({"b", "a", "c"})),
            "value b has another place in its list");
  Description after = before;
  after.state.values[1].type = ValueType::int32;
  EXPECT_EQ(description_difference(before, after), "value b is int32, was float64");
  after = before;
  after.state.values[1].initial = 7;  // A changed default is tried by `check`; it is no other description.
  EXPECT_EQ(description_difference(before, after), "");
  after.actions = {{"kick", {}}};
  EXPECT_EQ(description_difference(before, after), "action kick was added");
}

}  // namespace
}  // namespace hyrax
