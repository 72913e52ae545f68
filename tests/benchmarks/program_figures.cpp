#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>

#include <fmt/format.h>

#include "tests/benchmarks/figure.h"
#include "tests/benchmarks/stopwatch.h"
#include "tools/files/scenario_reader.h"
#include "tools/files/scenario_writer.h"
#include "tools/files/text_file.h"

extern char** environ;

namespace hyrax::bench {
namespace {

namespace fs = std::filesystem;

// Runs a program with its output thrown away; returns its peak memory in MB.
double run(const std::vector<std::string>& command) {
  std::vector<char*> arguments;
  for (const std::string& part : command) arguments.push_back(const_cast<char*>(part.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  pid_t child = 0;
  const int error = posix_spawn(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  int status = -1;
  rusage usage{};
  if (error == 0) wait4(child, &status, 0, &usage);
  if (status != 0) throw std::runtime_error(command[0] + " " + command[1] + " did not end with exit code 0");
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

Figure of(std::string what, const Timing& timing, double scale, double goal, std::string unit) {
  return {std::move(what),
          scale * timing.median(),
          scale * timing.quantile(0.25),
          scale * timing.quantile(0.75),
          goal,
          false,
          std::move(unit)};
}

// A temporary folder, removed with this object.
struct Workplace {
  fs::path folder = fs::temp_directory_path() / ("hyrax-figures-" + std::to_string(getpid()));
  Workplace() { fs::create_directories(folder / "scenarios"); }
  Workplace(const Workplace&) = delete;
  Workplace& operator=(const Workplace&) = delete;
  ~Workplace() {
    std::error_code ignored;
    fs::remove_all(folder, ignored);
  }
};

std::vector<Figure> check_figures(const std::string& program, const std::string& scenario_path) {
  const Workplace workplace;
  const std::string scenarios = (workplace.folder / "scenarios").string();
  Scenario scenario = load_scenario(scenario_path);
  scenario.expect.reset();
  for (int index = 0; index < 1000; ++index) {
    scenario.name = "fling-" + std::to_string(index);
    scenario.start_velocity.vx_px_per_s = 900.0 + 0.37 * index;
    write_text_file(scenarios + "/" + scenario.name + ".json", scenario_file_text(scenario));
  }
  run({program, "bless", scenarios, "--reason", "figures"});
  const auto timings = time_side_by_side({[&] { run({program, "check", scenarios, "--jobs", "1"}); }}, 9);
  // Of 1000 scenarios in s is of one in ms; in microseconds a thousand times that.
  return {of("check of one scenario of 600 steps", timings[0], 1e3, 300.0, "us")};
}

Figure run_figure(const std::string& program, const std::string& scenario_path) {
  const Workplace workplace;
  const std::string output = (workplace.folder / "run.h5").string();
  const auto timings = time_side_by_side({[&] { run({program, "run", scenario_path, "-o", output}); }}, 201);
  return of("run of 600 steps, process start to exit", timings[0], 1e3, 3.5, "ms");
}

Figure start_figure() {
  const auto timings = time_side_by_side({[] { run({"/bin/true", ""}); }}, 201);
  return of("(fork and exec of /bin/true, for comparison)", timings[0], 1e3, 3.5, "ms");
}

Figure library_figure(const std::string& program, const std::string& scenarios) {
  const auto timings = time_side_by_side({[&] { run({program, "check", scenarios}); }}, 9);
  return of("all scenarios of the library checked", timings[0], 1.0, 1.0, "s");
}

Figure memory_figure(const std::string& program, const std::string& scenario_path) {
  const Workplace workplace;
  const double megabytes =
      run({program, "run", scenario_path, "-o", (workplace.folder / "run.h5").string(), "--set",
           "/steps=1000000000", "--set", "/record={\"every\": 1000000}", "--set", "/expect={}"});
  return {"memory of 1e9 steps with record.every 1e6", megabytes, megabytes, megabytes, 100.0, false, "MB"};
}

// A sweep of throws that keeps their ends.
std::vector<std::string> sweep_command(const std::string& program, const Workplace& workplace,
                                       const std::string& scenario_path, std::int64_t members,
                                       const std::string& threads) {
  const std::string path = (workplace.folder / "sweep.json").string();
  write_text_file(path, fmt::format(R"({{"format": "hyrax-sweep/1", "base": "{}", "members": {}, "seed": 1,
    "vary": {{"/start/vx_px_per_s": {{"uniform": [-2000, 2000]}}}}, "keep": ["final"]}})",
                                    fs::absolute(scenario_path).string(), members));
  return {program,     "sweep", path,     "-o", (workplace.folder / "sweep.h5").string(),
          "--threads", threads, "--quiet"};
}

Figure thread_figure(const std::string& program, const std::string& scenario_path) {
  const Workplace workplace;
  const auto play = [&](const std::string& threads) {
    run(sweep_command(program, workplace, scenario_path, 4'000'000, threads));
  };
  const auto timings = time_side_by_side({[&] { play("1"); }, [&] { play("2"); }}, 5);
  return {"sweep of 4e6 members, two threads, times faster than one",
          timings[0].median() / timings[1].median(),
          timings[0].quantile(0.25) / timings[1].quantile(0.75),
          timings[0].quantile(0.75) / timings[1].quantile(0.25),
          1.9,
          true,
          ""};
}

std::vector<Figure> large_sweep_figures(const std::string& program, const std::string& scenario_path) {
  const Workplace workplace;
  double megabytes = 0.0;
  const auto timings = time_side_by_side(
      {[&] { megabytes = run(sweep_command(program, workplace, scenario_path, 10'000'000, "2")); }}, 1);
  return {of("sweep of 1e7 members of 10 s, two threads, with its file", timings[0], 1.0, 30.0, "s"),
          {"memory of a sweep of 1e7 members", megabytes, megabytes, megabytes, 200.0, false, "MB"}};
}

}  // namespace

std::vector<Figure> program_figures(const std::string& program, const std::string& scenarios) {
  const std::string first = scenarios + "/flings/first-fling.json";
  std::vector<Figure> figures = check_figures(program, first);
  figures.push_back(run_figure(program, first));
  figures.push_back(start_figure());
  figures.push_back(library_figure(program, scenarios));
  figures.push_back(memory_figure(program, first));
  figures.push_back(thread_figure(program, first));
  for (Figure& figure : large_sweep_figures(program, first)) figures.push_back(std::move(figure));
  return figures;
}

}  // namespace hyrax::bench
