// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/python/core/interruptible.h"

#include <thread>
#include <vector>

#include <pthread.h>
#include <pybind11/pybind11.h>

namespace py = pybind11;

namespace detent::python {
namespace {

constexpr std::chrono::milliseconds signalsEvery{20}, graceOfCancelled{200};

/// A thread that executes work. It and its data live until the process ends.
class Worker {
 public:
  void give(std::function<void()> work);
  void run();

 private:
  std::mutex guard_;
  std::condition_variable given_;
  std::function<void()> work_;
};

/// Workers that are free. Never destroyed, because threads may outlast the static objects of this file.
struct Idle {
  std::mutex guard;
  std::vector<Worker*> workers;
};
Idle& idle() {
  static Idle* const all = [] {
    // A forked child does not have the threads.
    pthread_atfork([] { idle().guard.lock(); }, [] { idle().guard.unlock(); },
                   [] {
                     idle().workers.clear();
                     idle().guard.unlock();
                   });
    return new Idle;
  }();
  return *all;
}

void Worker::give(std::function<void()> work) {
  const std::lock_guard lock(guard_);
  work_ = std::move(work);
  given_.notify_one();
}

void Worker::run() {
  for (;;) {
    std::function<void()> work;
    {
      std::unique_lock lock(guard_);
      given_.wait(lock, [this] { return static_cast<bool>(work_); });
      work = std::exchange(work_, {});
    }
    work();
    work = {};
    const std::lock_guard lock(idle().guard);
    idle().workers.push_back(this);
  }
}

Worker* worker() {
  {
    const std::lock_guard lock(idle().guard);
    if (!idle().workers.empty()) {
      Worker* const last = idle().workers.back();
      idle().workers.pop_back();
      return last;
    }
  }
  auto* const made = new Worker;  // lives as long as its thread
  std::thread([made] { made->run(); }).detach();
  return made;
}

}  // namespace

void Errand::finish() {
  const std::lock_guard lock(guard_);
  over_ = true;
  changed_.notify_all();
}

bool Errand::waitFor(std::chrono::milliseconds longest) {
  std::unique_lock lock(guard_);
  return changed_.wait_for(lock, longest, [this] { return over_; });
}

void begin(std::function<void()> work) { worker()->give(std::move(work)); }

void await(Errand& errand) {
  const py::gil_scoped_release released;
  while (!errand.waitFor(signalsEvery)) {
    const py::gil_scoped_acquire held;
    if (PyErr_CheckSignals() == 0) continue;
    const py::error_already_set raised;
    errand.cancel();
    {
      const py::gil_scoped_release again;
      errand.waitFor(graceOfCancelled);
    }
    throw raised;
  }
}

}  // namespace detent::python
