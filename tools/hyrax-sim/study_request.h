// A study's command line: a request, and the options that are the same for every study.
#pragma once

#include <string>
#include <vector>

#include "tools/hyrax-sim/command_line/options.h"
#include "tools/hyrax-sim/study.h"

namespace hyrax {

/// The words of the command line as they were given.
struct StudyArguments {
  std::vector<std::string> words;  ///< The study's name, then scenarios.
  std::string folder = ".";
  std::string expect_file;
  std::string within;
  bool is_quick = false;
  bool is_gate = false;
  bool is_json = false;
  bool draws_nothing = false;
};

/// @param study_list the names of all studies, one line each.
void declare_study(Options& options, StudyArguments& arguments, const std::string& study_list);

/// The study of that name. ERRORS: Failure(bad_input) that names those there are.
[[nodiscard]] const StudyKind& find_study(const std::vector<StudyKind>& kinds, const std::string& name);

/// ERRORS: Failure(bad_input) where something is given that the study has no use for, and for a length that
/// is none.
[[nodiscard]] StudyRequest study_request(const StudyKind& kind, const StudyArguments& arguments);

/// A length of at least 0, as "1px", "0.5 px" or "2".
/// ERRORS: Failure(bad_input) for anything else; `place` tells where it stands.
[[nodiscard]] double parse_length_px(const std::string& text, const std::string& place);

}  // namespace hyrax
