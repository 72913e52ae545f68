#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "sim/reference/drift_columns.h"
#include "sim/reference/model.h"
#include "tools/app/command_line/print.h"
#include "tools/app/drift/drift.h"

namespace hyrax {
namespace {

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
// At most two digits.
std::string brief(double value) {
  const double size = std::fabs(value);
  if (size >= 99.5 && size < 1e6) return fmt::format("{:.0f}", value);
  if (size < 0.01) return fmt::format("{:.1g}", value);
  return fmt::format("{:.2g}", value);
}

std::string arcs_text(std::int64_t count) { return fmt::format("{} arc{}", count, count == 1 ? "" : "s"); }

std::string reference_text(const std::optional<GslOptions>& gsl) {
  if (!gsl) return "  reference    closed form alone\n";
  return fmt::format("  reference    closed form, checked by GSL {} at {:g}\n",
                     kGslStepperNames[static_cast<std::size_t>(gsl->stepper)], gsl->tolerance);
}

std::string more_text(std::int64_t count, std::size_t listed_max) {
  const std::int64_t more = count - static_cast<std::int64_t>(listed_max);
  return more > 0 ? fmt::format("  ... {} more; --verbose lists them\n", more) : "";
}

// How wrong the run is, and what a step of it costs: the first lines.
std::string whole_text(const DriftReport& report) {
  const DriftRun& run = report.run;
  if (!run.whole.run) return fmt::format("  whole run    no exact fling: {}\n", run.whole.why_not);
  const WholeRun& whole = *run.whole.run;
  std::string text = fmt::format(
      "  whole run    ends {} px from the exact fling, {} px at most, in row {}\n"
      "               energy {} px of height off at the end, {} px at most\n",
      number(whole.end_px), number(whole.max_px), whole.max_px_step, number(whole.energy_end_px),
      number(whole.energy_max_px));
  if (run.summary.secular_px_per_s)
    text += fmt::format("               in flight {} px of height a second{}\n",
                        number(run.summary.secular_px_per_s),
                        report.step_ns ? fmt::format(", at {} ns a step", brief(*report.step_ns)) : "");
  if (whole.contacts_differ_from)
    text += fmt::format("               other contacts than the exact fling's from row {}\n",
                        *whole.contacts_differ_from);
  return text;
}

std::string padded(const std::string& text, int width) {
  return width < 0 ? fmt::format(" {:<{}}", text, -width) : fmt::format(" {:>{}}", text, width);
}

// A line of the text columns: field(column) of each, at its width.
std::string line_of(const auto& field, const auto&... columns) {
  std::string line = " ";
  const auto add = [&](const auto& described) {
    for (const auto& each : described)
      if (const int width = each.text.width; width != 0) line += padded(field(each), width);
  };
  (add(columns), ...);
  return line + "\n";
}

template <class Record>
std::string field_of(const DriftColumn<Record>& column, std::optional<double> value) {
  if (!value) return "-";
  const double scaled = column.text.scale * *value;
  return *column.text.format != '\0' ? fmt::format(fmt::runtime(column.text.format), scaled) : number(scaled);
}

template <class Record>
std::string field_of(const DriftColumn<Record>& column, const Record& record) {
  if (const auto* const code = std::get_if<typename DriftColumn<Record>::Code>(&column.get))
    return std::string(code->names.of(code->of(record)));
  if (const auto* const row = std::get_if<std::int64_t Record::*>(&column.get))
    return std::to_string(record.**row);
  return field_of(column, column.number(record));
}

// The first records under the columns' heads.
template <class Record>
std::string table_text(const std::vector<Record>& records, std::size_t lines_max, const auto&... columns) {
  std::string text = line_of([](const auto& each) { return std::string(each.text.head); }, columns...);
  const std::string units = line_of([](const auto& each) { return std::string(each.text.unit); }, columns...);
  if (units.find_first_not_of(" \n") != std::string::npos) text += units;
  for (std::size_t index = 0; index < std::min(records.size(), lines_max); ++index)
    text += line_of([&](const auto& each) { return field_of(each, records[index]); }, columns...);
  return text;
}

// The largest of each column.
std::string worst_line(const DriftSummary& summary, const auto&... columns) {
  const auto worst = [&](const auto& each) {
    if (each.also == nullptr) return std::string();
    const std::optional<Worst>& largest = summary.*each.also;
    return field_of(each, largest ? std::optional(largest->value) : std::nullopt);
  };
  return line_of(worst, columns...).replace(2, 7, "  worst");
}

// The drift in percent depends on how high the arc begins; this does not.
std::string energy_text(const DriftSummary& summary) {
  if (!summary.energy_drift_max_px2_per_s2) return "";
  const auto [drift, first_step] = *summary.energy_drift_max_px2_per_s2;
  return fmt::format("  energy       drift at most {} px²/s², in the arc from row {}\n", number(drift),
                     first_step);
}

// Energy as the height in px that it lifts the sprite by.
std::string height(double energy_px2_per_s2, const Model& model) {
  return fmt::format("{:+.3g} px", energy_px2_per_s2 / model.gravity_px_per_s2);
}

// What the discretisation itself adds and takes, by cause; what the model takes at a contact is no error.
std::string causes_text(const DriftSummary& summary, const Model& model) {
  if (summary.arcs == 0 || !(model.gravity_px_per_s2 > 0.0)) return "";
  return fmt::format(
      "  by cause     as height: gravity once a step {}, drag on that path {},\n"
      "               lift out of walls {}, restitution after the wall {}\n",
      height(summary.arc_energy.gravity, model), height(summary.arc_energy.drag, model),
      height(summary.contact_energy.lift, model), height(summary.late_bounces_px2_per_s2, model));
}

std::string exact_law_text(const DriftSummary& summary) {
  if (!summary.exact_law_px) return "";
  return fmt::format("  exact law    every arc is within {} px of it\n", number(summary.exact_law_px));
}

std::string arcs_text(const DriftRun& run, std::size_t lines_max) {
  const DriftSummary& summary = run.summary;
  if (summary.arcs == 0) return "  no flight arc of two steps or more\n";
  return table_text(run.arcs, lines_max, kArcColumns, kReferenceArcColumns) +
         more_text(summary.arcs, lines_max) + worst_line(summary, kArcColumns, kReferenceArcColumns) +
         energy_text(summary) + causes_text(summary, run.model) + exact_law_text(summary);
}

std::string contacts_text(const DriftRun& run, std::size_t lines_max) {
  const DriftSummary& summary = run.summary;
  if (summary.contacts == 0) return "";
  std::string text =
      table_text(run.contacts, lines_max, kImpactColumns) + more_text(summary.contacts, lines_max);
  const Spread& restitution = summary.effective_restitution;
  if (restitution.count() > 0)
    text +=
        fmt::format("  restitution  median {:.4f}, from {:.4g} to {:.4g}, {} contacts; the model's is {:g}\n",
                    restitution.median(), restitution.smallest(), restitution.largest(), restitution.count(),
                    run.model.restitution);
  return text;
}

void print_faults(const DriftSummary& summary) {
  if (summary.non_finite_step)
    print_text("  {}   from row {}; not measured from there on\n", VerdictWord{"NOT FINITE", false},
               *summary.non_finite_step);
  if (summary.differing_steps > 0)
    print_text("  {}     {} flight steps differ from the listing\n", VerdictWord{"DIFFERS", false},
               summary.differing_steps);
  if (summary.reference_faults > 0)
    print_text("  {} of the reference in {}, the first from row {}: {}\n",
               VerdictWord{"INTERNAL ERROR", false}, arcs_text(summary.reference_faults),
               summary.first_reference_fault_step.value_or(0), summary.first_reference_fault);
}

// The items in lines of at most 100 columns.
std::string wrapped(const std::string& label, const std::vector<std::string>& items) {
  constexpr std::size_t kWidth = 100;
  std::string text;
  std::string line = fmt::format("  {:<12}", label);
  for (std::size_t index = 0; index < items.size(); ++index) {
    const std::string item = items[index] + (index + 1 < items.size() ? ";" : "");
    if (line.size() + 1 + item.size() > kWidth) {
      text += line + "\n";
      line = std::string(14, ' ');
    }
    line += " " + item;
  }
  return text + line + "\n";
}

std::string drift_of(const std::optional<ArcErrors>& longest) {
  if (!longest || !longest->energy_drift_slope_px_per_s) return "-";
  return brief(*longest->energy_drift_slope_px_per_s);
}

std::string truncation_of(const DriftSummary& summary) {
  return summary.truncation_px ? brief(summary.truncation_px->value) : std::string("-");
}

// The last line: what a step costs on this machine, its errors, and both at half the dt.
std::string speed_text(const DriftReport& report) {
  if (!report.step_ns) return "";
  std::string text =
      fmt::format("  this machine {} ns/step, trunc. {} px, drift {} px/s; half dt", brief(*report.step_ns),
                  truncation_of(report.run.summary), drift_of(report.run.longest_arc));
  if (!report.half_dt.half) return text + fmt::format(" not measured: {}\n", report.half_dt.why_not);
  const HalfDt& half = *report.half_dt.half;
  return text + fmt::format(": 2 x {} ns, {} px, {} px/s\n", brief(half.step_ns), truncation_of(half.summary),
                            drift_of(half.longest_arc));
}

// The error against the fixed model does not vanish with the frame if half the dt keeps most of it.
std::string convergence_text(const DriftReport& report) {
  if (!report.half_dt.half) return "";
  const std::optional<Worst>& now = report.run.summary.model_px;
  const std::optional<Worst>& half = report.half_dt.half->summary.model_px;
  constexpr double kHalvedAtLeast = 0.6;  // 0.5 for a method of first order.
  if (!now || !half || half->value <= kHalvedAtLeast * now->value) return "";
  return fmt::format(
      "  model        error {} px, at half the dt {} px: the paper's step applies drag\n"
      "               once a frame, however short, so it does not converge to a fixed rate\n",
      number(now), number(half));
}

// Two digits, never more than the value.
std::string rounded_down(double value) {
  std::string text = fmt::format("{:.17e}", value);
  text.erase(text.find('.') + 2, 16);
  double rounded = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), rounded);
  return fmt::format("{:g}", rounded);
}

}  // namespace

