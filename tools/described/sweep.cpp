#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "sim/described/described_run.h"
#include "sim/scenario/frame_clock.h"
#include "tools/described/commands.h"
#include "tools/described/scenario_json.h"
#include "tools/described/value_json.h"
#include "tools/files/printable.h"
#include "tools/files/text_file.h"

namespace hyrax {
namespace {

// What a key sets, if that is a value of the core.
const ValueInfo* value_at(const Description& description, std::string_view pointer) {
  const auto take_last = [&pointer] {
    const std::size_t slash = std::min(pointer.rfind('/'), pointer.size());
    const std::string_view last = pointer.substr(std::min(slash + 1, pointer.size()));
    pointer = pointer.substr(0, slash);
    return last;
  };
  const auto find = [](const std::vector<ValueInfo>& values, std::string_view name) {
    const auto found = std::ranges::find(values, name, &ValueInfo::name);
    return found == values.end() ? nullptr : &*found;
  };
  const std::string_view name = take_last();
  if (pointer == "/start") return find(description.state.values, name);
  if (pointer == "/parameters") return find(description.parameters.values, name);
  if (pointer == "/inputs") return find(description.inputs.values, name);
  const std::string_view owner = take_last();
  if (pointer == "/inputs") return find(description.inputs.values, owner);  // A frame of an array.
  if (!pointer.starts_with("/events/")) return nullptr;
  if (owner == "set") {
    const ValueInfo* const input = find(description.inputs.values, name);
    return input != nullptr ? input : find(description.state.values, name);
  }
  const auto action = std::ranges::find(description.actions, owner, &ActionInfo::name);
  return action == description.actions.end() ? nullptr : find(action->arguments, name);
}

class DescribedScenarios final : public SweptScenarios {
 public:
  explicit DescribedScenarios(const Description& description) : description_(description) {}

  [[nodiscard]] VariedKey key_at(const std::string& pointer) const override {
    const ValueInfo* const value = value_at(description_, pointer);
    if (value == nullptr) return {pointer, number_kind(pointer), MemberNumber{}};
    const auto kind = value->type == ValueType::boolean ? ScenarioNumberKind::boolean
                      : is_floating(value->type)        ? ScenarioNumberKind::real
                      : is_signed_integer(value->type)  ? ScenarioNumberKind::integer
                                                        : ScenarioNumberKind::seed;
    return {pointer, kind, MemberNumber{}, value->names};
  }
  void read(const Json& document, const std::string& source) override {
    DescribedScenario scenario = to_described_scenario(description_, document, source, "");
    if (!base_) base_ = std::move(scenario);
  }
  // It was read with a number there; "-" appends one.
  [[nodiscard]] bool has_number(const VariedKey& key) override {
    return (key.pointer + "/").find("/-/") == std::string::npos;
  }
  // A time of an event has no limits of its own.
  [[nodiscard]] bool allows(const VariedKey& key, const SweepNumber& number) override {
    const ValueInfo* const value = value_at(description_, key.pointer);
    if (value == nullptr) {
      Scenario of_head;
      static_cast<ScenarioHead&>(of_head) = *base_;
      const auto field = number_at(of_head, key.pointer);
      return !field || field->allows(as_double(number));
    }
    const std::array<Word, 2> limits = file_limits(*value);
    const Word word = value->type == ValueType::float32
                          ? word_of(static_cast<float>(as_double(number)))
                          : std::visit([](auto each) { return word_of(each); }, number);
    return !is_less(value->type, word, limits[0]) && !is_less(value->type, limits[1], word);
  }
  void check_members(const SweepDocument& sweep, const std::string& source) override {
    const bool is_free = base_->events.empty() && base_->input_arrays.empty() &&
                         std::holds_alternative<std::int64_t>(base_->length) &&
                         !std::holds_alternative<RecordedSteps>(base_->clock.base);
    const auto is_value = [&](const VariedKey& key) { return value_at(description_, key.pointer); };
    if (is_free || std::ranges::all_of(sweep.plan.vary, is_value)) return;
    for (std::int64_t member = 0; member < sweep.plan.members; ++member)
      read_member(*this, sweep, member, source);
  }
  [[nodiscard]] const DescribedScenario& base() const { return *base_; }

