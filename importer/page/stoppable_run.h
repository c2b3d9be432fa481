// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// MuPDF does not ask whether to continue. Its cookie lets another thread stop it. Private to importer/page.

#include <ctime>
#include <functional>

#include "importer/page/mupdf_context.h"
#include "importer/page/progress.h"

namespace detent::importer {

/// Processor time of the program: a page is not slow because the machine has other work.
inline double processorSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

enum class RunStop { none, cancelled, tooSlow };

/// Runs `work` on its own thread and returns when it has ended. Meanwhile the calling thread polls `progress`
/// (first of all) and the clock. `work` passes `cookie` to MuPDF, which stops at the next object of the page
/// after an abort; it must not throw. `endAt_s`: of processorSeconds(). Throws std::system_error if no thread
/// can be started.
RunStop runStoppable(fz_cookie& cookie, double endAt_s, const Progress& progress,
                     const std::function<void()>& work);

}  // namespace detent::importer
