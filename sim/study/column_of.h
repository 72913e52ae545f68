// A column made of one quantity of many records.
#pragma once

#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "sim/study/table.h"

namespace hyrax {

/// `get(record)` is the value of a row; Value is double, std::int64_t or std::string.
template <class Value, class Records, class Get>
StudyColumn column_of(const std::string& name, const std::string& unit, const std::string& long_name,
                      const Records& records, const Get& get) {
  std::vector<Value> values;
  values.reserve(std::size(records));
  for (const auto& record : records) values.push_back(get(record));
  return {name, unit, long_name, std::move(values)};
}

}  // namespace hyrax
