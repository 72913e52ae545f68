#include "tools/app/command_line/options.h"
#include "tools/app/command_line/shell_command.h"
#include "tools/app/report/report_page.h"
#include "tools/store/output_guard.h"

namespace hyrax {
namespace {

struct ReportArguments {
  ReportRequest request;
  Printing printing;
};

std::string command_of(const ReportRequest& request) {
  std::vector<std::string> words = {"report"};
  for (const std::string& file : request.files) words.push_back(as_argument(file));
  if (!request.against.empty()) words.insert(words.end(), {"--against", request.against});
  words.insert(words.end(), {"-o", request.output});
  return program_command(words);
}

ExitCode write_page(const Core& core, const ReportArguments& arguments) {
  ReportRequest request = arguments.request;
  if (request.output.empty()) refuse_input("hyrax-sim report: -o FILE.html is missing");
  std::vector<std::string> inputs = request.files;
  if (!request.against.empty()) inputs.push_back(request.against);
  OutputGuard guard(inputs);
  guard.admit("hyrax-sim report: -o", request.output, {".html"});
  request.command = command_of(request);
  write_report(core, request);
  if (arguments.printing.is_json)
    print_text("{}\n", to_text(Json::Object{{"output", request.output}}));
  else
    print_text("written: {}\n", request.output);
  return ExitCode::agreed;
}

void declare(Options& options, ReportArguments& arguments) {
  ReportRequest& request = arguments.request;
  options.files(request.files, {"FILE.h5", "", "trajectory files; or files of sweeps"}, 1, -1);
  options.text(request.against, {"--against", "GOLDEN.h5", "compare with this trajectory, and draw both"});
  options.text(request.output, {"-o,--output", "FILE.html", "the page: one file, no network"});
  options.printing(arguments.printing);
}

}  // namespace

Command report_command() {
  return {.name = "report",
          .summary = "show trajectories or sweeps on a page for the browser, which replays them",
          .example =
              "hyrax-sim report first-fling.h5 -o first-fling.html\n"
              "  hyrax-sim report new.h5 --against golden/flings/first-fling.h5 -o difference.html\n"
              "  hyrax-sim report sweep.h5 -o sweep.html",
          .declare = with_request<ReportArguments>(declare, write_page)};
}

}  // namespace hyrax