 private:
  const Description& description_;
  std::optional<DescribedScenario> base_ = {};
};

bool is_number(const ValueInfo& value) {
  return value.type != ValueType::boolean && value.names.empty() && !value.is_enum;
}

void describe(const ValueInfo& value, Column& column) {
  column.unit = value.unit;
  column.stored_as = value.type;
  column.value_names = value.names;
}

std::vector<Table> tables_of(const Description& description, const SweepPlan& plan) {
  std::vector<Table> tables = {members_table(plan.keep.only({Keep::at_rest, Keep::state_hash}))};
  const auto add = [&](Keep kept, const char* group, const std::string& what, const auto& values) {
    if (!plan.keep.has(kept)) return;
    Table& table = tables.emplace_back(Table{.name = group});
    for (const ValueInfo& value : values) {
      if (kept == Keep::extremes && !is_number(value)) continue;
      Column& column = table.columns.emplace_back(
          Column{.name = value.name, .long_name = what + value.name, .values = {}});
      if (is_signed_integer(value.type))
        column.values = std::vector<std::int64_t>();
      else if (!is_floating(value.type))
        column.values = std::vector<std::uint64_t>();
      describe(value, column);
    }
  };
  std::vector<ValueInfo> contacts;
  for (const std::string& contact : description.contacts)
    contacts.push_back({.name = contact, .type = ValueType::int64});
  add(Keep::final, "members/final", "final ", description.state.values);
  add(Keep::contacts, "members/contacts", "contacts with ", contacts);
  add(Keep::extremes, "members/min", "smallest of all rows: ", description.state.values);
  add(Keep::extremes, "members/max", "largest of all rows: ", description.state.values);
  tables.push_back(inputs_table(plan));
  for (Column& column : tables.back().columns)
    if (const ValueInfo* const value = value_at(description, column.long_name)) describe(*value, column);
  return tables;
}

// A row replaces an extreme only if strictly beyond it.
struct Extremes final : DescribedSink {
  explicit Extremes(const std::vector<ValueInfo>& of_state) : state(of_state) {}

  void row(const DescribedRow& row) override {
    if (row.step == 0) smallest = largest = {row.state.begin(), row.state.end()};
    for (std::size_t place = 0; place < state.size(); ++place) {
      const Word word = row.state[place];
      if (is_less(state[place].type, word, smallest[place])) smallest[place] = word;
      if (is_less(state[place].type, largest[place], word)) largest[place] = word;
    }
  }

  const std::vector<ValueInfo>& state;
  std::vector<Word> smallest = {};
  std::vector<Word> largest = {};
};

// A sweep that was read. Refers to the core.
struct SweepOfCore {
  const DescribedCore& core;
  std::string path;
  SweepDocument document;

  // @param json of another member, or the base.
  [[nodiscard]] DescribedScenario scenario(std::int64_t member, Json& json) const {
    set_member(document.plan, member, path, json);
    return to_described_scenario(core.description, json, path, "");
  }

