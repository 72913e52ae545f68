#include "tools/described/golden_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <span>
#include <utility>

#include "sim/described/described_step.h"
#include "sim/trace/step_text.h"
#include "sim/trajectory/stored_run.h"
#include "tools/app/core/accepted_core.h"
#include "tools/described/run_text.h"
#include "tools/described/scenario_json.h"
#include "tools/files/failure.h"
#include "tools/files/scenario_changes.h"
#include "tools/files/summary_text.h"
#include "tools/files/text_file.h"
#include "tools/platform/atomic_file.h"
#include "tools/store/golden_summary.h"

namespace hyrax {
namespace {

constexpr std::int64_t kGoldenValuesMax = 10'000;
constexpr std::int64_t kComparedValuesMax = 1 << 25;  // Of a run that is played again, in memory.
constexpr std::size_t kSecondsListed = 10;
constexpr std::size_t kPairsListed = 8;
constexpr std::size_t kValuesListed = 40;
constexpr std::size_t kContactsListed = 40;

bool keeps_rows(const DescribedCore& core, std::int64_t steps) {
  const std::int64_t values = std::ssize(core.description.state.values);
  return is_stored_as_rows(steps) && (steps + 1) * values <= kGoldenValuesMax;
}

class GoldenRecorder : public DescribedSink {
 public:
  explicit GoldenRecorder(bool keeps_rows) : keeps_rows_(keeps_rows) {}

  void row(const DescribedRow& row) override {
    if (keeps_rows_) contents_.rows.append(row);
    while (last_ && !has_all_seconds() && row.t_s > next_second() + 1e-9 * row.dt_s)
      contents_.at_seconds.push_back(*last_);
    if (!has_all_seconds())
      last_ = KeptRow{row.step, row.t_s, row.dt_s, {row.state.begin(), row.state.end()}, {}};
  }
  void block(const DescribedBlock& block) override {
    if (!keeps_rows_) contents_.blocks.push_back(block);
  }
  void contact(const DescribedContact& contact) override { contents_.contacts.push_back(contact); }

  [[nodiscard]] GoldenContents take(DescribedSummary summary) {
    while (last_ && !has_all_seconds() && last_->t_s >= next_second() - 1e-9 * last_->dt_s)
      contents_.at_seconds.push_back(*last_);
    contents_.summary = std::move(summary);
    std::ranges::sort(contents_.contacts, {},
                      [](const DescribedContact& contact) { return order_of(contact); });
    return std::move(contents_);
  }

 private:
  [[nodiscard]] double next_second() const { return static_cast<double>(contents_.at_seconds.size() + 1); }
  [[nodiscard]] bool has_all_seconds() const { return contents_.at_seconds.size() == kSecondsListed; }

