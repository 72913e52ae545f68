// Pictures of one fling at many displays.
#pragma once

#include <string>

#include "sim/study/frame_rate/frame_rate.h"

namespace hyrax {

/// Resting place of the drawn fling against the rate, by each method, with jitter and missed frames as dots.
[[nodiscard]] std::string resting_places_script(const FrameRateStudy& study);
/// Its paths at some rates, by one method (number in kFrameRateMethods).
[[nodiscard]] std::string fan_script(const FrameRateStudy& study, std::size_t method);

}  // namespace hyrax
