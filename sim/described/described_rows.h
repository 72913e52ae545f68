// Rows of a run, kept.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/compare/equal_times.h"
#include "sim/described/described_run.h"

namespace hyrax {

struct KeptRow {
  std::int64_t step = 0;
  double t_s = 0.0;
  double dt_s = 0.0;
  std::vector<Word> state = {};
  std::vector<std::uint8_t> contacts = {};
};

/// One after another, all of one core.
struct DescribedRows {
  std::vector<std::int64_t> step = {};
  std::vector<double> t_s = {};
  std::vector<double> dt_s = {};
  std::vector<Word> state = {};             ///< Row after row, as many values each.
  std::vector<std::uint8_t> contacts = {};  ///< As `state`.

  [[nodiscard]] std::size_t size() const { return step.size(); }
  /// REQUIRES: index < size().
  [[nodiscard]] KeptRow row(std::size_t index) const {
    const auto part = [&](const auto& values) {
      const std::size_t width = values.size() / size();
      const auto begin = values.begin() + static_cast<std::ptrdiff_t>(index * width);
      return std::vector(begin, begin + static_cast<std::ptrdiff_t>(width));
    };
    return {step[index], t_s[index], dt_s[index], part(state), part(contacts)};
  }
  /// Its outputs are not kept.
  void append(const auto& row) {
    step.push_back(row.step);
    t_s.push_back(row.t_s);
    dt_s.push_back(row.dt_s);
    state.insert(state.end(), row.state.begin(), row.state.end());
    contacts.insert(contacts.end(), row.contacts.begin(), row.contacts.end());
  }
};

using DescribedRowBatches = BatchesOf<DescribedRows>;

}  // namespace hyrax
