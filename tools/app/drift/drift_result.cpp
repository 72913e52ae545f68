#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/reference/drift_columns.h"
#include "sim/result/number_text.h"
#include "sim/scenario/frame_clock.h"
#include "tools/app/drift/drift.h"
#include "tools/files/failure.h"

namespace hyrax {
namespace {

std::string number(double value) { return rounded(value, 3); }
std::string number(const std::optional<Worst>& worst) {
  return worst ? number(worst->value) : std::string("-");
}

std::vector<Column> with(std::vector<Column> columns, std::vector<Column> more) {
  std::move(more.begin(), more.end(), std::back_inserter(columns));
  return columns;
}

std::vector<Column> arc_columns(const DriftRun& run) {
  return with(columns_of(kArcColumns, run.arcs), columns_of(kReferenceArcColumns, run.arcs));
}

// Of each quantity whose largest is kept: its column without values, its place in the summary, and how the
// text shows it.
void each_worst(const auto& take) {
  const auto each = [&](const auto& columns) {
    for (const auto& described : columns)
      if (described.also.worst != nullptr) take(column_of(described, {}), described.also);
  };
  each(kArcColumns);
  each(kReferenceArcColumns);
  each(kImpactColumns);
}

// The value of each largest error, or its step: an arc's first_step, a contact's step.
Table worst_table(const char* name, const DriftSummary& summary, auto Worst::*member) {
  Table table{.name = name, .columns = {}, .form = JsonForm::one};
  each_worst([&](Column column, const DriftShown& shown) {
    std::optional<std::decay_t<decltype(Worst{}.*member)>> value;
    if (const std::optional<Worst>& worst = summary.*shown.worst) value = (*worst).*member;
    column.values = column_of_one("", "", value).values;
    table.columns.push_back(std::move(column));
  });
  return table;
}

// The first records in the columns that the text shows.
template <class Record>
std::vector<Column> shown_columns(const auto& described, const std::vector<Record>& records,
                                  std::ptrdiff_t lines_max) {
  const std::vector<Record> first(records.begin(),
                                  records.begin() + std::min(std::ssize(records), lines_max));
  std::vector<Column> columns;
  for (const DriftColumn<Record>& each : described) {
    const DriftShown& shown = each.also;
    if (shown.head == nullptr) continue;
    Column column = column_of(each, first);
    column.name = shown.head;
    column.digits = 3;
    column.is_each_rounded = true;
    if (shown.unit != nullptr) column.unit = shown.unit;
    if (auto* const numbers = std::get_if<std::vector<double>>(&column.values))
      for (double& value : *numbers) value *= shown.scale;
    columns.push_back(std::move(column));
  }
  return columns;
}

// The items after a label, in lines of at most 100 columns.
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
  return text + line;
}

// How wrong the run is: the first lines.
std::string whole_text(const DriftRun& run) {
  if (!run.whole.run) return fmt::format("  whole run    no exact fling: {}", run.whole.why_not);
  const WholeRun& whole = *run.whole.run;
  std::string text = fmt::format(
      "  whole run    ends {} px from the exact fling, {} px at most, in row {}\n"
      "               energy {} px of height off at the end, {} px at most{}",
      number(whole.end_px), number(whole.max_px), whole.max_px_step, number(whole.energy_end_px),
      number(whole.energy_max_px),
      whole.energy_phase_px > whole.energy_max_px
          ? fmt::format(";\n               {} px where only one has bounced", number(whole.energy_phase_px))
          : "");
  if (whole.secular_px_per_s)
    text +=
        fmt::format("\n               in flight {} px of height a second", number(*whole.secular_px_per_s));
  if (whole.contacts_differ_from)
    text += fmt::format("\n               other contacts than the exact fling's from row {}",
                        *whole.contacts_differ_from);
  return text;
}

std::string worst_text(const DriftSummary& summary) {
  std::vector<std::string> items;
  each_worst([&](const Column& column, const DriftShown& shown) {
    std::string name = shown.head != nullptr ? shown.head : column.name;
    std::ranges::replace(name, '_', ' ');
    if (const std::optional<Worst>& worst = summary.*shown.worst)
      items.push_back(fmt::format("{} {} {} (row {})", name, number(shown.scale * worst->value),
                                  unit_text(shown.unit != nullptr ? shown.unit : column.unit), worst->step));
  });
  return wrapped("worst", items);
}

// What the discretisation itself adds and takes, by cause; what the model takes at a contact is no error.
std::string causes_text(const EnergyCauses& causes) {
  return fmt::format(
      "  by cause     as height: gravity once a step {:+.3g} px, drag on that path {:+.3g} px,\n"
      "               lift out of walls {:+.3g} px, restitution after the wall {:+.3g} px;\n"
      "               {:+.3g} px in all, and {:+.3g} px that these do not explain",
      causes.gravity, causes.drag, causes.lift, causes.bounce, causes.sum(), causes.flight);
}

std::string restitution_text(const Spread& restitution, const Model& model) {
  return fmt::format("  restitution  median {:.4f}, from {:.4g} to {:.4g}, of {}; the model's is {:g}",
                     restitution.median(), restitution.smallest(), restitution.largest(),
                     plain_counted(restitution.count(), "bounce"), model.restitution);
}

std::string reference_text(const DriftRun& run) {
  return fmt::format("  reference    closed form{}{}", run.checked_by.empty() ? " alone" : ", checked by ",
                     run.checked_by);
}

std::vector<std::string> not_computed(const DriftReport& report) {
  const DriftSummary& summary = report.run.summary;
  std::vector<std::string> items;
  if (summary.arcs_without_x > 0)
    items.push_back(
        fmt::format("x in {} without horizontal motion", plain_counted(summary.arcs_without_x, "arc")));
  if (report.run.checked_by.empty()) items.emplace_back("GSL (--reference gsl)");
  if (!report.has_rows_stored) items.emplace_back("errors of every row (--rows)");
  if (summary.skipped_arcs > 0)
    items.push_back(fmt::format("{} of fewer than two steps", plain_counted(summary.skipped_arcs, "arc")));
  return items;
}

std::string clock_text(const Clock& clock) {
  if (const auto* const fixed = std::get_if<FixedRate>(&clock.base))
    return rounded(fixed->rate_hz, 6) + " Hz";
  return fmt::format("dt {} s", rounded(base_dt_s(clock), 3));
}

// Truncation error grows with the time of flight; so the arcs of both runs need not end at the same walls.
double truncation_px_per_s(const DriftRun& run) {
  double error_px = 0.0, time_s = 0.0;
  for (const ArcErrors& arc : run.arcs) {
    error_px += arc.truncation_px;
    time_s += arc.duration_s;
  }
  return time_s > 0.0 ? error_px / time_s : 0.0;
}

// By the order that the truncation error has between this dt and half of it. Drag once a frame is the reason
// why the model error stays if that is all that the two errors differ in.
std::string half_error_text(const HalfDt& half, const DriftRun& run) {
  if (!half.run) return "  half the error: its cost is not measured: " + half.why_not;
  const DriftSummary &now = run.summary, &then = half.run->summary;
  if (!now.truncation_px || !then.truncation_px) return "  half the error: there is none";
  constexpr double kSmaller = 1.1;
  const std::string clock = clock_text(half.run->scenario.clock);
  const double ratio = truncation_px_per_s(run) / truncation_px_per_s(*half.run);
  if (!(ratio > kSmaller))
    return fmt::format("  half the error: not by shorter frames; truncation {} px, {} px at {}",
                       number(now.truncation_px), number(then.truncation_px), clock);
  std::string text = fmt::format("  half the error costs {:.1f} times the steps ({})",
                                 std::exp2(1.0 / std::log2(ratio)), clock);
  if (now.model_px && then.model_px && !(now.model_px->value > kSmaller * then.model_px->value))
    text +=
        fmt::format("\n               the model error then is {} px: drag acts once a frame, however short",
                    number(then.model_px));
  return text;
}

std::string reference_faults_text(const DriftSummary& summary) {
  return fmt::format("{}, the first from row {}: {}", plain_counted(summary.reference_faults, "arc"),
                     summary.first_reference_fault_step.value_or(0), summary.first_reference_fault);
}

std::vector<std::string> faults_of(const DriftRun& run) {
  const DriftSummary& summary = run.summary;
  std::vector<std::string> faults;
  if (summary.non_finite_step)
    faults.push_back(
        fmt::format("NOT FINITE from row {}; not measured from there on", *summary.non_finite_step));
  if (summary.differing_steps > 0)
    faults.push_back(fmt::format("{} flight steps differ from the listing", summary.differing_steps));
  if (summary.reference_faults > 0 && run.is_checked_by_default)
    faults.push_back("INTERNAL ERROR of the reference in " + reference_faults_text(summary));
  if (run.whole.is_fault) faults.push_back("INTERNAL ERROR of the reference: " + run.whole.why_not);
  return faults;
}

Verdict verdict_of(const DriftReport& report, bool lists_all) {
  const DriftRun& run = report.run;
  const DriftSummary& summary = run.summary;
  const std::ptrdiff_t lines_max = lists_all ? kArcsListedMax : 20;
  Verdict verdict{.text = {title_of(run.scenario, run.steps, run.simulated_s)},
                  .broken = faults_of(run),
                  .brief = fmt::format("largest errors: implementation {} px, truncation {} px, model {} px",
                                       number(summary.implementation_px), number(summary.truncation_px),
                                       number(summary.model_px))};
  const auto add_list = [&](std::vector<Column> columns, std::int64_t count) {
    verdict.text.emplace_back(Table{.columns = std::move(columns)});
    if (const std::int64_t more = count - lines_max; more > 0)
      verdict.text.emplace_back(fmt::format("  ... {} more; --verbose lists them", more));
  };
  if (!run.note.empty()) verdict.text.emplace_back("  " + run.note);
  verdict.text.emplace_back(whole_text(run));
  if (summary.arcs > 0)
    add_list(with(shown_columns(kArcColumns, run.arcs, lines_max),
                  shown_columns(kReferenceArcColumns, run.arcs, lines_max)),
             summary.arcs);
  else
    verdict.text.emplace_back("  no flight arc of two steps or more");
  if (summary.contacts > 0)
    add_list(shown_columns(kImpactColumns, run.contacts, lines_max), summary.contacts);
  if (summary.arcs + summary.contacts > 0) verdict.text.emplace_back(worst_text(summary));
  if (summary.arcs > 0 && run.model.gravity_px_per_s2 > 0.0)
    verdict.text.emplace_back(causes_text(summary.causes));
  if (summary.effective_restitution.count() > 0)
    verdict.text.emplace_back(restitution_text(summary.effective_restitution, run.model));
  verdict.text.emplace_back(start_text(run.margin, lists_all));
  if (is_knife_edge(run.margin))
    verdict.text.emplace_back("  KNIFE EDGE   rounding alone can change a contact");
  verdict.text.emplace_back(reference_text(run));
  if (const std::vector<std::string> items = not_computed(report); !items.empty())
    verdict.text.emplace_back(wrapped("not computed", items));
  if (report.half_dt) verdict.text.emplace_back(half_error_text(*report.half_dt, run));
  return verdict;
}

// A text that is missing is null.
Column text_or_null(const std::string& name, std::string_view text) {
  if (!text.empty()) return column_of_one(name, "", text);
  return column_of_one(name, "", Table{.columns = {}, .form = JsonForm::one});
}

Column energy_member(const std::string& name, double energy_px2_per_s2) {
  Column column = column_of_one(name, "px2/s2", energy_px2_per_s2);
  column.key = name;
  return column;
}

Table members(std::vector<Column> columns) {
  return {.columns = std::move(columns), .form = JsonForm::members};
}

Table whole_member(const WholeOutcome& whole) {
  Table table = whole_table(whole);
  if (!whole.run) return table;
  table.long_name = "the whole run against the exact fling, with bounds that hold for certain";
  table.columns = with(std::move(table.columns), columns_of(kEnclosureColumns, std::vector{*whole.run}));
  table.columns.push_back(text_or_null("enclosure_why", whole.enclosure_why));
  table.columns.push_back(column_of_one("reference", "", "exact fling"));
  return table;
}

Table restitution_member(const Spread& spread) {
  Table table{.name = "effective_restitution", .columns = {}, .form = JsonForm::one};
  if (spread.count() > 0)
    table.columns = {
        column_of_one("median", "1", spread.median()), column_of_one("smallest", "1", spread.smallest()),
        column_of_one("largest", "1", spread.largest()), column_of_one("contacts", "1", spread.count())};
  return table;
}

Table causes_member(const DriftRun& run) {
  Table table{.name = "by_cause", .columns = {}, .form = JsonForm::one};
  const EnergyCauses& causes = run.summary.causes;
  if (run.model.gravity_px_per_s2 > 0.0)
    table.columns = {
        column_of_one("gravity", "px", causes.gravity), column_of_one("drag", "px", causes.drag),
        column_of_one("lift", "px", causes.lift),       column_of_one("restitution", "px", causes.bounce),
        column_of_one("sum", "px", causes.sum()),       column_of_one("not_explained", "px", causes.flight)};
  return table;
}

Table half_dt_member(const std::optional<HalfDt>& half) {
  Table table{.name = "half_dt", .columns = {}, .form = JsonForm::one};
  if (half && half->run)
    table.columns = {column_of_one("steps", "1", step_count(half->run->scenario)),
                     column_of_one("worst", "", worst_table("worst", half->run->summary, &Worst::value))};
  return table;
}

}  // namespace

