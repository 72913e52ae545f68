// Preloaded, it refuses every thread after the first HYRAX_THREADS ones, as a limit on processes does.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <pthread.h>
#include <stdlib.h>

typedef int (*Create)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*start)(void*), void* argument) {
  static int made = 0;
  const char* const allowed = getenv("HYRAX_THREADS");
  if (allowed != NULL && made++ >= atoi(allowed)) return EAGAIN;
  union {
    void* symbol;
    Create create;
  } real = {dlsym(RTLD_NEXT, "pthread_create")};
  return real.create(thread, attributes, start, argument);
}
