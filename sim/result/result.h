// What a study or a measurement found, before anybody prints it.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "sim/result/figure.h"
#include "sim/result/table.h"

namespace hyrax {

struct Verdict {
  /// What was found, in one sentence of at most 80 letters; empty: in the text.
  std::string answer = {};
  /// At most one screen: sentences, each a line or more without the last line's end, and tables.
  std::vector<std::variant<std::string, Table>> text = {};
  /// What does not hold, one sentence each without its full stop. Empty: all rules hold.
  std::vector<std::string> broken = {};
  /// The one line of --quiet where all rules hold.
  std::string brief = "all rules hold";
};

/// The answer as a title: without its full stop.
[[nodiscard]] inline std::string headline(const Verdict& verdict) {
  return verdict.answer.substr(0, verdict.answer.find_last_not_of('.') + 1);
}

struct Result {
  std::vector<Table> tables = {};  ///< At least one of a study; the first is also the CSV file.
  std::vector<Figure> figures = {};
  Verdict verdict = {};
  std::vector<Table> summary = {};  ///< Its own members of the JSON document.
};

}  // namespace hyrax
