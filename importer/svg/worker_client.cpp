// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/svg/worker_client.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string_view>
#include <utility>

#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "importer/svg/protocol.h"

namespace detent::importer::svg {
namespace {

constexpr const char* program = "detent-svg-worker";
constexpr int output_MB = 256;

class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&&) = delete;
  ~Descriptor() {
    if (number_ >= 0) close(number_);
  }
  int number() const { return number_; }

 private:
  int number_;
};

/// A file in memory, at a descriptor above those the worker has.
Descriptor fileInMemory(ByteView content) {
  constexpr int aboveWorkers = 64;
  const Descriptor made(memfd_create("detent-svg", MFD_CLOEXEC));
  for (std::size_t written = 0; written < content.size();) {
    const ssize_t n = write(made.number(), content.data() + written, content.size() - written);
    if (n <= 0) return Descriptor();
    written += static_cast<std::size_t>(n);
  }
  lseek(made.number(), 0, SEEK_SET);
  return Descriptor(fcntl(made.number(), F_DUPFD_CLOEXEC, aboveWorkers));
}

/// Folders of the worker: beside the running program, in the libexec beside its folder, and relative to a
/// Python module.
std::vector<std::filesystem::path> workerFolders() {
  std::vector<std::filesystem::path> folders;
  std::error_code error;
  const auto itself = std::filesystem::read_symlink("/proc/self/exe", error);
  if (!error) {
    folders.push_back(itself.parent_path());
    folders.push_back(itself.parent_path().parent_path() / "libexec/detent");
  }
  Dl_info module{};
  if (dladdr(reinterpret_cast<const void*>(&workerFolders), &module) != 0 && module.dli_fname != nullptr &&
      module.dli_fname[0] == '/') {
    const auto folder = std::filesystem::path(module.dli_fname).parent_path();
    folders.push_back(folder / "../../bin");                   // in the build folder
    folders.push_back(folder / "../../../../libexec/detent");  // below dist-packages
  }
  return folders;
}

std::string workerPath() {
  for (const auto& folder : workerFolders())
    if (const auto path = folder / program; access(path.c_str(), X_OK) == 0) return path.string();
  return {};
}

struct SpawnActions {
  posix_spawn_file_actions_t actions;
  SpawnActions() { posix_spawn_file_actions_init(&actions); }
  ~SpawnActions() { posix_spawn_file_actions_destroy(&actions); }
  SpawnActions(const SpawnActions&) = delete;
  SpawnActions& operator=(const SpawnActions&) = delete;
};

