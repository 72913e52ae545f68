#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>

#include <fmt/format.h>

#include "tests/benchmarks/figure.h"
#include "tools/files/scenario_reader.h"
#include "tools/files/scenario_writer.h"
#include "tools/files/text_file.h"

extern char** environ;

namespace hyrax::bench {
namespace {

namespace fs = std::filesystem;

struct Usage {
  double peak_MB = 0.0;
  double minor_faults = 0.0;
};

// Runs a program with its output thrown away.
Usage run(const std::vector<std::string>& command) {
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
  return {static_cast<double>(usage.ru_maxrss) / 1024.0, static_cast<double>(usage.ru_minflt)};
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
  Workplace() { fs::create_directories(folder); }
  Workplace(const Workplace&) = delete;
  Workplace& operator=(const Workplace&) = delete;
  ~Workplace() {
    std::error_code ignored;
    fs::remove_all(folder, ignored);
  }
};

// A thousand scenarios with their golden files.
void bless_flings(const std::string& program, const std::string& scenario_path, const fs::path& folder) {
  fs::create_directories(folder);
  Scenario scenario = load_scenario(scenario_path);
  scenario.expect.reset();
  for (int index = 0; index < 1000; ++index) {
    scenario.name = "fling-" + std::to_string(index);
    scenario.start_velocity.vx_px_per_s = 900.0 + 0.37 * index;
    write_text_file((folder / (scenario.name + ".json")).string(), scenario_file_text(scenario));
  }
  run({program, "bless", folder.string(), "--reason", "figures"});
}

// A sweep of throws that keeps their ends.
std::vector<std::string> sweep_command(const std::string& program, const fs::path& folder,
                                       const std::string& scenario_path, std::int64_t members,
                                       const std::string& threads) {
  const std::string path = (folder / "sweep.json").string();
  write_text_file(path, fmt::format(R"({{"format": "hyrax-sweep/1", "base": "{}", "members": {}, "seed": 1,
    "vary": {{"/start/vx_px_per_s": {{"uniform": [-2000, 2000]}}}}, "keep": ["final"]}})",
                                    fs::absolute(scenario_path).string(), members));
  const std::string output = (folder / "sweep.h5").string();
  return {program, "sweep", path, "-o", output, "--threads", threads, "--quiet"};
}

}  // namespace

std::vector<Figure> program_figures(const std::string& program, const std::string& scenarios) {
  const std::string first = scenarios + "/flings/first-fling.json";
  const Workplace workplace;
  const std::string blessed = (workplace.folder / "scenarios").string();
  const std::string output = (workplace.folder / "run.h5").string();
  bless_flings(program, first, blessed);
  Usage usage;  // Of the command that was run last.
  const auto running = [&](const std::vector<std::string>& command) {
    return [&usage, command] { usage = run(command); };
  };
  const auto sweep = [&](std::int64_t members, const char* threads) {
    return [&, members, threads] {
      usage = run(sweep_command(program, workplace.folder, first, members, threads));
    };
  };
  const auto timed = [](const std::function<void()>& work, int rounds) {
    return time_side_by_side({work}, rounds)[0];
  };
  const auto memory = [&](std::string what, double goal) {
    return Figure{std::move(what), usage.peak_MB, usage.peak_MB, usage.peak_MB, goal, false, "MB"};
  };
  const auto faults = [&](std::string what, const std::function<void()>& work, double goal) {
    work();
    const double count = usage.minor_faults;
    return Figure{std::move(what), count, count, count, goal, false, ""};
  };
  const auto jittered = [&](const std::string& rows, const fs::path& into) {
    return running({program, "run", first, "-o", into.string(), "--set", "/steps=" + rows, "--set",
                    "/expect={}", "--set",
                    R"(/clock/jitter={"kind": "uniform", "fraction": 0.1, "seed": 1})"});
  };
  std::vector<Figure> figures = {
      // Of 1000 scenarios in s is of one in ms; in microseconds a thousand times that.
      of("check of one scenario of 600 steps", timed(running({program, "check", blessed, "--jobs", "1"}), 9),
         1e3, 300.0, "us"),
      of("run of 600 steps, process start to exit",
         timed(running({program, "run", first, "-o", output}), 201), 1e3, 3.5, "ms"),
      of("(fork and exec of /bin/true, for comparison)", timed(running({"/bin/true", ""}), 201), 1e3, 3.5,
         "ms"),
      of("all scenarios of the library checked", timed(running({program, "check", scenarios}), 9), 1.0, 1.0,
         "s")};
  running({program, "run", first, "-o", output, "--set", "/steps=1000000000", "--set",
           "/record={\"every\": 1000000}", "--set", "/expect={}"})();
  figures.push_back(memory("memory of 1e9 steps with record.every 1e6", 100.0));
  const auto by_threads = time_side_by_side({sweep(4'000'000, "1"), sweep(4'000'000, "2")}, 5);
  figures.push_back(ratio("sweep of 4e6 members, two threads, times faster than one", by_threads[0],
                          by_threads[1], Goal::at_least, 1.9));
  figures.push_back(of("sweep of 1e7 members of 10 s, two threads, with its file",
                       timed(sweep(10'000'000, "2"), 1), 1.0, 30.0, "s"));
  figures.push_back(memory("memory of a sweep of 1e7 members", 200.0));
  figures.push_back(faults("page faults of 1e7 jittered rows to HDF5", jittered("10000000", output), 5000.0));
  const fs::path other = workplace.folder / "other.h5";
  jittered("1000000", output)();
  jittered("1000000", other)();
  figures.push_back(faults("(of diff of two files of 1e6 rows)",
                           running({program, "diff", output, other.string()}), 8000.0));
  figures.push_back(faults("(of a sweep of 4e6 members, one thread)", sweep(4'000'000, "1"), 6000.0));
  figures.push_back(faults("(of the same, two threads)", sweep(4'000'000, "2"), 8000.0));
  figures.push_back(
      faults("(of fuzz, 2,000 runs)", running({program, "fuzz", "--runs", "2000", "--seed", "1"}), 2500.0));
  return figures;
}

}  // namespace hyrax::bench
