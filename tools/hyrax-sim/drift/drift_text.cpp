#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tools/hyrax-sim/drift/drift_report.h"
#include "tools/hyrax-sim/drift/margin_text.h"

namespace hyrax {
namespace {

constexpr std::size_t kLinesMax = 20;  // Of arcs, and of contacts.

// Three digits, and an exponent only where it is shorter.
std::string number(double value) {
  const double size = std::fabs(value);
  if (size == 0.0 || (size >= 1e-3 && size < 999.5)) return fmt::format("{:.3g}", value);
  if (size >= 999.5 && size < 1e6) return fmt::format("{:.0f}", value);
  return fmt::format("{:.1e}", value);
}
std::string number(const std::optional<double>& value) { return value ? number(*value) : std::string("-"); }
std::string number(const std::optional<Worst>& worst) {
  return worst ? number(worst->value) : std::string("-");
}
std::string percent(double rel) { return number(100.0 * rel); }
std::string percent(const std::optional<double>& rel) { return rel ? percent(*rel) : std::string("-"); }
std::string percent(const std::optional<Worst>& worst) {
  return worst ? number(100.0 * worst->value) : std::string("-");
}
std::string milliseconds(const std::optional<double>& seconds) {
  return seconds ? number(1e3 * *seconds) : std::string("-");
}

std::string arcs_text(std::int64_t count) { return fmt::format("{} arc{}", count, count == 1 ? "" : "s"); }

std::string clock_text(const Clock& clock) {
  std::string text = "at recorded dt";
  if (const auto* rate = std::get_if<FixedRate>(&clock.base)) text = fmt::format("at {} Hz", rate->rate_hz);
  if (const auto* step = std::get_if<FixedStep>(&clock.base)) text = fmt::format("at dt {} s", step->dt_s);
  return clock.jitter ? text + ", jittered" : text;
}

std::string head_text(const DriftRun& run) {
  return fmt::format("{}: {} steps, {:.6g} s {}\n", run.scenario.name, run.steps, run.simulated_s,
                     clock_text(run.scenario.clock));
}

std::string reference_text(const std::optional<GslOptions>& gsl) {
  if (!gsl) return "  reference    closed form alone\n";
  return fmt::format("  reference    closed form, checked by GSL {} at {:g}\n",
                     kGslStepperNames[static_cast<std::size_t>(gsl->stepper)], gsl->tolerance);
}

template <class... Columns>
std::string arc_line(const Columns&... columns) {
  return fmt::format("  {:>7} {:>7} {:>7} {:<6} {:>9} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8}\n", columns...);
}

// Beside the drift in percent, which depends on how high the arc begins.
std::string energy_text(const DriftSummary& summary) {
  if (!summary.energy_drift_max_px2_per_s2) return "";
  const auto [drift, first_step] = *summary.energy_drift_max_px2_per_s2;
  return fmt::format("  energy       drift at most {} px²/s², in the arc from row {}\n", number(drift),
                     first_step);
}

std::string arcs_text(const DriftRun& run) {
  const DriftSummary& summary = run.summary;
  if (summary.arcs == 0) return "  no flight arc of two steps or more\n";
  std::string text =
      arc_line("arc", "", "time", "ended", "implem.", "trunc.", "model", "drift", "at end", "slope", "GSL") +
      arc_line("from", "to", "s", "by", "px", "px", "px", "%", "%", "%/s", "off px");
  for (std::size_t index = 0; index < std::min(run.arcs.size(), kLinesMax); ++index) {
    const ArcErrors& arc = run.arcs[index];
    text += arc_line(arc.first_step, arc.last_step, fmt::format("{:.4g}", arc.duration_s),
                     kArcEndNames[static_cast<std::size_t>(arc.ended_by)], number(arc.implementation_px),
                     number(arc.truncation_px), number(arc.model_px), percent(arc.energy_drift_rel_max),
                     percent(arc.energy_drift_rel_end), percent(arc.energy_drift_slope_per_s),
                     number(arc.gsl_vs_closed_px));
  }
  if (summary.arcs > static_cast<std::int64_t>(kLinesMax))
    text += fmt::format("  ... {} more; --json lists them\n",
                        summary.arcs - static_cast<std::int64_t>(kLinesMax));
  return text +
         arc_line("worst", "", "", "", number(summary.implementation_px), number(summary.truncation_px),
                  number(summary.model_px), percent(summary.energy_drift_rel_max), "",
                  percent(summary.energy_drift_slope_per_s), number(summary.gsl_vs_closed_px)) +
         energy_text(summary);
}

template <class... Columns>
std::string contact_line(const Columns&... columns) {
  return fmt::format("  {:>7} {:<6} {:>14} {:>14} {:>14} {:>14}\n", columns...);
}

std::string contacts_text(const DriftRun& run) {
  const DriftSummary& summary = run.summary;
  if (summary.contacts == 0) return "";
  std::string text =
      contact_line("contact", "wall", "time error ms", "overshoot px", "energy jump %", "restitution");
  for (std::size_t index = 0; index < std::min(run.contacts.size(), kLinesMax); ++index) {
    const ImpactErrors& contact = run.contacts[index];
    text +=
        contact_line(contact.step, kWallNames[wall_index(contact.wall)], milliseconds(contact.time_error_s),
                     number(contact.overshoot_px), percent(contact.energy_jump_rel),
                     contact.effective_restitution ? fmt::format("{:.4f}", *contact.effective_restitution)
                                                   : std::string("-"));
  }
  if (summary.contacts > static_cast<std::int64_t>(kLinesMax))
    text += fmt::format("  ... {} more; --json lists them\n",
                        summary.contacts - static_cast<std::int64_t>(kLinesMax));
  const Spread& restitution = summary.effective_restitution;
  if (restitution.count() > 0)
    text +=
        fmt::format("  restitution  {:.4f} on average, spread {:.4f}, over {} contacts; the paper's is 0.6\n",
                    restitution.mean(), restitution.standard_deviation(), restitution.count());
  return text;
}

std::string faults_text(const DriftSummary& summary) {
  std::string text;
  if (summary.non_finite_step)
    text += fmt::format("  NOT FINITE   from row {}; nothing from there on was measured\n",
                        *summary.non_finite_step);
  if (summary.steps_astray > 0)
    text += fmt::format("  ASTRAY       {} steps of flight are not the paper's step, bit for bit\n",
                        summary.steps_astray);
  if (summary.reference_faults > 0)
    text += fmt::format("  FAULT        of the reference in {}, the first from row {}: {}\n",
                        arcs_text(summary.reference_faults), summary.first_reference_fault_step.value_or(0),
                        summary.first_reference_fault);
  return text;
}

// The words in lines that fit a terminal, under each other.
std::string wrapped(const std::string& label, const std::vector<std::string>& words) {
  constexpr std::size_t kWidth = 100;
  std::string text;
  std::string line = fmt::format("  {:<12}", label);
  for (std::size_t index = 0; index < words.size(); ++index) {
    const std::string word = words[index] + (index + 1 < words.size() ? ";" : "");
    if (line.size() + 1 + word.size() > kWidth) {
      text += line + "\n";
      line = std::string(14, ' ');
    }
    line += " " + word;
  }
  return text + line + "\n";
}

// Two digits at most, for a line that holds much.
std::string brief(double value) {
  const double size = std::fabs(value);
  if (size >= 99.5 && size < 1e6) return fmt::format("{:.0f}", value);
  if (size < 0.01) return fmt::format("{:.1g}", value);
  return fmt::format("{:.2g}", value);
}

// Relative drift of a short, low arc says little, so it is the longest arc's.
std::string drift_of(const std::optional<ArcErrors>& longest) {
  if (!longest || !longest->energy_drift_slope_per_s) return "-";
  return brief(100.0 * *longest->energy_drift_slope_per_s);
}

std::string truncation_of(const DriftSummary& summary) {
  return summary.truncation_px ? brief(summary.truncation_px->value) : std::string("-");
}

// One line, the last: what a step costs here, what it errs by, and the same for frames half as long.
std::string speed_text(const DriftReport& report) {
  if (!report.step_ns) return "";
  std::string text =
      fmt::format("  this machine {} ns/step, trunc. {} px, drift {} %/s; half dt", brief(*report.step_ns),
                  truncation_of(report.run.summary), drift_of(report.run.longest_arc));
  if (!report.half_dt.half) return text + fmt::format(" unmeasured: {}\n", report.half_dt.why_not);
  const HalfDt& half = *report.half_dt.half;
  return text + fmt::format(": {} ns, {} px, {} %/s\n", brief(2.0 * half.step_ns),
                            truncation_of(half.summary), drift_of(half.longest_arc));
}

std::string convergence_text(const DriftReport& report) {
  if (!shows_no_convergence(report)) return "";
  return fmt::format(
      "  model        half the dt takes {} px to {} px: against a fixed drag rate the\n"
      "               paper's step does not converge, since it drags once a frame, however short\n",
      number(report.run.summary.model_px), number(report.half_dt.half->summary.model_px));
}

}  // namespace

bool shows_no_convergence(const DriftReport& report) {
  if (!report.half_dt.half) return false;
  const std::optional<Worst>& now = report.run.summary.model_px;
  const std::optional<Worst>& half = report.half_dt.half->summary.model_px;
  constexpr double kHalvedAtLeast = 0.6;  // Of first order it would be 0.5.
  return now && half && half->value > kHalvedAtLeast * now->value;
}

std::vector<std::string> left_out(const DriftReport& report) {
  const DriftSummary& summary = report.run.summary;
  std::vector<std::string> words;
  if (summary.arcs_without_x > 0)
    words.push_back(fmt::format("x in {} without horizontal motion", arcs_text(summary.arcs_without_x)));
  if (!report.run.gsl) words.emplace_back("GSL (--reference gsl)");
  if (!report.has_rows_stored) words.emplace_back("errors of every row (--rows)");
  if (summary.skipped_arcs > 0)
    words.push_back(fmt::format("{} of fewer than two steps", arcs_text(summary.skipped_arcs)));
  return words;
}

std::string drift_text(const DriftReport& report) {
  const DriftRun& run = report.run;
  std::string text = head_text(run);
  if (!run.note.empty()) text += "  " + run.note + "\n";
  text += arcs_text(run) + contacts_text(run) + faults_text(run.summary);
  text += fmt::format("  {}\n", margin_text(run.margin));
  if (is_knife_edge(run.margin)) text += "  KNIFE EDGE   rounding alone may decide otherwise\n";
  text += reference_text(run.gsl);
  if (const std::vector<std::string> omitted = left_out(report); !omitted.empty())
    text += wrapped("left out", omitted);
  return text + convergence_text(report) + speed_text(report);
}

}  // namespace hyrax
