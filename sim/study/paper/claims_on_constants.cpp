// Section 5, table 1: the paper's numbers against the core's.
#include "sim/reference/model.h"
#include "sim/study/paper/claim_probe.h"

namespace hyrax {
namespace {

Claim constant(const char* id, const char* sentence, double core, double paper, const char* unit) {
  return {id,
          sentence,
          "the core's value",
          core,
          unit,
          holds_if(core == paper),
          core == paper ? "" : "the paper has " + exact_digits(paper),
          true};
}

}  // namespace

std::vector<Claim> claims_on_constants() {
  const Constants core = core_constants();
  const Model paper;  // The reference's own copy of the table.
  return {
      constant("5-gravity", "GRAVITY 1200.0", core.gravity_px_per_s2, paper.gravity_px_per_s2, "px/s2"),
      constant("5-restitution", "RESTITUTION 0.6", core.restitution, paper.restitution, "1"),
      constant("5-air-drag", "AIR_DRAG 0.999, velocity multiplier per frame", core.air_drag, paper.air_drag,
               "1"),
      constant("5-ground-friction", "GROUND_FRICTION 0.8", core.ground_friction, paper.ground_friction, "1"),
      constant("5-rest-threshold", "REST_THRESHOLD 5.0, minimum |vy| to consider at rest",
               core.rest_threshold_px_per_s, paper.rest_threshold_px_per_s, "px/s"),
  };
}

}  // namespace hyrax
