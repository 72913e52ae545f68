// How studies show what they found: tables of records, medians and shares with their intervals.
#pragma once

#include <string>

#include <fmt/format.h>

#include "sim/result/estimate.h"
#include "sim/result/table.h"

namespace hyrax {

/// A table with a row for each record, made column by column. Refers to the records.
template <class Records>
class StudyTable {
 public:
  StudyTable(const std::string& name, const std::string& long_name, const Records& records)
      : table_{name, long_name, {}}, records_(records) {}

  /// See column_of.
  template <class Get>
  StudyTable& add(const std::string& name, const std::string& unit, const std::string& long_name,
                  const Get& get, int digits = 4) {
    table_.columns.push_back(column_of(name, unit, long_name, records_, get, digits));
    return *this;
  }
  /// Columns of the median, low and high of a Band. @param median the first column's name.
  template <class Get>
  StudyTable& add_band(const std::string& name, const std::string& unit, const std::string& what,
                       const Get& get, const std::string& median) {
    const auto part = [&get](double Band::*each) {
      return [&get, each](const auto& record) { return std::invoke(get, record).*each; };
    };
    return add(median, unit, what + ", median", part(&Band::median))
        .add(name + "_low", unit, what + ", 10 %", part(&Band::low))
        .add(name + "_high", unit, what + ", 90 %", part(&Band::high));
  }

  /// Column::key of the last column.
  StudyTable& key(const std::string& key) {
    table_.columns.back().key = key;
    return *this;
  }

  operator Table() const { return table_; }  // NOLINT(google-explicit-constructor): a table is what it is.

 private:
  Table table_;
  const Records& records_;
};

/// "35 (10 .. 80)".
[[nodiscard]] inline std::string interval_text(double value, double low, double high, int decimals = 0) {
  return fmt::format("{:.{}f} ({:.{}f} .. {:.{}f})", value, decimals, low, decimals, high, decimals);
}
[[nodiscard]] inline std::string interval_text(const Band& band, int decimals = 0) {
  return interval_text(band.median, band.low, band.high, decimals);
}

/// "118 of 121 flings (93 .. 99 %)".
[[nodiscard]] inline std::string share_text(const Share& share, const std::string& nouns) {
  return fmt::format("{} of {} {} ({:.0f} .. {:.0f} %)", share.count, share.of, nouns, 100.0 * share.low(),
                     100.0 * share.high());
}

}  // namespace hyrax
