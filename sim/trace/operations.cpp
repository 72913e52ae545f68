#include "sim/trace/step_program.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>

namespace hyrax {
namespace {

// The function objects have no state.
template <class Function>
double in_real(double a, double b, double c) {
  return Function()(a, b, c);
}
template <class Function>
double in_single(double a, double b, double c) {
  return static_cast<double>(Function()(static_cast<float>(a), static_cast<float>(b), static_cast<float>(c)));
}

template <class Function>
OperationFunction of_kind(Function /*unused*/, NumberKind kind) {
  return kind == NumberKind::real ? in_real<Function> : in_single<Function>;
}

OperationFunction call_of(const Expression& call) {
  const auto is_of = [&](std::string_view name, std::size_t operands) {
    return call.name == name && call.used_operands().size() == operands;
  };
  if (call.kind == NumberKind::whole) return nullptr;
    // A function of <cmath> and its name in one word.
#define HYRAX_ONE(name, is_fixed) \
  if (is_of(#name, 1)) return of_kind([](auto a, auto, auto) { return std::name(a); }, call.kind);
#define HYRAX_TWO(name, is_fixed) \
  if (is_of(#name, 2)) return of_kind([](auto a, auto b, auto) { return std::name(a, b); }, call.kind);
  HYRAX_TRACE_FUNCTIONS(HYRAX_ONE, HYRAX_TWO)
#undef HYRAX_ONE
#undef HYRAX_TWO
  if (!is_of("fma", 3)) return nullptr;
  return of_kind([](auto a, auto b, auto c) { return std::fma(a, b, c); }, call.kind);
}

// The int with the value's last 32 bits.
double wrapped(std::int64_t value) {
  return static_cast<double>(static_cast<std::int32_t>(static_cast<std::uint32_t>(value)));
}
std::int64_t whole(double value) { return static_cast<std::int64_t>(value); }

double to_whole(double value) {
  const bool fits = value > -2147483649.0 && value < 2147483648.0;
  return fits ? std::trunc(value) + 0.0 : static_cast<double>(std::numeric_limits<std::int32_t>::min());
}

OperationFunction whole_operation(Operator op) {
  switch (op) {
    case Operator::negate:
      return [](double a, double, double) { return wrapped(-whole(a)); };
    case Operator::add:
      return [](double a, double b, double) { return wrapped(whole(a) + whole(b)); };
    case Operator::multiply:
      return [](double a, double b, double) { return wrapped(whole(a) * whole(b)); };
    case Operator::divide:
      return [](double a, double b, double) { return b == 0.0 ? 0.0 : wrapped(whole(a) / whole(b)); };
    case Operator::remainder:
      return [](double a, double b, double) { return b == 0.0 ? 0.0 : wrapped(whole(a) % whole(b)); };
    default:
      return nullptr;
  }
}

}  // namespace

OperationFunction operation_of(const Expression& expression) {
  switch (expression.op) {
    case Operator::call:
      return call_of(expression);
    case Operator::to_real:
      return [](double a, double, double) { return a; };
    case Operator::to_single:
      return [](double a, double, double) { return static_cast<double>(static_cast<float>(a)); };
    case Operator::to_whole:
      return [](double a, double, double) { return to_whole(a); };
    default:
      break;
  }
  if (expression.kind == NumberKind::whole) return whole_operation(expression.op);
  switch (expression.op) {
    case Operator::negate:
      return of_kind([](auto a, auto, auto) { return -a; }, expression.kind);
    case Operator::add:
      return of_kind([](auto a, auto b, auto) { return a + b; }, expression.kind);
    case Operator::multiply:
      return of_kind([](auto a, auto b, auto) { return a * b; }, expression.kind);
    case Operator::divide:
      return of_kind([](auto a, auto b, auto) { return a / b; }, expression.kind);
    default:
      return nullptr;
  }
}

}  // namespace hyrax
