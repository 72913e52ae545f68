// A program that moves the pet, and records it.
#include <chrono>
#include <thread>

#include "pet_core.h"
#include "tools/recorder/core_recorder.h"

int main() {
  using namespace std::chrono;
  hyrax_core pet;
  pet.gravity = 1000;
  hyrax::CoreRecorder recorder("my-fling.json", "pet", pet);
  auto last = steady_clock::now();
  for (int frame = 0; frame < 60; ++frame) {
    std::this_thread::sleep_for(milliseconds(5));
    if (frame == 20) pet.p.vx = 1200.5, pet.p.pose = pose_kind::sit;
    if (frame == 25) pet.p.set_spin(-7.25);
    const auto now = steady_clock::now();
    const double dt_s = duration<double>(now - std::exchange(last, now)).count();
    if (frame >= 30 && frame < 40)
      recorder.hold(pet, dt_s);
    else
      recorder.step(pet, dt_s);
  }
}
