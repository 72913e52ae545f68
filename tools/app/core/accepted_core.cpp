#include "tools/app/core/accepted_core.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <span>

#include "sim/core/traced_stepper.h"
#include "sim/trace/step_program.h"
#include "sim/trace/step_text.h"
#include "sim/trajectory/state_hash.h"
#include "tools/app/command_line/shell_command.h"
#include "tools/files/golden_place.h"
#include "tools/files/summary_text.h"
#include "tools/files/table_text.h"
#include "tools/files/text_file.h"
#include "tools/platform/path.h"

namespace hyrax {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kCoreFormat = "hyrax-core/1";

constexpr std::string_view kHeaderNameKey = "header name: ";
constexpr std::string_view kDescriptionKey = "description: ";
constexpr std::string_view kFileKey = "file: ";
constexpr std::string_view kOutsideKey = "outside the project: ";

std::string checksum_of(std::string_view text) { return hex(digest(std::as_bytes(std::span(text)))); }

struct CoreFiles {
  std::string header, step, description, accepted;
};

CoreFiles files_in(const std::string& golden_folder, const std::string& header_name) {
  const std::string folder = accepted_core_folder(golden_folder) + "/";
  return {folder + (header_name.empty() ? "physics.h" : header_name), folder + "step.txt",
          folder + "description.json", folder + "accepted.txt"};
}

std::string kept_path(const std::string& golden_folder, const AcceptedFile& file) {
  return accepted_core_folder(golden_folder) + "/files/" + file.path;
}

std::string constants_text(const std::string& core) {
  std::string text;
  for (const HeaderConstant& constant : header_constants(core))
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", constant.name, constant.value);
  return text;
}

// accepted.txt: a line a key, the checksum of all lines before it last.
std::string accepted_text(const AcceptedCore& core) {
  std::string text = fmt::format("{}\nclass: {}\nconstants: {}\nheader: {}\n", kCoreFormat, core.model,
                                 constants_text(core.text()), checksum_of(core.header));
  if (!core.header_name.empty())
    text += fmt::format("{}{}\n{}{}\n", kHeaderNameKey, core.header_name, kDescriptionKey,
                        checksum_of(core.description));
  for (const AcceptedFile& file : core.files)
    text += fmt::format("{}{} {}\n", file.is_of_project ? kFileKey : kOutsideKey, file.checksum, file.path);
  text += core.step.empty() ? fmt::format("step: not complete: {}\n", core.why_incomplete)
                            : fmt::format("step: {}\n", checksum_of(core.step));
  if (!core.agreeing_cores.empty())
    text += fmt::format("agreeing: {}\n", fmt::join(core.agreeing_cores, " "));
  text += fmt::format("reason: {}\n", core.reason);
  return text + fmt::format("checksum: {}\n", checksum_of(text));
}

std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    words.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return words;
}

[[noreturn]] void refuse_core(const std::string& path, const std::string& fault) {
  throw Failure(ExitCode::disagreed, path + ": " + fault + "; take the folder from version control");
}

}  // namespace

bool AcceptedFile::operator==(const AcceptedFile& other) const {
  return checksum == other.checksum && is_of_project == other.is_of_project &&
         (is_of_project ? path == other.path : fs::path(path).filename() == fs::path(other.path).filename());
}

std::string AcceptedCore::text() const {
  std::string text = header;
  for (const AcceptedFile& file : files) text += "\n" + file.text;
  return text;
}

bool AcceptedCore::has_same_files(const AcceptedCore& other) const {
  return header == other.header &&
         (files.empty() || other.files.empty() || std::ranges::is_permutation(files, other.files));
}

bool AcceptedCore::covers(const std::string& core_name) const {
  return core_name == name() || std::ranges::find(agreeing_cores, core_name) != agreeing_cores.end();
}

AcceptedCore program_core(const Core& core) { return core_of(core.name, core.record); }

AcceptedCore core_of(std::string_view model, const CoreRecord& record) {
  AcceptedCore accepted{.model = std::string(model),
                        .header = std::string(record.header),
                        .step = std::string(record.step),
                        .why_incomplete = std::string(record.why_incomplete),
                        .agreeing_cores = {},
                        .reason = {}};
  for (const CoreFile& file : record.files)
    accepted.files.push_back({std::string(file.path), std::string(file.is_of_project ? file.text : ""),
                              checksum_of(file.text), file.is_of_project});
  return accepted;
}

std::shared_ptr<const StepProgram> program_step(const Core& core) {
  const std::optional<TracedStep> step = read_step(core.record.step);
  return step ? make_step_program(*step) : nullptr;
}

std::string accepted_core_folder(const std::string& golden_folder) { return golden_folder + "/core"; }