  bool keeps_rows_;
  std::optional<KeptRow> last_ = {};
  GoldenContents contents_;
};

GoldenContents play_and_keep(const DescribedCore& core, const DescribedScenario& scenario, bool keeps_rows,
                             std::vector<DescribedSink*> sinks = {}) {
  GoldenRecorder recorder(keeps_rows);
  sinks.push_back(&recorder);
  DescribedSummary summary = play(core, scenario, sinks);
  return recorder.take(std::move(summary));
}

// What does not change the run.
Json without_texts(const Description& description, DescribedScenario scenario) {
  scenario.name.clear();
  scenario.description.reset();
  scenario.schema.reset();
  scenario.expect.reset();
  scenario.core.reset();
  return to_json(description, scenario);
}

// What of a description is compared: its defaults and limits change no file.
Description without_defaults(Description description) {
  for (ValueList* const list :
       {&description.state, &description.inputs, &description.parameters, &description.outputs})
    for (ValueInfo& value : list->values) {
      value.initial = 0;
      value.limits.reset();
    }
  return description;
}

std::string contents_checksum(const Description& description, const DescribedScenario& scenario,
                              const GoldenContents& run) {
  const std::string text = fmt::format("{}\n{}\n{}\n{}\n{}\n", to_text(without_texts(description, scenario)),
                                       to_text(description_json(without_defaults(description))),
                                       kDescribedModel, run.summary.steps, run.state_hash());
  return hex(digest(std::as_bytes(std::span(text))));
}

ComparedSide side_of(const GoldenContents& run, const DescribedScenario& scenario) {
  return {batches_of(run.rows), jump_frames(scenario, run.summary.steps), run.contacts};
}

bool fits_in_memory(const Description& description, std::int64_t steps) {
  return steps < kComparedValuesMax / std::ssize(description.state.values);
}

// All rows of the run of a file by this core; nothing where it does not give them.
std::optional<ComparedSide> replayed_side(const DescribedCore& core, const DescribedHead& head) {
  const GoldenContents run = play_and_keep(core, head.scenario, true);
  return run.state_hash() == head.state_hash ? std::optional(side_of(run, head.scenario)) : std::nullopt;
}

// The nearest folder above the file that has an accepted core; empty: none.
std::string golden_folder_above(const std::string& path) {
  std::error_code error;
  std::filesystem::path folder = std::filesystem::absolute(path, error);
  while (folder.has_relative_path()) {
    folder = folder.parent_path();
    if (std::filesystem::exists(accepted_core_folder(folder.string()) + "/accepted.txt", error))
      return folder.string();
  }
  return "";
}

// The same by the step of the accepted core of the file's golden folder, if that is complete.
std::optional<ComparedSide> side_by_accepted_step(const DescribedFile& file) {
  const DescribedHead& head = file.head();
  const std::string folder = golden_folder_above(file.path());
  const std::optional<AcceptedCore> accepted = folder.empty() ? std::nullopt : undamaged_core(folder);
  std::optional<TracedStep> step = accepted ? read_step(accepted->step) : std::nullopt;
  if (!step || accepted->model != kDescribedModel) return std::nullopt;
  const DescribedCore core{.description = parse_description(accepted->description, head.description.core,
                                                            accepted_core_folder(folder))};
  if (!description_difference(head.description, core.description).empty()) return std::nullopt;
  return replayed_side(interpreted(core, *std::move(step)), head);
}

// Nothing, too, where the scenario's run would be too large to compare.
std::optional<ComparedSide> golden_side(const DescribedCore& core, const DescribedScenario& scenario,
                                        const DescribedFile& file) {
  if (!fits_in_memory(core.description, step_count(scenario))) return std::nullopt;
  return all_rows_of(core, file);
}

// A run with all its rows.
ComparedSide whole_side(const DescribedCore& core, const DescribedScenario& scenario,
                        const GoldenContents& run) {
  return side_of(run.rows.size() > 0 ? run : play_and_keep(core, scenario, true), scenario);
}

DescribedComparison compare_with_rows(const DescribedCore& core, const DescribedScenario& scenario,
                                      const GoldenContents& run, const DescribedFile& file) {
  const DescribedHead& kept = file.head();
  const std::vector<DescribedBlock> blocks = file.blocks();
  const bool is_same_scenario = plays_the_same(kept.scenario, scenario);
  DescribedComparison result;
  if (const auto golden = golden_side(core, scenario, file))
    result = compare_runs(core.description, *golden, whole_side(core, scenario, run));
  else if (!blocks.empty() && !run.blocks.empty())
    result = compare_blocks(core.description, blocks, run.blocks);
  else
    result.distance.has_unknown_rows = true;
  if (result.distance.has_unknown_rows) result.contacts = contact_counts(file.contacts(), run.contacts);
  if (!is_same_scenario)
    result.shape = "the scenario changed since it was blessed: " +
                   scenario_changes(core.description, kept.scenario, scenario);
  else if (kept.steps != run.summary.steps)
    result.shape = fmt::format("the numbers of steps differ: {} and {}", kept.steps, run.summary.steps);
  else if (result.agrees() && kept.state_hash != run.state_hash())
    result.shape = "the state hash differs, but no row that was compared";
  if (!result.shape.empty()) result.difference = DifferenceClass::shape;
  return result;
}

// Of a golden file of another description: what both have.
DescribedComparison compare_with_other_shape(const DescribedCore& core, const DescribedScenario& scenario,
                                             const GoldenContents& run, const DescribedFile& file) {
  const DescribedHead& kept = file.head();
  const auto unknown = batches_of(DescribedRows());
  const auto golden = golden_side(core, scenario, file);
  const ComparedSide before =
      golden ? *golden : ComparedSide{unknown, jump_frames(kept.scenario, kept.steps), file.contacts()};
  ComparedSide after = golden ? whole_side(core, scenario, run) : side_of(run, scenario);
  if (!golden) after.rows = unknown;
  DescribedComparison result = compare_common(kept.description, before, core.description, after);
  result.distance.has_unknown_rows = !golden;
  return result;
}

std::string summary_text(const DescribedCore& core, const DescribedScenario& scenario,
                         const GoldenContents& run) {
  const Description& description = core.description;
  const DescribedSummary& summary = run.summary;
  std::string text =
      fmt::format("scenario: {}\nphysics: {}\ncore: {}\nsteps: {}\n{}{}\n", scenario.name, kDescribedModel,
                  description.core, summary.steps, kStateHashKey, run.state_hash());
  text += fmt::format("contacts: {}\n", contacts_text(description, summary));
  for (std::size_t index = 0; index < run.contacts.size(); ++index) {
    const bool is_cut = run.contacts.size() > kContactsListed;
    if (is_cut && index == kContactsListed / 2) {
      text += fmt::format("  ... {} more\n", run.contacts.size() - kContactsListed);
      index = run.contacts.size() - kContactsListed / 2;
    }
    const DescribedContact& contact = run.contacts[index];
    text += fmt::format("  {}{} {}\n", contact.step,
                        contact.last_step == contact.step ? "" : fmt::format(" .. {}", contact.last_step),
                        description.contacts[contact.contact]);
  }
  const auto& values = description.state.values;
  std::vector<PositionPair> pairs = position_pairs(description);
  if (pairs.size() > kPairsListed) pairs.resize(kPairsListed);
  if (!pairs.empty() && !run.at_seconds.empty()) text += "position:\n";
  for (std::size_t second = 0; !pairs.empty() && second < run.at_seconds.size(); ++second) {
    const KeptRow& row = run.at_seconds[second];
    text += fmt::format("  {} s", second + 1);
    for (const PositionPair& pair : pairs)
      text += fmt::format("  {}{}x {:.6f} px, y {:.6f} px", pair.name, pair.name.empty() ? "" : " ",
                          number_of(values[pair.x].type, row.state[pair.x]),
                          number_of(values[pair.y].type, row.state[pair.y]));
    text += fmt::format("  step {}\n", row.step);
  }
  text += fmt::format("end: t {} s\n", summary.simulated_s);
  for (std::size_t index = 0; index < std::min(values.size(), kValuesListed); ++index) {
    const ValueInfo& value = values[index];
    const Word word = summary.final[index];
    text += fmt::format("  {} {}{}{}\n", value.name, value_text(value, word),
                        value.unit.empty() ? "" : " " + value.unit,
                        is_floating(value.type) ? "  " + hex_float(number_of(value.type, word)) : "");
  }
  if (values.size() > kValuesListed) text += fmt::format("  and {} more\n", values.size() - kValuesListed);
  return text + (summary.at_rest_since_s
                     ? fmt::format("settled since: {} s\n", *summary.at_rest_since_s)
                     : fmt::format("not settled: {}\n", why_not_settled(description, summary)));
}

}  // namespace

std::string scenario_changes(const Description& description, const DescribedScenario& from,
                             const DescribedScenario& to) {
  if (plays_the_same(from, to)) return "";
  return json_changes(without_texts(description, from), without_texts(description, to));
}

std::optional<ComparedSide> all_rows_of(const DescribedCore& core, const DescribedFile& file) {
  const DescribedHead& head = file.head();
  if (file.holds_every_row())
    return ComparedSide{file.rows(), jump_frames(head.scenario, head.steps), file.contacts()};
  if (!fits_in_memory(head.description, head.steps)) return std::nullopt;
  std::optional<ComparedSide> played;
  if (description_difference(head.description, core.description).empty()) played = replayed_side(core, head);
  return played ? std::move(played) : side_by_accepted_step(file);
}

GoldenContents play_for_golden(const DescribedCore& core, const DescribedScenario& scenario,
                               const std::vector<DescribedSink*>& also) {
  return play_and_keep(core, scenario, keeps_rows(core, step_count(scenario)), also);
}

bool is_proved_to_agree(const DescribedCore& core, const DescribedScenario& scenario,
                        const GoldenContents& run, const GoldenPlace& place) {
  const std::string text = read_text_file(place.txt_path);
  return has_checksums(text, contents_checksum(core.description, scenario, run),
                       file_checksum(place.h5_path)) &&
         text.starts_with("scenario: " + scenario.name + "\n");
}

GoldenComparison compare_with_golden(const DescribedCore& core, const DescribedScenario& scenario,
                                     const GoldenContents& run, const GoldenPlace& place) {
  const std::string text = read_text_file(place.txt_path);
  const std::string file_sum = file_checksum(place.h5_path);
  GoldenComparison result;
  result.is_proved = is_proved_to_agree(core, scenario, run, place);
  if (result.is_proved) {
    static_cast<DescribedComparison&>(result) = no_difference(core.description);
    return result;
  }
  const DescribedFile file = DescribedFile::open(place.h5_path, core.description.core);
  const DescribedHead& kept = file.head();
  const std::string difference = description_difference(kept.description, core.description);
  if (!difference.empty()) {
    static_cast<DescribedComparison&>(result) = compare_with_other_shape(core, scenario, run, file);
    result.shape = difference + ": bless --accept shape";
    result.difference = DifferenceClass::shape;
  } else {
    static_cast<DescribedComparison&>(result) = compare_with_rows(core, scenario, run, file);
    result.has_other_scenario = !plays_the_same(kept.scenario, scenario);
  }
  const std::string blessed_sum = summary_file_checksum(text).value_or("");
  if (text.find("\r\n") != std::string::npos)
    result.fault = place.txt_path + ": " + kConvertedLineEnds;
  else if (blessed_sum != file_sum)
    result.fault = place.h5_path + ": does not have the checksum in " + place.txt_path;
  else if (result.agrees() && kept.scenario.name == scenario.name)
    result.fault = place.txt_path + ": its checksums are not those of its lines and of " + place.h5_path;
  if (result.fault.empty()) return result;
  result.fault = "the golden file was changed since it was blessed: " + result.fault +
                 "; restore it, or bless the scenario again";
  result.difference = DifferenceClass::shape;
  return result;
}

bool is_golden_h5(const DescribedCore& core, const std::string& path) try {
  const DescribedFile file = DescribedFile::open(path, core.description.core);
  return file.holds_every_row() || !file.blocks().empty();
} catch (const Failure&) {
  return false;
}

void write_golden_pair(const DescribedCore& core, const DescribedScenario& scenario, const GoldenPlace& place,
                       const std::string& reason) {
  std::error_code error;
  std::filesystem::create_directories(std::filesystem::path(place.h5_path).parent_path(), error);
  AtomicFile rows(place.h5_path);
  AtomicFile summary(place.txt_path);
  const std::int64_t steps = step_count(scenario);
  const bool are_rows_kept = keeps_rows(core, steps);
  DescribedWriter writer(rows.part_path(), place.h5_path, core.description, steps,
                         are_rows_kept ? 1 : static_cast<std::int64_t>(kBlockRows));
  const GoldenContents run = play_for_golden(core, scenario, {&writer});
  writer.finish({{.steps = steps,
                  .physics = std::string(kDescribedModel),
                  .state_hash = run.state_hash(),
                  .core = core.record.checksum()},
                 core.description,
                 scenario},
                run.contacts_total(), run.blocks);
  summary.write(with_checksums(summary_text(core, scenario, run), reason,
                               contents_checksum(core.description, scenario, run),
                               file_checksum(rows.part_path())));
  // The rows come last: until they are there, `check` compares with the old ones and reports it.
  summary.commit();
  rows.commit();
}

}  // namespace hyrax
