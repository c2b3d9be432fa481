// SPDX-License-Identifier: GPL-3.0-or-later
// Debian's archives are compiled for programs: they take stdout and stderr for objects of their own file. In a shared library there
// must be such objects; these are seen by nobody else and are the C library's before anything runs.
#include <dlfcn.h>

struct _IO_FILE;

extern "C" {
__attribute__((visibility("hidden"))) _IO_FILE* stdin = nullptr;
__attribute__((visibility("hidden"))) _IO_FILE* stdout = nullptr;
__attribute__((visibility("hidden"))) _IO_FILE* stderr = nullptr;
}

namespace {

_IO_FILE* streamOf(const char* name) { return *static_cast<_IO_FILE**>(dlsym(RTLD_DEFAULT, name)); }

__attribute__((constructor(101))) void takeStreams() {
  stdin = streamOf("stdin");
  stdout = streamOf("stdout");
  stderr = streamOf("stderr");
}

}  // namespace
