// One verdict of `check` as text.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "tools/app/check/check_report.h"
#include "tools/app/command_line/shell_command.h"
#include "tools/app/comparison/comparison_text.h"
#include "tools/app/expect/judged_run.h"
#include "tools/files/golden_place.h"
#include "tools/files/path.h"
#include "tools/files/unreferenced_golden.h"

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

}  // namespace

std::string verdict_sentence(const CheckVerdict& verdict) {
  const std::string broken = broken_sentence(verdict.broken);
  const CheckVerdict* const renamed = verdict.renamed;
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
      return joined(joined(verdict.non_finite, missing_golden_sentence(verdict.golden)),
                    broken.empty() && verdict.non_finite.empty()
                        ? "to create it: " + bless_command_for({verdict.path}, verdict.golden_option)
                        : broken);
    case CheckStatus::disagreed:
      break;
  }
  const DifferenceGroup* const group = verdict.group;
  if (group == nullptr || !verdict.non_finite.empty()) return joined(verdict.non_finite, broken);
  if (!verdict.runs) return joined(verdict.comparison.shape, broken);
  return joined(fmt::format("{}{}: {}", group->cause.kind == CauseKind::unknown ? "cause unknown: " : "",
                            group->cause.detail, scenario_consequence(verdict)),
                broken);
}

std::string verdict_details(const CheckVerdict& verdict, bool lists_all) {
  if (verdict.status == CheckStatus::failed) return "  " + verdict.error + "\n";
  if (verdict.status == CheckStatus::unreferenced) return fmt::format("  {}\n", kUnreferencedSentence);
  if (verdict.status == CheckStatus::agreed) return "";
  std::string text = verdict.non_finite.empty() ? "" : fmt::format("  not finite {}\n", verdict.non_finite);
  for (const Expectation& broken : verdict.broken)
    text += fmt::format("  expect     {}\n", expectation_text(broken));
  if (verdict.status == CheckStatus::missing)
    return text + fmt::format("  {}\n", missing_golden_sentence(verdict.golden)) +
           (text.empty() ? fmt::format("  to create it: {}\n",
                                       bless_command_for({verdict.path}, verdict.golden_option))
                         : "");
  if (verdict.comparison.agrees) return text;
  return text + comparison_text(verdict.comparison, lists_all) +
         fmt::format("  to see more     {}\n", diff_commands(verdict.path, verdict.golden->h5_path)) +
         acceptance_text({verdict.path}, {&verdict});
}

std::string acceptance_text(const std::vector<std::string>& paths,
                            const std::vector<const CheckVerdict*>& verdicts) {
  std::vector<std::string> to_edit;
  std::vector<std::string> damaged;
  std::vector<std::string> differing;
  bool updates = false;
  DifferenceClass widest = DifferenceClass::rounding;  // Edits of the scenarios themselves are accepted.
  bool blesses_all = true;                             // Nothing among `paths` would make bless refuse.
  // A run that is not finite, or gives other bits when it is repeated, is no result to bless.
  bool is_acceptable = true;
  for (const CheckVerdict* const verdict : verdicts) {
    const bool differs = verdict->status == CheckStatus::disagreed && !verdict->comparison.agrees;
    const bool is_to_edit = !std::ranges::all_of(verdict->broken, is_updatable);
    blesses_all &= !is_to_edit && verdict->status != CheckStatus::failed;
    if (is_to_edit)
      to_edit.push_back(verdict->path);
    else if (differs || !verdict->broken.empty())
      differing.push_back(verdict->path);
    updates |= !is_to_edit && !verdict->broken.empty();
    if (differs && verdict->group != nullptr && verdict->group->cause.kind != CauseKind::scenario)
      widest = std::max(widest, *verdict->comparison.difference);
    if (differs && (!verdict->runs || !verdict->runs->is_golden_as_blessed))
      damaged.push_back(verdict->golden->h5_path +
                        (verdict->runs ? "" : " and " + verdict->golden->txt_path));
    is_acceptable &= verdict->non_finite.empty() && (!verdict->runs || verdict->runs->is_repeated);
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

}  // namespace hyrax
