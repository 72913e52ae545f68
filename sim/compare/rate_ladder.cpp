#include "sim/compare/rate_ladder.h"

namespace hyrax {

double RateLadder::gain() const {
  if (doubling_px.back() == 0.0) return HUGE_VAL;
  const double middle = 0.5 * static_cast<double>(doubling_px.size() - 1);
  double slope = 0.0, square = 0.0;
  for (std::size_t index = 0; index < doubling_px.size(); ++index) {
    const double place = static_cast<double>(index) - middle;
    slope += place * std::log2(doubling_px[index]);
    square += place * place;
  }
  return std::exp2(-slope / square);
}

}  // namespace hyrax
