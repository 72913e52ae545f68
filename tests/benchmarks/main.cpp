// Prints the figures of speed: `hyrax-figures [PATH OF hyrax-sim] [PATH OF scenarios]`.
#include <fmt/format.h>

#include <exception>
#include <filesystem>
#include <fstream>
#include <thread>

#include "tests/benchmarks/figure.h"
#include "tools/files/build_info.h"

namespace {

std::string processor() {
  std::ifstream cpuinfo("/proc/cpuinfo");
  for (std::string line; std::getline(cpuinfo, line);)
    if (line.starts_with("model name")) return line.substr(line.find(": ") + 2);
  return "unknown processor";
}

void print(const hyrax::bench::Figure& figure) {
  const bool is_reached =
      figure.is_at_least ? figure.measured >= figure.goal : figure.measured <= figure.goal;
  fmt::print("{:<64} {:>9.4g} {:<2} ({:.4g} .. {:.4g})  {} {:g}{}\n", figure.what, figure.measured,
             figure.unit, figure.low, figure.high, figure.is_at_least ? "at least" : "at most", figure.goal,
             is_reached ? "" : "  NOT REACHED");
}

}  // namespace

int main(int argc, char** argv) try {
  const auto here = std::filesystem::canonical("/proc/self/exe").parent_path();
  const std::string program = argc > 1 ? argv[1] : (here / "hyrax-sim").string();
  const std::string scenarios = argc > 2 ? argv[2] : HYRAX_SOURCE_DIR "/scenarios";
  const hyrax::BuildInfo build = hyrax::build_info();
  fmt::print("{}, {} threads; {}, {}\nmedian (quartiles), goal\n", processor(),
             std::thread::hardware_concurrency(), build.compiler, build.flags);
  for (const auto& figure : hyrax::bench::core_figures()) print(figure);
  for (const auto& figure : hyrax::bench::described_figures()) print(figure);
  for (const auto& figure : hyrax::bench::drift_figures()) print(figure);
  for (const auto& figure : hyrax::bench::ensemble_figures()) print(figure);
  for (const auto& figure : hyrax::bench::program_figures(program, scenarios)) print(figure);
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "hyrax-figures: {}\n", error.what());
  return 1;
}
