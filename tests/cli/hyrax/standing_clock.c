// Preloaded into hyrax.exe: while the file named by HYRAX_CLOCK_STOPS exists, the clocks behind Wine's
// performance counter are stopped.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <pthread.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

enum { clocks = 16 };
static pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
static struct {
  struct timespec shift;  // Total stopped time, so that the clock continues where it stopped.
  struct timespec stopped_at;
  int is_stopped;
} state[clocks];

static struct timespec difference(struct timespec a, struct timespec b) {
  struct timespec result = {a.tv_sec - b.tv_sec, a.tv_nsec - b.tv_nsec};
  if (result.tv_nsec < 0) {
    result.tv_nsec += 1000000000;
    --result.tv_sec;
  }
  return result;
}

int clock_gettime(clockid_t clock, struct timespec* now) {
  static int (*real)(clockid_t, struct timespec*);
  if (real == NULL) real = (int (*)(clockid_t, struct timespec*))dlsym(RTLD_NEXT, "clock_gettime");
  const int result = real(clock, now);
  if (result != 0 || clock == CLOCK_REALTIME || clock < 0 || clock >= clocks) return result;
  const char* const path = getenv("HYRAX_CLOCK_STOPS");
  const int must_stop = path != NULL && access(path, F_OK) == 0;
  pthread_mutex_lock(&mutex);
  if (must_stop && !state[clock].is_stopped) state[clock].stopped_at = *now;
  if (!must_stop && state[clock].is_stopped)
    state[clock].shift = difference(*now, difference(state[clock].stopped_at, state[clock].shift));
  state[clock].is_stopped = must_stop;
  *now = difference(must_stop ? state[clock].stopped_at : *now, state[clock].shift);
  pthread_mutex_unlock(&mutex);
  return 0;
}
