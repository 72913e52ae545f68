// How studies show what they found: tables of records, medians and shares with their intervals.
#pragma once

#include <functional>
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
  /// As printed text: without a name.
  explicit StudyTable(const Records& records) : StudyTable("", "", records) {}

  /// See column_of.
  template <class Get>
  StudyTable& add(const std::string& name, const std::string& unit, const std::string& long_name,
                  const Get& get, int digits = 4) {
    table_.columns.push_back(column_of(name, unit, long_name, records_, get, digits));
    return *this;
  }
  /// As printed text and JSON have it: without a long name.
  template <class Get>
  StudyTable& add(const std::string& name, const std::string& unit, const Get& get, int digits = 4) {
    return add(name, unit, "", get, digits);
  }
  /// Columns of the median, low and high of a Band. @param median the first column's name.
  template <class Get>
  StudyTable& add_band(const std::string& name, const std::string& unit, const std::string& what,
                       const Get& get, const std::string& median) {
    return add(median, unit, what + ", median", part(get, &Band::median))
        .add(name + "_low", unit, what + ", 10 %", part(get, &Band::low))
        .add(name + "_high", unit, what + ", 90 %", part(get, &Band::high));
  }
  /// Columns of a MedianEstimate; JSON, where `key` is given, has the median only. @param what the first
  /// column's long name.
  template <class Get>
  StudyTable& add_estimate(const std::string& name, const std::string& unit, const std::string& what,
                           const Get& get, const std::string& key = "") {
    const std::string ends_key = key.empty() ? "" : "-";
    return add(name, unit, what, part(get, &MedianEstimate::median))
        .key(key)
        .add(name + "_low", unit, "95 % interval of the median, low end", part(get, &MedianEstimate::low))
        .key(ends_key)
        .add(name + "_high", unit, "95 % interval of the median, high end", part(get, &MedianEstimate::high))
        .key(ends_key);
  }
  /// Columns of the count of a Share and of the interval of its part. @param what the first one's long name.
  template <class Get>
  StudyTable& add_share(const std::string& name, const std::string& what, const Get& get) {
    return add(name, "1", what, part(get, &Share::count))
        .add(name + "_share_low", "1", "95 % interval of their share", part(get, &Share::low))
        .add(name + "_share_high", "1", "95 % interval of their share", part(get, &Share::high));
  }

  /// Column::key of the last column.
  StudyTable& key(const std::string& key) {
    table_.columns.back().key = key;
    return *this;
  }

  operator Table() const { return table_; }  // What it makes.

 private:
  // A member of what `get` gives.
  static auto part(const auto& get, auto member) {
    return [&get, member](const auto& record) { return std::invoke(member, std::invoke(get, record)); };
  }

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
