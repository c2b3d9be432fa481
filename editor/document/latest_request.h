// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Work off the GUI thread, for requests of which only the latest counts.

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <QObject>
#include <thread>
#include <utility>

namespace detent::editor {

/// One worker thread, started by the first request. One request waits while one is running; a later one
/// replaces it. Whatever `work` uses must outlive this: declare it last. Not copyable.
template <class Request>
class LatestRequest {
 public:
  explicit LatestRequest(std::function<void(const Request&)> work) : work_(std::move(work)) {}
  LatestRequest(const LatestRequest&) = delete;
  LatestRequest& operator=(const LatestRequest&) = delete;
  /// Waits for the running request; drops the waiting one.
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

/// LatestRequest for an object of the GUI thread that receives the answers. Declare it last. GUI thread,
/// except where stated.
template <class Request>
class LatestAnswer {
 public:
  /// A running request. Worker thread.
  class Query {
   public:
    const Request& request;
    const std::uint64_t revision;  ///< counted from 1

    /// Returns true if a newer request exists, or nobody waits any more.
    bool overtaken() const { return answers_.latest_ != revision; }
    /// Calls the callback in the GUI thread, unless a newer request exists by then.
    template <class Report>
    void tell(Report report) const {
      tellAnyway([&answers = answers_, number = revision, report = std::move(report)] {
        if (answers.latest_ == number) report();
      });
    }
    /// Calls the callback in the GUI thread even if a newer request exists. Qt drops events for a destroyed
    /// object, and the destructor waits for this thread.
    template <class Report>
    void tellAnyway(Report report) const {
      QMetaObject::invokeMethod(answers_.owner_, std::move(report), Qt::QueuedConnection);
    }

   private:
    friend class LatestAnswer;
    Query(LatestAnswer& answers, const Request& current, std::uint64_t number)
        : request(current), revision(number), answers_(answers) {}
    LatestAnswer& answers_;
  };

  /// `owner` receives the answers and holds this. `work` runs on the worker thread.
  LatestAnswer(QObject* owner, std::function<void(const Query&)> work)
      : owner_(owner),
        work_(std::move(work)),
        requests_([this](const Waiting& next) { work_(Query(*this, next.request, next.revision)); }) {}
  /// Cancels the running request and waits for it.
  ~LatestAnswer() { cancel(); }
  LatestAnswer(const LatestAnswer&) = delete;
  LatestAnswer& operator=(const LatestAnswer&) = delete;

  /// Returns the revision of the request.
  std::uint64_t ask(Request request) {
    const std::uint64_t revision = ++latest_;
    requests_.put({std::move(request), revision});
    return revision;
  }
  /// Suppresses the answers of all requests so far.
  void cancel() { ++latest_; }
  std::uint64_t latest() const { return latest_; }

 private:
  struct Waiting {
    Request request;
    std::uint64_t revision = 0;
  };

  QObject* owner_;
  std::function<void(const Query&)> work_;
  std::atomic<std::uint64_t> latest_{0};
  LatestRequest<Waiting> requests_;  // last, because its thread uses the others
};

}  // namespace detent::editor
