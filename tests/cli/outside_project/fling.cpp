// Plays scenarios/flings/first-fling.json by hand and compares two of its rows with known bits.
#include <cstdio>

#include "sim/physics/physics.h"
#include "sim/physics/strict_arithmetic.h"

namespace {

struct KnownRow {
  int step;
  double x, y, vx, vy;
};

// From tests/oracle/replay.py: a row of the first arc, and one after the
// right wall and bounces of the ground.
constexpr KnownRow kKnownRows[] = {
    {60, 0x1.0185d6c710a8ap+10, 0x1.77e86ff360370p+7, 0x1.d6de3dd72ce4ep+9, -0x1.acf019bf71cccp+6},
    {300, 0x1.517c140521fe6p+9, 0x1.db0854893b7b0p+9, -0x1.234202dfc9580p+7, -0x1.803044ff45f49p+5},
};

bool agrees(const physics& body, const KnownRow& row) {
  const bool is_same = body.x() == row.x && body.y() == row.y && body.vx() == row.vx && body.vy() == row.vy;
  std::printf("step %d: %s (x %a, y %a, vx %a, vy %a)\n", row.step, is_same ? "agrees" : "differs", body.x(),
              body.y(), body.vx(), body.vy());
  return is_same;
}

bool fling_agrees() {
  physics body(60.0, 900.0, 1000.0, -1350.0);
  bool all_agree = true;
  int step = 0;
  for (const KnownRow& row : kKnownRows) {
    for (; step < row.step; ++step) body.update(1.0 / 60.0, 1920, 1080, 128, 128);
    all_agree = agrees(body, row) && all_agree;
  }
  return all_agree;
}

}  // namespace

int main() {
#ifdef __FMA__
  std::puts("can fuse");
#endif
  if (const auto fault = hyrax::arithmetic_fault()) {
    std::printf("%.*s\n", static_cast<int>(fault->size()), fault->data());
    return 5;
  }
  return fling_agrees() ? 0 : 1;
}
