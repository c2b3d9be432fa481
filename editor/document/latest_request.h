// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Work off the GUI thread of which only the latest counts.

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace detent::editor {

/// One worker thread, begun with the first request. One request waits while one is worked on; a later one takes its place. What
/// `work` uses must outlive this: declare it last. Not copied.
template <class Request>
class LatestRequest {
 public:
  explicit LatestRequest(std::function<void(const Request&)> work) : work_(std::move(work)) {}
  LatestRequest(const LatestRequest&) = delete;
  LatestRequest& operator=(const LatestRequest&) = delete;
  /// Waits for what is being worked on; what waits is dropped.
  ~LatestRequest() {
    {
      const std::lock_guard lock(mutex_);
      stopping_ = true;
    }
    wake_.notify_one();
    if (worker_.joinable()) worker_.join();
  }

  /// One thread.
  void put(Request request) {
    {
      const std::lock_guard lock(mutex_);
      waiting_.emplace(std::move(request));
    }
    if (!worker_.joinable()) worker_ = std::thread([this] { run(); });
    wake_.notify_one();
  }

 private:
  void run() {
    std::unique_lock lock(mutex_);
    while (true) {
      wake_.wait(lock, [this] { return stopping_ || waiting_.has_value(); });
      if (stopping_) return;
      const Request next = *std::exchange(waiting_, std::nullopt);
      lock.unlock();
      work_(next);
      lock.lock();
    }
  }

  std::function<void(const Request&)> work_;
  std::mutex mutex_;
  std::condition_variable wake_;
  std::optional<Request> waiting_;
  bool stopping_ = false;
  std::thread worker_;
};

}  // namespace detent::editor