/// Process id of the worker, or a negative error code.
pid_t start(const std::string& path, const WorkerJob& job, int in, int out,
            const std::vector<Descriptor>& fonts) {
  SpawnActions spawn;
  posix_spawn_file_actions_adddup2(&spawn.actions, in, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&spawn.actions, out, STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&spawn.actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  int next = firstFont;
  for (const Descriptor& font : fonts)
    posix_spawn_file_actions_adddup2(&spawn.actions, font.number(), next++);
  posix_spawn_file_actions_addclosefrom_np(&spawn.actions, next);
  std::array<std::string, 5> words{program, std::to_string(job.processor_s), std::to_string(job.memory_MB),
                                   std::to_string(output_MB), std::to_string(fonts.size())};
  std::array<char*, 6> arguments{};
  for (std::size_t i = 0; i < words.size(); ++i) arguments[i] = words[i].data();
  std::string locale = "LC_ALL=C.UTF-8";
  std::array<char*, 2> environment{locale.data(), nullptr};
  pid_t worker = -1;
  const int error =
      posix_spawn(&worker, path.c_str(), &spawn.actions, nullptr, arguments.data(), environment.data());
  return error == 0 ? worker : -error;
}

/// Waits until the worker ends; kills it if it is cancelled or takes too long. `end` is set in these cases.
int waitFor(pid_t worker, const WorkerJob& job, WorkerEnd& end) {
  using Clock = std::chrono::steady_clock;
  constexpr int pollInterval_ms = 20;
  // even a busy machine gives the worker at least one part in so many of a processor
  constexpr int othersShare = 12;
  const auto last = Clock::now() + std::chrono::seconds(othersShare * job.processor_s);
  const Descriptor watched(static_cast<int>(syscall(SYS_pidfd_open, worker, 0)));
  pollfd polled{watched.number(), POLLIN, 0};
  int status = 0;
  while (watched.number() < 0 || poll(&polled, 1, pollInterval_ms) <= 0) {
    if (watched.number() < 0 && poll(nullptr, 0, pollInterval_ms) == 0 &&
        waitpid(worker, &status, WNOHANG) != 0)
      return status;
    const bool cancelled = job.cancelled && job.cancelled();
    if (!cancelled && Clock::now() < last) continue;
    end = cancelled ? WorkerEnd::cancelled : WorkerEnd::tooSlow;
    kill(worker, SIGKILL);
    break;
  }
  while (waitpid(worker, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

std::vector<unsigned char> contentOf(int descriptor) {
  const off_t size = lseek(descriptor, 0, SEEK_END);
  std::vector<unsigned char> content(static_cast<std::size_t>(std::max<off_t>(size, 0)));
  for (std::size_t at = 0; at < content.size();) {
    const ssize_t n = pread(descriptor, content.data() + at, content.size() - at, static_cast<off_t>(at));
    if (n <= 0) return {};
    at += static_cast<std::size_t>(n);
  }
  return content;
}

WorkerResult understood(const std::vector<unsigned char>& answer) {
  WorkerResult result;
  std::string_view rest(reinterpret_cast<const char*>(answer.data()), answer.size());
  while (true) {
    const std::size_t end = rest.find('\n'), blank = rest.find(' ');
    if (end == std::string_view::npos || blank > end) return result;
    const std::string_view key = rest.substr(0, blank);
    const std::string value(rest.substr(blank + 1, end - blank - 1));
    rest.remove_prefix(end + 1);
    if (key == pdfKey) break;
    if (key == scaleKey) result.scale = std::strtod(value.c_str(), nullptr);
    if (key == leftOutKey) result.leftOut = std::atoi(value.c_str());
    if (key == noFontKey) result.withoutFont = value;
    if (key == truncatedKey) result.end = WorkerEnd::truncated;
    if (key == problemKey) {
      result.end = WorkerEnd::refused;
      result.words = value;
    }
  }
  if (!(result.scale > 0)) return result;
  result.end = WorkerEnd::drawn;
  result.pdf.assign(rest.begin(), rest.end());
  return result;
}

WorkerResult ended(WorkerEnd end, std::string words = {}) {
  WorkerResult result;
  result.end = end;
  result.words = std::move(words);
  return result;
}

}  // namespace

WorkerResult drawSvg(const WorkerJob& job) {
  const std::string path = workerPath();
  if (path.empty()) {
    std::string searched;
    for (const auto& folder : workerFolders())
      searched += (searched.empty() ? "" : ", ") + folder.lexically_normal().string();
    return ended(WorkerEnd::absent, searched);
  }
  const Descriptor in = fileInMemory(job.drawing), out = fileInMemory({});
  std::vector<Descriptor> fonts;
  for (const ByteView font : job.fonts)
    if (Descriptor file = fileInMemory(font); file.number() >= 0) fonts.push_back(std::move(file));
  if (in.number() < 0 || out.number() < 0) return ended(WorkerEnd::notStarted, std::strerror(errno));
  const pid_t worker = start(path, job, in.number(), out.number(), fonts);
  if (worker < 0) return ended(WorkerEnd::notStarted, std::strerror(-worker));

  WorkerEnd end = WorkerEnd::drawn;
  const int status = waitFor(worker, job, end);
  if (end != WorkerEnd::drawn) return ended(end);
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    const bool outOfTime = signal == SIGXCPU || signal == SIGKILL;
    return ended(outOfTime ? WorkerEnd::tooSlow : signal == SIGXFSZ ? WorkerEnd::tooLarge : WorkerEnd::broke);
  }
  return WEXITSTATUS(status) == 0 ? understood(contentOf(out.number())) : ended(WorkerEnd::broke);
}

}  // namespace detent::importer::svg
