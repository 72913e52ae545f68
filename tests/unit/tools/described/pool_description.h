// The description of a core that nobody compiles: a value of each kind.
#pragma once

#include "sim/described/description.h"

namespace hyrax {

template <class T>
ValueInfo value_info(std::string name, T initial, std::optional<std::array<T, 2>> limits = {},
                     std::vector<std::string> names = {}) {
  ValueInfo value{.name = std::move(name), .type = value_type<T>(), .unit = {}, .initial = word_of(initial)};
  value.unit = unit_of(value.name);
  if (limits) value.limits = {word_of((*limits)[0]), word_of((*limits)[1])};
  value.names = std::move(names);
  return value;
}

inline Description pool_description() {
  Description pool;
  pool.core = "pool";
  pool.state.values = {value_info("a.x_px", 10.0),
                       value_info("a.y_px", 20.0),
                       value_info("a.spin_rad_per_s", 0.1F),
                       value_info<std::int32_t>("mood", 0, {}, {"calm", "wild"}),
                       value_info<std::int32_t>("pocketed", 0),
                       value_info<std::uint8_t>("lives", 3),
                       value_info<std::int64_t>("debt", -1),
                       value_info<std::uint64_t>("ticks", 0),
                       value_info("hot", false),
                       value_info<double>("heat", 0.0, {{0.0, 100.0}}),
                       value_info<std::int16_t>("level", 1, {{1, 5}})};
  pool.inputs.values = {value_info<double>("width_px", 800.0, {{320.0, 4096.0}}), value_info("push", false)};
  pool.parameters.values = {value_info("gravity_px_per_s2", 980.0)};
  pool.outputs.values = {value_info("energy_px2_per_s2", 0.0)};
  pool.actions = {{"strike", {value_info("vx_px_per_s", 0.0), value_info("vy_px_per_s", 0.0)}},
                  {"rack", {}},
                  {"tint", {value_info<std::uint8_t>("shade", 0)}}};
  pool.contacts = {"rail", "pocket"};
  pool.properties = {{"balls do not overlap", true}, {"a ball falls", false}};
  return pool;
}

}  // namespace hyrax