CoreCommands core_commands(const std::vector<std::string>& scenarios, const std::string& golden_option) {
  if (!scenarios.empty() && libraries_of(scenarios, golden_option).empty()) return {};
  const auto command = [&](const char* name, std::initializer_list<const char*> options) {
    std::vector<std::string> words = {name};
    for (const std::string& path : scenarios) words.push_back(as_argument(path));
    if (words.size() == 1 && options.size() == 0) words.emplace_back("scenarios");
    if (!golden_option.empty()) words.insert(words.end(), {"--golden", as_argument(golden_option)});
    words.insert(words.end(), options.begin(), options.end());
    return program_command(words);
  };
  return {command("bless", {"--core"}) + " --reason \"...\"",
          command("check", {"--core", "--unnoticed", "unnoticed"}),
          command("bless", {}) + " --reason \"...\""};
}

std::vector<HeaderChange> core_changes(const AcceptedCore& accepted, const AcceptedCore& program,
                                       const std::string& header_path) {
  std::vector<HeaderChange> changes = header_changes(accepted.header, program.header, header_path);
  if (accepted.files.empty() || program.files.empty()) return changes;
  std::map<std::string, std::array<std::string_view, 2>> texts;  // Of the project's: accepted, the program's.
  for (const AcceptedFile& file : accepted.files)
    if (file.is_of_project) texts[file.path][0] = file.text;
  for (const AcceptedFile& file : program.files)
    if (file.is_of_project)
      texts[file.path][1] = file.text;
    else if (std::ranges::find(accepted.files, file) == accepted.files.end())
      changes.push_back({HeaderChangeKind::altered, "a file outside the project", 1, {}, {}, file.path});
  for (const auto& [path, pair] : texts)
    std::ranges::move(header_changes(pair[0], pair[1], path), std::back_inserter(changes));
  return changes;
}

std::vector<Library> libraries_of(const std::vector<std::string>& arguments,
                                  const std::string& golden_option) {
  std::vector<Library> libraries;
  for (const std::string& argument : arguments) {
    const bool is_library = is_folder(argument) && !golden_option.empty();
    const std::string path = is_folder(argument) ? argument + "/x.json" : argument;
    std::string scenarios = scenarios_folder_of(path);
    if (scenarios.empty() && is_library) scenarios = argument;
    if (scenarios.empty()) continue;
    const auto is_known = [&](const Library& library) { return library.scenarios_folder == scenarios; };
    if (std::ranges::any_of(libraries, is_known)) continue;
    libraries.push_back({scenarios, golden_folder_of(path, golden_option)});
  }
  return libraries;
}

std::optional<AcceptedCore> read_accepted_core(const std::string& golden_folder) {
  AcceptedCore core;
  CoreFiles files = files_in(golden_folder, "");
  if (!is_there(files.accepted)) {
    for (const std::string& path : {files.header, files.step, files.description})
      if (is_there(path)) refuse_core(files.accepted, "is missing, but " + path + " exists: half written");
    return std::nullopt;
  }
  if (is_device_or_pipe(files.accepted)) refuse_core(files.accepted, "is a pipe or a device");
  const std::string accepted = read_text_file(files.accepted);
  core.header_name = line_value(accepted, kHeaderNameKey);
  if (core.header_name.find('/') != std::string::npos)
    refuse_core(files.accepted, "was changed after it was written");
  files = files_in(golden_folder, core.header_name);
  for (const std::string& path : {files.header, files.step, files.description})
    if (is_device_or_pipe(path)) refuse_core(path, "is a pipe or a device");
  if (accepted.find("\r\n") != std::string::npos)
    refuse_core(files.accepted, std::string(kConvertedLineEnds));
  core.model = line_value(accepted, "class: ");
  core.agreeing_cores = words_of(line_value(accepted, "agreeing: "));
  core.reason = line_value(accepted, "reason: ");
  const std::string step_line = line_value(accepted, "step: ");
  constexpr std::string_view kNotComplete = "not complete: ";
  const bool has_step = !step_line.starts_with(kNotComplete);
  if (!has_step) core.why_incomplete = step_line.substr(kNotComplete.size());
  if (!accepted.starts_with(fmt::format("{}\n", kCoreFormat)))
    refuse_core(files.accepted, fmt::format("must begin with {}", kCoreFormat));
  if (!is_there(files.header)) refuse_core(files.header, "is missing");
  core.header = read_text_file(files.header);
  if (checksum_of(core.header) != line_value(accepted, "header: "))
    refuse_core(files.header, "does not have the checksum in accepted.txt");
  if (!core.header_name.empty()) {
    if (!is_there(files.description)) refuse_core(files.description, "is missing");
    core.description = read_text_file(files.description);
    if (checksum_of(core.description) != line_value(accepted, kDescriptionKey))
      refuse_core(files.description, "does not have the checksum in accepted.txt");
  }
  for (std::size_t begin = accepted.find('\n'); begin != std::string::npos;) {
    const std::size_t end = accepted.find('\n', ++begin);
    const std::string_view line = std::string_view(accepted).substr(begin, end - begin);
    begin = end;
    const bool is_of_project = line.starts_with(kFileKey);
    if (!is_of_project && !line.starts_with(kOutsideKey)) continue;
    const std::string_view listed = line.substr((is_of_project ? kFileKey : kOutsideKey).size());
    const std::size_t gap = std::min(listed.find(' '), listed.size() - 1);
    AcceptedFile file{std::string(listed.substr(gap + 1)), "", std::string(listed.substr(0, gap)),
                      is_of_project};
    const std::string path = kept_path(golden_folder, file);
    if (is_of_project) {
      if (!is_there(path)) refuse_core(path, "is missing");
      if (is_device_or_pipe(path)) refuse_core(path, "is a pipe or a device");
      file.text = read_text_file(path);
      if (checksum_of(file.text) != file.checksum)
        refuse_core(path, "does not have the checksum in accepted.txt");
    }
    core.files.push_back(std::move(file));
  }
  if (has_step != is_there(files.step))
    refuse_core(files.step, has_step ? "is missing" : "is not in accepted.txt");
  if (has_step) core.step = read_text_file(files.step);
  if (has_step && checksum_of(core.step) != step_line)
    refuse_core(files.step, "does not have the checksum in accepted.txt");
  if (has_step && !read_step(core.step)) refuse_core(files.step, "is not the canonical text of a step");
  if (accepted_text(core) != accepted) refuse_core(files.accepted, "was changed after it was written");
  return core;
}

