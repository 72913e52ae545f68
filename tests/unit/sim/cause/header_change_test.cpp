// A header's change is said in its own words, and layout is none; a traced step with another constant is that
// of a header with it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/cause/header_change.h"
#include "sim/core/listing_core.h"
#include "sim/core/shipped_core.h"
#include "sim/core/traced_stepper.h"
#include "sim/replay/replay.h"
#include "sim/trace/step_text.h"
#include "tests/unit/sim/replay/some_flings.h"
#include "tests/unit/sim/result/described.h"

namespace hyrax {
namespace {

constexpr std::string_view kHeader = R"(// A core.
#pragma once
class physics {
  static constexpr double GRAVITY = 1200.0;  ///< px/s^2.
  static constexpr double DRAG = -0.5;
  void update(double dt) {
    m_vy += GRAVITY * dt;
    m_vx *= DRAG;
    if (m_x < 0.0) {
      m_x = 0.0;
    }
  }
};
)";

std::string with(std::string_view from, std::string_view to) {
  std::string text(kHeader);
  return text.replace(text.find(from), from.size(), to);
}

HeaderChange only_change(const std::string& current) {
  const std::vector<HeaderChange> changes = header_changes(kHeader, current);
  EXPECT_EQ(changes.size(), 1u) << current;
  return changes.empty() ? HeaderChange{} : changes.front();
}

TEST(HeaderConstants, AreReadWithTheirSigns) {
  const std::vector<HeaderConstant> constants = header_constants(kHeader);
  ASSERT_EQ(constants.size(), 2u);
  EXPECT_EQ(constants[0].name, "GRAVITY");
  EXPECT_EQ(constants[0].value, 1200.0);
  EXPECT_EQ(constants[1].value, -0.5);
}

TEST(HeaderConstants, OfAFloatAreTheFloatsValue) {
  for (const char* const text : {"const double G = 0.1f;", "const float G = 0.1;", "const float G = 0.1F;"})
    EXPECT_EQ(header_constants(text).at(0).value, static_cast<double>(0.1F)) << text;
}

TEST(HeaderConstants, AreReadInEveryWayToGiveAValue) {
  for (const char* const text :
       {"const double G = 1250.0L;", "const double G = 0x1.388p+10;", "const int G = 0X4E2;",
        "constexpr double G{1250.0};", "constexpr double G = {1250.0};", "constexpr double G( 1250.0 );",
        "struct A { double a{2.0}; const double G{1250.0}; };",
        "// of \\\n const double A = 1.0;\nconst double G{1250};",
        "// of \\\r\n const double A = 1.0;\r\nconst double G = 1250.l;"}) {
    const std::vector<HeaderConstant> constants = header_constants(text);
    ASSERT_EQ(constants.size(), 1u) << text;
    EXPECT_EQ(constants[0].name, "G") << text;
    EXPECT_EQ(constants[0].value, 1250.0) << text;
  }
  EXPECT_EQ(header_constants("const double G{-0x1p-1f};").at(0).value, -0.5);
  for (const char* const text :
       {"const double G{};", "const double G[] = {1.0, 2.0};", "const double G = 1.0_m;",
        "double f() const { return 1.0; }", "double G{1.0};", "const double G = 0x;"})
    EXPECT_TRUE(header_constants(text).empty()) << text;
}

TEST(HeaderChanges, CommentsBlanksAndLineEndsAreNone) {
  EXPECT_TRUE(header_changes(kHeader, kHeader).empty());
  EXPECT_TRUE(header_changes(kHeader, with("// A core.", "/* Another\n text; */ // with words")).empty());
  EXPECT_TRUE(header_changes(kHeader, with("// A core.", "/*/ not its end */")).empty());
  EXPECT_TRUE(
      header_changes(kHeader, with("m_vy += GRAVITY * dt;", "m_vy +=\n   GRAVITY*dt ;\r\n\n")).empty());
  EXPECT_TRUE(
      header_changes(kHeader, with("// A core.", "// A core, \\\n m_x += 1; \\\r\n m_y += 1;")).empty());
  EXPECT_TRUE(header_changes("#define A 1 \\\n  + 2\nint b;", "#define A 1 + 2\nint b;").empty());
}

TEST(HeaderChanges, OfAConstantIsARowWithBothValues) {
  const HeaderChange change = only_change(with("1200.0", "1'250.0"));
  EXPECT_EQ(change.kind, HeaderChangeKind::constant);
  const Table table = changes_table({change, only_change(with("m_vx *= DRAG;", ""))});
  for (const auto& [name, value] : {std::pair("from", 1200.0), {"to", 1250.0}}) {
    const auto& numbers =
        std::get<std::vector<double>>(std::ranges::find(table.columns, name, &Column::name)->values);
    EXPECT_EQ(numbers[0], value) << name;
    EXPECT_TRUE(std::isnan(numbers[1])) << name;
  }
}

// What is said of each part of the header that has another text.
TEST(HeaderChanges, AreSaidInTheWordsApproved) {
  const std::string drag = "m_vx *= DRAG;", gravity = "m_vy += GRAVITY * dt;";
  std::string text;
  std::string accepted(kHeader);
  const auto add = [&](const std::string& current) {
    const std::vector<HeaderChange> changes = header_changes(accepted, current);
    for (const HeaderChange& change : changes) text += change_text(change) + "\n";
    text += "  " + changes_sentence(changes) + "\n";
  };
  for (const char* const value : {"1'250.0", "1.25e+3", "5E-1", ".5", "2.5F", "-3f"})
    add(with("1200.0", value));
  add(with("-0.5", "-0.25"));
  text += "A constant of the same value, or given by an expression\n";
  for (const char* const value : {"= 1.2e3", "= 2.0 * 600.0"}) add(with("= 1200.0", value));
  text += "A statement: a loop is one, a member's initial value and a list are\n";
  for (const std::string& statement :
       {std::string("m_vx *= 2 * DRAG;"), std::string(), drag + "\n    " + drag,
        std::string("if (m_vx < 0.0)   m_vx = -m_vx*( DRAG);"),
        std::string("for (int i = 0; i < 2; ++i) m_vx *= DRAG;"), std::string("double a{2.0};"),
        std::string("double a[] = {1.0, 2.0};")})
    add(with(drag, statement));
  text += "Two statements exchanged; three and a constant\n";
  add(with(gravity + "\n    " + drag, drag + "\n    " + gravity));
  std::string many = with(drag, "m_vx *= 2 * DRAG;");
  many.replace(many.find("m_x = 0.0"), 9, "m_x = 1.0");
  add(many);
  many.replace(many.find("1200.0"), 6, "980.0");
  add(many);
  many.replace(many.find("m_vy +="), 7, "m_vy -=");
  add(many);
  text += "A statement in a lambda in a call; an access specifier\n";
  accepted = with(drag, "each([](double& v) { v *= DRAG; v += 1; });");
  add(with(drag, "each([](double& v) { v *= DRAG; v += 2; });"));
  accepted = with("class physics {", "class physics {\n public:");
  add(with("class physics {", "class physics {\n private:"));
  expect_approved("tests/unit/sim/cause/header_changes.txt", text);
}

// The lines of the changes, in their order.
std::vector<std::int64_t> lines_of(std::string_view accepted, const std::string& current) {
  std::vector<std::int64_t> lines;
  for (const HeaderChange& change : header_changes(accepted, current)) lines.push_back(change.line);
  return lines;
}

TEST(HeaderChanges, ABlockEndsWithItsOwnBrace) {
  using Lines = std::vector<std::int64_t>;
  const std::string moved_into = with("    m_vx *= DRAG;", "    if (m_vy > 0.0) { m_vx *= DRAG; }");
  EXPECT_EQ(lines_of(kHeader, moved_into), (Lines{8, 8}));
  EXPECT_EQ(lines_of(moved_into, std::string(kHeader)), (Lines{8, 8}));
  const std::string around =
      with("    if (m_x < 0.0) {\n      m_x = 0.0;\n    }",
           "    if (m_y < 0.0) {\n      if (m_x < 0.0) {\n        m_x = 0.0;\n      }\n    }");
  EXPECT_EQ(lines_of(kHeader, around), (Lines{9, 13}));
  EXPECT_EQ(lines_of(around, std::string(kHeader)), (Lines{9, 13}));
  const std::string at_its_end = with("m_x = 0.0;", "if (m_y < 0.0) { m_x = 0.0; }");
  EXPECT_EQ(lines_of(kHeader, at_its_end), (Lines{10, 10}));
  EXPECT_EQ(lines_of(kHeader, with("m_x = 0.0;\n",
                                   "m_x = 0.0;\n      if (m_y < 0.0) {\n        m_y = 0.0;\n      }\n")),
            (Lines{11, 12, 13}));
}

TEST(HeaderChanges, LinesAreCountedInWhateverIsAboveThem) {
  for (const auto& [above, lines] : {std::pair(" \r\n\n", 2),
                                     {"// one\n", 1},
                                     {"/* one\n two\n */\n", 3},
                                     {"#define A 1 \\\n + 2\n", 2},
                                     {"#define A \"b\\\n c\"\n", 2},
                                     {"int a =\n    1;\n", 2}}) {
    std::string current = above + with("1200.0", "1250.0");
    current.replace(current.find("m_vx *= DRAG;"), 13, "m_vx *=\n 2 *\n DRAG;");
    EXPECT_EQ(lines_of(above + std::string(kHeader), current),
              (std::vector<std::int64_t>{4 + lines, 8 + lines}))
        << above;
  }
}

TEST(HeaderLiterals, AreTheNumbersThatAreNotThoseOfConstants) {
  EXPECT_EQ(header_literals(with("m_vx *= DRAG;", "if (dt < 1200) m_vx *= 0.5f * DRAG;")),
            (std::vector{1200.0, 0.5, 0.0, 0.0}));
}

TEST(HeaderMembers, AreThoseOfTheGettersThenTheOthers) {
  const std::string header = R"(namespace a {
class other { double m_other; };
class physics {
 public:
  static constexpr double G = 1.0;
  double x() const { return m_x; }
  double y() const { return m_y; } double vx() const { return v; }
  double vy() const { return w; }
  void update(double dt) { double local = dt; if (dt > 0.0) { int i; } m_spin += local; }
 private:
  double m_spin = 0.0, v, w;
  int m_count{3};
  double m_y, m_x;
  bool m_on;
};
class last { double m_last; };
})";
  EXPECT_EQ(header_members(header),
            (std::vector<std::string>{"m_x", "m_y", "v", "w", "m_spin", "m_count", "m_on"}));
  EXPECT_TRUE(header_members(with("m_vx", "m_vy")).empty());
  EXPECT_EQ(header_members(shipped_core().record.header),
            (std::vector<std::string>{"m_x", "m_y", "m_vx", "m_vy"}));
}

