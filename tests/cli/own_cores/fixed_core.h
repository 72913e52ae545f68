// Integers: 16.16 fixed point, and counters of several types; names of one letter.
#pragma once

#include <cstdint>

struct hyrax_core {
  std::int32_t x = 10 << 16, v = 3 << 16;
  std::uint8_t ticks = 250;
  std::int16_t s = -3;
  std::uint64_t big = ~std::uint64_t{0} - 5;
  std::int64_t low = -(std::int64_t{1} << 62);
  bool up = true;

  void step(double dt_s) {
    x += static_cast<std::int32_t>((std::int64_t{v} * static_cast<std::int64_t>(dt_s * 65536.0)) >> 16);
    if (x > (12 << 16) || x < (8 << 16)) v = -v, up = !up;
    ++ticks;
    ++big;
    low += ticks;
    if (++s == 5) s = -5;
  }
  void state(auto&& see) {
    see("x", x);
    see("v", v);
    see("ticks", ticks);
    see("s", s, {-5, 5});
    see("big", big);
    see("low", low);
    see("up", up);
  }
};
