#include <algorithm>

#include "tools/app/bless/bless_report.h"
#include "tools/app/command_line/options.h"
#include "tools/files/printable.h"
#include "tools/files/scenario_list.h"
#include "tools/store/golden_file.h"

namespace hyrax {
namespace {

struct BlessRequest {
  std::vector<std::string> files;
  BlessOptions options;
  std::string accepted = std::string(name_of(DifferenceClass::rounding));
  bool is_dry_run = false;
  bool prunes = false;
  bool accepts_core_only = false;
  Printing printing;
};

// With --prune alone nothing is blessed.
bool blesses(const BlessRequest& request) { return !request.prunes || !request.options.reason.empty(); }

void complete(BlessRequest& request) {
  if (request.prunes && request.files.empty()) {
    request.files = {"scenarios"};
    if (request.options.golden_folder.empty()) request.options.golden_folder = "golden";
  }
  if (request.accepts_core_only) set_default_folders(request.files, request.options.golden_folder);
  if (request.files.empty())
    refuse_input("hyrax-sim bless: SCENARIO: at least 1 needed (found 0); see `hyrax-sim bless --help`");
  if (blesses(request) && request.options.reason.find_first_not_of(" \t\n") == std::string::npos)
    refuse_input(
        "hyrax-sim bless: --reason must say why the golden files change, as in --reason 'wider window'");
  request.options.reason = printable_lines(request.options.reason);
  std::ranges::replace(request.options.reason, '\n', ' ');
  request.options.accepted = *std::ranges::find(kDifferenceClasses, request.accepted,
                                                [](DifferenceClass value) { return name_of(value); });
}

bool is_golden_file(const std::string& path) try {
  static_cast<void>(read_golden(path));
  return true;
} catch (const Failure&) {
  return false;
}

// All checks come before the first write: if one fails, no golden file is changed.
ExitCode bless(const Core& core, BlessRequest& request) {
  complete(request);
  BlessReport report;
  if (request.prunes)
    report.pruning = find_prunable(request.files, request.options.golden_folder, is_golden_file);
  const std::vector<std::string> paths =
      blesses(request) ? list_scenarios(request.files) : std::vector<std::string>{};
  if (!request.accepts_core_only) report.blessings = plan_blessings(core, paths, request.options);
  if (refusal_sentence(report).empty())
    report.cores = plan_core_acceptances(core, blesses(request) ? request.files : paths, report.blessings,
                                         request.options);
  const bool is_refused = !refusal_sentence(report).empty();
  CoreChecks cores(core, request.files, request.options.golden_folder);
  const std::vector<DifferenceGroup> groups = request.printing.is_quiet() && !request.printing.is_json
                                                  ? std::vector<DifferenceGroup>{}
                                                  : groups_of(report, cores);
  if (!request.printing.is_json) print_plans(core, report, groups, cores, request.printing);
  if (is_refused) print_error(refusal_sentence(report));
  report.is_written = !is_refused && !request.is_dry_run;
  if (report.is_written) {
    require_unchanged(report.blessings);
    for (Blessing& blessing : report.blessings)
      if (blessing.writes()) write(core, blessing, request.options);
    if (const std::string sentence = unfinished_sentence(report); !sentence.empty()) {
      print_error(sentence);
      report.pruning.removed.clear();
    }
    remove_files(report.pruning.removed);
    write_cores(report.cores, report.blessings);
    for (const std::string& sentence : git_ignored_sentences(report)) print_error(sentence);
  }
  if (request.accepts_core_only && report.cores.empty()) {
    if (libraries_of(request.files, request.options.golden_folder).empty())
      refuse_input(
          "hyrax-sim bless: --core: needs scenarios below a folder named scenarios, or a folder "
          "and --golden (found " +
          request.files.front() + ")");
    if (!request.printing.is_json) print_text("core: accepted already\n");
  }
  if (request.printing.is_json) {
    if (request.accepts_core_only)
      report.is_written &= std::ranges::any_of(report.cores, &CoreAcceptance::is_accepted);
    print_json(bless_json(report, groups));
  } else {
    print_done(report, request.is_dry_run);
  }
  for (const std::string& path : report.pruning.left)
    print_error(path + ": has no scenario; left, as `bless` did not write it");
  if (request.prunes && report.pruning.removed.empty() && report.pruning.left.empty() &&
      !request.printing.is_json)
    print_text("no golden file without a scenario\n");
  ExitCode exit_code = ExitCode::agreed;
  for (const Blessing& blessing : report.blessings) exit_code = more_serious(exit_code, blessing.exit_code);
  for (const CoreAcceptance& acceptance : report.cores)
    if (acceptance.is_refused || (request.accepts_core_only && !acceptance.why_not.empty()))
      exit_code = more_serious(exit_code, ExitCode::disagreed);
  return exit_code;
}

void declare(Options& options, BlessRequest& request) {
  std::vector<std::string> class_names;
  for (const DifferenceClass difference : kDifferenceClasses) class_names.emplace_back(name_of(difference));
  options.files(request.files, {"SCENARIO or DIR", "", "scenario files, or folders of them"}, 0, -1);
  options.text(request.options.reason,
               {"--reason", "TEXT", "why they change; recorded in the summary (required)"});
  options.choice(request.accepted,
                 {"--accept", "CLASS",
                  "the widest difference that may be blessed (default: rounding); new scenarios and those "
                  "whose own text changed need none"},
                 class_names);
  options.flag(request.is_dry_run, {"--dry-run", "", "show what would change; write nothing"});
  options.flag(request.options.updates_hash, {"--update-hash", "",
                                              "put the new `expect.state_hash` into the scenario files that "
                                              "have one; nothing else in them changes"});
  options.flag(request.options.updates_ranges,
               {"--update-expect", "",
                "as --update-hash, and new values for counts and ranges of `expect` that do not hold: a "
                "range keeps its width. Booleans, error bounds and one-sided limits never change"});
  options.flag(
      request.accepts_core_only,
      {"--core", "",
       "only accept this program's core in golden/core, if the whole library agrees (default: scenarios)"});
  options.flag(request.prunes, {"--prune", "",
                                "remove the golden files without a scenario, of the folders given (default: "
                                "scenarios); with --reason bless as well. Refused where no scenario is left "
                                "or something cannot be read; files that `bless` did not write stay"});
  options.text(request.options.golden_folder,
               {"--golden", "DIR", "folder of golden files (default: the `golden` beside `scenarios`)"});
  options.printing(request.printing, "print what differs in every scenario, and all contacts that moved");
}

}  // namespace

Command bless_command() {
  return {.name = "bless",
          .summary = "accept current results as the new golden files, with a reason",
          .example =
              "hyrax-sim bless scenarios/flings/first-fling.json --reason 'a longer throw'\n"
              "  hyrax-sim bless scenarios --accept contacts --reason 'drag is weaker' --dry-run\n"
              "  hyrax-sim bless --prune",
          .is_common = true,
          .declare = with_request<BlessRequest>(declare, bless)};
}

}  // namespace hyrax
