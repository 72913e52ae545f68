#include "sim/explain/statement_text.h"

#include <fmt/format.h>

#include <array>

#include "sim/explain/cause.h"

namespace hyrax {
namespace {

std::string_view text(Component component) {
  constexpr std::string_view kNames[] = {"x", "y", "vx", "vy"};
  return kNames[static_cast<std::size_t>(component)];
}
std::string_view text(WallPlace place) {
  constexpr std::string_view kNames[] = {"0", "right", "bottom"};
  return kNames[static_cast<std::size_t>(place)];
}
std::string_view text(Relation relation) {
  constexpr std::string_view kNames[] = {"<", "<=", ">", ">="};
  return kNames[static_cast<std::size_t>(relation)];
}

std::string product_text(const Statement& s, std::string_view factor) {
  return fmt::format("{} += {} * dt", text(s.target), factor);
}

std::string scale_text(const Statement& s) {
  const std::string_view target = text(s.target);
  if (s.operation == Operation::restitution) return fmt::format("{0} = -{0} * RESTITUTION", target);
  return fmt::format("{} *= {}", target, constant_name_of(s.operation));
}

std::string stop_text(const Statement& s) {
  const std::string source(text(s.source));
  return fmt::format("if ({} {} REST_THRESHOLD) {} = 0", s.signed_source ? source : "fabs(" + source + ")",
                     text(s.relation), text(s.target));
}

}  // namespace

std::string statement_text(const Statement& s) {
  switch (s.form) {
    case Statement::Form::accelerate:
      return product_text(s, constant_name_of(s.operation));
    case Statement::Form::move:
      return product_text(s, text(s.source));
    case Statement::Form::scale:
      return scale_text(s);
    case Statement::Form::clamp:
      return fmt::format("{} = {}", text(s.target), text(s.place));
    case Statement::Form::stop:
      return stop_text(s);
    case Statement::Form::wall:
      return fmt::format("if ({} {} {})", text(s.source), text(s.relation), text(s.place));
    case Statement::Form::first_of:
      return s.operation == Operation::wall_x ? "the walls in x" : "the walls in y";
  }
  return "";
}

}  // namespace hyrax
