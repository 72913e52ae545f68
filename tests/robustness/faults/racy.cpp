// A control: two threads count without a lock. The thread sanitizer must find it.
#include <thread>

int main() {
  int count = 0;
  const auto work = [&] {
    for (int turn = 0; turn < 1000; ++turn) ++count;
  };
  std::jthread other(work);
  work();
  return 0;
}
