#include "tools/app/library/bless_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "tools/app/expect/judged_run.h"
#include "tools/files/printable.h"

namespace hyrax {
namespace {

using BlessStatus = Blessing::Status;

std::string_view name_of(BlessStatus status) {
  constexpr std::string_view kNames[] = {"new", "changed", "unchanged", "refused", "failed"};
  return kNames[static_cast<std::size_t>(status)];
}

// "core: accepted in golden/core", or why not.
std::string acceptances_text(const std::vector<CoreAcceptance>& cores, bool is_written) {
  std::string text;
  for (const CoreAcceptance& acceptance : cores) {
    const std::string folder = accepted_core_folder(acceptance.golden_folder);
    text += !acceptance.why_not.empty()
                ? fmt::format("core: not accepted in {}: {}\n", folder, acceptance.why_not)
                : fmt::format("{}core: {} in {}\n", acceptance.unnoticed,
                              is_written ? "accepted" : "would be accepted", folder);
  }
  return text;
}

// Of a run that differs, its group says more.
void print_plan(const Blessing& blessing, const Printing& printing) {
  const ScenarioVerdict& verdict = *blessing.verdict;
  const std::string path = printable(verdict.path);
  if (blessing.scenario_text && !blessing.has_failed())
    print_text("{}: new {}{}{}\n", path, blessing.has_new_hash ? "expect.state_hash" : "",
               blessing.has_new_hash && !blessing.updated.empty() ? "; " : "",
               blessing.updated.empty() ? "" : broken_sentence(blessing.updated));
  if (blessing.status == BlessStatus::fresh) print_text("{}: new golden file\n", path);
  if (blessing.status != BlessStatus::changed && blessing.status != BlessStatus::refused) return;
  if (!blessing.unreadable.empty())
    return print_text("{}: replaces a golden file that cannot be read ({})\n", path, blessing.unreadable);
  print_text("{}: changes {}\n{}", path,
             printable(blessing.keeps_h5 ? verdict.golden->txt_path : verdict.golden->h5_path),
             printing.is_verbose() || !blessing.plays_otherwise()
                 ? verdict.differences_text(printing.is_verbose())
                 : "");
}

// A line each of a few, else how many they are.
void print_unchanged(const BlessReport& report) {
  constexpr std::ptrdiff_t kListed = 3;
  const auto unchanged = report.count(BlessStatus::unchanged);
  if (unchanged > kListed)
    return print_text("{} scenarios: {} with their golden files already\n", unchanged,
                      VerdictWord{"agree", true});
  for (const Blessing& blessing : report.blessings)
    if (blessing.status == BlessStatus::unchanged)
      print_text("{}: {} with {} already\n", printable(blessing.verdict->path), VerdictWord{"agrees", true},
                 printable(blessing.verdict->golden->h5_path));
}

void print_done(const Blessing& blessing) {
  if (blessing.has_failed()) return;
  const std::string path = printable(blessing.verdict->path);
  const auto& [h5_path, txt_path, is_reserved, folder] = *blessing.verdict->golden;
  if (blessing.writes_golden_file() && blessing.keeps_h5)
    print_text("{}: agrees with {} already; its summary, {}, is written again{}\n", path, printable(h5_path),
               printable(txt_path),
               blessing.renewed_summary.empty() ? "" : " with its own reason: it is of an older layout");
  else if (blessing.writes_golden_file())
    print_text("{}: {}, {}\n", path, VerdictWord{"blessed", true}, printable(h5_path));
  if (blessing.scenario_text)
    print_text("{}: {} updated\n", path, blessing.updated.empty() ? "expect.state_hash" : "expect");
}

Json blessing_json(const Blessing& blessing) {
  const std::optional<GoldenPlace>& place = blessing.verdict->golden;  // None of one that cannot be read.
  Json::Object entry = result_of(*blessing.verdict, name_of(blessing.status),
                                 !blessing.has_failed() && blessing.status != BlessStatus::fresh);
  entry.emplace_back("golden_file", place ? Json(place->h5_path) : Json());
  entry.emplace_back("summary", place ? Json(place->txt_path) : Json());
  entry.emplace_back("updates_hash", blessing.scenario_text.has_value());
  if (!blessing.verdict->error.empty()) entry.emplace_back("error", blessing.verdict->error);
  return entry;
}

}  // namespace

std::string refusal_sentence(const BlessReport& report) {
  const auto& blessings = report.blessings;
  const auto failed = report.count(BlessStatus::failed);
  if (failed > 0)
    return fmt::format("hyrax-sim bless: nothing written: {} of {} scenarios failed", failed,
                       blessings.size());
  for (const CoreAcceptance& core : report.cores)
    if (core.is_refused)
      return fmt::format("hyrax-sim bless: nothing written: {}: {}", accepted_core_folder(core.golden_folder),
                         core.why_not);
  const auto refused = report.count(BlessStatus::refused);
  if (refused == 0) return "";
  const Blessing& widest = *std::ranges::max_element(blessings, {}, [](const Blessing& blessing) {
    return blessing.status == BlessStatus::refused ? blessing.differs_in : std::nullopt;
  });
  return fmt::format(
      "hyrax-sim bless: nothing written: {} of {} scenarios differ by more than --accept allows; --accept {} "
      "accepts all of them, the widest of which is {}",
      refused, blessings.size(), hyrax::name_of(*widest.differs_in), widest.verdict->path);
}

std::string unfinished_sentence(const BlessReport& report) {
  const auto failed = report.count(BlessStatus::failed);
  const auto planned = failed + std::ranges::count_if(report.blessings, &Blessing::writes);
  if (failed == 0) return "";
  return fmt::format(
      "hyrax-sim bless: {} of {} scenarios blessed, {} could not be written; the same command completes it",
      planned - failed, planned, failed);
}

void print_plans(const BlessReport& report, const BlessWords& words, const Printing& printing) {
  print_unchanged(report);
  if (printing.is_quiet()) return;
  for (const Blessing& blessing : report.blessings) print_plan(blessing, printing);
  for (const Paragraph& paragraph : words.paragraphs) print(paragraph);
  for (const std::string& path : report.pruning.removed) print_text("{}: has no scenario\n", printable(path));
}

void print_done(const BlessReport& report, bool is_dry_run) {
  if (is_dry_run) print_text("{}dry run: nothing written\n", acceptances_text(report.cores, false));
  if (!report.is_written) return;
  for (const Blessing& blessing : report.blessings) print_done(blessing);
  for (const std::string& path : report.pruning.removed) print_text("{}: removed\n", printable(path));
  print_text("{}", acceptances_text(report.cores, true));
}

Json bless_json(const BlessReport& report, Json::Array groups) {
  Json::Object document;
  for (const BlessStatus status : {BlessStatus::fresh, BlessStatus::changed, BlessStatus::unchanged,
                                   BlessStatus::refused, BlessStatus::failed})
    document.emplace_back(name_of(status), report.count(status));
  document.emplace_back("written", report.is_written && report.count(BlessStatus::failed) == 0);
  const std::vector<std::string>& removed = report.pruning.removed;
  document.emplace_back("pruned", Json::Array(removed.begin(), removed.end()));
  document.emplace_back("cores", list_of(report.cores, [](const CoreAcceptance& core) {
                          return Json::Object{
                              {"golden", core.golden_folder},
                              {"accepted", core.why_not.empty()},
                              {"why_not", core.why_not.empty() ? Json() : Json(core.why_not)}};
                        }));
  document.emplace_back("results", list_of(report.blessings, blessing_json));
  document.emplace_back("groups", std::move(groups));
  return document;
}

}  // namespace hyrax
