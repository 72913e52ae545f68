// The accepted core: golden/core/, the core with which a library was last accepted.
//
// Three files: the header, byte for byte; step.txt, its step in canonical text, if that is complete; and
// accepted.txt, written last, with the checksums of both. Nothing of it is compiled.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/core/core.h"
#include "sim/core/core_record.h"
#include "sim/trace/step_player.h"

namespace hyrax {

struct AcceptedCore {
  std::string model;           ///< The class: the name of its physics model.
  std::string header;          ///< Its bytes.
  std::string step;            ///< Canonical text (sim/trace/step_text.h); empty: not complete.
  std::string why_incomplete;  ///< As "more than 4,096 paths".
  /// Other cores that golden files name which agreed when this one was accepted.
  std::vector<std::string> agreeing_cores;
  std::string reason;  ///< One line.

  /// Refers to this.
  [[nodiscard]] CoreRecord record() const { return {header, step, why_incomplete}; }
  /// What golden files call it: the checksum of its step, else of its header.
  [[nodiscard]] std::string name() const;
  /// Whether a golden file of that core agreed with this one.
  [[nodiscard]] bool covers(const std::string& core_name) const;
};

/// This program's core, without a reason.
[[nodiscard]] AcceptedCore program_core(const Core& core);

/// This program's step, ready to be played; null if it is not complete.
[[nodiscard]] std::shared_ptr<const StepProgram> program_step(const Core& core);

/// FOLDER/core.
[[nodiscard]] std::string accepted_core_folder(const std::string& golden_folder);

/// What to do about the core of a library.
struct CoreCommands {
  std::string accept;           ///< Accepts this program's.
  std::string write_unnoticed;  ///< Writes scenarios that show what no scenario of the library does.
};
/// @param scenarios files and folders as given; none: the folder `scenarios`.
/// @param golden_option as given; empty if it was not.
[[nodiscard]] CoreCommands core_commands(const std::vector<std::string>& scenarios,
                                         const std::string& golden_option);

/// Nothing if FOLDER/core does not exist or is empty.
/// ERRORS: Failure(disagreed) "FILE: ...; take the folder from version control" where it is damaged, half
/// written or edited by hand; Failure(cannot_access) where a file cannot be read.
[[nodiscard]] std::optional<AcceptedCore> read_accepted_core(const std::string& golden_folder);

/// Plays its step; nothing if there is none that can be played.
[[nodiscard]] std::optional<Core> accepted_step(const std::string& golden_folder);

/// Replaces it. A killed program leaves the old one, or one that read_accepted_core calls half written.
/// ERRORS: Failure(cannot_access).
void write_accepted_core(const std::string& golden_folder, const AcceptedCore& core);

}  // namespace hyrax
