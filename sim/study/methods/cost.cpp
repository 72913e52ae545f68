#include "sim/study/methods/cost.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "sim/scenario/split_mix64.h"

namespace hyrax {
namespace {

// A chain of multiplications, each of which waits for the one before: nothing but the clock decides how
// long it takes.
void probe_clock() {
  volatile double factor = 1.0000001;
  double product = factor;
  for (int link = 0; link < 1'000; ++link) product *= factor;
  factor = product;
}

// The time of one run, as a mean of many.
double mean_ns(const std::function<void()>& work, std::int64_t runs, const Stopwatch& time_of) {
  const std::int64_t all_ns = time_of([&] {
    for (std::int64_t run = 0; run < runs; ++run) work();
  });
  return static_cast<double>(all_ns) / static_cast<double>(runs);
}

// How many runs of the work take so long.
std::int64_t runs_in(double time_ns, const std::function<void()>& work, const Stopwatch& time_of) {
  constexpr double kEnough = 0.1;
  for (std::int64_t runs = 1;; runs *= 10) {
    const double run_ns = std::max(mean_ns(work, runs, time_of), 1e-3);
    if (run_ns * static_cast<double>(runs) >= kEnough * time_ns)
      return std::max<std::int64_t>(1, std::llround(time_ns / run_ns));
  }
}

// The works in random order (Fisher and Yates; Durstenfeld, CACM 7:420, 1964).
std::vector<std::size_t> shuffled(std::size_t works, int round) {
  std::vector<std::size_t> order(works);
  std::iota(order.begin(), order.end(), std::size_t{0});
  const std::uint64_t first = static_cast<std::uint64_t>(round) * works;
  for (std::size_t end = works; end > 1; --end)
    std::swap(order[end - 1], order[split_mix64(kOrderSeed, first + end) % end]);
  return order;
}

ClockProbe probe_of(const std::vector<double>& probes_ns) {
  if (probes_ns.empty()) return {};
  ClockProbe probe{.median_ns = quantile(probes_ns, 0.5)};
  if (probe.median_ns > 0.0)
    probe.drift_rel = (quantile(probes_ns, 0.95) - quantile(probes_ns, 0.05)) / probe.median_ns;
  return probe;
}

}  // namespace

Cost cost_of(std::vector<double> processes_ns) {
  const MedianEstimate time_ns = median_of(processes_ns);
  return {std::move(processes_ns), time_ns};
}

Cost difference_of(const Cost& work, const Cost& part, double divisor) {
  std::vector<double> processes_ns;
  if (work.is_measured() && part.is_measured()) {
    assert(work.processes_ns.size() == part.processes_ns.size());
    for (std::size_t process = 0; process < work.processes_ns.size(); ++process)
      processes_ns.push_back((work.processes_ns[process] - part.processes_ns[process]) / divisor);
  }
  return cost_of(std::move(processes_ns));
}

int processes_for(std::int64_t comparisons) {
  constexpr int kLeast = 6;
  constexpr double kChanceMax = 0.05;
  int processes = kLeast;
  while (std::ldexp(static_cast<double>(comparisons), 1 - processes) > kChanceMax) ++processes;
  return processes;
}

bool is_cheaper(const Cost& a, const Cost& b, std::int64_t comparisons) {
  return a.is_measured() && std::ssize(a.processes_ns) >= processes_for(comparisons) &&
         std::ranges::equal(a.processes_ns, b.processes_ns, std::less<>());
}

std::string unsteady_text(const ClockProbe& probe) {
  std::string text = "not measured: clock unsteady";
  if (probe.is_steady()) return text;
  return fmt::format("{} (drift {:.0f} %, at most {:.0f} %)", text, 100.0 * probe.drift_rel,
                     100.0 * ClockProbe::kDriftMax_rel);
}

ProcessTimes time_works(const Works& works, const Stopwatch& time_of, const CostOptions& options,
                        int process) {
  const auto sample_ns = static_cast<double>(options.sample_ns);
  std::vector<std::int64_t> runs;
  for (const auto& work : works) {
    work();
    runs.push_back(runs_in(sample_ns, work, time_of));
  }
  const double probe_ns = sample_ns / static_cast<double>(runs_in(sample_ns, probe_clock, time_of));
  std::vector<std::vector<std::pair<double, double>>> samples(works.size());  // Times of a run and a probe.
  std::vector<double> probes_ns;
  for (int round = 0; round < options.rounds; ++round)
    for (const std::size_t work : shuffled(works.size(), process * options.rounds + round)) {
      const double run_ns = mean_ns(works[work], runs[work], time_of);
      const std::int64_t probes = std::llround(run_ns * static_cast<double>(runs[work]) / probe_ns);
      probes_ns.push_back(mean_ns(probe_clock, std::max<std::int64_t>(1, probes), time_of));
      samples[work].emplace_back(run_ns, probes_ns.back());
    }
  ProcessTimes times{.works_ns = {}, .probe = probe_of(probes_ns)};
  for (const auto& of_work : samples) {
    std::vector<double> steady_ns;
    for (const auto& [run_ns, after_ns] : of_work)
      if (after_ns <= (1.0 + ClockProbe::kDriftMax_rel) * times.probe.median_ns) steady_ns.push_back(run_ns);
    const bool is_measured = !steady_ns.empty() && 2 * steady_ns.size() >= of_work.size();
    times.works_ns.push_back(is_measured ? quantile(std::move(steady_ns), 0.5) : kNotGiven);
  }
  return times;
}

Costs costs_of(const std::vector<ProcessTimes>& processes) {
  assert(!processes.empty());
  Costs result{.costs = std::vector<Cost>(processes.front().works_ns.size()), .probe = {}};
  for (const ProcessTimes& process : processes)
    if (!(process.probe.drift_rel < result.probe.drift_rel)) result.probe = process.probe;
  for (std::size_t work = 0; work < result.costs.size() && result.probe.is_steady(); ++work) {
    std::vector<double> processes_ns;
    for (const ProcessTimes& process : processes)
      if (!std::isnan(process.works_ns[work])) processes_ns.push_back(process.works_ns[work]);
    if (processes_ns.size() == processes.size()) result.costs[work] = cost_of(std::move(processes_ns));
  }
  return result;
}

}  // namespace hyrax
