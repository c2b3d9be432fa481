// SPDX-License-Identifier: GPL-3.0-or-later
// Debian's static libraries are compiled for programs, in which stdin, stdout and stderr are objects of the
// program itself. A shared library must therefore define such objects. The ones here are hidden from other
// files, and get the C library's values before any other code runs.
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
