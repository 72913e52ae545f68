// Section 3.2.2: the rest threshold.
#include "sim/study/paper/claim_probe.h"

namespace hyrax {
namespace {

// Whether drops from many heights all end with no vertical speed: two rows, since a cycle passes 0 in every
// other.
bool ends_at_rest(double rate_hz) {
  constexpr int kDrops = 12;
  for (int drop = 0; drop < kDrops; ++drop) {
    const State body = thrown({900.0, 952.0 * drop / kDrops, 0.0, 0.0}, rate_hz, 12.0);
    const State next = core_step(body, 1.0 / rate_hz, kDesktop);
    if (body.vy_px_per_s != 0.0 || next.vy_px_per_s != 0.0) return false;
  }
  return true;
}

// The rate above which drops end at rest, by bisection.
double rest_rate_hz() {
  double low_hz = 20.0, high_hz = 1000.0;
  for (int halving = 0; halving < 20; ++halving) {
    const double middle_hz = 0.5 * (low_hz + high_hz);
    (ends_at_rest(middle_hz) ? high_hz : low_hz) = middle_hz;
  }
  return high_hz;
}

}  // namespace

std::vector<Claim> claims_on_rest() {
  Claim claim{"3.2.2-infinite-bounce",
              "the rest threshold eliminates the infinite bounce phenomenon",
              "frame rate above which drops from twelve heights end without speed",
              0.0,
              "Hz",
              ClaimVerdict::does_not_hold,
              ""};
  if (ends_at_rest(20.0) && ends_at_rest(60.0)) {
    claim.verdict = ClaimVerdict::holds;
    claim.number = 20.0;
  } else if (ends_at_rest(1000.0)) {
    claim.number = rest_rate_hz();
    claim.verdict = ClaimVerdict::holds_when;
    claim.remark =
        "when the display is faster than " + digits(claim.number) + " Hz; below, some keep a speed";
  }
  return {claim};
}

}  // namespace hyrax
