#include "tools/described/core_verdict.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <utility>

#include "sim/described/described_step.h"
#include "sim/described/interpreted_core.h"
#include "sim/described/scripted_body.h"
#include "sim/trace/step_text.h"
#include "tools/described/value_json.h"
#include "tools/files/summary_text.h"
#include "tools/files/text_file.h"
#include "tools/platform/path.h"

namespace hyrax {
namespace {

std::string header_name(const DescribedCore& core) {
  const FileName name = file_name(core.record.path);
  return std::string(name.stem) + std::string(name.extension);
}

// REQUIRES: the same names and types.
void add_defaults(const Description& before, const Description& now, DescribedCoreVerdict& verdict) {
  for (const SettableList list : {SettableList::parameters, SettableList::state}) {
    const std::vector<ValueInfo>& values = list_of(now, list).values;
    for (std::size_t place = 0; place < values.size(); ++place) {
      const ValueInfo &from = list_of(before, list).values[place], &to = values[place];
      if (from.initial == to.initial) continue;
      DescribedChange& change = verdict.changes.emplace_back();
      change.kind = HeaderChangeKind::constant;
      change.detail =
          fmt::format("{} {} -> {}", to.name, value_text(to, from.initial), value_text(to, to.initial));
      change.from = {from.name, shown_number_of(from.type, from.initial)};
      change.to = {to.name, shown_number_of(to.type, to.initial)};
      change.file = "description.json";
      change.of_default = {list, place, from.initial};
    }
  }
}

// With the default set, unless the scenario sets that value itself.
DescribedScenario with_default(DescribedScenario scenario, const DefaultChange& change) {
  std::vector<GivenValue>& given =
      change.list == SettableList::parameters ? scenario.parameters : scenario.start;
  const auto at = std::ranges::lower_bound(given, change.place, {}, &GivenValue::first);
  if (at == given.end() || at->first != change.place) given.insert(at, {change.place, change.before});
  return scenario;
}

// As the build recorded it.
AcceptedCore recorded_core(const DescribedCore& core) {
  AcceptedCore accepted = core_of(kDescribedModel, core.record);
  accepted.header_name = header_name(core);
  accepted.description = to_text(description_json(core.description), 3) + "\n";
  return accepted;
}

// REQUIRES: the same names and types.
void compare_steps(const AcceptedCore& accepted, const AcceptedCore& program, DescribedCoreVerdict& verdict) {
  const StepProof proof = prove_equal("the accepted core", accepted.record(), program.record());
  if (proof.is_complete && !proof.is_equal) {
    verdict.status = CoreStatus::changed;
    if (accepted.description == program.description) verdict.accepted_step = read_step(accepted.step);
    verdict.differences = value_differences(*read_step(accepted.step), *read_step(program.step),
                                            shared_names(accepted.text(), program.text()));
  } else if (verdict.status == CoreStatus::changed && !proof.is_complete) {
    verdict.why = program.step.empty() ? "the step is not complete: " + proof.why : proof.why;
  } else if (verdict.status == CoreStatus::changed && accepted.description == program.description) {
    verdict.status = CoreStatus::proved_equal;
  }
}

void compare(const DescribedCore& core, const AcceptedCore& accepted, DescribedCoreVerdict& verdict) {
  const AcceptedCore recorded = recorded_core(core);
  if (accepted.has_same_files(recorded) && accepted.description == recorded.description &&
      accepted.step == recorded.step) {
    verdict.status = CoreStatus::accepted;
    return;
  }
  const AcceptedCore program = program_core(core);
  if (program.step.empty()) verdict.paths.reset();
  if (accepted.model != program.model) {
    verdict.why = fmt::format("the accepted core does not describe itself (found {})", accepted.model);
    verdict.exit_code = ExitCode::bad_input;
    return;
  }
  const bool is_same_description = accepted.description == program.description;
  verdict.status =
      accepted.has_same_files(program) && is_same_description ? CoreStatus::accepted : CoreStatus::changed;
  for (HeaderChange& change : core_changes(accepted, program, verdict.header_path))
    verdict.changes.push_back({std::move(change)});
  if (is_same_description) return compare_steps(accepted, program, verdict);
  const Description before =
      parse_description(accepted.description, core.description.core,
                        accepted_core_folder(verdict.golden_folder) + "/description.json");
  const std::string difference = description_difference(before, core.description);
  if (difference.empty()) {
    compare_steps(accepted, program, verdict);
    return add_defaults(before, core.description, verdict);
  }
  HeaderChange& change = verdict.changes.emplace_back();
  change.detail = difference;
  change.file = "description.json";
}

}  // namespace

AcceptedCore program_core(const DescribedCore& core) {
  AcceptedCore accepted = recorded_core(core);
  accepted.why_incomplete = described_step(core).why_incomplete;
  if (!accepted.why_incomplete.empty()) accepted.step.clear();
  return accepted;
}

std::string DescribedCoreVerdict::sentence() const {
  std::string sentence;  // Of the description, which has no lines.
  std::vector<HeaderChange> of_lines;
  for (const DescribedChange& change : changes)
    if (change.line > 0)
      of_lines.push_back(change);
    else
      sentence += (sentence.empty() ? "" : ", ") + change.detail;
  // A changed default has lines, too, but is no change of the step.
  if (of_lines.empty() || (!sentence.empty() && differences.empty())) return sentence;
  return sentence + (sentence.empty() ? "" : "; ") + changes_sentence(of_lines, header_path);
}

std::string DescribedCoreVerdict::text(bool scenarios_agree) const {
  if (status == CoreStatus::accepted) return "";
  if (status == CoreStatus::none) return fmt::format("core: {}\n", why);
  if (status == CoreStatus::proved_equal) return fmt::format("core: {}", kProvedEqualText);
  std::string text = "core: changed\n";
  if (changes.empty())
    text += differences.empty() ? "  comments or layout only\n"
                                : "  the step changed, its files did not: a compiler option\n";
  for (const DescribedChange& change : changes)
    text += fmt::format("  {}{}\n",
                        change.line > 0 ? change_text(change, header_path)
                                        : (change.of_default ? "default: " : "description: ") + change.detail,
                        change.scenarios ? fmt::format("; alone reproduces {}", *change.scenarios) : "");
  const auto texts = [](const std::vector<std::string>& expressions) {
    return expressions.empty() ? "none" : fmt::format("`{}`", fmt::join(expressions, "`, `"));
  };
  for (const ValueDifference& each : differences)
    text += fmt::format("  {}: {}{} -> {}\n", each.function,
                        each.values.empty() ? "" : fmt::format("{}: ", fmt::join(each.values, ", ")),
                        texts(each.before), texts(each.after));
  if (!why.empty()) text += fmt::format("  not compared: {}\n", why);
  return text + (scenarios_agree && !commands.accept.empty()
                     ? fmt::format("  to accept it    {}\n", commands.accept)
                     : "");
}

Json DescribedCoreVerdict::json() const {
  const auto texts = [](const std::vector<std::string>& list) {
    return Json::Array(list.begin(), list.end());
  };
  Json::Object document = CoreFinding::json(0, {changes.begin(), changes.end()});
  document.emplace_back("differences", list_of(differences, [&](const ValueDifference& each) {
                          return Json::Object{{"function", each.function},
                                              {"values", texts(each.values)},
                                              {"before", texts(each.before)},
                                              {"after", texts(each.after)}};
                        }));
  document.emplace_back("unnoticed", Json::Array());
  if (status == CoreStatus::changed) document.emplace_back("beyond", Json::Object{{"why", kNotDescribedYet}});
  return document;
}

void count_reproduced(const DescribedCore& core, const std::vector<const DescribedRun*>& runs,
                      DescribedCoreVerdict& verdict) {
  std::map<double, double> all;
  for (const DescribedChange& change : verdict.changes)
    if (change.kind == HeaderChangeKind::constant) all[change.from.value] = change.to.value;
  // Where something else changed, too, a constant alone proves nothing.
  const bool are_constants_all =
      verdict.accepted_step && with_constants(*verdict.accepted_step, all) == *read_step(core.record.step);
  for (DescribedChange& change : verdict.changes) {
    if (are_constants_all && change.kind == HeaderChangeKind::constant) {
      const DescribedCore alone =
          interpreted(core, with_constants(*verdict.accepted_step, {{change.from.value, change.to.value}}));
      change.scenarios = std::ranges::count_if(runs, [&](const DescribedRun* run) {
        return play(alone, run->scenario, {}).state_hash == run->contents.summary.state_hash;
      });
    }
    if (!change.of_default) continue;
    change.scenarios = 0;
    for (const DescribedRun* const run : runs) {
      const DescribedScenario scenario = with_default(run->scenario, *change.of_default);
      const std::string golden_hash = summary_state_hash(read_text_file(run->golden->txt_path));
      if (hex(play(core, scenario, {}).state_hash) == golden_hash) ++*change.scenarios;
    }
  }
}

DescribedCoreVerdict verdict_on_core(const DescribedCore& core, const std::string& golden_folder,
                                     const std::vector<std::string>& scenarios,
                                     const std::string& golden_option) {
  DescribedCoreVerdict verdict;
  verdict.golden_folder = golden_folder;
  verdict.header_path = std::string(core.record.path);
  if (const auto step = read_step(core.record.step)) verdict.paths = std::ssize(step->paths.front());
  verdict.commands = core_commands(scenarios, golden_option);
  try {
    if (const auto accepted = verdict.read_accepted()) compare(core, *accepted, verdict);
  } catch (const Failure& failure) {
    verdict.take(failure);
  }
  return verdict;
}

}  // namespace hyrax
