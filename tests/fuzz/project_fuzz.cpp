// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes, as if they were measurements kept as strokes: a digitizer's project (JSON, TAR), a spreadsheet,
// JSON of a force tester. What is taken has finite strokes; what is not has a reason and a remedy.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include <sys/mman.h>
#include <unistd.h>

#include "importer/log/force_log.h"

using namespace detent;
using namespace detent::importer;

namespace {

void demand(bool condition) {
  if (!condition) std::abort();
}

/// The same bytes under names of every ending that is read.
class NamedMemory {
 public:
  NamedMemory() : memory_(memfd_create("fuzz", 0)) {
    char folder[] = "/tmp/detent-project-fuzz-XXXXXX";
    demand(memory_ >= 0 && mkdtemp(folder) != nullptr);
    folder_ = folder;
    for (const char* ending : endings)
      demand(symlink(("/proc/self/fd/" + std::to_string(memory_)).c_str(), path(ending).c_str()) == 0);
  }
  NamedMemory(const NamedMemory&) = delete;
  NamedMemory& operator=(const NamedMemory&) = delete;
  ~NamedMemory() {
    for (const char* ending : endings) unlink(path(ending).c_str());
    rmdir(folder_.c_str());
    close(memory_);
  }

  void hold(const std::uint8_t* data, std::size_t size) {
    demand(ftruncate(memory_, 0) == 0 && pwrite(memory_, data, size, 0) == static_cast<ssize_t>(size));
  }
  std::string path(const char* ending) const { return folder_ + "/x" + ending; }

  static constexpr const char* endings[] = {".json", ".tar", ".ods"};

 private:
  int memory_;
  std::string folder_;
};

void demandFinite(const std::vector<CurvePoint>& points) {
  for (const CurvePoint& point : points)
    demand(std::isfinite(point.displacement_mm) && std::isfinite(point.force_N));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static NamedMemory memory;
  memory.hold(data, size);
  for (const char* ending : NamedMemory::endings) {
    const auto log = readForceLog(memory.path(ending));
    if (!log) {
      demand(!log.failure().sentence().empty());
      demand(!log.failure().remedies.empty());
      continue;
    }
    demandFinite(log->strokes.press.points);
    if (log->strokes.release) demandFinite(log->strokes.release->points);
  }
  return 0;
}
