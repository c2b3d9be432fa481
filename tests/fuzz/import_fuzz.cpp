// SPDX-License-Identifier: GPL-3.0-or-later
// The whole import on any bytes: document -> frames -> axes -> trace -> strokes -> callouts -> fit -> button,
// or log -> fit -> button. Nothing may crash, hang, leak, or give a button with a number that is not finite.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include <sys/mman.h>
#include <unistd.h>

#include "importer/page/picture_header.h"
#include "tests/fuzz/import_document.h"

using namespace detent;
using namespace detent::importer;

namespace {

void importLog(const std::uint8_t* data, std::size_t size) {
  const int file = memfd_create("fuzz", 0);
  if (file < 0 || write(file, data, size) != static_cast<ssize_t>(size)) std::abort();
  const auto log = readForceLog("/proc/self/fd/" + std::to_string(file));
  close(file);
  if (!log) return;
  auto fitted = fuzz::fitBoth(log->strokes, fitOptionsFor(FitEffort::draft, {log->noise_mm, log->noise_N}));
  if (!fitted) return;
  const auto button = buttonFrom("fuzz", *fitted, {}, {});
  if (button) fuzz::mustBeFinite(*button);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::vector<unsigned char> bytes(data, data + size);
  if (sniffFileKind(bytes) == FileKind::unknown) {
    importLog(data, size);
    return 0;
  }
  fuzz::importDocument(std::move(bytes));
  return 0;
}
