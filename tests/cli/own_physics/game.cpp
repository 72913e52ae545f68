// A program that moves the box, and records it.
#include <chrono>
#include <thread>

#include "elastic_box.h"
#include "tools/recorder/physics_recorder.h"

int main() {
  using namespace std::chrono;
  physics box(100, 100, 900, -7000);  // It meets the top, however short its frames are.
  hyrax::PhysicsRecorder recorder("my-fling.json", box, {640, 480}, {64, 64});
  int width = 640;
  auto last = steady_clock::now();
  for (int frame = 0; frame < 60; ++frame) {
    std::this_thread::sleep_for(milliseconds(5));
    if (frame == 20) box.setVelocity(-1200.5, 300);
    if (frame >= 30 && frame < 40) box.setPos(300 + frame, 200.25);
    if (frame == 50) width = 320;
    const auto now = steady_clock::now();
    const double dt_s = duration<double>(now - std::exchange(last, now)).count();
    if (frame >= 30 && frame < 40)
      recorder.hold(box, dt_s, width, 480, 64, 64);
    else
      recorder.update(box, dt_s, width, 480, 64, 64);
  }
}
