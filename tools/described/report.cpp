#include <fmt/format.h>

#include "sim/described/described_figure.h"
#include "sim/result/number_text.h"
#include "tools/app/command_line/shell_command.h"
#include "tools/described/commands.h"
#include "tools/described/run_text.h"
#include "tools/described/trajectory_file.h"
#include "tools/store/output_guard.h"

namespace hyrax {
namespace {

struct ReportRequest {
  std::vector<std::string> files;
  std::string against;
  std::string output;
  Printing printing;
};

// A run, as its file has it.
class FileRun final : public DescribedSink {
 public:
  FileRun(const DescribedFile& file, DescribedPicture& picture) : picture_(picture) {
    summary_.steps = file.head().steps;
    summary_.contacts.resize(file.head().description.contacts.size());
    for (const DescribedContact& contact : file.contacts()) ++summary_.contacts[contact.contact];
  }
  void row(const DescribedRow& row) override {
    picture_.row(row);
    summary_.simulated_s = row.t_s;
    summary_.final.assign(row.state.begin(), row.state.end());
  }
  [[nodiscard]] const DescribedSummary& summary() const { return summary_; }

 private:
  DescribedPicture& picture_;
  DescribedSummary summary_ = {};
};

ShownResult shown_file(const DescribedCore& core, const ReportRequest& request, const std::string& path,
                       std::vector<RunPanel>& panels) {
  const DescribedFile file = DescribedFile::open(path, core.description.core);
  const DescribedHead& head = file.head();
  const Description& description = head.description;
  const DescribedScenario& scenario = head.scenario;
  DescribedPicture picture(description, scenario);
  FileRun run(file, picture);
  file.show(run);
  const DescribedSummary& summary = run.summary();
  ShownResult shown =
      shown_run(description, scenario, summary, picture,
                fmt::format("{}, {:.6g} s", plain_counted(head.steps, "step"), summary.simulated_s),
                {{"core", description.core}, {"file", path}, {"state hash", head.state_hash}});
  panels.push_back({.name = scenario.name, .status = "played", .picture = panel_picture(picture)});
  if (!request.against.empty()) {
    const DescribedComparison comparison =
        compare_files(core, DescribedFile::open(request.against, core.description.core), file);
    panels.back().status = comparison.agrees() ? "agreed" : "disagreed";
    if (comparison.agrees())
      shown.judgement = "Agrees with " + request.against + ", bit for bit.";
    else
      shown.verdict.broken.push_back("differs from " + request.against + ": " +
                                     comparison_sentence(comparison));
  }
  return shown;
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
  for (const std::string& path : request.files) {
    shown.push_back(shown_file(core, request, path, panels));
    panels.back().link = fmt::format("#result-{}", shown.size());
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
  options.files(request.files, {"FILE.h5", "", "trajectory files of this core"}, 1, -1);
  options.text(request.against, {"--against", "GOLDEN.h5", "compare with this trajectory"});
  options.text(request.output, {"-o,--output", "FILE.html", "the page: one file, no network"});
  options.printing(request.printing);
}

}  // namespace

Command described_report_command(const DescribedCore& core) {
  return {.name = "report",
          .summary = "show trajectories on a page for the browser",
          .example = "hyrax-sim report first.h5 --against golden/first.h5 -o first.html",
          .declare = with_request<ReportRequest>(
              declare, [&core](const ReportRequest& request) { return report(core, request); })};
}

}  // namespace hyrax
