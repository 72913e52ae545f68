// The figures of the study frame-rate.
#pragma once

#include <vector>

#include "sim/result/figure.h"
#include "sim/study/frame_rate/frame_rate.h"

namespace hyrax {

/// Where the drawn fling settles against the display rate, how far off many flings settle, the path of the
/// drawn one by either method.
[[nodiscard]] std::vector<Figure> frame_rate_figures(const FrameRateStudy& study);

}  // namespace hyrax
