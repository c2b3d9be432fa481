// SPDX-License-Identifier: GPL-3.0-or-later
// Debian's archives are compiled for programs: they take stdout and stderr for objects of their own file. In
// a shared library there must be such objects; these are seen by nobody else and are the C library's before
// anything runs.
#include <dlfcn.h>

extern "C" {  // pointers, of whatever type
__attribute__((visibility("hidden"))) void* stdin = nullptr;
__attribute__((visibility("hidden"))) void* stdout = nullptr;
__attribute__((visibility("hidden"))) void* stderr = nullptr;
}

namespace {

void* streamOf(const char* name) { return *static_cast<void**>(dlsym(RTLD_DEFAULT, name)); }

__attribute__((constructor(101))) void takeStreams() {
  stdin = streamOf("stdin");
  stdout = streamOf("stdout");
  stderr = streamOf("stderr");
}

}  // namespace