void require_reached(const DriftRun& run) {
  if (run.summary.reference_faults == 0 || run.is_checked_by_default) return;
  refuse_input(
      fmt::format("{}: {}: this stepper does not reach the closed form, in {}; to check it, leave out "
                  "--stepper and --tolerance",
                  run.scenario.name, run.checked_by, reference_faults_text(run.summary)));
}

Result drift_result(const DriftReport& report, bool lists_all) {
  const DriftRun& run = report.run;
  const DriftSummary& summary = run.summary;
  return {
      .verdict = verdict_of(report, lists_all),
      .summary = {
          whole_member(run.whole),
          members({text_or_null("whole_why", run.whole.why_not),
                   column_of_one("skipped_arcs", "1", summary.skipped_arcs)}),
          {.name = "arcs", .long_name = "flights without contact or input", .columns = arc_columns(run)},
          {.name = "contacts",
           .long_name = "contacts of the run",
           .columns = columns_of(kImpactColumns, run.contacts)},
          sensitivity_table(run.margin.sensitivity),
          worst_table("worst", summary, &Worst::value),
          worst_table("worst_step", summary, &Worst::step),
          members({column_of_one("arcs_measured", "1", summary.arcs),
                   column_of_one("contacts_measured", "1", summary.contacts),
                   energy_member("reference_energy", summary.reference_energy_px2_per_s2),
                   energy_member("unlisted_energy", summary.unlisted_energy_px2_per_s2)}),
          causes_member(run),
          restitution_member(summary.effective_restitution),
          margin_table(run.margin),
          members({column_of_one("differing_steps", "1", summary.differing_steps),
                   column_of_one("reference_faults", "1", summary.reference_faults),
                   text_or_null("first_reference_fault", summary.first_reference_fault),
                   column_of_one("non_finite_step", "", summary.non_finite_step)}),
          {.name = "not_computed", .columns = {{.values = not_computed(report)}}, .form = JsonForm::values},
          half_dt_member(report.half_dt)}};
}

}  // namespace hyrax
