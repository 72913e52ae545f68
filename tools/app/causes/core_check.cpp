#include "tools/app/causes/core_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "sim/cause/run_match.h"
#include "sim/core/traced_stepper.h"
#include "sim/trace/step_text.h"
#include "sim/trajectory/physics_model.h"
#include "tools/files/printable.h"
#include "tools/files/scenario_writer.h"

namespace hyrax {
namespace {

constexpr std::string_view kHeaderIsSame =
    "the core's step changed, its header did not: an included header or a compiler option";

// IEEE-754 does not fix the bits of other functions.
bool depends_on_library(const Expression& expression) {
  constexpr std::array<std::string_view, 16> kExact = {
      "fabs", "abs",       "sqrt",     "fma",  "floor", "ceil", "trunc",     "round",
      "rint", "nearbyint", "copysign", "fmin", "fmax",  "fmod", "remainder", "signbit"};
  return expression.op == Operator::call && std::ranges::find(kExact, expression.name) == kExact.end();
}

}  // namespace

CoreCheck::CoreCheck(const Core& core, const std::string& golden_folder, CoreCommands commands)
    : core_(core) {
  verdict_.golden_folder = golden_folder;
  verdict_.header_path = core.record.path;
  verdict_.commands = std::move(commands);
  program_step_ = read_step(core.record.step);
  if (program_step_)
    verdict_.paths = static_cast<std::int64_t>(program_step_->paths_of(CoreFunction::update).size());
  accepted_ = verdict_.read_accepted();
  if (accepted_) compare();
}

void CoreCheck::compare() {
  const AcceptedCore program = program_core(core_);
  if (!is_same_model(accepted_->model, program.model)) {
    verdict_.status = CoreStatus::not_proved;
    verdict_.why = fmt::format("the accepted core is of another class (found {}); this program's is {}",
                               accepted_->model, program.model);
    verdict_.exit_code = ExitCode::bad_input;  // As for golden files of another class.
    return;
  }
  accepted_step_ = read_step(accepted_->step);
  if (accepted_step_) accepted_core_ = playable_step(*accepted_step_, core_);
  verdict_.changes = core_changes(*accepted_, program, std::string(core_.record.path));
  if (accepted_->has_same_files(program) && accepted_->step == program.step) {
    verdict_.status = CoreStatus::accepted;
    return;
  }
  const StepProof proof = prove_equal("the accepted core", accepted_->record(), core_.record);
  verdict_.status = proof.is_equal ? CoreStatus::proved_equal : CoreStatus::not_proved;
  verdict_.why = proof.why;
}

CauseBase CoreCheck::base() const {
  const std::vector<HeaderChange> changes(verdict_.changes.begin(), verdict_.changes.end());
  return {
      .program = core_,
      .accepted = accepted_core_ ? &*accepted_core_ : nullptr,
      .has_further_members = accepted_step_ && accepted_step_->members.size() > kMembersOfRows,
      .why_not_played = why_not_played(),
      .is_same_core = verdict_.status == CoreStatus::accepted || verdict_.status == CoreStatus::proved_equal,
      .core_change =
          changes.empty() ? std::string(kHeaderIsSame) : changes_sentence(changes, core_.record.path),
      .calls_libm = accepted_step_ && std::ranges::any_of(accepted_step_->expressions, depends_on_library)};
}

std::string CoreCheck::why_not_played() const {
  if (!accepted_ || verdict_.status == CoreStatus::none) return verdict_.why;
  return "the accepted core cannot be played: " + (accepted_->step.empty() ? accepted_->why_incomplete
                                                   : accepted_step_        ? "its step cannot be interpreted"
                                                                           : verdict_.why);
}

bool CoreCheck::covers(const std::string& core_name) const {
  return accepted_ && accepted_->covers(core_name);
}

void CoreCheck::take_core_runs(const std::vector<const StoredRun*>& fresh) {
  verdict_.commands.accept.clear();  // Refused while a scenario differs.
  if (fresh.empty()) return;
  verdict_.status = CoreStatus::changed;
  verdict_.why.clear();
  if (!accepted_core_ || !program_step_) return;
  std::map<double, double> all;
  for (const HeaderChange& change : verdict_.changes)
    if (change.kind == HeaderChangeKind::constant) all[change.from.value] = change.to.value;
  if (with_constants(*accepted_step_, all) != *program_step_)
    return;  // Something else changed, too: a constant alone proves nothing.
  for (HeaderChange& change : verdict_.changes) {
    if (change.kind != HeaderChangeKind::constant) continue;
    const auto alone =
        playable_step(with_constants(*accepted_step_, {{change.from.value, change.to.value}}), core_);
    change.scenarios = std::ranges::count_if(
        fresh, [&](const StoredRun* run) { return match(*alone, run->scenario, *run).rows; });
  }
}

void CoreCheck::measure_beyond_library(std::int64_t flings) {
  if (flings == 0) {
    verdict_.why_not_beyond = "--flings 0";
    return;
  }
  Core accepted = *accepted_core_;
  accepted.constants = accepted.paper_match.constants;
  const bool has_constant_changed = std::ranges::any_of(
      verdict_.changes, [](const HeaderChange& change) { return change.kind == HeaderChangeKind::constant; });
  verdict_.beyond = measure_beyond(accepted, core_, flings,
                                   exact_end(has_constant_changed ? std::nullopt : accepted.constants));
}

std::string CoreCheck::unrecorded_sentence() {
  const std::vector<std::string> names = header_members(core_.record.header);
  MemberBits said = 0;
  std::string sentence;
  for (UnnoticedDifference& difference : verdict_.unnoticed)
    for (std::size_t member = 0; member < kStepMembersMax; ++member) {
      const MemberBits bit = MemberBits{1} << member;
      if ((difference.unrecorded & bit) == 0) continue;
      const std::string name = member < names.size() ? names[member] : member_name(member);
      difference.consequence += (difference.consequence.empty() ? "" : ", ") + name;
      if ((said & bit) == 0)
        sentence += fmt::format("{}{} is not recorded: describe it", sentence.empty() ? "" : "; ", name);
      said |= bit;
    }
  return sentence;
}

void CoreCheck::judge_differences(const std::vector<std::string>& scenarios_folders, std::int64_t flings) {
  const bool is_judged = verdict_.status == CoreStatus::changed || verdict_.status == CoreStatus::not_proved;
  if (!is_judged) return;
  if (!accepted_core_ || !program_step_) {
    verdict_.why_not_beyond =
        program_step_ ? why_not_played()
                      : fmt::format("this program's step is not complete: {}", core_.record.why_incomplete);
    return;
  }
  const StepPair pair(*accepted_step_, *program_step_,
                      shared_names(accepted_->text(), program_core(core_).text()));
  static_cast<LibraryNotice&>(verdict_) = notice(pair, *accepted_core_, core_, scenarios_folders);
  measure_beyond_library(flings);
  const bool is_found_beyond = verdict_.beyond && verdict_.beyond->other_bits.count > 0;
  const bool is_shown = (is_found_beyond && !verdict_.is_noticed) ||
                        std::ranges::any_of(verdict_.unnoticed, [](const UnnoticedDifference& one) {
                          return one.scenario.has_value();
                        });
  const std::string unrecorded = unrecorded_sentence();
  if (is_shown || !unrecorded.empty())
    verdict_.exit_code = more_serious(verdict_.exit_code, ExitCode::disagreed);
  if (is_shown || verdict_.is_noticed) verdict_.status = CoreStatus::changed;
  if (verdict_.status == CoreStatus::changed)
    verdict_.why.clear();
  else if (!unrecorded.empty())
    verdict_.why = unrecorded;
  else if (!verdict_.unnoticed.empty())
    verdict_.why = fmt::format("{} steps tried, none of other bits", verdict_.unnoticed.front().steps_tried);
  else if (!pair.are_setters_equal())
    verdict_.why = "the constructor or a setter is another one, and no scenario shows it";
}

CoreChecks::CoreChecks(const Core& core, const std::vector<std::string>& scenarios,
                       const std::string& golden_option)
    : core_(core), commands_(core_commands(scenarios, golden_option)) {}

void CoreChecks::judge_differences(const std::vector<Library>& libraries, std::int64_t flings) {
  std::map<std::string, std::vector<std::string>> scenarios_folders;  // By golden folder.
  for (const Library& library : libraries)
    scenarios_folders[library.golden_folder].push_back(library.scenarios_folder);
  for (const auto& [golden_folder, folders] : scenarios_folders)
    of(golden_folder).judge_differences(folders, flings);
}

std::string core_text(const CoreVerdict& verdict, bool is_alone, bool scenarios_agree) {
  if (verdict.status == CoreStatus::accepted) return "";
  std::string text = is_alone ? "core: " : fmt::format("core of {}: ", printable(verdict.golden_folder));
  if (verdict.status == CoreStatus::none) return text + verdict.why + "\n";
  if (verdict.status == CoreStatus::proved_equal) return text + std::string(kProvedEqualText);
  text += verdict.status == CoreStatus::changed
              ? "changed\n"
              : fmt::format("not proved equal to the accepted one: {}\n", verdict.why);
  if (verdict.changes.empty() && verdict.status == CoreStatus::changed)
    text += fmt::format("  {}\n", kHeaderIsSame);
  for (const HeaderChange& change : verdict.changes)
    text += fmt::format("  {}{}\n", change_text(change, verdict.header_path),
                        change.scenarios ? fmt::format("; alone reproduces {}", *change.scenarios) : "");
  std::set<std::string> printed;  // Scenarios, by their names.
  for (const UnnoticedDifference& unnoticed : verdict.unnoticed) {
    if (unnoticed.unrecorded != 0)
      text += fmt::format("  no scenario can notice `{}`: it changes {} alone, which no file holds\n",
                          unnoticed.text, unnoticed.consequence);
    else if (!unnoticed.scenario)
      text += fmt::format("  no scenario notices `{}`; {} steps tried, none of other bits\n", unnoticed.text,
                          unnoticed.steps_tried);
    else if (printed.insert(unnoticed.scenario->name).second)
      text += fmt::format("  no scenario notices `{}`, which changes results: this one, {}\n    {}\n",
                          unnoticed.text, unnoticed.consequence, to_text(to_json(*unnoticed.scenario), {}));
    else
      text += fmt::format("  no scenario notices `{}` either; {} shows it\n", unnoticed.text,
                          unnoticed.scenario->name);
  }
  if (verdict.beyond) text += beyond_text(*verdict.beyond);
  const auto& [accept, write_unnoticed, bless_all] = verdict.commands;
  if (!printed.empty() && !write_unnoticed.empty())
    text += fmt::format("  to write {}   {}\n", printed.size() == 1 ? "it  " : "them", write_unnoticed);
  const bool has_unrecorded = std::ranges::any_of(
      verdict.unnoticed, [](const UnnoticedDifference& one) { return one.unrecorded != 0; });
  const bool is_acceptable = scenarios_agree ? verdict.status == CoreStatus::changed || has_unrecorded
                                             : (!printed.empty() || has_unrecorded) && !verdict.is_noticed;
  if (is_acceptable && !accept.empty()) text += fmt::format("  to accept it    {}\n", accept);
  return text;
}

Json core_json(const CoreVerdict& verdict) {
  Json::Array unnoticed;
  for (const UnnoticedDifference& one : verdict.unnoticed)
    unnoticed.push_back(Json::Object{{"difference", one.text},
                                     {"scenario", one.scenario ? to_json(*one.scenario) : Json()},
                                     {"steps_tried", one.steps_tried}});
  Json::Object document = verdict.json(std::ssize(verdict.paths_taken), verdict.changes);
  document.emplace_back("unnoticed", std::move(unnoticed));
  if (verdict.status == CoreStatus::changed || verdict.status == CoreStatus::not_proved)
    document.emplace_back("beyond", verdict.beyond ? beyond_json(*verdict.beyond)
                                                   : Json::Object{{"why", verdict.why_not_beyond}});
  return document;
}

}  // namespace hyrax
