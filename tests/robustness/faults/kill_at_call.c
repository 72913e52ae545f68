// Loaded into the program, kills it at a chosen one of the calls by which it changes files: with
// HYRAX_KILL_AT=N right before the N-th, 1 being the first. With 0 the calls are only counted, and
// the count is written into the file HYRAX_CALLS names.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

static long calls;
static pid_t program;

__attribute__((constructor)) static void remember(void) { program = getpid(); }

static void count(void) {
  if (getpid() != program) return;  // A child of the program changes no files: it reads on trial.
  const char* const at = getenv("HYRAX_KILL_AT");
  if (at != NULL && atol(at) == ++calls) raise(SIGKILL);
}

__attribute__((destructor)) static void write_count(void) {
  const char* const path = getenv("HYRAX_CALLS");
  FILE* const file = path == NULL ? NULL : fopen(path, "w");
  if (file == NULL) return;
  fprintf(file, "%ld\n", calls);
  fclose(file);
}

#define PASS_ON(result, name, parameters, arguments)                        \
  result name parameters {                                                  \
    static result(*real) parameters;                                        \
    if (real == NULL) real = (result(*) parameters)dlsym(RTLD_NEXT, #name); \
    count();                                                                \
    return real arguments;                                                  \
  }

PASS_ON(ssize_t, write, (int descriptor, const void* data, size_t size), (descriptor, data, size))
PASS_ON(ssize_t, pwrite, (int descriptor, const void* data, size_t size, off_t at),
        (descriptor, data, size, at))
PASS_ON(ssize_t, pwrite64, (int descriptor, const void* data, size_t size, off64_t at),
        (descriptor, data, size, at))
PASS_ON(int, ftruncate, (int descriptor, off_t size), (descriptor, size))
PASS_ON(int, ftruncate64, (int descriptor, off64_t size), (descriptor, size))
PASS_ON(int, rename, (const char* from, const char* to), (from, to))
PASS_ON(int, unlink, (const char* path), (path))
PASS_ON(int, close, (int descriptor), (descriptor))
PASS_ON(int, fclose, (FILE * file), (file))
PASS_ON(size_t, fwrite, (const void* data, size_t size, size_t items, FILE* file), (data, size, items, file))

static mode_t mode_of(int flags, va_list list) { return flags & O_CREAT ? va_arg(list, mode_t) : 0; }

#define PASS_ON_OPEN(name)                                                            \
  int name(const char* path, int flags, ...) {                                        \
    static int (*real)(const char*, int, ...);                                        \
    if (real == NULL) real = (int (*)(const char*, int, ...))dlsym(RTLD_NEXT, #name); \
    va_list list;                                                                     \
    va_start(list, flags);                                                            \
    const mode_t mode = mode_of(flags, list);                                         \
    va_end(list);                                                                     \
    count();                                                                          \
    return real(path, flags, mode);                                                   \
  }

PASS_ON_OPEN(open)
PASS_ON_OPEN(open64)
