#include "tools/hyrax-sim/margin_text.h"

#include <fmt/format.h>

#include <charconv>

#include "tools/hyrax-sim/drift_run.h"

namespace hyrax {
namespace {

// Two digits, never more than the value.
std::string rounded_down(double value) {
  std::string text = fmt::format("{:.17e}", value);
  text.erase(text.find('.') + 2, 16);
  double rounded = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), rounded);
  return fmt::format("{:g}", rounded);
}

}  // namespace

bool is_knife_edge(const Margin& margin) {
  constexpr double kKnifeEdge = 1e-9;
  return margin.half_width && *margin.half_width < kKnifeEdge;
}

std::string margin_text(const Margin& margin) {
  if (!margin.half_width || !margin.nearest) return "no start changes the contacts";
  return fmt::format("any start within ±{} px and px/s keeps all contacts; nearest decision: {}, step {}",
                     rounded_down(*margin.half_width),
                     kDecisionNames[static_cast<std::size_t>(margin.nearest->decision)],
                     margin.nearest->step);
}

std::string margin_in_summary(const FreshRun& fresh) {
  RunRows rows = rows_of(fresh.run.scenario, fresh.summary);
  if (fresh.run.rows.size() > 0)  // All of them: no replay is needed.
    rows.hand_to = [&](RowSink& sink, std::int64_t) { sink.rows(fresh.run.rows); };
  const Margin margin = margin_of(rows);
  return margin_text(margin) + (is_knife_edge(margin) ? " (a knife edge)" : "");
}

}  // namespace hyrax
