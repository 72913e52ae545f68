// Texts about a user's own core, about a core that differs from the accepted one, and about contacts of which
// a list is full.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>

#include "sim/cause/watched_core.h"
#include "sim/core/shipped_core.h"
#include "sim/core/traced_stepper.h"
#include "sim/trace/step_program.h"
#include "tests/unit/sim/replay/some_flings.h"
#include "tests/unit/sim/result/described.h"
#include "tests/unit/sim/trace/recording.h"
#include "tests/unit/tools/files/refusal.h"
#include "tests/unit/tools/store/temp_folder.h"
#include "tools/app/causes/core_check.h"
#include "tools/app/core/accepted_core.h"
#include "tools/app/core/core_requirements.h"
#include "tools/app/expect/judged_run.h"
#include "tools/app/runs/scenario_run.h"
#include "tools/files/scenario_writer.h"

namespace hyrax {
namespace {

Core own_core(bool has_constants) {
  Core core = shipped_core();
  core.name = "my-physics/3";
  core.record.header = "constexpr double GRAVITY = 1250.0;\nconstexpr double AIR_DRAG = 0.4;\n";
  core.record.why_incomplete = "more than 4,096 paths";
  core.paper_match.difference = "vx * 2";
  core.walls_of_rows = kAllWalls;
  if (has_constants)
    core.constants->air_drag = 0.4;
  else
    core.constants.reset();
  return core;
}

std::string section(const std::string& what, const std::string& text) {
  return "# " + what + "\n" + text + "\n";
}

std::string run_texts() {
  const TempFolder folder;
  const Core core = own_core(false);
  ScenarioRun run =
      run_scenario(core, "x.json", fling_at(60.0, 200), folder.at("run.csv"), {.measures_start = false});
  run.output = "run.csv";
  testing::internal::CaptureStdout();
  print_run(core, run, {});
  const std::string text = section("a run", testing::internal::GetCapturedStdout()) +
                           section("its entry", to_text(run_json(core, run), 1));
  run.summary.final.x_px = -std::numeric_limits<double>::quiet_NaN();
  testing::internal::CaptureStdout();
  print_run(core, run, {});
  EXPECT_NE(testing::internal::GetCapturedStdout().find("end            x NaN px, y "), std::string::npos);
  return text;
}

std::string refusals() {
  Scenario scenario = fling_at(60.0, 9);
  std::string text;
  for (const bool has_constants : {false, true}) {
    const Core core = own_core(has_constants);
    text += refusal_of([&] { require_paper_core(core, "hyrax-sim drift"); }) + "\n";
    for (const auto member :
         {&Expect::implementation_px_max, &Expect::truncation_px_max, &Expect::energy_drift_rel_max}) {
      scenario.expect.emplace().*member = 1.0;
      text += refusal_of([&] { require_measurable(core, "x.json", scenario); }) + "\n";
    }
  }
  text += refusal_of([] { require_own_core(own_core(true), "run.h5", "hyrax-physics/1"); }) + "\n";
  require_own_core(shipped_core(), "run.h5", "hyrax-physics/7");
  return section("refused", text);
}

std::string of_another_class() {
  const TempFolder folder;
  AcceptedCore accepted = program_core(own_core(true));
  accepted.step.clear();
  accepted.reason = "two lines";
  write_accepted_core(folder.at(""), accepted);
  const Core core = shipped_core();
  const CoreCheck check(core, folder.at(""), {"accept it", "write them"});
  EXPECT_EQ(check.verdict().exit_code, ExitCode::bad_input);
  return section("accepted before", bytes_of(folder.at("core/accepted.txt"))) +
         section("another class", core_text(check.verdict()));
}

// What each change of the accepted core's files is called.
std::string damages() {
  const Core core = shipped_core();
  std::string text;
  const auto damage = [&](const char* file, const auto& change) {
    const TempFolder folder;
    write_accepted_core(folder.at("golden"), program_core(core));
    change(folder.at(std::string("golden/core/") + file));
    const CoreCheck check(core, folder.at("golden"), {});
    EXPECT_EQ(check.verdict().exit_code, ExitCode::disagreed) << file;
    text += std::regex_replace(check.verdict().why, std::regex(folder.at("")), "") + "\n";
  };
  const auto more = [](const std::string& path) { write_bytes(path, bytes_of(path) + "\n"); };
  const auto first = [](const std::string& path) { write_bytes(path, "x" + bytes_of(path)); };
  const auto none = [](const std::string& path) { std::filesystem::remove(path); };
  for (const char* const file : {"physics.h", "step.txt", "accepted.txt"}) {
    damage(file, more);
    damage(file, none);
  }
  damage("accepted.txt", first);
  damage("accepted.txt", [](const std::string& path) {
    const std::string kept = bytes_of(path);
    const std::size_t step = kept.find("\nstep: ") + 7;
    write_bytes(path, kept.substr(0, step) + "not complete: a reason" + kept.substr(kept.find('\n', step)));
  });
  damage("step.txt", [](const std::string& path) {
    std::filesystem::remove(path);
    std::filesystem::create_symlink("/dev/null", path);
  });
  return section("damaged", text);
}

std::string verdicts() {
  CoreVerdict verdict;
  verdict.golden_folder = "golden";
  verdict.why = "a reason";
  verdict.commands = {"accept it", "write them"};
  verdict.paths_taken = {3, 5};
  std::string text;
  for (const CoreStatus status : {CoreStatus::none, CoreStatus::accepted, CoreStatus::proved_equal,
                                  CoreStatus::changed, CoreStatus::not_proved}) {
    verdict.status = status;
    text += section("status", core_text(verdict) + core_text(verdict, false, true));
  }
  verdict.status = CoreStatus::changed;
  verdict.changes = {{HeaderChangeKind::constant,
                      "GRAVITY 1200 -> 1250",
                      16,
                      {"GRAVITY", 1200.0},
                      {"GRAVITY", 1250.0},
                      "",
                      4},
                     {HeaderChangeKind::added, "a line", 20, {}, {}}};
  Scenario scenario = fling_at(60.0, 1);
  scenario.name = "unnoticed-1";
  verdict.unnoticed = {{"vx > 1", scenario, "played for 5 s, ends 3 px apart", 7},
                       {"vx > 2", scenario, "the same", 7},
                       {"vx > 3", std::nullopt, "", 300'000}};
  text += section("unnoticed", core_text(verdict));
  scenario.name = "unnoticed-2";
  verdict.unnoticed.push_back({"vx > 4", scenario, "played for 5 s, ends 4 px/s apart", 9});
  text += section("more unnoticed", core_text(verdict)) + section("as JSON", to_text(core_json(verdict), 2));
  verdict.unnoticed.clear();
  BeyondLibrary beyond{.other_bits = {0, 1000}, .end_error_px = {{41.0, 12.0}}};
  for (const double current_px : {12.0, 41.0, 1234.5}) {
    beyond.end_error_px->current = current_px;
    verdict.beyond = beyond;
    text += section("beyond", core_text(verdict));
    beyond.other_bits.count = 998;
    beyond.ends_elsewhere = {612, 1000};
    beyond.apart_px = {612, 41.25, 1.0, std::numeric_limits<double>::infinity()};
    beyond.other_bounces = {300, 1000};
    beyond.settles_in_one = {1, 1000};
  }
  return text + section("beyond, as JSON", to_text(core_json(verdict), 2));
}

TEST(OwnCore, TextsAreThoseApproved) {
  expect_approved("tests/unit/tools/app/own_core.txt",
                  run_texts() + refusals() + of_another_class() + damages() + verdicts());
}

// Falls, counts its steps, and becomes slower after the third.
template <int kFirst>
struct CountingBody : recording::Body {
  recording::Real steps = kFirst;
};
template <int kFirst = 0>
TracedStep counting(double factor, double pull = 1.0) {
  return canonical(recording::record_of<CountingBody<kFirst>>([=](auto& body, const recording::Frame& frame) {
    body.steps = body.steps + recording::Real(1.0);
    if (body.steps > 3.0) body.vx = body.vx * recording::Real(factor);
    body.vy = body.vy + recording::Real(pull);
    body.x = body.x + body.vx * frame.dt;
  }));
}

// The verdict on the step, against an accepted counting(0.5) and libraries: `scenarios` is of one scenario.
CoreVerdict verdict_on(const TracedStep& step, const Scenario& scenario,
                       const std::vector<std::string>& libraries = {"scenarios"}) {
  const TempFolder folder;
  std::filesystem::create_directories(folder.at("scenarios"));
  write_bytes(folder.at("scenarios/fling.json"), scenario_file_text(scenario));
  write_accepted_core(folder.at("golden"), {.model = std::string(shipped_core().name),
                                            .header = "",
                                            .step = step_text(counting(0.5)),
                                            .why_incomplete = "",
                                            .agreeing_cores = {},
                                            .reason = "x"});
  Core core = *traced_core(step);
  const std::string text = step_text(step);
  core.record.step = text;
  CoreCheck check(core, folder.at("golden"), {"accept it", "write them"});
  std::vector<std::string> folders;
  for (const std::string& library : libraries) folders.push_back(folder.at(library));
  check.judge_differences(folders, 20);
  return check.verdict();
}

TEST(CoreCheck, SeesWhatFurtherMembersHoldInTheScenariosOfTheLibrary) {
  for (const TracedStep& step : {counting(0.25), counting<2>(0.5)}) {
    const CoreVerdict verdict = verdict_on(step, fling_at(60.0, 9));
    EXPECT_EQ(verdict.status, CoreStatus::changed) << verdict.why;
    EXPECT_TRUE(verdict.is_noticed && verdict.unnoticed.empty());
  }
}

TEST(CoreCheck, SearchesNothingThatOneOfTheLibrariesNotices) {
  const CoreVerdict verdict = verdict_on(counting(0.25), fling_at(60.0, 9), {"scenarios", "of no scenario"});
  EXPECT_TRUE(verdict.is_noticed && verdict.unnoticed.empty());
}

TEST(CoreCheck, ShowsWhatIsUnnoticedByAScenarioThatEvaluatesItBesideAnotherDifference) {
  const CoreVerdict verdict = verdict_on(counting(0.25, 2.0), fling_at(60.0, 3));
  ASSERT_FALSE(verdict.unnoticed.empty());
  for (const UnnoticedDifference& unnoticed : verdict.unnoticed) {
    ASSERT_TRUE(unnoticed.scenario) << unnoticed.text;
    EXPECT_GE(std::get<std::int64_t>(unnoticed.scenario->length), 4) << unnoticed.text;
  }
  EXPECT_TRUE(verdict.is_noticed);
  EXPECT_EQ(core_text(verdict).find("accept it"), std::string::npos);
}

TEST(WatchedCore, TakesThePathsThatFurtherMembersDecide) {
  const TracedStep step = counting(0.5);
  std::set<std::uint32_t> paths;
  const auto note = [&](const StepInput& input, std::span<TracedBody> bodies) {
    bodies.front().update(input);
    paths.insert(bodies.front().path());
  };
  static_cast<void>(play(watched(*traced_core(step), {make_step_program(step)}, note), fling_at(60.0, 9)));
  EXPECT_EQ(paths.size(), 2U);
}

TEST(FullContacts, AreSaidToBeTheFewestThatMoved) {
  PairVerdict scenario;
  scenario.path = "scenarios/full.json";
  ContactChanges& contacts = scenario.comparison.contacts;
  contacts.is_cut = true;
  CoreChecks cores(shipped_core(), {}, "");
  for (const std::string text : {"no compared contact moved", "at least 3 contacts moved"}) {
    const DifferenceGroup group = group_by_cause({&scenario}, cores).front();
    EXPECT_TRUE(consequence_sentence(group).ends_with("no position differs, " + text + "."));
    EXPECT_EQ(scenario.consequence(), "no position differs, " + text);
    contacts.moved.resize(3);
  }
  scenario.comparison.difference = DifferenceClass::values;
  EXPECT_TRUE(consequence_sentence(group_by_cause({&scenario}, cores).front())
                  .starts_with("Values differ (class values)"));
}

// A core whose header includes files, which are kept and compared.
TEST(OwnCore, IsAcceptedWithTheFilesThatItsHeaderIncludes) {
  const TempFolder folder;
  Core core = own_core(true);
  std::array files = {CoreFile{"/usr/fast.h", "int fast;\n", false},
                      CoreFile{"src/deep/pull.h", "constexpr double PULL = 9.0;\n", true}};
  core.record.step = {};
  core.record.path = "src/core.h";
  core.record.files = files;
  write_accepted_core(folder.at(""), program_core(core));
  EXPECT_EQ(bytes_of(folder.at("core/files/src/deep/pull.h")), files[1].text);
  EXPECT_NE(bytes_of(folder.at("core/accepted.txt")).find(", AIR_DRAG 0.4, PULL 9\n"), std::string::npos);
  const auto verdict = [&] { return CoreCheck(core, folder.at(""), {}).verdict(); };
  EXPECT_EQ(verdict().status, CoreStatus::accepted);
  core.record.files = {};  // As what an older version accepted: nothing is known of them.
  EXPECT_EQ(verdict().status, CoreStatus::accepted);
  core.record.files = files;
  files[0].path = "/opt/here/fast.h";  // As on another machine.
  EXPECT_EQ(verdict().status, CoreStatus::accepted);
  files[1].text = "\nconstexpr double PULL = 9.5;\n";
  EXPECT_EQ(verdict().status, CoreStatus::not_proved);
  EXPECT_EQ(core_text(verdict()),
            "core: not proved equal to the accepted one: more than 4,096 paths\n"
            "  line 2    constant: PULL 9 -> 9.5 (src/deep/pull.h)\n");
  files[0].text = "int slow;\n";
  EXPECT_NE(core_text(verdict()).find("altered: a file outside the project (/opt/here/fast.h)"),
            std::string::npos);
  files[1].path = "src/push.h";
  EXPECT_EQ(changes_sentence(header_changes("int a;", "int b;", "src/push.h"), "src/core.h"),
            "the core changed at line 1 of src/push.h");
  EXPECT_NE(core_text(verdict()).find("removed: constexpr double PULL = 9.0; (src/deep/pull.h)"),
            std::string::npos);
  write_bytes(folder.at("core/files/src/deep/pull.h"), "");
  EXPECT_NE(verdict().why.find("files/src/deep/pull.h: does not have the checksum"), std::string::npos);
}

TEST(AcceptedCore, KeepsOneHeaderWhateverItsNameIs) {
  const TempFolder folder;
  AcceptedCore core = program_core(own_core(true));
  for (const char* const name : {"toy_core.h", "toy2_core.h"}) {
    core.header_name = name;
    write_accepted_core(folder.at(""), core);
    EXPECT_EQ(bytes_of(folder.at(std::string("core/") + name)), core.header);
  }
  EXPECT_FALSE(std::filesystem::exists(folder.at("core/toy_core.h")));
}

// A file that the accepted core does not list may be as it was.
TEST(OwnCore, OfAnOlderAcceptedCoreTheHeaderAloneIsCompared) {
  const TempFolder folder;
  Core core = own_core(true);
  core.record.step = {};
  write_accepted_core(folder.at(""), program_core(core));
  const std::array files = {CoreFile{"/usr/fast.h", "int fast;\n", false},
                            CoreFile{"src/pull.h", "int pull;\n", true}};
  core.record.files = files;
  const std::string header = std::string(core.record.header) + "int more;\n";
  core.record.header = header;
  const std::vector<HeaderChange> changes = CoreCheck(core, folder.at(""), {}).verdict().changes;
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_EQ(changes.front().detail, "int more;");
}

}  // namespace
}  // namespace hyrax
