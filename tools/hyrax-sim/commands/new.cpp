#include <algorithm>
#include <charconv>
#include <memory>
#include <optional>

#include "sim/scenario/scenario.h"
#include "tools/files/atomic_file.h"
#include "tools/files/json_pointer.h"
#include "tools/files/path.h"
#include "tools/files/scenario_reader.h"
#include "tools/files/text_file.h"
#include "tools/files/unknown_word.h"
#include "tools/hyrax-sim/command_line/options.h"
#include "tools/store/output_guard.h"

namespace hyrax {
namespace {

constexpr std::int64_t kFlingStep = 120;
constexpr std::string_view kPresentMonColumn = "MsBetweenPresents";
constexpr std::string_view kTemplate = R"({
  "$schema": "scenario.schema.json",
  "format": "hyrax-scenario/1",
  "name": "",
  "description": "What happens, and why it is worth testing.",
  "window": { "width_px": 1920, "height_px": 1080 },
  "sprite": { "width_px": 128, "height_px": 128 },
  "start": { "x_px": 300, "y_px": 500, "vx_px_per_s": 900, "vy_px_per_s": -700 },
  "clock": { "rate_hz": 60 },
  "steps": 600,
  "events": [ { "step": 120, "fling": { "vx_px_per_s": -1500, "vy_px_per_s": -900 } } ],
  "record": { "every": 1 },
  "expect": { "in_bounds": true, "finite": true }
})";

struct NewRequest {
  std::vector<std::string> names;
  std::string frames_path;
  std::string column;
  std::string unit;
  bool is_forced = false;
  Printing printing;
};

// The records of a CSV file by RFC 4180; line ends are LF or CRLF, a byte-order mark is skipped.
class CsvReader {
 public:
  CsvReader(const std::string& path, std::string_view text) : path_(path), rest_(text) {
    if (rest_.starts_with("\xef\xbb\xbf")) rest_.remove_prefix(3);
  }

  // The next record's fields; nothing at the end of the file. ERRORS: Failure(bad_input) for a misplaced
  // quote.
  std::optional<std::vector<std::string>> next() {
    if (rest_.empty()) return std::nullopt;
    line_ = next_line_++;
    std::vector<std::string> fields;
    do
      fields.push_back(rest_.starts_with('"') ? quoted_field(fields.size() + 1)
                                              : plain_field(fields.size() + 1));
    while (take(","));
    if (!take("\r\n")) static_cast<void>(take("\n"));
    return fields;
  }

  [[noreturn]] void refuse(const std::string& what) const {
    throw Failure(ExitCode::bad_input, fmt::format("{}: line {}{}", path_, line_, what));
  }

 private:
  bool take(std::string_view text) {
    if (!rest_.starts_with(text)) return false;
    rest_.remove_prefix(text.size());
    return true;
  }

  bool is_at_end() const {
    return rest_.empty() || rest_[0] == ',' || rest_[0] == '\n' || rest_.starts_with("\r\n");
  }

  std::string plain_field(std::size_t column) {
    std::string field;
    for (; !is_at_end(); rest_.remove_prefix(1)) {
      if (rest_[0] == '"') refuse(fmt::format(", column {}: quote inside a field without quotes", column));
      field += rest_[0];
    }
    return field;
  }

  std::string quoted_field(std::size_t column) {
    std::string field;
    for (rest_.remove_prefix(1); !take("\"") || rest_.starts_with('"'); rest_.remove_prefix(1)) {
      if (rest_.empty()) refuse(fmt::format(", column {}: closing quote is missing", column));
      if (rest_[0] == '\n') ++next_line_;
      field += rest_[0];
    }
    if (!is_at_end())
      refuse(fmt::format(", column {}: text after the closing quote (found {})", column, rest_[0]));
    return field;
  }

  const std::string& path_;
  std::string_view rest_;
  std::size_t line_ = 1;
  std::size_t next_line_ = 1;
};

std::size_t find_column(const CsvReader& csv, const std::vector<std::string>& header,
                        const std::string& name) {
  std::size_t found = header.size();
  for (std::size_t column = 0; column < header.size(); ++column) {
    if (header[column] != name) continue;
    if (found < header.size()) csv.refuse(": duplicate column (found " + name + ")");
    found = column;
  }
  if (found == header.size()) csv.refuse(": " + unknown_word("column", name, {header.begin(), header.end()}));
  return found;
}

