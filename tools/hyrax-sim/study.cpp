// The command study over the studies of sim/study.
#include <algorithm>
#include <chrono>
#include <set>
#include <sstream>

#include <fmt/ranges.h>

#include "sim/study/study.h"
#include "tools/app/command_line/print.h"
#include "tools/app/core/accepted_core.h"
#include "tools/app/core/core_requirements.h"
#include "tools/app/study/study_command.h"
#include "tools/files/failure.h"
#include "tools/files/scenario_reader.h"
#include "tools/hyrax-sim/program.h"
#include "tools/platform/guarded_child.h"
#include "tools/platform/process.h"
#include "tools/run_core/run_core.h"

namespace hyrax {
namespace {

// What other programs take from this one is no cost of the work, so it is the processor time of this thread.
// To read that takes a microsecond: where nothing was taken, the time that passed is less, and is the better
// one.
std::int64_t time_of(const std::function<void()>& work) {
  using Clock = std::chrono::steady_clock;
  const std::int64_t from_processor_ns = thread_time_ns();
  const Clock::time_point from = Clock::now();
  work();
  const std::chrono::nanoseconds passed = Clock::now() - from;
  return std::min<std::int64_t>(passed.count(), thread_time_ns() - from_processor_ns);
}

// What a process measured in a call of the meter: a line.
void print_times(const ProcessTimes& times) {
  print_text("{} {} {}\n", times.probe.median_ns, times.probe.drift_rel, fmt::join(times.works_ns, " "));
}

// A member each call.
std::vector<ProcessTimes> read_times(const std::string& printed) {
  std::vector<ProcessTimes> calls;
  std::istringstream lines(printed);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream numbers(line);
    ProcessTimes& times = calls.emplace_back();
    numbers >> times.probe.median_ns >> times.probe.drift_rel;
    for (std::string number; numbers >> number;) times.works_ns.push_back(std::stod(number));  // "nan", too.
  }
  return calls;
}

// Measures in processes of their own: this program plays the same study in each, one after the other, up to
// its costs. All calls of the meter share them; one that needs more starts more.
class CostProcesses {
 public:
  explicit CostProcesses(const StudyInput& input) : input_(input) {}

  std::vector<ProcessTimes> operator()(const Works& works, const CostOptions& options) {
    for (int process = static_cast<int>(std::ssize(processes_)); process < options.processes; ++process) {
      if (input_.report_progress) input_.report_progress("processes", process, options.processes);
      processes_.push_back(read_times(printed_by(process)));
    }
    std::vector<ProcessTimes> times;
    for (int process = 0; process < options.processes; ++process) {
      const std::vector<ProcessTimes>& calls = processes_[static_cast<std::size_t>(process)];
      if (call_ >= calls.size() || calls[call_].works_ns.size() != works.size())
        throw std::logic_error("a process that measures costs has measured others");
      times.push_back(calls[call_]);
    }
    ++call_;
    return times;
  }

 private:
  [[nodiscard]] std::string printed_by(int process) const {
    if (std::ranges::count(input_.scenarios, "-") > 0)
      refuse_input("-: processes that measure costs cannot read standard input again; name a scenario file");
    std::vector<std::string> words = input_.words;
    words.insert(words.begin(), "hyrax-sim");
    words.insert(words.end(), {kCostsOption, std::to_string(process)});
    const std::string what = "hyrax-sim study: costs";
    const WorkEnd end = in_new_process(what, std::move(words));
    if (!end.result)
      throw Failure(ExitCode::cannot_access,
                    fmt::format("{}: the process that measures them ended {}", what,
                                end.signal != 0 ? fmt::format("by signal {}", end.signal) : "with an error"));
    return *end.result;
  }

  const StudyInput& input_;
  std::vector<std::vector<ProcessTimes>> processes_;
  std::size_t call_ = 0;
};

StudyRequest request_of(const Study& study, const StudyInput& input) {
  StudyRequest request{.core = input.core,
                       .is_quick = input.is_quick,
                       .within_px = input.within_px,
                       .core_step = program_step(input.core),
                       .machine = processor_name(),
                       .report_progress = input.report_progress};
  std::set<std::string> names;
  for (const std::string& path : input.scenarios) {
    request.scenarios.push_back({path, load_scenario(path)});
    const Scenario& scenario = request.scenarios.back().scenario;
    const Core core = run_core(input.core, path, scenario);
    if (study.needs_paper_step || core.constants)
      require_paper_core(core, path);
    else
      require_measurable(core, path, scenario);
    const std::string& name = scenario.name;
    if (!names.insert(name).second)
      refuse_input(path + ": /name: duplicate scenario name (found " + name +
                   "); scenarios of one study need different names");
  }
  const auto has_other_parameters = [&](const NamedScenario& named) {
    return named.scenario.parameters != request.scenarios.front().scenario.parameters;
  };
  if (!input.scenarios.empty() && std::ranges::none_of(request.scenarios, has_other_parameters))
    request.core = run_core(input.core, input.scenarios.front(), request.scenarios.front().scenario);
  return request;
}

Result run_study(const Study& study, const StudyRequest& request) {
  try {
    return study.run(request);
  } catch (const RequestRefused& refused) {
    refuse_input(refused.what());
  }
}

Result run_study(const Study& study, const StudyInput& input) {
  CostProcesses processes(input);
  StudyRequest request = request_of(study, input);
  request.measure_costs = std::ref(processes);
  return run_study(study, request);
}

void print_costs(const Study& study, const StudyInput& input, int process) {
  StudyRequest request = request_of(study, input);
  request.is_costs_only = true;
  request.core_step = nullptr;  // Its paths have no cost.
  request.measure_costs = [process](const Works& works, const CostOptions& options) {
    const ProcessTimes times = time_works(works, time_of, options, process);
    print_times(times);
    return std::vector{times};
  };
  static_cast<void>(run_study(study, request));
}

}  // namespace

Command study_command() {
  std::vector<OfferedStudy> offered;
  for (const Study& study : studies())
    offered.push_back(
        {study.name, study.summary, study.takes_within, study.default_scenarios,
         [&study](const StudyInput& input) { return run_study(study, input); },
         [&study](const Core& core) {
           if (study.needs_paper_step || core.constants)
             require_paper_core(core, "hyrax-sim study " + study.name);
         },
         [&study](const StudyInput& input, int process) { print_costs(study, input, process); }});
  Command command = study_command_of(
      std::move(offered),
      {{"paper", "was removed; the paper's claims and their figures are in sim/physics/claims.md"},
       {"rest", "was removed; study frame-rate says where, when and how flings end at each rate"},
       {"bounces", "was removed; study hard-cases plays bounces without loss"}});
  command.summary = "measure error against cost, needs, hard cases, frame rates";
  command.example =
      "hyrax-sim study frame-rate --report frame-rate.html\n"
      "  hyrax-sim study needs scenarios/flings/first-fling.json --within 1px";
  command.is_common = true;
  return command;
}

}  // namespace hyrax
