// What the build records of a core's header.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace hyrax {

struct Core;

/// Gives a core what its recorded step tells: how it matches the paper's, its contacts, and the constants of
/// one that is not named as the paper's model, or whose class has none of their names.
void complete_by_step(Core& core);

/// Another file of which a header consists.
struct CoreFile {
  std::string_view path = {};  ///< Below the project's folder, else whole.
  std::string_view text = {};
  bool is_of_project = false;  ///< Else a golden folder has its checksum only.
};

/// Written by tools/cmake/record_core.cmake, from the header that a program compiles.
struct CoreRecord {
  std::string_view header = {};          ///< Its bytes.
  std::string_view step = {};            ///< Its canonical text (sim/trace/step_text.h); empty: not complete.
  std::string_view why_incomplete = {};  ///< As "more than 4,096 paths"; empty: complete.
  /// The step is proved to be the paper's with the constants of its class: then steps of that may replace its
  /// own, and tell its contacts.
  bool is_listing = false;
  /// Reads the step of any other core (complete_by_step). A pointer, so that a program whose core
  /// is the paper's links nothing that reads steps.
  void (*complete)(Core& core) = nullptr;

  /// Of a core that describes itself: its step has no defaults, outputs or properties.
  bool is_named_by_header = false;

  std::string_view path = {};            ///< Of the header, as that of a file.
  std::span<const CoreFile> files = {};  ///< That it includes, in order of their paths.

  /// What files call the core: the checksum of its step, else of its header; empty if neither is known.
  [[nodiscard]] std::string checksum() const;
};

/// Of the core that a program is built with; only its `main` asks for it.
[[nodiscard]] const CoreRecord& built_core_record();

}  // namespace hyrax