// Of the end to the start, as long as no contact changes.
std::string sensitivity_text(const Sensitivity& sensitivity) {
  constexpr std::string_view kNames[] = {"x", "y", "vx", "vy"};
  std::string text = fmt::format("  {:<12} {:>10} {:>10} {:>10} {:>10}   of the start, by 1 px or 1 px/s\n",
                                 "end moves by", kNames[0], kNames[1], kNames[2], kNames[3]);
  for (std::size_t row = 0; row < sensitivity.size(); ++row) {
    const auto& [x, y, vx, vy] = sensitivity[row];
    text += fmt::format("  {:>12} {:>10} {:>10} {:>10} {:>10}\n", kNames[row], number(x), number(y),
                        number(vx), number(vy));
  }
  return text;
}

ContactChance contact_chance_of(const Scenario& scenario, const Margin& margin) {
  // Where no decision depends on the start, no start changes a contact.
  return contact_chance(scenario, margin.half_width.value_or(std::numeric_limits<double>::infinity()));
}

std::string contact_chance_text(const ContactChance& chance) {
  const std::string within = fmt::format("within ±{:g} px of the start, ", chance.within_px);
  if (chance.changed.of == 0) return within + "no contact changes";
  return within +
         fmt::format("contacts change for {:.2g} % of starts ({:.2g} .. {:.2g} %; {} starts, seed {})",
                     100.0 * chance.chance(), 100.0 * chance.low(), 100.0 * chance.high(), chance.changed.of,
                     chance.seed);
}

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

