#include <algorithm>

#include "sim/core/core.h"
#include "sim/core/traced_stepper.h"
#include "sim/replay/fingerprint.h"
#include "sim/scenario/schedule.h"
#include "sim/study/reference_model.h"
#include "sim/trace/step_text.h"
#include "sim/trajectory/physics_model.h"
#include "sim/trajectory/state_hash.h"
#include "tools/app/comparison/comparison_text.h"
#include "tools/app/core/core_requirements.h"
#include "tools/app/diff/trajectory_diff.h"
#include "tools/app/drift/drift.h"
#include "tools/app/expect/judged_run.h"
#include "tools/app/play/play.h"
#include "tools/app/report/report_page.h"
#include "tools/app/runs/scenario_run.h"
#include "tools/files/build_info.h"
#include "tools/files/non_finite_text.h"
#include "tools/files/scenario_writer.h"
#include "tools/report/page_file.h"
#include "tools/report/wasm/scenario_record.h"
#include "tools/run_core/run_core.h"
#include "tools/store/trajectory_file.h"

namespace hyrax {
namespace {

constexpr std::size_t kInputsShownMax = 5'000;
constexpr std::size_t kContactsShownMax = 500;  // As many as the page draws.
constexpr std::size_t kScenarioTextMax = 200'000;
constexpr std::size_t kStepTextMax = 1'000'000;

std::string base64(std::string_view bytes) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    std::uint32_t group = 0;
    for (std::size_t index = 0; index < 3; ++index)
      group = group << 8 | (at + index < bytes.size() ? static_cast<std::uint8_t>(bytes[at + index]) : 0u);
    for (std::size_t digit = 0; digit < 4; ++digit)
      text += at + digit > bytes.size() ? '=' : kDigits[group >> (18 - 6 * digit) & 63u];
  }
  return text;
}

Json rows_json(const Columns& rows) {
  const std::vector<double> steps(rows.step.begin(), rows.step.end());
  const std::vector<double> contacts(rows.contact.begin(), rows.contact.end());
  Json::Object object{{"step", doubles_json(steps)}};
  for (const RowColumn& column : kRowColumns)
    object.emplace_back(column.name, doubles_json(rows.*column.also));
  object.emplace_back("contact", doubles_json(contacts));
  return object;
}

// What of a file's rows goes into the page: the rows, or, of a long run of which the file holds every row,
// the digests of its blocks and the rows of the first block that the replay does not give.
struct Evidence {
  Columns rows;
  std::vector<Digest> blocks;
};

class BlockList final : public RowSink {
 public:
  [[nodiscard]] Wants wants() const override { return {.blocks = true}; }
  void block(const Block& block, std::int64_t count) override {
    digests.insert(digests.end(), static_cast<std::size_t>(count), block.digest);
  }
  std::vector<Digest> digests;
};

std::vector<Digest> block_digests(const TrajectoryFile& file) {
  std::vector<Digest> digests;
  constexpr auto kRows = static_cast<std::int64_t>(kBlockRows);
  for (std::int64_t first = 0; first < file.row_count(); first += kRows) {
    const Columns rows = file.rows(first, std::min(kRows, file.row_count() - first));
    RowBlock block;
    for (std::size_t index = 0; index < rows.size(); ++index) block.append(rows.row(index));
    digests.push_back(digest(block));
  }
  return digests;
}

Evidence evidence_of(const Core& core, const TrajectoryFile& file, std::int64_t rows_max) {
  Evidence evidence;
  if (file.row_count() <= rows_max) {
    evidence.rows = file.rows(0, file.row_count());
    return evidence;
  }
  if (!file.holds_every_row()) return evidence;
  evidence.blocks = block_digests(file);
  BlockList played;
  static_cast<void>(replay(core, file.head().scenario, played));
  const auto end = std::min(evidence.blocks.size(), played.digests.size());
  std::size_t block = 0;
  while (block < end && evidence.blocks[block] == played.digests[block]) ++block;
  const auto first = static_cast<std::int64_t>(block * kBlockRows);
  if (first < file.row_count())
    evidence.rows = file.rows(first, std::min<std::int64_t>(kBlockRows, file.row_count() - first));
  return evidence;
}

Json blocks_json(const std::vector<Digest>& blocks) {
  std::string bytes;
  for (const Digest& block : blocks) bytes.append(block.begin(), block.end());
  return base64(bytes);
}

