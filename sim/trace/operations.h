// What an operation of a traced step does to values of its kind.
#pragma once

#include "sim/trace/traced_step.h"

namespace hyrax {

/// Values of every kind are doubles: a `float` and an `int` are exact in one. As the program that a build
/// makes of the header, with what C++ leaves undefined defined: an int wraps around, its quotient by 0 is 0,
/// and what fits no int becomes the least, as on x86. Null: a function
/// that is not known.
using OperationFunction = double (*)(double, double, double);
[[nodiscard]] OperationFunction operation_of(const Expression& expression);

[[nodiscard]] inline bool holds(Relation relation, double left, double right) {
  return relation == Relation::less            ? left < right
         : relation == Relation::less_or_equal ? left <= right
                                               : left == right;
}

}  // namespace hyrax
