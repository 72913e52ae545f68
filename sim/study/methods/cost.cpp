#include "sim/study/methods/cost.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <numeric>

#include <fmt/format.h>

#include "sim/scenario/split_mix64.h"

namespace hyrax {
namespace {

// A chain of multiplications, each of which waits for the one before: nothing but the clock decides how
// long it takes.
double probe_chain() {
  volatile double factor = 1.0000001;
  double product = factor;
  for (int link = 0; link < 5'000; ++link) product *= factor;
  return product;
}

std::int64_t probe_ns(const NanosecondClock& now_ns) {
  const std::int64_t from_ns = now_ns();
  volatile double product = probe_chain();
  static_cast<void>(product);
  return now_ns() - from_ns;
}

// The works in random order (Fisher and Yates; Durstenfeld, CACM 7:420, 1964).
std::vector<std::size_t> shuffled(std::size_t works, int round) {
  constexpr std::uint64_t kSeed = 1;
  std::vector<std::size_t> order(works);
  std::iota(order.begin(), order.end(), std::size_t{0});
  const std::uint64_t first = static_cast<std::uint64_t>(round) * works;
  for (std::size_t end = works; end > 1; --end)
    std::swap(order[end - 1], order[split_mix64(kSeed, first + end) % end]);
  return order;
}

// Each round's value of two works; none where one is not measured.
template <class Function>
std::vector<double> by_round(const Cost& a, const Cost& b, const Function& function) {
  if (!a.is_measured() || !b.is_measured()) return {};
  assert(a.rounds_ns.size() == b.rounds_ns.size());
  std::vector<double> values;
  std::transform(a.rounds_ns.begin(), a.rounds_ns.end(), b.rounds_ns.begin(), std::back_inserter(values),
                 function);
  return values;
}

ClockProbe probe_of(const std::vector<double>& probes_ns) {
  ClockProbe probe{.median_ns = quantile(probes_ns, 0.5)};
  if (probe.median_ns > 0.0)
    probe.drift_rel = (quantile(probes_ns, 0.95) - quantile(probes_ns, 0.05)) / probe.median_ns;
  return probe;
}

}  // namespace

Cost cost_of(std::vector<double> rounds_ns) {
  const MedianEstimate time_ns = median_of(rounds_ns);
  return {std::move(rounds_ns), time_ns};
}

Cost difference_of(const Cost& work, const Cost& part, double divisor) {
  return cost_of(by_round(work, part, [divisor](double a, double b) { return (a - b) / divisor; }));
}

bool is_cheaper(const Cost& a, const Cost& b) {
  return median_of(by_round(a, b, std::divides<>())).high < 1.0;
}

std::string unsteady_text(const ClockProbe& probe) {
  if (probe.is_steady()) return "";
  return fmt::format("not measured: clock unsteady (drift {:.0f} %, at most {:.0f} %)",
                     100.0 * probe.drift_rel, 100.0 * ClockProbe::kDriftMax_rel);
}

Costs measure_costs(const std::vector<std::function<void()>>& works, const NanosecondClock& now_ns,
                    const CostOptions& options,
                    const std::function<void(std::int64_t, std::int64_t)>& report_progress) {
  std::vector<std::int64_t> runs_per_sample;
  for (const auto& work : works) {
    work();
    const std::int64_t from_ns = now_ns();
    work();
    const std::int64_t run_ns = std::max<std::int64_t>(now_ns() - from_ns, 1);
    runs_per_sample.push_back(std::max<std::int64_t>(1, options.sample_ns / run_ns));
  }
  std::vector<std::vector<double>> rounds_ns(works.size());
  std::vector<double> probes_ns{static_cast<double>(probe_ns(now_ns))};
  constexpr std::int64_t kSamplesBetweenProbes = 4;
  std::int64_t samples = 0;
  for (int round = 0; round < options.repetitions; ++round)
    for (const std::size_t work : shuffled(works.size(), round)) {
      const std::int64_t runs = runs_per_sample[work];
      const std::int64_t from_ns = now_ns();
      for (std::int64_t run = 0; run < runs; ++run) works[work]();
      rounds_ns[work].push_back(static_cast<double>(now_ns() - from_ns) / static_cast<double>(runs));
      if (samples++ % kSamplesBetweenProbes == 0) probes_ns.push_back(static_cast<double>(probe_ns(now_ns)));
      if (report_progress)
        report_progress(samples, std::ssize(works) * static_cast<std::int64_t>(options.repetitions));
    }
  Costs result{.costs = std::vector<Cost>(works.size()), .probe = probe_of(probes_ns)};
  if (result.probe.is_steady())
    std::transform(rounds_ns.begin(), rounds_ns.end(), result.costs.begin(), cost_of);
  return result;
}

}  // namespace hyrax