TEST(HeaderChanges, OfUnclosedTextsEnd) {
  for (const char* const text : {"/* open", "\"open", "'", "#define", "a\\", "1e", "/"})
    EXPECT_FALSE(header_changes(kHeader, text).empty()) << text;
}

TEST(StepProof, NeedsTwoCompleteStepsOfTheSameText) {
  const CoreRecord one{.header = "a", .step = "one"}, same{.header = "b", .step = "one"},
      other{.header = "a", .step = "other"}, incomplete{.header = "a", .why_incomplete = "many paths"};
  EXPECT_TRUE(prove_equal("base.h", one, same).is_equal);
  EXPECT_FALSE(prove_equal("base.h", one, other).is_equal);
  EXPECT_TRUE(prove_equal("base.h", one, other).is_complete);
  EXPECT_FALSE(prove_equal("base.h", incomplete, incomplete).is_equal);
  EXPECT_EQ(prove_equal("base.h", one, same).why, "");
  EXPECT_EQ(prove_equal("base.h", one, other).why,
            "its step is another one; no step is known whose bits differ");
  EXPECT_EQ(prove_equal("base.h", one, incomplete).why, "many paths");
  EXPECT_EQ(prove_equal("base.h", incomplete, one).why, "the step of base.h is not complete: many paths");
}

