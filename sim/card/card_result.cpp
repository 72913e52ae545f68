#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "sim/card/card.h"
#include "sim/result/number_text.h"
#include "sim/study/display_rates.h"
#include "sim/study/study_table.h"

namespace hyrax {
namespace {

// The card in the making: its lines for people, and its members of the JSON document.
struct Lines {
  std::vector<std::string> names;
  std::vector<std::string> texts;
  std::vector<Table> json;

  // Without a name it continues the line before.
  void add(const std::string& name, const std::string& text) {
    names.push_back(name);
    texts.push_back(text);
  }
  // A line for each of the first items.
  template <class Items, class ToText>
  void add_first(std::size_t most, const Items& items, const ToText& to_text) {
    for (std::size_t index = 0; index < std::min(items.size(), most); ++index) add("", to_text(items[index]));
    if (items.size() > most) add("", fmt::format("and {} more", items.size() - most));
  }
};

// "35.2 (10 .. 80)"
std::string text_of(const std::optional<Band>& band, double unit = 1.0) {
  if (!band) return "not measured";
  const auto digits = [unit](double value) { return rounded(value / unit, 3); };
  return fmt::format("{} ({} .. {})", digits(band->median), digits(band->low), digits(band->high));
}
template <class OptionalBand>
std::string text_of(const BeforeAfter<OptionalBand>& pair, const std::string& unit_name, double unit = 1.0) {
  return fmt::format("{} -> {} {}", text_of(pair.before, unit), text_of(pair.after, unit), unit_name);
}

// ", 152 of 200 flings"; empty where the band is of all of them.
std::string size_text(const std::optional<Band>& band, std::int64_t of) {
  return band && band->samples < of ? fmt::format(", {} of {} flings", band->samples, of) : "";
}

// "12 of 1000 (95 %: 0.7 .. 2.1 %)"
std::string text_of(const Share& share) {
  return fmt::format("{} of {} (95 %: {:.1f} .. {:.1f} %)", share.count, share.of, 100.0 * share.low(),
                     100.0 * share.high());
}

std::string text_of(const ClassCounts& counts) {
  std::string text = fmt::format("{} of {} the same", counts.same_bits, counts.total());
  for (const DifferenceClass difference : kDifferenceClasses)
    if (counts.of(difference) > 0) text += fmt::format(", {} {}", name_of(difference), counts.of(difference));
  return text;
}

// The first few, and how many there are more.
std::string list_text(const std::vector<std::string>& names, std::size_t most = 3) {
  std::string text;
  for (std::size_t index = 0; index < std::min(names.size(), most); ++index)
    text += (index == 0 ? "" : ", ") + names[index];
  if (names.size() > most) text += fmt::format(" and {} more", names.size() - most);
  return text;
}

// Without columns null.
Table one(const std::string& name = "", std::vector<Column> columns = {}) {
  return {.name = name, .columns = std::move(columns), .shape = JsonShape::one};
}

Column text_or_null(const std::string& name, const std::string& text) {
  return text.empty() ? column_of_one(name, "", one()) : column_of_one(name, "", text);
}

Table table_of(const std::optional<Band>& band) {
  if (!band) return one();
  return one("", {column_of_one("samples", "1", band->samples), column_of_one("median", "1", band->median),
                  column_of_one("p10", "1", band->low), column_of_one("p90", "1", band->high)});
}
Table table_of(const Share& share) {
  return one("", {column_of_one("count", "1", share.count), column_of_one("of", "1", share.of),
                  column_of_one("low95", "1", share.low()), column_of_one("high95", "1", share.high())});
}
Table table_of(const ClassCounts& counts) {
  Table table = one(
      "", {column_of_one("count", "1", counts.total()), column_of_one("same_bits", "1", counts.same_bits)});
  for (const DifferenceClass difference : kDifferenceClasses)
    table.columns.push_back(column_of_one(std::string(name_of(difference)), "1", counts.of(difference)));
  return table;
}
template <class Value>
Table table_of(const std::vector<Value>& values) {
  return {.columns = {{.values = values}}, .shape = JsonShape::values};
}
template <class Value>
Table table_of(const BeforeAfter<Value>& pair);

template <class Value>
Column member(const std::string& name, const std::string& unit, const Value& value) {
  if constexpr (requires { table_of(value); })
    return column_of_one(name, unit, table_of(value));
  else
    return column_of_one(name, unit, value);
}

template <class Value>
Table table_of(const BeforeAfter<Value>& pair) {
  return one("", {member("before", "", pair.before), member("after", "", pair.after)});
}

void add_step(const Card& card, Lines& lines) {
  const StepLine& line = card.step;
  if (line.status == StepStatus::proved_equal)
    lines.add("step", "same operations on every path: proved");
  else if (line.status == StepStatus::not_proved)
    lines.add("step", "not proved equal: " + line.why);
  else
    lines.add("step", line.why.empty() ? "changed" : "changed; not all paths are known: " + line.why);
  if (line.changes.empty() && line.status == StepStatus::changed)
    lines.add("", "the header did not change: an included header or a compiler option did");
  lines.add_first(6, line.changes, change_text);
  lines.json.push_back(
      one("step", {member("status", "", kStepStatusNames[static_cast<std::size_t>(line.status)]),
                   text_or_null("why", line.why), member("changes", "", changes_table(line.changes))}));
  lines.json.push_back({.columns = {text_or_null("lacking", card.lacking)}, .shape = JsonShape::members});
}

Table scenario_table(const std::vector<ScenarioChange>& changed) {
  const auto of = [](const auto& get) {
    return [get](const ScenarioChange& each) { return std::invoke(get, each.change); };
  };
  return StudyTable("scenarios", "scenarios that differ", changed)
      .add("scenario", "", "its file", &ScenarioChange::path)
      .add("class", "", "class of difference",
           of([](const auto& change) { return name_of(*change.difference); }))
      .add("largest", "px", "largest distance of two rows of the same step",
           of([](const auto& change) { return change.largest ? change.largest->px : 0.0; }))
      .key("max_px")
      .add("end", "px", "distance of the last rows", of(&RunChange::end_shift_px))
      .key("end_shift_px")
      .add("contacts_before", "1", "contacts of the base", of(&RunChange::contacts_before))
      .add("contacts_after", "1", "contacts of the candidate", of(&RunChange::contacts_after))
      .add("moved", "1", "contacts of both at another step",
           of([](const auto& change) { return std::ssize(change.contacts.moved); }))
      .add("only_before", "1", "contacts of the base alone",
           of([](const auto& change) { return std::ssize(change.contacts.only_a); }))
      .add("only_after", "1", "contacts of the candidate alone",
           of([](const auto& change) { return std::ssize(change.contacts.only_b); }))
      .add("became_non_finite", "", "with the candidate alone", of(&RunChange::became_non_finite))
      .add("no_longer_settles", "", "it settles with the base alone", of(&RunChange::no_longer_settles));
}

void add_bits(const Card& card, Lines& lines) {
  lines.add("bits", "scenarios: " + text_of(card.library.classes));
  lines.add("", "random flings: " + text_of(card.random.classes));
  const HardCaseLine& hard = card.hard_cases;
  lines.add("",
            fmt::format("hard cases: {} of {} the same, random runs: {} of {}", hard.cases - hard.other_cases,
                        hard.cases, hard.other_random_runs.of - hard.other_random_runs.count,
                        hard.other_random_runs.of));
  if (card.library.cut > 0)
    lines.add("", fmt::format("compared in their first {} rows only: {}", kCoreRunRowsMax, card.library.cut));
  Table scenarios = table_of(card.library.classes);
  scenarios.name = "scenarios";
  scenarios.columns.push_back(member("cut", "1", card.library.cut));
  scenarios.columns.push_back(member("changed", "", scenario_table(card.library.changed)));
  lines.json.push_back(std::move(scenarios));
}

void add_contacts(const Card& card, Lines& lines) {
  const ContactLine& line = card.contacts;
  lines.add("contacts",
            fmt::format("changed in {} of {} scenarios: {} moved, {} only before, {} only after ({} -> {})",
                        line.scenarios, card.scenarios, line.moved, line.only_before, line.only_after,
                        line.contacts.before, line.contacts.after));
  lines.add("", "changed in random flings: " + text_of(card.random.changed_contacts));
  lines.json.push_back(
      one("contacts", {member("scenarios", "1", line.scenarios), member("moved", "1", line.moved),
                       member("only_before", "1", line.only_before),
                       member("only_after", "1", line.only_after), member("contacts", "1", line.contacts)}));
}

void add_landing(const Card& card, Lines& lines) {
  const FlingLine& line = card.random;
  lines.add("landing",
            fmt::format("shift in x {} px, distance {} px, largest {} px{}", text_of(line.shift_px),
                        text_of(line.distance_px), rounded(line.distance_max_px, 3),
                        size_text(line.distance_px, card.flings)));
  lines.add("", fmt::format("of {} random flings at 60 Hz settle: {} -> {}", card.flings, line.settled.before,
                            line.settled.after));
  lines.json.push_back(one(
      "flings", {member("classes", "1", line.classes), member("contacts_changed", "1", line.changed_contacts),
                 member("settled", "1", line.settled), member("no_longer_settle", "1", line.no_longer_settle),
                 member("shift", "px", line.shift_px), member("distance", "px", line.distance_px),
                 member("distance_max", "px", line.distance_max_px)}));
}

void add_displays(const DisplayLine& line, Lines& lines) {
  lines.add("displays",
            fmt::format("a fling's spread over 24 .. 1000 Hz: {}, {} of {} flings",
                        text_of(line.spread_px, "px"), line.spreads_px.before.size(), line.flings));
  lines.json.push_back(
      one("displays", {member("flings", "1", line.flings), member("spread", "px", line.spread_px)}));
}

void add_rest(const RestLine& line, Lines& lines) {
  const auto moved = [&](auto display) {
    const auto at = static_cast<std::size_t>(display);
    return fmt::format("{} -> {} px at {:g} Hz", rounded(line.moved_px.before[at], 3),
                       rounded(line.moved_px.after[at], 3), kLandingRates_hz[at]);
  };
  const std::vector<double>& after = line.moved_px.after;
  lines.add("rest", fmt::format("a dropped sprite still moves after 19 s by {}, at most by {}",
                                moved(std::ranges::find(kLandingRates_hz, 60.0) - kLandingRates_hz.begin()),
                                moved(std::ranges::max_element(after) - after.begin())));
  const std::vector<double> rates_hz(kLandingRates_hz.begin(), kLandingRates_hz.end());
  lines.json.push_back(one("rest", {member("rate", "Hz", rates_hz), member("moved", "px", line.moved_px)}));
}

void add_energy(const Card& card, Lines& lines) {
  struct Cause {
    const char* name;
    const char* text;
    const char* key;
  };
  constexpr std::array<Cause, kEnergyCauseCount> kCauses = {{{"energy", "as height, in flight", "drift"},
                                                             {"", "at walls, by lift", "lift"},
                                                             {"", "by bounces", "bounce"},
                                                             {"", "by friction", "friction"}}};
  Table energy = one("energy");
  for (std::size_t cause = 0; cause < kEnergyCauseCount; ++cause) {
    const Bands& bands = card.energy_px2_per_s2[cause];
    lines.add(kCauses[cause].name,
              fmt::format("{}: {}{}", kCauses[cause].text, text_of(bands, "px", kHeight_px2_per_s2),
                          cause == 0 ? size_text(bands.after, card.flings) : ""));
    energy.columns.push_back(member(kCauses[cause].key, "px2/s2", bands));
  }
  lines.json.push_back(std::move(energy));
}

void add_exact(const Card& card, Lines& lines) {
  std::vector<std::int64_t> seconds;
  for (const Bands& bands : card.exact_px) {
    seconds.push_back(std::ssize(seconds) + 1);
    lines.add(seconds.size() == 1 ? "exact motion" : "",
              fmt::format("after {} s at 60 Hz: {}{}", seconds.back(), text_of(bands, "px"),
                          size_text(bands.after, card.flings)));
  }
  lines.json.push_back({.name = "exact",
                        .columns = {{.name = "t", .unit = "s", .values = std::move(seconds)},
                                    column_of("distance", "px", "", card.exact_px,
                                              [](const Bands& bands) { return table_of(bands); })}});
}

void add_speed(const CostLine& line, Lines& lines) {
  lines.add("speed",
            fmt::format("{}; ratio {:.3f} ({:.3f} .. {:.3f}), {} pairs", text_of(line.step_ns, "ns a step"),
                        line.ratio.median, line.ratio.low, line.ratio.high, line.ratio.samples));
  lines.json.push_back(one("cost", {member("step", "ns", line.step_ns), member("ratio", "1", line.ratio)}));
}

// "velocity 9, position 3" of "CASE: INVARIANT".
std::string invariants_text(const std::vector<std::string>& broken) {
  std::map<std::string, int> counts;
  for (const std::string& name : broken) ++counts[name.substr(name.rfind(' ') + 1)];
  std::string text;
  for (const auto& [invariant, count] : counts)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", invariant, count);
  return text;
}

void add_hard_cases(const Card& card, Lines& lines) {
  const HardCaseLine& hard = card.hard_cases;
  Table json =
      one("hard_cases", {member("cases", "1", hard.cases), member("cases_changed", "1", hard.other_cases),
                         member("random_runs_changed", "1", hard.other_random_runs)});
  const auto add = [&](const char* name, const char* kind, const char* key, const InvariantLine& line) {
    if (!card.lacking.empty()) return json.columns.push_back(member(key, "", one()));
    const auto& [before, after] = line.random_runs;
    lines.add(name,
              fmt::format("{}: broken in hard cases {} -> {} of {}, in random runs {} -> {}", kind,
                          line.cases.before, line.cases.after, hard.cases, before.count, text_of(after)));
    if (!line.newly_broken.empty()) lines.add("", "newly broken: " + invariants_text(line.newly_broken));
    if (!line.mended.empty()) lines.add("", "no longer broken: " + invariants_text(line.mended));
    json.columns.push_back(member(
        key, "",
        one("", {member("cases_broken", "1", line.cases), member("random_runs_broken", "1", line.random_runs),
                 member("newly_broken", "", line.newly_broken), member("mended", "", line.mended)})));
  };
  if (!card.lacking.empty()) lines.add("invariants", "not measured: " + card.lacking);
  add("invariants", "of any core", "general", hard.general);
  add("", "of the listing", "listing", hard.listing);
  if (card.lacking.empty() && hard.cases == 0)
    lines.add("", "hard cases: not measured: no scenarios in a folder named hard");
  lines.json.push_back(std::move(json));
}

Table invariant_table(const HardCaseLine& hard) {
  struct Change {
    std::string name;
    std::string kind;
    std::string change;
  };
  std::vector<Change> changes;
  for (const auto& [line, kind] : {std::pair(&hard.general, "general"), {&hard.listing, "listing"}}) {
    for (const std::string& name : line->newly_broken) changes.push_back({name, kind, "newly broken"});
    for (const std::string& name : line->mended) changes.push_back({name, kind, "no longer broken"});
  }
  return StudyTable("invariants", "invariants of hard cases and random runs that differ", changes)
      .add("invariant", "", "case and invariant", &Change::name)
      .add("kind", "", "general, or the listing's own", &Change::kind)
      .add("change", "", "what changed", &Change::change);
}

Table claim_table(const std::vector<ChangedClaim>& claims) {
  return StudyTable("claims", "claims of the paper with another verdict", claims)
      .add("claim", "", "section and name", &ChangedClaim::id)
      .add("before", "", "verdict on the base", [](const auto& claim) { return claim.verdict.before; })
      .key("verdict/before")
      .add("after", "", "verdict on the candidate", [](const auto& claim) { return claim.verdict.after; })
      .key("verdict/after")
      .add("measured_before", "", "measured on the base",
           [](const auto& claim) { return claim.number.before; })
      .key("number/before")
      .add("measured_after", "", "measured on the candidate",
           [](const auto& claim) { return claim.number.after; })
      .key("number/after")
      .add("unit", "", "of what is measured", &ChangedClaim::unit);
}

void add_claims(const Card& card, Lines& lines) {
  if (!card.lacking.empty()) {
    lines.json.push_back(one("claims"));
    return lines.add("paper's claims", "not measured: " + card.lacking);
  }
  const ClaimLine& line = card.claims;
  lines.add("paper's claims", fmt::format("{} of {} change, {} more with another number", line.changed.size(),
                                          line.claims, line.other_numbers));
  if (!line.not_measured.empty())
    lines.add("", fmt::format("{} not measured with one of the cores: {}", line.not_measured.size(),
                              list_text(line.not_measured)));
  lines.add_first(4, line.changed, [](const ChangedClaim& claim) {
    return fmt::format("{} {} -> {}", claim.id, claim.verdict.before, claim.verdict.after);
  });
  lines.json.push_back(
      one("claims",
          {member("claims", "1", line.claims), member("changed", "", claim_table(line.changed)),
           member("not_measured", "", line.not_measured), member("other_numbers", "1", line.other_numbers)}));
}

Table recording_table(const std::vector<ScenarioChange>& moved) {
  return StudyTable("recordings", "recordings that end elsewhere", moved)
      .add("recording", "", "its file", &ScenarioChange::path)
      .key("scenario")
      .add("shift", "px", "distance of the last rows",
           [](const ScenarioChange& each) { return each.change.end_shift_px; })
      .key("px");
}

// "fling" of "folder/fling.json".
std::string stem(const std::string& path) {
  const std::size_t begin = path.rfind('/') + 1;
  return path.substr(begin, path.rfind('.') - begin);
}

void add_recordings(const Card& card, Lines& lines) {
  if (card.recordings == 0) {
    lines.json.push_back(one("recordings"));
    return lines.add("recordings", "not measured: no scenarios in a folder named recorded");
  }
  const std::vector<ScenarioChange> moved = card.moved_recordings();
  std::vector<std::string> names;
  names.reserve(moved.size());
  for (const ScenarioChange& recording : moved)
    names.push_back(fmt::format("{} {} px", stem(recording.path), rounded(recording.change.end_shift_px, 3)));
  lines.add("recordings", fmt::format("{} of {} end elsewhere", moved.size(), card.recordings));
  if (!moved.empty()) lines.add("", list_text(names, 2));
  lines.json.push_back(one("recordings", {member("recordings", "1", card.recordings),
                                          member("moved", "", recording_table(moved))}));
}

// What differs, one by one. Tables without rows are left out.
std::vector<Table> tables_of(const Card& card) {
  std::vector<Table> tables = {changes_table(card.step.changes), scenario_table(card.library.changed),
                               invariant_table(card.hard_cases), claim_table(card.claims.changed),
                               recording_table(card.moved_recordings())};
  std::erase_if(tables, [](const Table& table) { return row_count(table) == 0; });
  return tables;
}

}  // namespace

Result card_result(const Card& card) {
  Lines lines;
  lines.json.push_back({.columns = {member("seed", "1", card.seed)}, .shape = JsonShape::members});
  add_step(card, lines);
  add_bits(card, lines);
  add_contacts(card, lines);
  add_landing(card, lines);
  add_displays(card.displays, lines);
  add_rest(card.rest, lines);
  add_energy(card, lines);
  add_exact(card, lines);
  add_speed(card.cost, lines);
  add_hard_cases(card, lines);
  add_claims(card, lines);
  add_recordings(card, lines);
  const std::string consequence = consequence_of(card);
  lines.json.push_back({.columns = {member("consequence", "", consequence)}, .shape = JsonShape::members});
  return {.tables = tables_of(card),
          .figures = card_figures(card),
          .verdict = {.text = {Table{"card",
                                     fmt::format("{} scenarios, {} random flings (seed {}); median "
                                                 "(10 .. 90 %), before -> after",
                                                 card.scenarios, card.flings, card.seed),
                                     {{"line", "", "what is measured", std::move(lines.names)},
                                      {"measured", "", "with its interval", std::move(lines.texts)}}}},
                      .brief = consequence},
          .summary = std::move(lines.json)};
}

}  // namespace hyrax
