// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/playback/realtime/callback_guard.h"

#include <atomic>
#include <cstddef>

#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <time.h>
#include <unistd.h>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define DETENT_GUARD_OFF 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define DETENT_GUARD_OFF 1
#endif
#endif

namespace {

thread_local int depth = 0;
std::atomic<std::uint64_t> hits{0}, memory{0};
std::atomic<const char*> first{nullptr};

#ifndef DETENT_GUARD_OFF
void note(const char* name) {
  if (depth == 0) return;
  hits.fetch_add(1, std::memory_order_relaxed);
  const char* none = nullptr;
  first.compare_exchange_strong(none, name);
}
void noteMemory(const char* name) {
  note(name);
  if (depth > 0) memory.fetch_add(1, std::memory_order_relaxed);
}
#endif

}  // namespace

namespace detent::test {

void enterGuard() { ++depth; }
void leaveGuard() { --depth; }
GuardedScope::GuardedScope() { enterGuard(); }
GuardedScope::~GuardedScope() { leaveGuard(); }
std::uint64_t guardHits() { return hits.load(); }
std::uint64_t guardedMemoryCalls() { return memory.load(); }
std::string firstGuardHit() { return first.load() == nullptr ? "" : first.load(); }
void resetGuard() {
  hits = memory = 0;
  first = nullptr;
}
bool guardWorks() {
#ifdef DETENT_GUARD_OFF
  return false;
#else
  return true;
#endif
}

}  // namespace detent::test

#ifndef DETENT_GUARD_OFF

extern "C" {

void* __libc_malloc(std::size_t);
void __libc_free(void*);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);

void* malloc(std::size_t size) {
  noteMemory("malloc");
  return __libc_malloc(size);
}
void free(void* p) {
  noteMemory("free");
  __libc_free(p);
}
void* calloc(std::size_t n, std::size_t size) {
  noteMemory("calloc");
  return __libc_calloc(n, size);
}
void* realloc(void* p, std::size_t size) {
  noteMemory("realloc");
  return __libc_realloc(p, size);
}
void* memalign(std::size_t alignment, std::size_t size) {
  noteMemory("memalign");
  return __libc_memalign(alignment, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  noteMemory("aligned_alloc");
  return __libc_memalign(alignment, size);
}
}

namespace {

template <class Function>
Function next(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" {

int pthread_mutex_lock(pthread_mutex_t* mutex) {
  static const auto real = next<int (*)(pthread_mutex_t*)>("pthread_mutex_lock");
  note("pthread_mutex_lock");
  return real(mutex);
}
int pthread_cond_wait(pthread_cond_t* condition, pthread_mutex_t* mutex) {
  static const auto real = next<int (*)(pthread_cond_t*, pthread_mutex_t*)>("pthread_cond_wait");
  note("pthread_cond_wait");
  return real(condition, mutex);
}
ssize_t write(int file, const void* data, std::size_t size) {
  static const auto real = next<ssize_t (*)(int, const void*, std::size_t)>("write");
  note("write");
  return real(file, data, size);
}
ssize_t read(int file, void* data, std::size_t size) {
  static const auto real = next<ssize_t (*)(int, void*, std::size_t)>("read");
  note("read");
  return real(file, data, size);
}
int nanosleep(const timespec* wanted, timespec* left) {
  static const auto real = next<int (*)(const timespec*, timespec*)>("nanosleep");
  note("nanosleep");
  return real(wanted, left);
}
int poll(pollfd* files, nfds_t count, int timeout) {
  static const auto real = next<int (*)(pollfd*, nfds_t, int)>("poll");
  note("poll");
  return real(files, count, timeout);
}
}

#endif
