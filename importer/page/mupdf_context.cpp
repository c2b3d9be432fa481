// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/page/mupdf_context.h"

#include <cstdlib>
#include <cstring>

// Only these handlers are registered. Those for books, web pages and archives are neither offered nor linked.
extern "C" fz_document_handler pdf_document_handler;

namespace detent::importer {
namespace {

constexpr std::size_t storeBytes = 32u << 20;  // decoded images and glyphs that MuPDF may keep

/// Each block begins with its size, so that frees can be counted.
constexpr std::size_t headerBytes = alignof(std::max_align_t);

void ignoreRemark(void*, const char*) {}

}  // namespace

MupdfContext::MupdfContext(std::size_t maxBytes)
    : maxBytes_(maxBytes), allocator_{this, &allocate, &reallocate, &release} {
  context_ = fz_new_context(&allocator_, nullptr, storeBytes);
  if (!context_) return;
  fz_set_warning_callback(context_, &ignoreRemark, nullptr);
  fz_set_error_callback(context_, &ignoreRemark, nullptr);
  std::string ignored;
  const bool registered =
      guarded(context_, ignored, [this] { fz_register_document_handler(context_, &pdf_document_handler); });
  if (!registered) {
    fz_drop_context(context_);
    context_ = nullptr;
  }
}

MupdfContext::~MupdfContext() { fz_drop_context(context_); }

void* MupdfContext::allocate(void* self, std::size_t size) { return reallocate(self, nullptr, size); }

void* MupdfContext::reallocate(void* self, void* block, std::size_t size) {
  auto* context = static_cast<MupdfContext*>(self);
  auto* old = block ? static_cast<unsigned char*>(block) - headerBytes : nullptr;
  std::size_t oldSize = 0;
  if (old) std::memcpy(&oldSize, old, sizeof oldSize);
  if (size > context->maxBytes_ || context->used_ - oldSize > context->maxBytes_ - size) return nullptr;
  auto* fresh = static_cast<unsigned char*>(std::realloc(old, size + headerBytes));
  if (!fresh) return nullptr;
  std::memcpy(fresh, &size, sizeof size);
  context->used_ = context->used_ - oldSize + size;
  return fresh + headerBytes;
}

void MupdfContext::release(void* self, void* block) {
  if (!block) return;
  auto* start = static_cast<unsigned char*>(block) - headerBytes;
  std::size_t size = 0;
  std::memcpy(&size, start, sizeof size);
  static_cast<MupdfContext*>(self)->used_ -= size;
  std::free(start);
}

bool guardedCall(fz_context* context, void (*body)(void*), void* argument, std::string& error) {
  volatile bool failed = false;  // set after the longjmp
  fz_try(context) { body(argument); }
  fz_catch(context) { failed = true; }
  if (failed) error = fz_caught_message(context);
  return !failed;
}

}  // namespace detent::importer
