#include <fmt/format.h>

#include <memory>
#include <optional>

#include "sim/result/number_text.h"
#include "tools/app/command_line/shell_command.h"
#include "tools/app/sweep/member_result.h"
#include "tools/described/commands.h"
#include "tools/described/run_text.h"
#include "tools/described/trajectory_file.h"
#include "tools/platform/path.h"
#include "tools/store/output_guard.h"
#include "tools/store/table_file.h"

namespace hyrax {
namespace {

struct ReportRequest {
  std::vector<std::string> files;
  std::string against;
  std::string output;
  Printing printing;
};

ShownResult shown_file(const DescribedCore& core, const ReportRequest& request, const std::string& path,
                       const std::unique_ptr<FileRun>& against, std::vector<RunPanel>& panels) {
  const FileRun run(core, path);
  const DescribedHead& head = run.file().head();
  const Description& description = head.description;
  const DescribedScenario& scenario = head.scenario;
  const DescribedSummary& summary = run.summary();
  std::optional<DescribedComparison> comparison;
  if (against) comparison = compare_files(core, against->file(), run.file());
  const DescribedPicture* const golden = comparison && !comparison->agrees() ? picture_of(against) : nullptr;
  ShownResult shown =
      shown_run(description, scenario, summary, run.picture(), golden,
                fmt::format("{}, {:.6g} s", plain_counted(head.steps, "step"), summary.simulated_s),
                {{"core", description.core}, {"file", path}, {"state hash", head.state_hash}});
  panels.push_back(
      {.name = scenario.name, .status = "played", .picture = panel_picture(run.picture(), golden)});
  if (!comparison) return shown;
  panels.back().status = comparison->agrees() ? "agreed" : "disagreed";
  if (comparison->agrees())
    shown.judgement = "Agrees with " + request.against + ", bit for bit.";
  else
    shown.verdict.broken.push_back("differs from " + request.against + ": " +
                                   comparison_sentence(*comparison));
  return shown;
}

// Its members are not played on the page.
ShownResult shown_sweep(const DescribedCore& core, const std::string& path) {
  const EnsembleReader reader(path, swept_core(core).read_contents);
  return member_result(reader, member_numbers(reader), std::string(file_name(path).stem), "run");
}

ExitCode report(const DescribedCore& core, const ReportRequest& request) {
  if (request.output.empty()) refuse_input("hyrax-sim report: -o FILE.html is missing");
  std::vector<std::string> inputs = request.files;
  std::vector<std::string> words = {"report"};
  for (const std::string& file : request.files) words.push_back(as_argument(file));
  if (!request.against.empty()) {
    inputs.push_back(request.against);
    words.insert(words.end(), {"--against", as_argument(request.against)});
  }
  OutputGuard guard(inputs);
  guard.admit("hyrax-sim report: -o", request.output, {".html"});
  std::vector<ShownResult> shown;
  std::vector<RunPanel> panels;
  if (format_of_file(request.files.front()) == kEnsembleFormat) {
    shown = shown_sweeps(request.files, request.against,
                         [&](const std::string& path) { return shown_sweep(core, path); });
  } else {
    const auto against = request.against.empty() ? nullptr : std::make_unique<FileRun>(core, request.against);
    for (const std::string& path : request.files) {
      shown.push_back(shown_file(core, request, path, against, panels));
      panels.back().link = fmt::format("#result-{}", shown.size());
    }
  }
  words.insert(words.end(), {"-o", request.output});
  write_run_pages(request.output, program_command(words), panels, shown);
  if (request.printing.is_json)
    print_text("{}\n", to_text(Json::Object{{"output", request.output}}));
  else
    print_text("written: {}\n", request.output);
  return ExitCode::agreed;
}

void declare(Options& options, ReportRequest& request) {
  options.files(request.files, {"FILE.h5", "", "trajectories or sweeps of this core"}, 1, -1);
  options.text(request.against, {"--against", "GOLDEN.h5", "compare with this trajectory"});
  options.text(request.output, {"-o,--output", "FILE.html", "the page: one file, no network"});
  options.printing(request.printing);
}

}  // namespace

Command described_report_command(const DescribedCore& core) {
  return {.name = "report",
          .summary = "show trajectories or sweeps on a page for the browser",
          .example = "hyrax-sim report first.h5 --against golden/first.h5 -o first.html",
          .declare = with_request<ReportRequest>(
              declare, [&core](const ReportRequest& request) { return report(core, request); })};
}

}  // namespace hyrax
