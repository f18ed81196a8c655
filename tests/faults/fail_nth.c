// Makes one call fail: LD_PRELOAD this library, with LASIUS_FAULT=CALL:N[:HOW]. CALL: malloc, mmap,
// open, write, rename, link, fsync or flush (of standard output); N from 1; HOW: an errno's number
// (default EIO, of malloc and mmap ENOMEM), or "short": half of a write. Writes are those to files.
// clock:N:SECONDS: from the N-th look at it on the steady clock is ahead by so many.
// LASIUS_FAULT_COUNT=FILE: at the end the number of such calls is written there.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

static char call_name[16];
static long fail_at;
static int fail_how, fail_short;
static atomic_long calls;
static const char* count_file;
static int ready;

__attribute__((constructor)) static void prepare(void) {
  const char* asked = getenv("LASIUS_FAULT");
  count_file = getenv("LASIUS_FAULT_COUNT");
  if (asked == NULL) return;
  const char* colon = strchr(asked, ':');
  if (colon == NULL || colon - asked >= (long)sizeof call_name) return;
  memcpy(call_name, asked, colon - asked);
  fail_at = strtol(colon + 1, NULL, 10);
  const char* how = strchr(colon + 1, ':');
  fail_short = how != NULL && strcmp(how + 1, "short") == 0;
  const int usual =
      strcmp(call_name, "malloc") == 0 || strcmp(call_name, "mmap") == 0 ? ENOMEM : EIO;
  fail_how = how != NULL && !fail_short ? atoi(how + 1) : usual;
  ready = 1;
  unsetenv("LD_PRELOAD");  // a helper, as Open MPI's, has no faults, and does not count
}

static int fails(const char* name) {
  if (!ready || strcmp(name, call_name) != 0) return 0;
  if (atomic_fetch_add(&calls, 1) + 1 != fail_at) return 0;
  errno = fail_how;
  return 1;
}

__attribute__((destructor)) static void tell(void) {
  if (count_file == NULL) return;
  char text[32];
  const int size = snprintf(text, sizeof text, "%ld\n", atomic_load(&calls));
  ready = 0;
  const int file = open(count_file, O_WRONLY | O_CREAT | O_TRUNC, 0666);
  if (file >= 0 && write(file, text, size) == size) close(file);
}

extern void* __libc_malloc(size_t size);
extern void* __libc_calloc(size_t count, size_t size);
extern void* __libc_realloc(void* from, size_t size);

// Says in FILE.who which object's allocation failed: some libraries do not bear it.
static int fails_to_allocate(void* caller) {
  if (!fails("malloc")) return 0;
  Dl_info about;
  char name[4096];
  if (count_file == NULL || dladdr(caller, &about) == 0 ||
      snprintf(name, sizeof name, "%s.who", count_file) >= (int)sizeof name)
    return 1;
  const int file = (int)syscall(SYS_openat, AT_FDCWD, name, O_WRONLY | O_CREAT | O_TRUNC, 0666);
  if (syscall(SYS_write, file, about.dli_fname, strlen(about.dli_fname)) >= 0)
    syscall(SYS_close, file);
  errno = fail_how;
  return 1;
}
#define ALLOCATION_FAILS fails_to_allocate(__builtin_return_address(0))

void* malloc(size_t size) { return ALLOCATION_FAILS ? NULL : __libc_malloc(size); }
void* calloc(size_t count, size_t size) {
  return ALLOCATION_FAILS ? NULL : __libc_calloc(count, size);
}
void* realloc(void* from, size_t size) {
  return ALLOCATION_FAILS ? NULL : __libc_realloc(from, size);
}

#define NEXT(type, name) ((type)dlsym(RTLD_NEXT, name))

ssize_t write(int file, const void* bytes, size_t size) {
  static ssize_t (*next)(int, const void*, size_t);
  if (next == NULL) next = NEXT(ssize_t(*)(int, const void*, size_t), "write");
  struct stat about;  // a program's own pipes do not fail
  if (fstat(file, &about) != 0 || !S_ISREG(about.st_mode) || !fails("write"))
    return next(file, bytes, size);
  return fail_short ? next(file, bytes, size / 2) : -1;
}

int renameat(int from_folder, const char* from, int to_folder, const char* to) {
  static int (*next)(int, const char*, int, const char*);
  if (next == NULL) next = NEXT(int (*)(int, const char*, int, const char*), "renameat");
  return fails("rename") ? -1 : next(from_folder, from, to_folder, to);
}

int linkat(int from_folder, const char* from, int to_folder, const char* to, int flags) {
  static int (*next)(int, const char*, int, const char*, int);
  if (next == NULL) next = NEXT(int (*)(int, const char*, int, const char*, int), "linkat");
  return fails("link") ? -1 : next(from_folder, from, to_folder, to, flags);
}

int open(const char* file, int flags, ...) {
  static int (*next)(const char*, int, ...);
  if (next == NULL) next = NEXT(int (*)(const char*, int, ...), "open");
  va_list more;
  va_start(more, flags);
  const int mode = flags & (O_CREAT | __O_TMPFILE) ? va_arg(more, int) : 0;
  va_end(more);
  return fails("open") ? -1 : next(file, flags, mode);
}

int openat(int folder, const char* file, int flags, ...) {
  static int (*next)(int, const char*, int, ...);
  if (next == NULL) next = NEXT(int (*)(int, const char*, int, ...), "openat");
  va_list more;
  va_start(more, flags);
  const int mode = flags & (O_CREAT | __O_TMPFILE) ? va_arg(more, int) : 0;
  va_end(more);
  return fails("open") ? -1 : next(folder, file, flags, mode);
}

int fflush(FILE* file) {
  static int (*next)(FILE*);
  if (next == NULL) next = NEXT(int (*)(FILE*), "fflush");
  if (fails(file == stdout ? "flush" : "other")) return EOF;
  return next(file);
}

int clock_gettime(clockid_t clock, struct timespec* now) {
  const int result = (int)syscall(SYS_clock_gettime, clock, now);
  if (result != 0 || clock != CLOCK_MONOTONIC || !ready || strcmp(call_name, "clock") != 0)
    return result;
  if (atomic_fetch_add(&calls, 1) + 1 >= fail_at) now->tv_sec += fail_how;
  return result;
}

int fdatasync(int file) {
  static int (*next)(int);
  if (next == NULL) next = NEXT(int (*)(int), "fdatasync");
  return fails("fsync") ? -1 : next(file);
}

void* mmap(void* at, size_t size, int protection, int flags, int file, off_t offset) {
  static void* (*next)(void*, size_t, int, int, int, off_t);
  if (next == NULL) next = NEXT(void* (*)(void*, size_t, int, int, int, off_t), "mmap");
  return fails("mmap") ? MAP_FAILED : next(at, size, protection, flags, file, offset);
}
