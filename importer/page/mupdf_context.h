// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// MuPDF reports faults by longjmp. All calls of it go through guarded(), so that no jump crosses a C++
// destructor. Private to importer/page.

#include <cstddef>
#include <string>
#include <type_traits>

#include <mupdf/fitz.h>

namespace detent::importer {

/// One MuPDF context with a bound on its memory; silent. Not copyable: MuPDF keeps a pointer into it.
class MupdfContext {
 public:
  /// `maxBytes`: allocations beyond this total fail (as an error of the call that allocates).
  explicit MupdfContext(std::size_t maxBytes);
  ~MupdfContext();
  MupdfContext(const MupdfContext&) = delete;
  MupdfContext& operator=(const MupdfContext&) = delete;

  /// Null if the machine has not even the memory for the context.
  fz_context* get() const { return context_; }

 private:
  std::size_t used_ = 0;
  std::size_t maxBytes_;
  fz_alloc_context allocator_;
  fz_context* context_ = nullptr;

  static void* allocate(void* self, std::size_t size);
  static void* reallocate(void* self, void* block, std::size_t size);
  static void release(void* self, void* block);
};

/// Runs `body(argument)` and catches what MuPDF throws. False: failed, `error` says why.
/// The body must hold no object with a destructor while it calls MuPDF, and must not throw C++ exceptions.
bool guardedCall(fz_context* context, void (*body)(void*), void* argument, std::string& error);

/// The same for a lambda.
template <class Body>
bool guarded(fz_context* context, std::string& error, Body&& body) {
  return guardedCall(
      context, [](void* argument) { (*static_cast<std::remove_reference_t<Body>*>(argument))(); }, &body,
      error);
}

}  // namespace detent::importer
