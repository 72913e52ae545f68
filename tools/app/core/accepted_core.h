// The accepted core: golden/core/, the core with which a library was last accepted.
//
// The header, byte for byte, as physics.h, or by its own name that of a core which describes itself, with its
// description; files/, the project's files that it includes; step.txt, its step in canonical
// text, if that is complete; and accepted.txt, written last, with the checksums of all. Nothing of it is
// compiled.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/cause/header_change.h"
#include "sim/core/core.h"
#include "sim/core/core_record.h"
#include "sim/trace/step_player.h"
#include "tools/files/failure.h"
#include "tools/files/json.h"

namespace hyrax {

struct AcceptedFile {
  std::string path;
  std::string text;  ///< Empty of one that is not of the project.
  std::string checksum;
  bool is_of_project = false;

  /// Outside the project the folder may be another: machines differ in where they keep their files.
  bool operator==(const AcceptedFile& other) const;
};

struct AcceptedCore {
  std::string model;  ///< The class: the name of its physics model.
  /// Of a core that describes itself: the file's own name, and the text of description.json; else empty.
  std::string header_name = {};
  std::string description = {};
  std::string header;          ///< Its bytes.
  std::string step;            ///< Canonical text (sim/trace/step_text.h); empty: not complete.
  std::string why_incomplete;  ///< As "more than 4,096 paths".
  /// Other cores that golden files name which agreed when this one was accepted.
  std::vector<std::string> agreeing_cores;
  std::string reason;  ///< One line.
  /// That the header includes (CoreRecord::files). None: accepted by a version that did not look at them.
  std::vector<AcceptedFile> files = {};

  /// Refers to this.
  [[nodiscard]] CoreRecord record() const {
    return {.header = header,
            .step = step,
            .why_incomplete = why_incomplete,
            .is_named_by_header = !header_name.empty()};
  }
  /// The header and the project's files that it includes.
  [[nodiscard]] std::string text() const;
  /// Whether all bytes are those of another one, as far as both list files.
  [[nodiscard]] bool has_same_files(const AcceptedCore& other) const;
  /// What files call it.
  [[nodiscard]] std::string name() const { return record().checksum(); }
  /// Whether a golden file of that core agreed with this one.
  [[nodiscard]] bool covers(const std::string& core_name) const;
};

/// This program's core, without a reason.
[[nodiscard]] AcceptedCore program_core(const Core& core);
[[nodiscard]] AcceptedCore core_of(std::string_view model, const CoreRecord& record);

/// What the program's core changes of the accepted one, in the words of its header and, as far as both list
/// them, of the files that it includes. @param header_path names the header.
[[nodiscard]] std::vector<HeaderChange> core_changes(const AcceptedCore& accepted,
                                                     const AcceptedCore& program,
                                                     const std::string& header_path);

/// This program's step, ready to be played; null if it is not complete.
[[nodiscard]] std::shared_ptr<const StepProgram> program_step(const Core& core);

/// A library: a folder of scenarios, and its golden folder.
struct Library {
  std::string scenarios_folder;
  std::string golden_folder;
};

/// The libraries that scenarios or folders of them belong to, each once: the nearest folder named
/// `scenarios`; with --golden also a folder that is in none. Scenarios outside of any have no accepted core.
[[nodiscard]] std::vector<Library> libraries_of(const std::vector<std::string>& arguments,
                                                const std::string& golden_option);

/// FOLDER/core.
[[nodiscard]] std::string accepted_core_folder(const std::string& golden_folder);

/// What to do about the core of a library.
struct CoreCommands {
  std::string accept;           ///< Accepts this program's.
  std::string write_unnoticed;  ///< Writes scenarios that show what no scenario of the library does.
  std::string bless_all;        ///< Accepts it with all scenarios, of which none is blessed yet.
};
/// None for scenarios in no library.
/// @param scenarios files and folders as given; none: the folder `scenarios`.
/// @param golden_option as given; empty if it was not.
[[nodiscard]] CoreCommands core_commands(const std::vector<std::string>& scenarios,
                                         const std::string& golden_option);

/// Nothing if FOLDER/core does not exist or is empty.
/// ERRORS: Failure(disagreed) "FILE: ...; take the folder from version control" where it is damaged, half
/// written or edited by hand; Failure(cannot_access) where a file cannot be read.
[[nodiscard]] std::optional<AcceptedCore> read_accepted_core(const std::string& golden_folder);

enum class CoreStatus : std::uint8_t {
  none,          ///< No accepted core, or a damaged one.
  accepted,      ///< The same header and step.
  proved_equal,  ///< Another header, the same step: the same bits for every state, dt and size.
  changed,       ///< Steps of other bits are known.
  not_proved
};
inline constexpr std::array<std::string_view, 5> kCoreStatusNames = {"none", "accepted", "proved_equal",
                                                                     "changed", "not_proved"};

/// A program's core against the accepted one of a golden folder.
struct CoreFinding {
  std::string golden_folder;
  CoreStatus status = CoreStatus::none;
  std::string why;                    ///< Of none and not_proved; why steps are not compared.
  std::string header_path;            ///< CoreRecord::path.
  std::optional<std::int64_t> paths;  ///< Of the step; nothing where the program's is not complete.
  CoreCommands commands;              ///< Empty ones are left out.
  ExitCode exit_code = ExitCode::agreed;

  /// The accepted core; that it is missing or damaged becomes part of this.
  [[nodiscard]] std::optional<AcceptedCore> read_accepted();
  void take(const Failure& failure);
  /// Where nothing else is judged.
  [[nodiscard]] ExitCode exit_code_alone() const {
    return status == CoreStatus::none && exit_code == ExitCode::agreed ? ExitCode::golden_missing : exit_code;
  }
  /// {"golden", "status", "why", "paths", "paths_taken", "changes"}
  [[nodiscard]] Json::Object json(std::int64_t paths_taken, const std::vector<HeaderChange>& changes) const;
};

/// Plays the step, with parameters by the names of the program's core; nothing if it cannot be played.
[[nodiscard]] std::optional<Core> playable_step(const TracedStep& step, const Core& program);
/// The accepted core; nothing, too, where it is damaged: `check` reports that, and `bless` replaces it.
[[nodiscard]] std::optional<AcceptedCore> undamaged_core(const std::string& golden_folder);
/// Plays the accepted step; nothing if there is none that can be played.
[[nodiscard]] std::optional<Core> accepted_step(const std::string& golden_folder, const Core& program);

/// Replaces it. A killed program leaves the old one, or one that read_accepted_core calls half written.
/// ERRORS: Failure(cannot_access).
void write_accepted_core(const std::string& golden_folder, const AcceptedCore& core);

}  // namespace hyrax
