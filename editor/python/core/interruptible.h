// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Work beside Python: without its lock, so that other threads go on, and ended by Ctrl-C.

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <utility>

namespace detent::python {

/// Called often by everything that takes long.
using Cancelled = std::function<bool()>;

/// One piece of work between who waits for it and who does it. Any thread.
class Errand {
 public:
  bool cancelled() const { return cancelled_; }
  void cancel() { cancelled_ = true; }
  void finish();
  /// False: not over within `longest`.
  bool waitFor(std::chrono::milliseconds longest);

 private:
  std::atomic<bool> cancelled_{false};
  std::mutex guard_;
  std::condition_variable changed_;
  bool over_ = false;
};

/// Runs `work` on a thread that lives on between calls (the text engine is loaded for each thread once). It
/// must own all it uses: one that does not end on request is left behind. Exceptions must not leave it.
void begin(std::function<void()> work);

/// Waits without Python's lock and checks for its signals; call with the lock held. Throws the exception of a
/// signal's handler (KeyboardInterrupt), 0.2 s after it at the latest.
void await(Errand& errand);

/// The value of `work(cancelled)`, done so. `Value` can be moved.
template <class Value, class Work>
Value interruptible(Work work) {
  struct Shared : Errand {
    std::unique_ptr<Value> value;
  };
  const auto shared = std::make_shared<Shared>();
  begin([shared, work = std::move(work)] {
    shared->value = std::make_unique<Value>(work(Cancelled([shared] { return shared->cancelled(); })));
    shared->finish();
  });
  await(*shared);
  return std::move(*shared->value);
}

}  // namespace detent::python
