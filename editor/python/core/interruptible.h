// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Runs work without Python's lock, so that other Python threads continue, and lets Ctrl-C end it.

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <utility>

namespace detent::python {

/// Polled often by all long work; true requests its end.
using Cancelled = std::function<bool()>;

/// One piece of work, shared by the thread that waits and the thread that does it. Any thread.
class Errand {
 public:
  bool cancelled() const { return cancelled_; }
  void cancel() { cancelled_ = true; }
  void finish();
  /// Returns false if the work is not finished within `longest`.
  bool waitFor(std::chrono::milliseconds longest);

 private:
  std::atomic<bool> cancelled_{false};
  std::mutex guard_;
  std::condition_variable changed_;
  bool over_ = false;
};

/// Runs `work` on a thread that is kept between calls, because the text engine is loaded once per thread.
/// `work` must own all its data: if it does not end on request, it is left running. No exception may leave
/// it.
void begin(std::function<void()> work);

/// Waits without Python's lock and checks for its signals; call with the lock held. Throws the exception of a
/// signal's handler (KeyboardInterrupt), 0.2 s after it at the latest.
void await(Errand& errand);

/// Runs `work(cancelled)` in this way and returns its value. `Value` can be moved.
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
