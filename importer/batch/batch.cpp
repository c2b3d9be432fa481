// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/batch/batch.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <map>
#include <optional>
#include <set>
#include <thread>

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace detent::importer {
namespace {

using Clock = std::chrono::steady_clock;

/// A running child process and the pipe on which its report lines arrive.
struct Child {
  std::size_t inputIndex = 0;
  pid_t pid = -1;
  int pipe = -1;
  Clock::time_point deadline;
  std::string lines;
  bool timedOut = false;
};

void writeAll(int descriptor, const std::string& text) {
  std::size_t written = 0;
  while (written < text.size()) {
    const ssize_t n = write(descriptor, text.data() + written, text.size() - written);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return;  // the parent has ended, so nobody reads the report
    written += static_cast<std::size_t>(n);
  }
}

// AddressSanitizer reserves terabytes of address space, so with any limit the child's first allocation would
// fail.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool addressSpaceIsUsed = false;
#elif defined(__has_feature)
constexpr bool addressSpaceIsUsed = !__has_feature(address_sanitizer);
#else
constexpr bool addressSpaceIsUsed = true;
#endif

void limitMemory(double megabytes) {
  const auto bytes = static_cast<rlim_t>(megabytes * 1048576.0);
  const rlimit limit{bytes, bytes};
  if (addressSpaceIsUsed) setrlimit(RLIMIT_AS, &limit);
  const rlimit noCore{0, 0};
  setrlimit(RLIMIT_CORE, &noCore);
}

std::optional<Child> startChild(std::size_t index, const std::string& input, const BatchOptions& options,
                                const std::function<int(const std::string&, std::string&)>& handle) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) return {};
  std::fflush(nullptr);
  const pid_t pid = fork();
  if (pid < 0) {
    close(ends[0]);
    close(ends[1]);
    return {};
  }
  if (pid == 0) {
    close(ends[0]);
    std::signal(SIGINT, SIG_IGN);  // an interrupt is handled by the parent
    for (const int fault : {SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV}) std::signal(fault, SIG_DFL);
    limitMemory(options.memoryLimit_MB);
    std::string lines;
    const int code = handle(input, lines);
    writeAll(ends[1], lines);
    close(ends[1]);
    std::fflush(nullptr);
    _exit(code);
  }
  close(ends[1]);
  const auto limit =
      std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(options.timeLimit_s));
  return Child{index, pid, ends[0], Clock::now() + limit, {}, false};
}

/// Reads what has arrived; returns true while the pipe is open.
bool drain(Child& child) {
  char buffer[65536];
  const ssize_t n = read(child.pipe, buffer, sizeof buffer);
  if (n > 0) child.lines.append(buffer, static_cast<std::size_t>(n));
  return n > 0 || (n < 0 && errno == EINTR);
}

std::string seconds(double s) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g s", s);
  return text;
}

InputOutcome reap(Child& child, const std::string& input, const BatchOptions& options) {
  close(child.pipe);
  int status = 0;
  while (waitpid(child.pid, &status, 0) < 0 && errno == EINTR) {
  }
  InputOutcome outcome{input, 0, std::move(child.lines), {}};
  if (child.timedOut) {
    outcome.exitCode = static_cast<int>(FailureCode::unreadableInput);
    outcome.death = "took longer than the limit of " + seconds(options.timeLimit_s);
  } else if (WIFSIGNALED(status)) {
    outcome.exitCode = static_cast<int>(FailureCode::internalFault);
    outcome.death = std::string("crashed (") + strsignal(WTERMSIG(status)) + ")";
    outcome.killed = WTERMSIG(status) == SIGKILL;
  } else {
    outcome.exitCode = WEXITSTATUS(status);
  }
  if (!outcome.death.empty()) outcome.reportLines.clear();  // an incomplete report is dropped
  return outcome;
}

int defaultJobs() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

}  // namespace

Result<Done> runIsolated(const std::vector<std::string>& inputs, const BatchOptions& options,
                         const std::function<int(const std::string& input, std::string& reportLines)>& handle,
                         const std::function<void(const InputOutcome&)>& finished,
                         const std::function<bool()>& cancelled) {
  const auto jobs = static_cast<std::size_t>(options.jobs > 0 ? options.jobs : defaultJobs());
  std::vector<Child> running;
  std::map<std::size_t, InputOutcome> waiting;  // finished inputs that wait for an earlier one
  std::size_t next = 0, reported = 0;
  std::vector<std::size_t> again;  // inputs whose process was killed from outside once; started again
  std::set<std::size_t> repeated;
  const auto stopAll = [&] {
    for (Child& child : running) {
      kill(child.pid, SIGKILL);
      reap(child, inputs[child.inputIndex], options);
    }
  };

  while (reported < inputs.size()) {
    while (running.size() < jobs && (!again.empty() || next < inputs.size())) {
      const std::size_t index = again.empty() ? next : again.back();
      auto child = startChild(index, inputs[index], options, handle);
      if (!child) {
        stopAll();
        return Failure{FailureCode::internalFault, "batch", "",
                       std::string("no process could be started (") + std::strerror(errno) + ")",
                       "Pass a smaller --jobs"};
      }
      running.push_back(std::move(*child));
      again.empty() ? void(++next) : again.pop_back();
    }

    std::vector<pollfd> polled;
    for (const Child& child : running) polled.push_back({child.pipe, POLLIN, 0});
    poll(polled.data(), polled.size(), 100);
    if (cancelled && cancelled()) {
      stopAll();
      return Failure{FailureCode::cancelled, "batch", "", "cancelled", "Run it again with --resume to go on"};
    }
    for (std::size_t i = polled.size(); i-- > 0;) {
      Child& child = running[i];
      const bool late = Clock::now() > child.deadline;
      if (late) {
        child.timedOut = true;
        kill(child.pid, SIGKILL);
      }
      const bool open = polled[i].revents == 0 ? !late : drain(child) && !late;
      if (open) continue;
      InputOutcome outcome = reap(child, inputs[child.inputIndex], options);
      if (outcome.killed && repeated.insert(child.inputIndex).second)
        again.push_back(child.inputIndex);
      else
        waiting.emplace(child.inputIndex, std::move(outcome));
      running.erase(running.begin() + static_cast<std::ptrdiff_t>(i));
    }
    for (auto done = waiting.find(reported); done != waiting.end(); done = waiting.find(reported)) {
      finished(done->second);
      waiting.erase(done);
      ++reported;
    }
  }
  return Done{};
}

}  // namespace detent::importer
