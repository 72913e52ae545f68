// The report of `check` in words.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

#include "tools/app/command_line/shell_command.h"
#include "tools/app/expect/judged_run.h"
#include "tools/app/library/check_flow.h"
#include "tools/files/printable.h"
#include "tools/platform/path.h"

namespace hyrax {
namespace {

std::string joined(const std::string& first, const std::string& second) {
  return first.empty() || second.empty() ? first + second : first + "; " + second;
}

// How to give the golden file the scenario's new name.
std::string rename_command(const std::string& golden_path, const GoldenPlace& place) {
  const std::string folder(file_name(place.h5_path).folder);
  const std::string make_folder =
      folder.empty() || is_folder(folder) ? "" : shell_command({"mkdir", "-p", folder}) + " && ";
  return make_folder + shell_command({"mv", as_argument(golden_path + ".h5"), as_argument(place.h5_path)}) +
         " && " + shell_command({"mv", as_argument(golden_path + ".txt"), as_argument(place.txt_path)});
}

// What is wrong with one scenario, in one line without its path: the cause and how far it moves the run, or
// where it becomes non-finite; the expectations that do not hold; what is missing. Empty if it agrees.
std::string verdict_sentence(const ScenarioVerdict& verdict) {
  const std::string broken = broken_sentence(verdict.broken);
  const std::string faults = fmt::format("{}", fmt::join(verdict.faults, "; "));
  const ScenarioVerdict* const renamed = verdict.renamed;
  switch (verdict.status) {
    case CheckStatus::agreed:
      return "";
    case CheckStatus::failed:
      return verdict.error;
    case CheckStatus::unreferenced:
      return renamed == nullptr ? kUnreferencedSentence : "its scenario was renamed to " + renamed->path;
    case CheckStatus::missing:
      if (renamed != nullptr)
        return fmt::format("renamed: {} has the same run; to rename that: {}", renamed->path,
                           rename_command(renamed->path, *verdict.golden));
      return joined(joined(faults, missing_golden_sentence(verdict.golden)),
                    broken.empty() && faults.empty()
                        ? "to create it: " + bless_command_for({verdict.path}, verdict.golden_option)
                        : broken);
    case CheckStatus::disagreed:
      break;
  }
  const DifferenceGroup* const group = verdict.group;
  if (group == nullptr || !faults.empty()) return joined(faults, broken);
  if (!verdict.golden_fault.empty()) return joined(verdict.golden_fault, broken);
  return joined(fmt::format("{}{}: {}", group->cause.kind == CauseKind::unknown ? "cause unknown: " : "",
                            group->cause.detail, verdict.consequence()),
                broken);
}

// How to accept what differs: the command that blesses it, unless a run becomes non-finite, and before it
// what in `expect` keeps bless from doing so, and which golden file was changed since it was blessed.
// @param paths scenarios, or folders of them, that are blessed.
// @param verdicts on all scenarios of `paths`; one of them differs.
std::string acceptance_text(const std::vector<std::string>& paths,
                            const std::vector<const ScenarioVerdict*>& verdicts) {
  std::vector<std::string> to_edit;
  std::vector<std::string> damaged;
  std::vector<std::string> differing;
  bool updates = false;
  DifferenceClass widest = DifferenceClass::rounding;  // Edits of the scenarios themselves are accepted.
  bool blesses_all = true;                             // Nothing among `paths` would make bless refuse.
  // A run that is not finite, or gives other bits when it is repeated, is no result to bless.
  bool is_acceptable = true;
  for (const ScenarioVerdict* const verdict : verdicts) {
    const bool differs = verdict->status == CheckStatus::disagreed && verdict->differs();
    const bool is_to_edit = !std::ranges::all_of(verdict->broken, is_updatable);
    blesses_all &= !is_to_edit && verdict->status != CheckStatus::failed;
    if (is_to_edit)
      to_edit.push_back(verdict->path);
    else if (differs || !verdict->broken.empty())
      differing.push_back(verdict->path);
    updates |= !is_to_edit && !verdict->broken.empty();
    if (differs && verdict->group != nullptr && verdict->group->cause.kind != CauseKind::scenario)
      widest = std::max(widest, *verdict->deviation().difference);
    if (differs && !verdict->to_restore.empty()) damaged.push_back(verdict->to_restore);
    is_acceptable &= verdict->faults.empty() && verdict->is_repeated;
  }
  std::string text;
  if (!damaged.empty())
    text += fmt::format("  to restore it   take {}{} from version control\n", damaged.front(),
                        damaged.size() == 1 ? "" : fmt::format(" and {} more", damaged.size() - 1));
  if (!is_acceptable) return text;
  if (!to_edit.empty())
    text += fmt::format(
        "  to edit         expect of {}: bless changes no boolean, error bound or one-sided limit\n",
        fmt::join(to_edit, ", "));
  if (differing.empty()) return text;
  std::string command = bless_command_for(blesses_all ? paths : differing, verdicts.front()->golden_option);
  if (widest > DifferenceClass::rounding) command += fmt::format(" --accept {}", name_of(widest));
  if (updates) command += " --update-expect";
  return text + fmt::format("  to accept it    {}\n", command);
}

// All that is known of one scenario, with the commands that show more.
std::string verdict_details(const ScenarioVerdict& verdict, bool lists_all = false) {
  if (verdict.status == CheckStatus::failed) return "  " + verdict.error + "\n";
  if (verdict.status == CheckStatus::unreferenced) return fmt::format("  {}\n", kUnreferencedSentence);
  if (verdict.status == CheckStatus::agreed) return "";
  std::string text;
  for (const std::string& fault : verdict.faults)
    text += fmt::format("  {:<10} {}\n", verdict.is_non_finite ? "not finite" : "fault", fault);
  for (const Expectation& broken : verdict.broken)
    text += fmt::format("  expect     {}\n", expectation_text(broken));
  if (verdict.status == CheckStatus::missing)
    return text + fmt::format("  {}\n", missing_golden_sentence(verdict.golden)) +
           (text.empty() ? fmt::format("  to create it: {}\n",
                                       bless_command_for({verdict.path}, verdict.golden_option))
                         : "");
  if (!verdict.differs()) return text;
  return text + verdict.differences_text(lists_all) +
         fmt::format("  to see more     {}\n", diff_commands(verdict.path, verdict.golden->h5_path)) +
         acceptance_text({verdict.path}, {&verdict});
}

// "a, b, c and 37 more".
std::string names_text(const std::vector<const ScenarioVerdict*>& verdicts) {
  constexpr std::size_t kNamed = 3;
  std::string text;
  for (std::size_t index = 0; index < std::min(verdicts.size(), kNamed); ++index)
    text += (index == 0 ? "" : ", ") + printable(verdicts[index]->path);
  return verdicts.size() <= kNamed ? text : text + fmt::format(" and {} more", verdicts.size() - kNamed);
}

std::vector<std::string> arguments_of(const CheckReport& report) {
  return report.selection.arguments.empty() ? std::vector<std::string>{"scenarios"}
                                            : report.selection.arguments;
}

Paragraph line_of(const ScenarioVerdict& verdict) {
  return {.subject = printable(verdict.path) + ": ",
          .verdict = std::string(name_of(verdict.status)),
          .predicate = ": " + verdict_sentence(verdict)};
}

// Of several one sentence, and of missing ones how to accept them all, unless others keep bless from it.
Paragraph paragraph_of(const CheckReport& report, const std::vector<const ScenarioVerdict*>& verdicts) {
  if (verdicts.size() == 1) return line_of(*verdicts.front());
  const CheckStatus status = verdicts.front()->status;
  const bool is_missing = status == CheckStatus::missing;
  const std::string& folder = report.selection.golden_option;
  const std::string why = !is_missing                           ? "no scenario"
                          : folder.empty() || is_folder(folder) ? "no golden file"
                                                                : "no folder " + printable(folder);
  Paragraph paragraph{
      .subject = fmt::format("{} {}: ", verdicts.size(), is_missing ? "scenarios" : "golden files"),
      .verdict = std::string(name_of(status)),
      .predicate = fmt::format(": {}: {}", why, names_text(verdicts))};
  if (!is_missing) return paragraph;
  std::vector<std::string> paths = arguments_of(report);
  if (std::ssize(verdicts) + report.count(CheckStatus::agreed) != report.scenario_count()) {
    paths.clear();
    for (const ScenarioVerdict* const verdict : verdicts) paths.push_back(verdict->path);
  }
  paragraph.lines = fmt::format("  to create them  {}\n", bless_command_for(paths, folder));
  return paragraph;
}

// One for each kind: what is missing, failed or unreferenced, and expectations that do not hold.
void add_others(CheckReport& report) {
  std::vector<const ScenarioVerdict*> missing;
  std::vector<const ScenarioVerdict*> unreferenced;
  std::vector<const ScenarioVerdict*> unexpected;  // Only by their authors.
  for (const ScenarioVerdict* const each : report.verdicts) {
    const ScenarioVerdict& verdict = *each;
    if (verdict.status == CheckStatus::agreed || verdict.group != nullptr) continue;
    const bool is_renamed = verdict.renamed != nullptr;
    if (verdict.status == CheckStatus::unreferenced && !is_renamed)
      unreferenced.push_back(&verdict);
    else if (verdict.status == CheckStatus::missing && !is_renamed && verdict.broken.empty() &&
             verdict.faults.empty())
      missing.push_back(&verdict);
    else if (verdict.status != CheckStatus::unreferenced)
      report.paragraphs.push_back(line_of(verdict));
    if (verdict.status == CheckStatus::disagreed && verdict.faults.empty()) unexpected.push_back(&verdict);
  }
  for (const auto& verdicts : {missing, unreferenced})
    if (!verdicts.empty()) report.paragraphs.push_back(paragraph_of(report, verdicts));
  if (report.groups.empty() && !unexpected.empty())
    report.paragraphs.push_back({.lines = acceptance_text({unexpected.front()->path}, unexpected)});
}

// What else does not hold in those that differ: faults, of the first few, and how many break their
// expectations; and the names of the physics models, where they differ: each sentence once.
void add_remarks(CheckReport& report) {
  constexpr std::int64_t kNamed = 3;
  std::string faults;
  std::int64_t faulty = 0;
  for (const ScenarioVerdict* const verdict : report.verdicts)
    if (verdict->group != nullptr && !verdict->faults.empty() && !verdict->is_non_finite &&
        ++faulty <= kNamed)
      faults += fmt::format("  fault   {}: {}\n", printable(verdict->path), fmt::join(verdict->faults, "; "));
  if (faulty > kNamed) faults += fmt::format("          and {} more\n", faulty - kNamed);
  if (faulty > 0) report.paragraphs.push_back({.lines = faults});
  const auto broken = std::ranges::count_if(report.verdicts, [](const ScenarioVerdict* verdict) {
    return verdict->group != nullptr && !verdict->broken.empty();
  });
  if (broken > 0)
    report.paragraphs.push_back({.lines = fmt::format("  expect  does not hold in {} of them\n", broken)});
  std::set<std::string> sentences;
  for (const ScenarioVerdict* const verdict : report.verdicts)
    if (!verdict->remark.empty()) sentences.insert(verdict->remark);
  for (const std::string& sentence : sentences) report.paragraphs.push_back({.subject = sentence});
}

// The commands that show more of the worst scenario, and the one that accepts all.
std::string commands_text(const CheckReport& report) {
  const ScenarioVerdict& worst = *report.groups.front().scenarios.front();
  const bool is_alone = report.groups.size() == 1 && report.groups.front().scenarios.size() == 1;
  std::vector<std::string> verbose = {"check", "--verbose"};
  for (const std::string& argument : report.selection.arguments) verbose.push_back(as_argument(argument));
  if (!report.selection.golden_option.empty())
    verbose.insert(verbose.end(), {"--golden", as_argument(report.selection.golden_option)});
  std::vector<const ScenarioVerdict*> blessed;
  for (const ScenarioVerdict* const each : report.verdicts)
    if (each->status != CheckStatus::unreferenced && (!is_alone || each == &worst)) blessed.push_back(each);
  const std::string text =
      fmt::format("  to see all      {}\n  to see more     {}\n", program_command(verbose),
                  diff_commands(worst.path, worst.golden->h5_path));
  // Its results are others the next time.
  if (std::ranges::any_of(report.groups, [](const auto& each) { return each.cause.detail == kNotRepeated; }))
    return text;
  return text + acceptance_text(is_alone ? std::vector{worst.path} : arguments_of(report), blessed);
}

ReportEntry entry_of(const ScenarioVerdict& verdict) {
  return {verdict.path,
          name_of(verdict.status),
          verdict.exit_code,
          verdict_sentence(verdict),
          verdict_details(verdict),
          verdict.path,
          verdict.seconds};
}

// And entries of the folders.
void add_counts(CheckReport& report) {
  std::vector<CheckStatus> statuses;
  std::int64_t folders_failed = 0;
  for (const ScenarioVerdict* const verdict : report.verdicts)
    if (!verdict->is_scenario && verdict->status == CheckStatus::failed)
      ++folders_failed;
    else
      statuses.push_back(verdict->status);
  report.counts = counts_sentence(statuses, folders_failed);
  for (const Failure& failure : report.selection.unlisted)
    report.entries.push_back({failure.what(), "folder", failure.exit_code(), failure.what()});
}

}  // namespace

void set_groups(std::vector<DifferenceGroup> groups, CheckReport& report) {
  for (ScenarioVerdict* const missing : report.verdicts)
    for (ScenarioVerdict* const golden : report.verdicts)
      if (missing->status == CheckStatus::missing && golden->status == CheckStatus::unreferenced &&
          !golden->state_hash.empty() && missing->state_hash == golden->state_hash &&
          missing->renamed == nullptr && golden->renamed == nullptr) {
        missing->renamed = golden;
        golden->renamed = missing;
      }
  report.groups = std::move(groups);
  std::map<const ScenarioVerdict*, const DifferenceGroup*> group_of;
  for (const DifferenceGroup& group : report.groups)
    for (const ScenarioVerdict* const scenario : group.scenarios) group_of[scenario] = &group;
  for (ScenarioVerdict* const verdict : report.verdicts)
    if (const auto found = group_of.find(verdict); found != group_of.end()) verdict->group = found->second;
}

void put_into_words(const std::vector<CoreWords>& cores, CheckReport& report) {
  for (const DifferenceGroup& group : report.groups)
    for (const ScenarioVerdict* const scenario : group.scenarios) {
      ReportEntry& entry = report.entries.emplace_back(entry_of(*scenario));
      const auto core = std::ranges::find(cores, scenario->golden_folder, &CoreWords::golden_folder);
      if (group.cause.kind != CauseKind::core || core == cores.end() || core->file.empty()) continue;
      entry.file = core->file;  // What the core is the cause of is marked where its header changed first.
      entry.line = core->line;
    }
  for (const ScenarioVerdict* const verdict : report.verdicts)
    if (verdict->group == nullptr) report.entries.push_back(entry_of(*verdict));
  add_counts(report);
  std::vector<std::string> texts;
  for (const CoreWords& core : cores) {
    texts.push_back(core.text);
    if (core.exit_code == ExitCode::agreed) continue;
    const std::string path = accepted_core_folder(core.golden_folder) + "/accepted.txt";
    report.entries.push_back({path, "core", core.exit_code, core.text.substr(0, core.text.find('\n')),
                              core.text, core.file.empty() ? path : core.file});
    report.entries.back().line = core.line;
  }
  report.paragraphs =
      difference_paragraphs(report.groups, texts, static_cast<std::size_t>(report.scenario_count()));
  add_remarks(report);
  add_others(report);
  if (!report.groups.empty()) report.paragraphs.push_back({.lines = commands_text(report)});
}

void print_verdicts(const CheckReport& report) {
  for (const ScenarioVerdict* const verdict : report.verdicts)
    print_text("{}: {}\n{}", printable(verdict->path),
               VerdictWord{name_of(verdict->status), verdict->status == CheckStatus::agreed},
               verdict_details(*verdict, true));
}

}  // namespace hyrax
