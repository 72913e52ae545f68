#include "tools/app/check/check_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "tools/app/command_line/shell_command.h"
#include "tools/files/path.h"
#include "tools/files/printable.h"

namespace hyrax {
namespace {

// "a, b, c and 37 more".
std::string names_text(const std::vector<const CheckVerdict*>& verdicts) {
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

Paragraph line_of(const CheckVerdict& verdict) {
  return {.subject = printable(verdict.path) + ": ",
          .verdict = std::string(name_of(verdict.status)),
          .predicate = ": " + verdict_sentence(verdict)};
}

// Of several one sentence, and of missing ones how to accept them all, unless others keep bless from it.
Paragraph paragraph_of(const CheckReport& report, const std::vector<const CheckVerdict*>& verdicts) {
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
    for (const CheckVerdict* const verdict : verdicts) paths.push_back(verdict->path);
  }
  paragraph.lines = fmt::format("  to create them  {}\n", bless_command_for(paths, folder));
  return paragraph;
}

// One for each kind: what is missing, failed or unreferenced, and expectations that do not hold.
void add_others(CheckReport& report) {
  std::vector<const CheckVerdict*> missing;
  std::vector<const CheckVerdict*> unreferenced;
  for (const CheckVerdict& verdict : report.verdicts) {
    if (verdict.status == CheckStatus::agreed || verdict.group != nullptr) continue;
    const bool is_renamed = verdict.renamed != nullptr;
    if (verdict.status == CheckStatus::unreferenced && !is_renamed)
      unreferenced.push_back(&verdict);
    else if (verdict.status == CheckStatus::missing && !is_renamed && verdict.broken.empty() &&
             verdict.non_finite.empty())
      missing.push_back(&verdict);
    else if (verdict.status != CheckStatus::unreferenced)
      report.paragraphs.push_back(line_of(verdict));
  }
  for (const auto& verdicts : {missing, unreferenced})
    if (!verdicts.empty()) report.paragraphs.push_back(paragraph_of(report, verdicts));
}

// How many of those that differ break their expectations as well, and the names of the physics models, where
// they differ: each sentence once.
void add_remarks(CheckReport& report) {
  const auto broken = std::ranges::count_if(report.verdicts, [&](const CheckVerdict& verdict) {
    return verdict.group != nullptr && !verdict.broken.empty();
  });
  if (broken > 0)
    report.paragraphs.push_back({.lines = fmt::format("  expect  does not hold in {} of them\n", broken)});
  std::set<std::string> sentences;
  for (const CheckVerdict& verdict : report.verdicts)
    if (!verdict.comparison.agrees && !verdict.comparison.physics.empty())
      sentences.insert(verdict.comparison.physics);
  for (const std::string& sentence : sentences) report.paragraphs.push_back({.subject = sentence});
}

// The commands that show more of the worst scenario, and the one that accepts all.
std::string commands_text(const CheckReport& report) {
  const PairVerdict& worst = *report.groups.front().scenarios.front();
  const bool is_alone = report.groups.size() == 1 && report.groups.front().scenarios.size() == 1;
  std::vector<std::string> verbose = {"check", "--verbose"};
  for (const std::string& argument : report.selection.arguments) verbose.push_back(as_argument(argument));
  if (!report.selection.golden_option.empty())
    verbose.insert(verbose.end(), {"--golden", as_argument(report.selection.golden_option)});
  std::vector<const CheckVerdict*> blessed;
  for (const CheckVerdict& each : report.verdicts)
    if (each.status != CheckStatus::unreferenced && (!is_alone || &each == &worst)) blessed.push_back(&each);
  const std::string text =
      fmt::format("  to see all      {}\n  to see more     {}\n", program_command(verbose),
                  diff_commands(worst.path, worst.golden->h5_path));
  // Its results are others the next time.
  if (std::ranges::any_of(report.groups, [](const auto& each) { return each.cause.detail == kNotRepeated; }))
    return text;
  return text + acceptance_text(is_alone ? std::vector{worst.path} : arguments_of(report), blessed);
}

ReportEntry entry_of(const CheckVerdict& verdict) {
  return {verdict.path,
          name_of(verdict.status),
          verdict.exit_code,
          verdict_sentence(verdict),
          verdict_details(verdict),
          verdict.path,
          verdict.seconds};
}

// What the core is the cause of is marked where its header changed first.
void mark_change(const CoreVerdict& core, ReportEntry& entry) {
  const auto change = std::ranges::find_if(core.changes, [](const HeaderChange& each) {
    return each.kind != HeaderChangeKind::removed && !each.file.empty();
  });
  if (change == core.changes.end()) return;
  entry.file = change->file;
  entry.line = change->line;
}

}  // namespace

void explain(CheckReport& report) {
  std::vector<CheckVerdict>& verdicts = report.verdicts;
  std::vector<const PairVerdict*> differing;
  for (const CheckVerdict& verdict : verdicts) {
    if (is_folder(verdict.golden_folder))
      report.cores.of(verdict.golden_folder).take_paths(verdict.paths_taken);
    if (verdict.status == CheckStatus::disagreed && !verdict.comparison.agrees) differing.push_back(&verdict);
  }
  for (CheckVerdict& missing : verdicts)
    for (CheckVerdict& golden : verdicts)
      if (missing.status == CheckStatus::missing && golden.status == CheckStatus::unreferenced &&
          !golden.state_hash.empty() && missing.state_hash == golden.state_hash &&
          missing.renamed == nullptr && golden.renamed == nullptr) {
        missing.renamed = &golden;
        golden.renamed = &missing;
      }
  if (!differing.empty()) report.groups = group_by_cause(differing, report.cores);
  for (const DifferenceGroup& group : report.groups)
    for (const PairVerdict* const scenario : group.scenarios)
      verdicts[static_cast<std::size_t>(&verdict_on(*scenario) - verdicts.data())].group = &group;
}

void put_into_words(CheckReport& report) {
  for (const DifferenceGroup& group : report.groups)
    for (const PairVerdict* const scenario : group.scenarios) {
      ReportEntry& entry = report.entries.emplace_back(entry_of(verdict_on(*scenario)));
      if (group.cause.kind == CauseKind::core)
        mark_change(report.cores.of(verdict_on(*scenario).golden_folder).verdict(), entry);
    }
  for (const CheckVerdict& verdict : report.verdicts)
    if (verdict.group == nullptr) report.entries.push_back(entry_of(verdict));
  add_counts(pointers_to(report.verdicts), report.selection, report);
  const std::vector<const CoreVerdict*> cores = report.cores.verdicts();
  for (const CoreVerdict* const core : cores) {
    if (core->exit_code == ExitCode::agreed) continue;
    const std::string path = accepted_core_folder(core->golden_folder) + "/accepted.txt";
    const std::string text = core_text(*core, cores.size() == 1, report.groups.empty());
    report.entries.push_back({path, "core", core->exit_code, text.substr(0, text.find('\n')), text, path});
    mark_change(*core, report.entries.back());
  }
  report.paragraphs =
      difference_paragraphs(report.groups, cores, static_cast<std::size_t>(report.scenario_count()));
  add_remarks(report);
  add_others(report);
  if (!report.groups.empty()) report.paragraphs.push_back({.lines = commands_text(report)});
}

void print_verdicts(const CheckReport& report) {
  for (const CheckVerdict& verdict : report.verdicts)
    print_text("{}: {}\n{}", printable(verdict.path),
               VerdictWord{name_of(verdict.status), verdict.status == CheckStatus::agreed},
               verdict_details(verdict, true));
}

}  // namespace hyrax
