// One verdict of `check` as text.
#include <fmt/format.h>

#include <algorithm>

#include "tools/files/golden_place.h"
#include "tools/files/unreferenced_golden.h"
#include "tools/hyrax-replay/judged_run.h"
#include "tools/hyrax-sim/command_line/shell_command.h"
#include "tools/hyrax-sim/golden/check_report.h"
#include "tools/hyrax-sim/golden/difference_text.h"
#include "tools/hyrax-sim/golden/group_text.h"

namespace hyrax {
namespace {

using Status = CheckVerdict::Status;

bool is_hash(const Expectation& expectation) { return expectation.rule == "state_hash"; }

}  // namespace

std::string verdict_sentence(const CheckReport& report, const CheckVerdict& verdict) {
  const std::string broken = broken_sentence(verdict.broken);
  switch (verdict.status) {
    case Status::agreed:
      return "";
    case Status::failed:
      return verdict.error;
    case Status::unreferenced:
      return kUnreferencedSentence;
    case Status::missing:
      return fmt::format("{}; {}", missing_golden_sentence(verdict.golden),
                         !broken.empty()
                             ? broken
                             : "to create it: " + bless_command_for({verdict.path}, verdict.golden_folder));
    case Status::disagreed:
      break;
  }
  const DifferenceGroup* const group = report.group_of(verdict);
  if (group == nullptr) return broken.empty() ? "the state is not finite" : broken;
  return fmt::format("{}{}: {}{}", group->reproduced() == 0 ? "cause unknown: " : "", group->cause.detail,
                     scenario_consequence({verdict.path, &verdict.comparison, verdict.runs.get()}),
                     broken.empty() ? "" : "; " + broken);
}

std::string verdict_details(const CheckVerdict& verdict, bool lists_all) {
  if (verdict.status == Status::failed) return "  " + verdict.error + "\n";
  if (verdict.status == Status::unreferenced) return fmt::format("  {}\n", kUnreferencedSentence);
  if (verdict.status == Status::agreed) return "";
  std::string text;
  for (const Expectation& broken : verdict.broken)
    text += fmt::format("  expect     {}\n", expectation_text(broken));
  if (verdict.status == Status::missing)
    return text + fmt::format("  {}\n", missing_golden_sentence(verdict.golden)) +
           (verdict.broken.empty() ? fmt::format("  to create it: {}\n",
                                                 bless_command_for({verdict.path}, verdict.golden_folder))
                                   : "");
  if (verdict.comparison.agrees) return text;
  return text + difference_text(verdict.comparison, lists_all) +
         fmt::format("  to see more     {}; {}\n",
                     program_command({"run", as_argument(verdict.path), "-o", "now.h5"}),
                     program_command({"diff", as_argument(verdict.golden->h5_path), "now.h5"})) +
         acceptance_text({verdict.path}, "", {&verdict});
}

std::string acceptance_text(const std::vector<std::string>& paths, const std::string& options,
                            const std::vector<const CheckVerdict*>& verdicts) {
  const std::string& golden_folder = verdicts.front()->golden_folder;
  std::vector<std::string> of_other_hash;
  std::vector<std::string> damaged;
  std::int64_t to_edit = 0;
  bool has_others = false;
  for (const CheckVerdict* const verdict : verdicts) {
    const bool has_other_hash = std::ranges::any_of(verdict->broken, is_hash);
    if (has_other_hash) of_other_hash.push_back(verdict->path);
    if (!std::ranges::all_of(verdict->broken, is_hash)) ++to_edit;
    if (verdict->runs && !verdict->runs->is_golden_as_blessed) damaged.push_back(verdict->golden->h5_path);
    has_others |= !has_other_hash && verdict->status == Status::disagreed && !verdict->comparison.agrees;
  }
  std::string text;
  if (!damaged.empty())
    text += fmt::format("  to restore it   take {}{} from version control\n", damaged.front(),
                        damaged.size() == 1 ? "" : fmt::format(" and {} more", damaged.size() - 1));
  if (to_edit > 0)
    text += fmt::format(
        "  to edit first   expect of {} scenario{}: bless refuses a run for which it does not hold\n",
        to_edit, to_edit == 1 ? "" : "s");
  // Of others than these, --update-hash would write a hash where there is none.
  const std::string first =
      of_other_hash.empty() ? ""
                            : bless_command_for(of_other_hash, golden_folder) + options + " --update-hash";
  const std::string second = has_others ? bless_command_for(paths, golden_folder) + options : "";
  return text +
         fmt::format("  to accept it    {}{}{}\n", first, !first.empty() && has_others ? "; " : "", second);
}

}  // namespace hyrax