double read_dt_s(const CsvReader& csv, const std::string& field, const std::string& place, double unit) {
  double value = -1.0;
  const char* const end = field.data() + field.size();
  const auto [rest, error] = std::from_chars(field.data(), end, value);
  const double dt_s = value / unit;
  if (error != std::errc() || rest != end || !(dt_s >= 0.0 && dt_s <= kFrameMax_s))
    csv.refuse(fmt::format(", {}: must be a number 0 .. {} (found {})", place, kFrameMax_s * unit,
                           field.substr(0, 60)));
  return dt_s;
}

// The dt of each frame that the CSV file recorded, in s.
Json::Array read_frames(const NewRequest& request) {
  const std::string name = request.column.empty() ? std::string(kPresentMonColumn) : request.column;
  if (request.unit.empty() && name != kPresentMonColumn)
    throw Failure(ExitCode::bad_input, "hyrax-sim new: --unit: is missing; needed with --column " + name);
  const std::string text = read_text_file(request.frames_path);
  CsvReader csv(request.frames_path, text);
  const std::vector<std::string> header = csv.next().value_or(std::vector<std::string>{});
  const std::size_t column = find_column(csv, header, name);
  const std::string place = fmt::format("column {} ({})", column + 1, name);
  Json::Array frames;
  while (const auto record = csv.next()) {
    if (record->size() != header.size())
      csv.refuse(
          fmt::format(": must have {} fields, as the header (found {})", header.size(), record->size()));
    frames.emplace_back(read_dt_s(csv, (*record)[column], place, request.unit == "s" ? 1.0 : 1000.0));
  }
  if (frames.empty()) csv.refuse(": no frame after the header");
  return frames;
}

Json new_document(const NewRequest& request) {
  Json document = parse_json(kTemplate, "new");
  set_at(document, "/name", request.names.front());
  if (request.frames_path.empty()) return document;
  Json::Array frames = read_frames(request);
  const auto steps = static_cast<std::int64_t>(frames.size());
  set_at(document, "/clock", Json::Object{{"dt_s", std::move(frames)}});
  set_at(document, "/steps", steps);
  set_at(document, "/events/0/step", std::min(kFlingStep, steps - 1));
  return document;
}

ExitCode write_new(const NewRequest& request) {
  if (request.frames_path.empty() && !(request.column.empty() && request.unit.empty()))
    throw Failure(ExitCode::bad_input, "hyrax-sim new: --column and --unit need --clock-from");
  const std::string path = request.names.front() + ".json";
  const Json document = new_document(request);
  const std::int64_t steps = std::get<std::int64_t>(to_scenario(document, path, "").length);
  std::vector<std::string> inputs;
  if (!request.frames_path.empty()) inputs.push_back(request.frames_path);
  OutputGuard(inputs).admit_scenario("hyrax-sim new", path);
  if (!request.is_forced && is_there(path))
    throw Failure(ExitCode::bad_input, path + ": exists; `--force` replaces it");
  AtomicFile file(path);
  file.write(to_text(document, {.depth_indented = 1}) + "\n");
  request.is_forced ? file.commit() : file.commit_as_new();
  if (request.printing.is_json) {
    print_text("{}\n", to_text(Json::Object{{"scenario", path}, {"steps", steps}}, {.depth_indented = 2}));
    return ExitCode::agreed;
  }
  print_text("written: {} ({} steps)\n", path, steps);
  if (!request.printing.is_quiet())
    print_text("its $schema, for editors: hyrax-sim schema > scenario.schema.json\n");
  return ExitCode::agreed;
}

}  // namespace

Command new_command() {
  return {.name = "new",
          .summary = "write a scenario file to start from, with every common key",
          .example = "hyrax-sim new my-fling --clock-from presentmon.csv",
          .needs_strict_ieee = false,
          .declare = [](Options& options) {
            const auto request = std::make_shared<NewRequest>();
            options.files(request->names,
                          {"NAME", "", "the scenario's name; writes NAME.json in the current folder"}, 1, 1);
            options.text(request->frames_path, {"--clock-from", "FRAMES.csv",
                                                "a CSV file of recorded frame times, as from PresentMon"});
            options.text(request->column,
                         {"--column", "NAME", "the column of frame times (default: MsBetweenPresents)"});
            options.choice(request->unit,
                           {"--unit", "s|ms", "the unit of frame times (default for MsBetweenPresents: ms)"},
                           {"s", "ms"});
            options.flag(request->is_forced, {"--force", "", "replace an existing NAME.json"});
            options.printing(request->printing);
            return [request] { return write_new(*request); };
          }};
}

}  // namespace hyrax
