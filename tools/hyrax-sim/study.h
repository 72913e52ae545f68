// The studies that `hyrax-sim study` knows: each has a file of its own, and a line in study.cpp.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/result/table.h"
#include "tools/files/json.h"

namespace hyrax {

/// What the user asked of a study.
struct StudyRequest {
  std::vector<std::string> scenarios;  ///< Paths: files, or folders of them.
  bool is_quick = false;               ///< A smaller study, in seconds.
  std::string expect_file;             ///< Verdicts that are expected; empty: none are.
  std::optional<double> within_px;     ///< A tolerance.
};

/// A picture: goes to DIR/NAME + suffix + ".svg".
struct StudyFigure {
  std::string suffix;  ///< Empty, or begins with "-".
  std::string script;  ///< gnuplot's, as draw_figure takes it.
};

/// What a study came to.
struct StudyOutcome {
  std::vector<Table> tables;    ///< The first is the CSV file, too. REQUIRES: at least one.
  std::vector<StudyFigure> figures;  ///< None where none was asked for is fine; drawing is not the study's.
  std::string verdict;               ///< At most one screen of text, its lines ended.
  std::vector<std::string> broken;   ///< What --gate fails on, one sentence each, without its full stop.
  Json::Object json;                 ///< The study's own members of the JSON document.
};

/// One study: its words in the help, what may be given to it, and how it is made.
struct StudyKind {
  std::string name;
  std::string summary;  ///< In a few words.
  bool takes_scenarios = false;
  bool takes_within = false;
  bool takes_expect = false;
  /// Shows progress on a terminal. ERRORS: Failure for scenarios that cannot be read or do not suit.
  StudyOutcome (*make)(const StudyRequest& request);
};

}  // namespace hyrax