  // Adds what is kept of a member to the tables and results.
  SweepTally play(std::int64_t member, Json& json, std::vector<MemberResult>& results,
                  std::vector<Table>& tables) const {
    const std::vector<ValueInfo>& state = core.description.state.values;
    Extremes extremes(state);
    DescribedSink* const sinks[] = {&extremes};
    const std::size_t used = document.plan.keep.has(Keep::extremes) ? 1 : 0;
    const DescribedSummary run = hyrax::play(core, scenario(member, json), std::span(sinks, used));
    SweepTally tally{{run.steps, run.steps}};
    if (const auto& end = run.early_end) {
      tally.early_ends = 1;
      tally.first_early_end = fmt::format("member {}: row {}: {}", member, end->step, printable(end->what));
      if (end->step == 0 && !end->is_non_finite)
        throw Failure(ExitCode::disagreed, path + ": " + tally.first_early_end + "; nothing written");
    }
    MemberResult& result = results.emplace_back();
    result.at_rest_since_s = run.at_rest_since_s.value_or(result.at_rest_since_s);
    result.state_hash = run.state_hash;
    auto table = tables.begin();
    const auto append = [&](Keep kept, const auto& values) {
      if (!document.plan.keep.has(kept)) return;
      auto column = (++table)->columns.begin();
      for (std::size_t place = 0; place < values.size(); ++place)
        if (kept != Keep::extremes || is_number(state[place]))
          with_numbers(*column++, [&]<class Numbers>(Numbers& numbers) {
            numbers.push_back(value_of<typename Numbers::value_type>(word_of(values[place])));
          });
    };
    append(Keep::final, run.final);
    append(Keep::contacts, run.contacts);
    append(Keep::extremes, extremes.smallest);
    append(Keep::extremes, extremes.largest);
    return tally;
  }
};

RowPlayer player_of(const std::shared_ptr<const SweepOfCore>& sweep) {
  return [sweep, json = sweep->document.base](const WorkPart& part, std::int64_t first_row,
                                              std::int64_t count, std::vector<Table>& tables) mutable {
    for (Table& table : tables)
      for (Column& column : table.columns) with_numbers(column, [](auto& numbers) { numbers.clear(); });
    std::vector<MemberResult> results;
    SweepTally tally;
    for (std::int64_t row = first_row; row < first_row + count; ++row)
      tally += sweep->play(part.member(row), json, results, tables);
    set_members(sweep->document.plan.keep.only({Keep::at_rest, Keep::state_hash}), results, tables.front());
    return tally;
  };
}

PlayableSweep load(const DescribedCore& core, const std::string& path) {
  DescribedScenarios scenarios(core.description);
  const auto sweep = std::make_shared<const SweepOfCore>(
      SweepOfCore{core, path, read_sweep(scenarios, read_text_file(path), path)});
  const auto member_text = [sweep](std::int64_t member) {
    Json json = sweep->document.base;
    DescribedScenario scenario = sweep->scenario(member, json);
    name_member(scenario, member);
    return to_text(to_json(sweep->core.description, scenario), 1) + "\n";
  };
  const SweepPlan& plan = sweep->document.plan;
  constexpr std::int64_t kSteps = 1 << 20;
  return {.contents = {plan, tables_of(core.description, plan)},
          .text = sweep->document.text,
          .base_path = sweep->document.base_path,
          .chunk_rows = std::clamp<std::int64_t>(kSteps / (step_count(scenarios.base()) + 1), 1, 16384),
          .make_player = [sweep] { return player_of(sweep); },
          .member_text = member_text};
}

EnsembleContents contents_of(const Description& own, const EnsembleHead& head, const std::string& path) {
  const std::string name = printable(head.core_name.empty() ? head.physics : head.core_name);
  if (head.core_name != own.core)
    refuse_input(fmt::format("{}: is a sweep of the core {}: join its parts with {}", path, name,
                             head.core_name.empty() ? "hyrax-sim, or its program" : name + "-sim"));
  if (head.description != to_text(description_json(own))) {
    const std::string difference = description_difference(
        own, parse_description(head.description, own.core, path + ": attribute description"));
    refuse_input(
        fmt::format("{}: was computed with another description of the core {} ({}); compute all "
                    "parts with one program, and join them with it",
                    path, name, difference.empty() ? "other defaults or limits" : printable(difference)));
  }
  DescribedScenarios scenarios(own);
  const SweepDocument sweep =
      read_sweep(scenarios, head.sweep_text, path + ": sweep", SweepCheck::first_member);
  return {sweep.plan, tables_of(own, sweep.plan)};
}

}  // namespace

SweptCore swept_core(const DescribedCore& core) {
  const Description& description = core.description;
  return {.head = {.physics = std::string(kDescribedModel),
                   .core = core.record.checksum(),
                   .core_name = description.core,
                   .description = to_text(description_json(description))},
          .load = [&core](const std::string& path) { return load(core, path); },
          .read_contents = [&description](
                               const EnsembleHead& head,
                               const std::string& path) { return contents_of(description, head, path); }};
}

Command described_sweep_command(const DescribedCore& core) {
  Command command = sweep_command_of([&core](const Core&) { return swept_core(core); });
  command.summary = "play many scenarios that differ in some values, and store selected results of each";
  return command;
}

}  // namespace hyrax