Json input_json(const Input& input) {
  Json::Object object{{"frame", input.frame}, {"kind", name_of(input.action)}};
  if (const auto* resize = std::get_if<Resize>(&input.action)) {
    const auto add = [&](const char* name, const std::optional<Size>& size) {
      if (size)
        object.emplace_back(name, Json::Array{std::int64_t{size->width_px}, std::int64_t{size->height_px}});
    };
    add("window", resize->window);
    add("sprite", resize->sprite);
  }
  return object;
}

Json constants_json(const Constants& constants) {
  const ConstantNumbers numbers = numbers_of(constants);
  return Json::Array(numbers.begin(), numbers.end());
}

Json errors_json(const DriftSummary& summary) {
  const auto value = [](const std::optional<Worst>& worst) { return worst ? Json(worst->value) : Json(); };
  return Json::Object{{"implementation_px", value(summary.implementation_px)},
                      {"truncation_px", value(summary.truncation_px)},
                      {"model_px", value(summary.model_px)},
                      {"energy_drift_rel", value(summary.energy_drift_rel_max)}};
}

// A page plays a core that is not its own by the text of its step. Empty: it plays this one.
std::string why_not_replayed(const Core& core) {
  const std::string name(core.name);
  if (core.record.step.empty())
    return "the step of the core " + name + " is not complete (" + std::string(core.record.why_incomplete) +
           ")";
  if (core.record.step.size() > kStepTextMax)
    return "the step of the core " + name + " is too long for a page";
  const std::optional<TracedStep> step = read_step(core.record.step);
  return step && traced_core(*step) ? "" : "a page cannot play the step of the core " + name;
}

// Of a core that a browser may not replay. NaN: not known.
Json contacts_json(const std::vector<Contact>& contacts) {
  const std::span<const Contact> shown(contacts.data(), std::min(contacts.size(), kContactsShownMax));
  Json::Object object;
  for (const ColumnOf<Contact>& column : kContactColumns) {
    std::vector<double> values;
    for (const Contact& contact : shown)
      values.push_back(column.number(contact).value_or(std::numeric_limits<double>::quiet_NaN()));
    object.emplace_back(column.name, doubles_json(values));
  }
  return object;
}

// With rows where it differs.
Json golden_json(const Core& core, const TrajectoryFile& golden, const TrajectoryFile& file,
                 std::int64_t rows_max) {
  const TrajectoryDiff difference = diff_trajectories(core, golden, file, {}, nullptr);
  const Comparison& comparison = difference.comparison;
  Json::Object object = comparison_json(comparison);
  object.insert(object.end(), {{"file", golden.path()},
                               {"agrees", comparison.agrees},
                               {"shape", comparison.shape},
                               {"is_by_time", comparison.distance.is_at_equal_times},
                               {"rows_compared", difference.rows_compared}});
  if (!comparison.agrees)
    object.emplace_back(
        "rows",
        rows_json(evidence_of(run_core(core, golden.path(), golden.head().scenario), golden, rows_max).rows));
  return object;
}

Json expectation_line(const Expectation& expectation) {
  return Json::Object{{"text", expectation_text(expectation)}, {"holds", expectation.holds}};
}

// The run of this program's own replay: what it exercised, what holds, where it ends.
ScenarioRun played(const Core& core, const TrajectoryFile& file) {
  ScenarioRun run;
  run.path = file.path();
  run.output = file.path();
  run.scenario = file.head().scenario;
  run.rows_recorded = file.row_count();
  std::optional<DriftRecorder> recorder;
  const FileHead& head = file.head();
  const Model model = reference_model(head.physics, head.constants, run.scenario.parameters);
  if (is_measurable(head.constants, model)) recorder.emplace(run.scenario, model);
  run.summary = play_with_progress(core, run.scenario, recorder ? recorder->sinks() : std::vector<RowSink*>(),
                                   judged_options(run.scenario));
  if (recorder) run.drift = recorder->finish(run.summary.steps, run.summary.simulated_s);
  run.expectations = judge_run(core, run.scenario, run.summary,
                               run.drift ? std::optional(run.drift->summary) : std::nullopt);
  return run;
}

Json provenance_json(const Provenance& provenance) {
  Json::Object object;
  for (std::size_t index = 0; index < provenance.size(); ++index)
    if (provenance[index]) object.emplace_back(kProvenanceNames[index], *provenance[index]);
  return object;
}

