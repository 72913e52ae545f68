// What the build records of a core's header.
#pragma once

#include <string_view>

namespace hyrax {

struct Core;

/// Gives a core what its recorded step tells: its shape, its contacts, and the constants of one that is not
/// named as the paper's model, or whose class has none of their names.
void complete_by_step(Core& core);

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
};

/// Of the core that a program is built with; only its `main` asks for it.
[[nodiscard]] const CoreRecord& built_core_record();

}  // namespace hyrax
