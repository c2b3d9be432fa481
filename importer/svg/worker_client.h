// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Runs detent-svg-worker, the program that draws SVG files. Its libraries are not loaded into this process,
// so a malicious drawing cannot crash it. POSIX. Any thread.

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace detent::importer::svg {

using ByteView = std::span<const unsigned char>;

struct WorkerJob {
  ByteView drawing;
  std::vector<ByteView> fonts;  ///< font files for letters that the usual fonts do not have
  int processor_s = 5;
  int memory_MB = 1024;
  std::function<bool()> cancelled;  ///< called every 20 ms; may be empty
};

enum class WorkerEnd {
  drawn,
  cancelled,
  absent,      ///< the program is not installed; `words`: the folders that were searched
  notStarted,  ///< no process could be started; `words`: the reason
  truncated,   ///< the file ends too early
  refused,     ///< `words`: what is wrong with the drawing, in the library's English
  tooSlow,
  tooLarge,  ///< the drawing exceeds the limits
  broke      ///< the worker crashed or ran out of memory
};

struct WorkerResult {
  WorkerEnd end = WorkerEnd::broke;
  std::string words;
  std::vector<unsigned char> pdf;
  double scale = 1;         ///< units of the PDF per CSS pixel
  int leftOut = 0;          ///< references outside the file, and HTML
  std::string withoutFont;  ///< letters that no font has
};

WorkerResult drawSvg(const WorkerJob& job);

}  // namespace detent::importer::svg
