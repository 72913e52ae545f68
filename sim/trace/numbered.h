// Expressions and comparisons by number: equal structure, equal number.
#pragma once

#include <map>
#include <vector>

#include "sim/trace/traced_step.h"

namespace hyrax {

/// Items, each once, numbered in the order in which they came.
template <class Item>
class Numbered {
 public:
  StepIndex number_of(const Item& item) {
    const auto [place, is_new] = numbers_.try_emplace(item, static_cast<StepIndex>(items_.size()));
    if (is_new) items_.push_back(item);
    return place->second;
  }
  [[nodiscard]] const std::vector<Item>& items() const { return items_; }

 private:
  std::map<Item, StepIndex> numbers_;
  std::vector<Item> items_;
};

/// Numbers that several steps share.
class SharedNumbers {
 public:
  struct OfStep {
    std::vector<StepIndex> expressions;
    std::vector<StepIndex> comparisons;
  };
  /// By the step's own numbers. REQUIRES: operands in order.
  [[nodiscard]] OfStep of(const TracedStep& step) {
    OfStep numbers;
    for (const Expression& expression : step.expressions)
      numbers.expressions.push_back(expressions_.number_of(with_operands(expression, numbers.expressions)));
    for (const StepComparison& comparison : step.comparisons)
      numbers.comparisons.push_back(comparisons_.number_of(with_sides(comparison, numbers.expressions)));
    return numbers;
  }

 private:
  Numbered<Expression> expressions_;
  Numbered<StepComparison> comparisons_;
};

}  // namespace hyrax