TEST(StepProof, LeavesOutComparisonsThatDecideNothing) {
  TracedStep step = read_step(shipped_core().record.step).value();
  std::vector<StepPath>& paths = step.paths[static_cast<std::size_t>(CoreFunction::set_position)];
  paths[0].outcomes = {{0, false}};
  paths.push_back(paths[0]);
  const std::string text_of_half = step_text(step);
  paths[1].outcomes[0].holds = true;
  const std::string earlier = step_text(step);
  const CoreRecord of_earlier{.step = earlier}, of_half{.step = text_of_half},
      now{.step = shipped_core().record.step};
  EXPECT_TRUE(prove_equal("base.h", of_earlier, now).is_equal);
  EXPECT_FALSE(prove_equal("base.h", of_half, now).is_equal);
}

TracedStep shipped_step() { return read_step(shipped_core().record.step).value(); }

Digest hash_of(const Core& core) { return replay(core, eventful_fling()).state_hash; }

TEST(WithConstants, PlaysAsTheListingWithThatConstant) {
  for (const double gravity : {1250.0, -1200.0, 0.0, -0.0}) {
    Constants constants = shipped_core().constants.value();
    constants.gravity_px_per_s2 = gravity;
    const std::optional<Core> core = traced_core(with_constants(shipped_step(), {{1200.0, gravity}}));
    EXPECT_EQ(hash_of(core.value()), hash_of(listing_core(constants))) << gravity;
  }
}

TEST(WithConstants, IsCanonicalAndGoesBack) {
  const TracedStep step = shipped_step();
  for (const double gravity : {1250.0, -1200.0}) {
    const TracedStep changed = with_constants(step, {{1200.0, gravity}});
    EXPECT_NE(changed, step);
    EXPECT_EQ(read_step(step_text(changed)), changed);
    EXPECT_EQ(with_constants(changed, {{gravity, 1200.0}}), step);
  }
  EXPECT_EQ(with_constants(step, {{1201.0, 1250.0}}), step);
  const TracedStep swapped = with_constants(step, {{0.6, 0.8}, {0.8, 0.6}});
  EXPECT_NE(swapped, step);
  EXPECT_EQ(with_constants(swapped, {{0.6, 0.8}, {0.8, 0.6}}), step);
}

}  // namespace
}  // namespace hyrax
