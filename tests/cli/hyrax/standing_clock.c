// Preloaded into hyrax.exe: while the file that HYRAX_CLOCK_STANDS names exists, the clocks that Wine takes
// the performance counter from stand still.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <pthread.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

enum { clocks = 16 };
static pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
static struct {
  struct timespec shift;  // What was stood still through, so that time goes on from where it stood.
  struct timespec stands_at;
  int stands;
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
  const char* const path = getenv("HYRAX_CLOCK_STANDS");
  const int is_to_stand = path != NULL && access(path, F_OK) == 0;
  pthread_mutex_lock(&mutex);
  if (is_to_stand && !state[clock].stands) state[clock].stands_at = *now;
  if (!is_to_stand && state[clock].stands)
    state[clock].shift = difference(*now, difference(state[clock].stands_at, state[clock].shift));
  state[clock].stands = is_to_stand;
  *now = difference(is_to_stand ? state[clock].stands_at : *now, state[clock].shift);
  pthread_mutex_unlock(&mutex);
  return 0;
}