Json run_data(const Core& own_core, const TrajectoryFile& file, std::int64_t rows_max) {
  const FileHead& head = file.head();
  const Core core = run_core(own_core, file.path(), head.scenario);
  const ScenarioRun run = played(core, file);
  const Evidence evidence = evidence_of(core, file, rows_max);
  Json::Object data{{"file", file.path()},
                    {"name", head.scenario.name},
                    {"title", title_of(head.scenario, head.steps, run.summary.simulated_s)},
                    {"description", head.scenario.description.value_or("")},
                    {"steps", head.steps},
                    {"row_count", file.row_count()},
                    {"state_hash", head.state_hash},
                    {"physics", head.physics},
                    {"constants", head.constants ? constants_json(*head.constants) : Json()},
                    {"model", head.constants ? constants_json(reference_model(head.physics, head.constants,
                                                                              head.scenario.parameters))
                                             : Json()},
                    {"record", doubles_json(record_of(head.scenario))},
                    {"rows", rows_json(evidence.rows)},
                    {"blocks", blocks_json(evidence.blocks)},
                    {"contacts", is_paper_model(core.name) ? Json() : contacts_json(file.contacts())},
                    {"parameters", parameters_json(core)},
                    {"inputs", inputs_json(file.inputs())},
                    {"result", run_json(core, run)},
                    {"expect", list_of(run.expectations, expectation_line)},
                    {"errors", run.drift ? errors_json(run.drift->summary) : Json()},
                    {"non_finite", non_finite_text(head.scenario, run.summary.final)},
                    {"margin", run.drift ? margin_text(run.drift->margin) : ""},
                    {"provenance", provenance_json(file.provenance())}};
  const std::string text = scenario_file_text(head.scenario);
  if (text.size() <= kScenarioTextMax) data.emplace_back("scenario_text", text);
  return data;
}

}  // namespace

bool is_core_of_page(const Core& core) {
  const std::string_view own = page_core_fingerprint();
  return is_paper_model(core.name) && (own.empty() || own == hex(fingerprint_of(core)));
}

Json doubles_json(const std::vector<double>& values) {
  std::string bytes(values.size() * sizeof(double), '\0');
  for (std::size_t index = 0; index < values.size(); ++index)
    store_little_endian(reinterpret_cast<std::byte*>(bytes.data()) + index * sizeof(double), values[index]);
  return base64(bytes);
}

Json inputs_json(const std::vector<Input>& inputs) {
  Json::Array list;
  for (const Input& input : inputs)
    if (list.size() < kInputsShownMax || std::holds_alternative<Resize>(input.action))
      list.push_back(input_json(input));
  return list;
}

Json parameters_json(const Core& core) {
  if (!core.paper_match.constants) return {};
  Json::Array names;  // Files have restitution before drag.
  for (const std::size_t place : {0u, 2u, 1u, 3u, 4u})
    names.emplace_back(std::string(core.constant_names[place]));
  Json::Object given;
  for (const auto& [name, value] : core.parameters) given.emplace_back(name, value);
  return Json::Object{{"names", std::move(names)},
                      {"values", constants_json(*core.paper_match.constants)},
                      {"given", std::move(given)}};
}

Json report_data(const Core& core, const ReportRequest& request) {
  Json::Array runs;
  const bool is_of_page = is_core_of_page(core);
  const std::string why_not = is_of_page ? "" : why_not_replayed(core);
  // Many runs share the room for rows, unless nothing else is shown of them.
  constexpr std::size_t kAllRows = 50'000;
  const std::int64_t rows_max =
      why_not.empty()
          ? std::min<std::int64_t>(kPageRowsMax, static_cast<std::int64_t>(kAllRows / request.files.size()))
          : kPageRowsMax;
  std::optional<TrajectoryFile> golden;
  for (std::size_t index = 0; index < request.files.size(); ++index) {
    const std::string& against = request.goldens.empty() ? request.against : request.goldens[index];
    if (!against.empty() && !(golden && golden->path() == against)) {
      golden.emplace(TrajectoryFile::open(against));
      require_own_core(core, against, golden->head().physics);
    }
    const std::string& path = request.files[index];
    const TrajectoryFile file = TrajectoryFile::open(path);
    require_own_core(core, path, file.head().physics);
    Json run = run_data(core, file, rows_max);
    if (!against.empty())
      run.get<Json::Object>()->emplace_back("golden", golden_json(core, *golden, file, rows_max));
    runs.push_back(std::move(run));
  }
  return Json::Object{
      {"format", "hyrax-report/1"},
      {"program", "hyrax-sim " + std::string(build_info().version)},
      {"core", core.name},
      {"no_replay", why_not.empty() ? Json() : Json(why_not)},
      {"core_fingerprint", why_not.empty() ? Json(hex(fingerprint_of(core))) : Json()},
      {"core_step", why_not.empty() && !is_of_page ? Json(std::string(core.record.step)) : Json()},
      {"command", request.command},
      {"runs", std::move(runs)}};
}

}  // namespace hyrax
