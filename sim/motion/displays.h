// Displays as people have them: what is tried first where any size and any rate is allowed.
#pragma once

#include <array>

#include "sim/motion/state.h"

namespace hyrax {

inline constexpr std::array<Size, 10> kDisplays = {{{1366, 768},
                                                    {1920, 1080},
                                                    {2560, 1440},
                                                    {3840, 2160},
                                                    {5120, 1440},
                                                    {1280, 720},
                                                    {3440, 1440},
                                                    {640, 480},
                                                    {320, 240},
                                                    {150, 140}}};
inline constexpr std::array kDisplayRates_hz = {24.0,  30.0,  50.0,  60.0,  75.0, 90.0,
                                                100.0, 120.0, 144.0, 165.0, 240.0};

}  // namespace hyrax