std::optional<AcceptedCore> CoreFinding::read_accepted() try {
  std::optional<AcceptedCore> accepted = read_accepted_core(golden_folder);
  if (accepted) return accepted;
  why = "no accepted core in " + accepted_core_folder(golden_folder);
  std::error_code error;
  const bool has_goldens =
      std::ranges::any_of(std::filesystem::directory_iterator(golden_folder, error),
                          [](const auto& entry) { return entry.path().filename() != "core"; });
  const std::string& command = has_goldens ? commands.accept : commands.bless_all;
  if (!command.empty()) why += "; to accept this program's: " + command;
  return std::nullopt;
} catch (const Failure& failure) {
  take(failure);
  return std::nullopt;
}

void CoreFinding::take(const Failure& failure) {
  status = CoreStatus::none;
  why = failure.what();
  exit_code = failure.exit_code();
  if (exit_code == ExitCode::disagreed && !commands.accept.empty())
    why += ", or accept this program's core: " + commands.accept;
}

Json::Object CoreFinding::json(std::int64_t paths_taken, const std::vector<HeaderChange>& changes) const {
  return {{"golden", golden_folder},
          {"status", kCoreStatusNames[static_cast<std::size_t>(status)]},
          {"why", why.empty() ? Json() : Json(why)},
          {"paths", or_null(paths)},
          {"paths_taken", paths_taken},
          {"changes", json_of(changes_table(changes))}};
}

std::optional<Core> playable_step(const TracedStep& step, const Core& program) {
  std::optional<Core> core = traced_core(step);
  if (!core) return core;
  core->paper_match = match_paper(step);
  core->constant_names = program.constant_names;
  return core;
}

std::optional<AcceptedCore> undamaged_core(const std::string& golden_folder) try {
  return read_accepted_core(golden_folder);
} catch (const Failure&) {
  return std::nullopt;
}

std::optional<Core> accepted_step(const std::string& golden_folder, const Core& program) {
  const std::optional<AcceptedCore> accepted = undamaged_core(golden_folder);
  const std::optional<TracedStep> step = accepted ? read_step(accepted->step) : std::nullopt;
  return step ? playable_step(*step, program) : std::nullopt;
}

void write_accepted_core(const std::string& golden_folder, const AcceptedCore& core) {
  const CoreFiles files = files_in(golden_folder, core.header_name);
  const std::optional<AcceptedCore> before = undamaged_core(golden_folder);
  std::error_code error;
  fs::create_directories(accepted_core_folder(golden_folder), error);
  write_text_file(files.header, core.header);
  if (before && before->header_name != core.header_name)
    fs::remove(files_in(golden_folder, before->header_name).header, error);
  fs::remove_all(accepted_core_folder(golden_folder) + "/files", error);
  for (const AcceptedFile& file : core.files) {
    if (!file.is_of_project) continue;
    fs::create_directories(fs::path(kept_path(golden_folder, file)).parent_path(), error);
    write_text_file(kept_path(golden_folder, file), file.text);
  }
  if (!core.header_name.empty()) write_text_file(files.description, core.description);
  if (!core.step.empty())
    write_text_file(files.step, core.step);
  else
    fs::remove(files.step, error);
  write_text_file(files.accepted, accepted_text(core));
}

}  // namespace hyrax
