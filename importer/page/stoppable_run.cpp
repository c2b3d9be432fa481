// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/page/stoppable_run.h"

#include <atomic>
#include <chrono>
#include <future>
#include <thread>

namespace detent::importer {

RunStop runStoppable(fz_cookie& cookie, double endAt_s, const Progress& progress,
                     const std::function<void()>& work) {
  constexpr std::chrono::milliseconds pollEvery{20};
  if (progress.isCancelled()) return RunStop::cancelled;
  std::promise<void> promise;
  const std::future<void> ended = promise.get_future();
  std::thread worker([&] {
    work();
    promise.set_value();
  });
  RunStop stop = RunStop::none;
  while (ended.wait_for(pollEvery) != std::future_status::ready) {
    if (stop != RunStop::none) continue;
    if (progress.isCancelled())
      stop = RunStop::cancelled;
    else if (processorSeconds() > endAt_s)
      stop = RunStop::tooSlow;
    if (stop != RunStop::none) std::atomic_ref(cookie.abort).store(1);
  }
  worker.join();
  return stop;
}

}  // namespace detent::importer