std::vector<std::string> not_computed(const DriftReport& report) {
  const DriftSummary& summary = report.run.summary;
  std::vector<std::string> items;
  if (summary.arcs_without_x > 0)
    items.push_back(fmt::format("x in {} without horizontal motion", arcs_text(summary.arcs_without_x)));
  if (!report.run.gsl) items.emplace_back("GSL (--reference gsl)");
  if (!report.has_rows_stored) items.emplace_back("errors of every row (--rows)");
  if (summary.skipped_arcs > 0)
    items.push_back(fmt::format("{} of fewer than two steps", arcs_text(summary.skipped_arcs)));
  return items;
}

void print_drift(const DriftReport& report, const Printing& printing) {
  const DriftRun& run = report.run;
  if (printing.is_quiet()) {
    print_text("{}: largest errors: implementation {} px, truncation {} px, model {} px\n", run.scenario.name,
               number(run.summary.implementation_px), number(run.summary.truncation_px),
               number(run.summary.model_px));
    return print_faults(run.summary);
  }
  const std::size_t lines_max = printing.is_verbose() ? kArcsListedMax : 20;
  print_text("{}\n", title_of(run.scenario, run.steps, run.simulated_s));
  if (!run.note.empty()) print_text("  {}\n", run.note);
  print_text("{}{}{}", whole_text(report), arcs_text(run, lines_max), contacts_text(run, lines_max));
  print_faults(run.summary);
  print_text("  {}\n", margin_text(run.margin));
  if (report.contact_chance) print_text("  {}\n", contact_chance_text(*report.contact_chance));
  if (printing.is_verbose()) print_text("{}", sensitivity_text(run.margin.sensitivity));
  if (is_knife_edge(run.margin)) print_text("  KNIFE EDGE   rounding alone can change a contact\n");
  print_text("{}", reference_text(run.gsl));
  if (const std::vector<std::string> items = not_computed(report); !items.empty())
    print_text("{}", wrapped("not computed", items));
  print_text("{}{}", convergence_text(report), speed_text(report));
}

}  // namespace hyrax
