// What a study says of its results, before anybody prints it.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "sim/result/table.h"

namespace hyrax {

struct Verdict {
  /// At most one screen: sentences, each a line or more without the last line's end, and tables.
  std::vector<std::variant<std::string, Table>> text = {};
  /// What does not hold, one sentence each without its full stop. Empty: all rules hold.
  std::vector<std::string> broken = {};
};

}  // namespace hyrax
