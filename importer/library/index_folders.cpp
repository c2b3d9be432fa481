// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/library/index_folders.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <optional>
#include <set>
#include <thread>
#include <utility>

#include "importer/library/origin.h"
#include "importer/library/read_switches.h"
#include "importer/log/force_log.h"
#include "model/file/text_file.h"
#include "model/sha256.h"
#include "model/text.h"
#include "model/version.h"

namespace detent::importer {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t mostBytes = 32 << 20;  // a switch measured in micrometre steps has 1 MB
constexpr std::size_t batchFiles = 64;  // files per transaction: as many are lost if the program is killed
constexpr std::int64_t settled_ns = 2'000'000'000;  // resolution of the coarsest file system clock in use

/// A file to be read, and the requested folder that holds it.
struct Candidate {
  fs::path path, root;
  FileStamp stamp;           ///< includes the file of the release
  std::string release = {};  ///< the release's file if the press has a separate one
};

std::optional<FileStamp> stampOf(const fs::path& path) {
  std::error_code noSize, noTime;
  const auto bytes = fs::file_size(path, noSize);
  const auto modified = fs::last_write_time(path, noTime);
  if (noSize || noTime) return {};
  const auto count_ns = [](fs::file_time_type time) {
    return std::int64_t{
        std::chrono::duration_cast<std::chrono::nanoseconds>(time.time_since_epoch()).count()};
  };
  return FileStamp{static_cast<std::int64_t>(bytes), count_ns(modified),
                   count_ns(fs::file_time_type::clock::now())};
}

/// Combined stamp of both files of a pair.
std::optional<FileStamp> stampOf(const Candidate& candidate) {
  auto stamp = stampOf(candidate.path);
  if (!stamp || candidate.release.empty()) return stamp;
  const auto release = stampOf(fs::path(candidate.release));
  if (!release) return {};
  stamp->bytes += release->bytes, stamp->modified_ns = std::max(stamp->modified_ns, release->modified_ns);
  return stamp;
}

bool sameFile(const FileStamp& a, const FileStamp& b) {
  return a.bytes == b.bytes && a.modified_ns == b.modified_ns;
}

bool isHidden(const fs::path& path) { return path.filename().string().starts_with('.'); }

RefusedFile refusalOf(const std::string& file, const Failure& why) {
  return {file, why.code, why.sentence()};
}

Failure unreadableFolder(const fs::path& folder, const std::string& why) {
  return {FailureCode::unreadableInput, folder.string(), "", Message("the folder cannot be read: %1", why),
          "Pass a folder of measurements"};
}

/// Collects files in the order of their names, each once.
class FolderSearch {
 public:
  explicit FolderSearch(bool pages) : pages_(pages) {}

  std::optional<Failure> into(const std::string& given) {
    std::error_code error;
    const fs::path root = fs::absolute(given, error).lexically_normal();
    if (error || !fs::exists(root, error)) return unreadableFolder(given, "there is none");
    if (!fs::is_directory(root, error)) {
      add(root, root.parent_path());
      return {};
    }
    const fs::path folder = root.has_filename() ? root : root.parent_path();
    fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, error), end;
    if (error) return unreadableFolder(given, error.message());
    while (entry != end) {
      std::error_code unknown;
      if (isHidden(entry->path()))
        entry.disable_recursion_pending();
      else if (isTaken(entry->path()) && entry->is_regular_file(unknown))
        add(entry->path(), folder);
      entry.increment(error);
      if (error) return unreadableFolder(given, error.message());
    }
    roots_.push_back(folder);
    return {};
  }

  const std::vector<Candidate>& found() {
    const auto pairs = pairedFiles({seen_.begin(), seen_.end()});
    for (Candidate& each : found_)
      if (const auto pair = pairs.find(each.path.string()); pair != pairs.end()) each.release = pair->second;
    for (const auto& [press, release] : pairs) seen_.erase(release);
    std::erase_if(found_, [&](const Candidate& each) { return !has(each.path.string()); });
    for (Candidate& each : found_)
      if (const auto stamp = stampOf(each)) each.stamp = *stamp;
    std::ranges::sort(found_, {}, &Candidate::path);
    return found_;
  }
  /// Returns true if a path lies below one of the folders.
  bool covers(const fs::path& path) const {
    return std::ranges::any_of(roots_, [&](const fs::path& root) {
      return std::mismatch(root.begin(), root.end(), path.begin(), path.end()).first == root.end();
    });
  }
  bool has(const std::string& path) const { return seen_.count(path) > 0; }

 private:
  bool isTaken(const fs::path& path) const { return isLibraryFile(path) || (pages_ && isPageFile(path)); }
  void add(const fs::path& path, const fs::path& root) {
    const auto stamp = stampOf(path);
    if (stamp && seen_.insert(path.string()).second) found_.push_back({path, root, *stamp});
  }

  bool pages_;
  std::vector<Candidate> found_;
  std::vector<fs::path> roots_;
  std::set<std::string> seen_;
};

/// The result of reading a file once; `same` if its content has not changed.
struct FileRead {
  LibraryFile file;
  bool same = false;
};

void take(FileRead& read, Result<std::vector<LibrarySwitch>> switches, const Origin& origin) {
  if (!switches) {
    read.file.refused = refusalOf(read.file.path, switches.failure());
    return;
  }
  for (LibrarySwitch& each : *switches) each.licence = origin.licence, each.credit = origin.credit;
  read.file.switches = std::move(*switches);
}

/// Reads a CSV file that is no record of a switch as a sheet of ratings, if it is one.
void takeRatings(FileRead& read, const Origin& origin) {
  if (!lowered(read.file.path).ends_with(".csv")) return;
  const auto text = readTextFile(read.file.path);
  if (!text) return;
  read.file.ratings = ratingsIn(*text);
  if (read.file.ratings.empty()) return;
  for (Rating& each : read.file.ratings) each.licence = origin.licence, each.credit = origin.credit;
  read.file.refused.reset();
}

/// Checks a file against its stored data. The switches of a file that must be read are still missing.
FileRead readingOf(const Candidate& candidate, const FileStamp& stamp, const KnownFile* known) {
  FileRead read;
  read.file = {candidate.path.string(), stamp, {}, version(), {}, {}};
  const std::string name = candidate.path.filename().string();
  if (stamp.bytes > mostBytes) {
    read.file.refused =
        refusalOf(read.file.path, {FailureCode::unreadableInput, name, "", "the file is larger than 32 MB",
                                   "Export one switch to a file"});
    return read;
  }
  const auto hash = contentHash(candidate.path.string(), candidate.release);
  if (!hash) {
    read.file.refused = refusalOf(read.file.path, hash.failure());
    return read;
  }
  read.file.sha256 = *hash;
  read.same = known && known->sha256 == read.file.sha256 && known->version == version();
  return read;
}

FileRead readOnce(const Candidate& candidate, const FileStamp& stamp, const Origin& origin,
                  const KnownFile* known) {
  FileRead read = readingOf(candidate, stamp, known);
  if (read.same || read.file.refused) return read;
  take(read, readSwitches(read.file.path, true, candidate.release), origin);
  if (read.file.refused) takeRatings(read, origin);
  return read;
}

/// Reads a file in a consistent state: again, up to three times, if it was written meanwhile.
FileRead readWhole(const Candidate& candidate, const Origin& origin, const KnownFile* known) {
  constexpr int attempts = 3;
  FileStamp before = candidate.stamp;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    FileRead read = readOnce(candidate, before, origin, known);
    const auto after = stampOf(candidate);
    if (after && sameFile(before, *after)) return read;
    if (!after) break;
    before = *after;
  }
  FileRead changed;
  // without a stamp, so that the next run reads it again
  changed.file = {candidate.path.string(), {}, {}, version(), {}, {}};
  changed.file.refused =
      refusalOf(changed.file.path, {FailureCode::unreadableInput, candidate.path.filename().string(), "",
                                    "it was written while it was read", "Index again when it is complete"});
  return changed;
}

/// A file to read, with its context.
struct Task {
  const Candidate* candidate = nullptr;
  Origin origin;
  const KnownFile* known = nullptr;  ///< null: a new file
};

/// Threads that read files; the results are taken one by one. The destructor ends the threads.
class Readers {
 public:
  Readers(const std::vector<Task>& tasks, int jobs, std::function<bool()> cancelled)
      : tasks_(tasks), cancelled_(std::move(cancelled)) {
    const auto most = static_cast<int>(std::min<std::size_t>(tasks.size(), 256));
    for (int i = 0; i < std::min(jobs, most); ++i) threads_.emplace_back([this] { work(); });
  }
  Readers(const Readers&) = delete;
  Readers& operator=(const Readers&) = delete;
  ~Readers() {
    stop_ = true;
    room_.notify_all();
    for (std::thread& thread : threads_) thread.join();
  }

  /// The next result, in the order of finishing; empty when cancelled.
  std::optional<FileRead> take() {
    std::unique_lock lock(mutex_);
    while (done_.empty()) {
      if (cancelled_ && cancelled_()) return {};
      ready_.wait_for(lock, std::chrono::milliseconds(50));
    }
    FileRead read = std::move(done_.front());
    done_.pop_front();
    room_.notify_one();
    return read;
  }

 private:
  void work() {
    for (std::size_t i = next_++; i < tasks_.size() && !stop_; i = next_++) {
      FileRead read = readWhole(*tasks_[i].candidate, tasks_[i].origin, tasks_[i].known);
      std::unique_lock lock(mutex_);
      room_.wait(
          lock, [&] { return stop_ || done_.size() < 2 * batchFiles; });  // limits memory if the disk is slow
      done_.push_back(std::move(read));
      ready_.notify_one();
    }
  }

  const std::vector<Task>& tasks_;
  std::function<bool()> cancelled_;
  std::atomic<bool> stop_{false};
  std::atomic<std::size_t> next_{0};
  std::mutex mutex_;
  std::condition_variable ready_, room_;
  std::deque<FileRead> done_;
  std::vector<std::thread> threads_;
};

/// One run over the folders.
class IndexRun {
 public:
  IndexRun(const IndexRequest& request, const IndexProgress& progress, LibraryStore& store)
      : request_(request), progress_(progress), store_(store) {}

  Result<IndexSummary> over(FolderSearch& search) {
    auto known = store_.files();
    if (!known) return known.failure();
    known_ = std::move(*known);
    summary_.rebuilt = store_.rebuilt();
    std::vector<Task> tasks;  // tasks of logs; those of pages are in pages_
    Origins origins(request_.licence, request_.credit);
    for (const Candidate& candidate : search.found()) plan(candidate, origins, tasks);
    if (auto failure = markGone(search)) return std::move(*failure);
    if (auto failure = read(tasks)) return std::move(*failure);
    if (auto failure = readPages()) return std::move(*failure);
    std::ranges::sort(summary_.refusals, {}, &RefusedFile::file);
    summary_.refused = summary_.refusals.size();
    return std::move(summary_);
  }

 private:
  void plan(const Candidate& candidate, Origins& origins, std::vector<Task>& tasks) {
    const auto at = known_.find(candidate.path.string());
    const KnownFile* known = at == known_.end() ? nullptr : &at->second;
    const bool settled = known && known->stamp.modified_ns + settled_ns < known->stamp.looked_ns;
    if (settled && sameFile(known->stamp, candidate.stamp) && known->version == version()) {
      countSame(candidate.path.string(), *known);
      if (known->gone) same_.emplace_back(candidate.path.string(), known->stamp);
      return;
    }
    Task task{&candidate, origins.of(candidate.path.parent_path(), candidate.root), known};
    if (request_.readPages && isPageFile(candidate.path))
      pages_.push_back(std::move(task));
    else
      tasks.push_back(std::move(task));
  }

  void countSame(const std::string& path, const KnownFile& known) {
    if (!known.refused) {
      ++summary_.unchanged;
      return;
    }
    RefusedFile refused = *known.refused;
    refused.file = path;
    summary_.refusals.push_back(std::move(refused));
  }

  std::optional<Failure> markGone(const FolderSearch& search) {
    std::vector<std::string> gone;
    for (const auto& [path, file] : known_) {
      if (search.has(path) || !search.covers(path) || isPassedOver(path)) continue;
      ++summary_.gone;
      if (!file.gone) gone.push_back(path);
    }
    auto done = store_.restamp(same_, gone);
    same_.clear();
    if (!done) return done.failure();
    return {};
  }

  /// Returns true for a page that an earlier run has read and this run does not request.
  bool isPassedOver(const std::string& path) const {
    std::error_code error;
    return !request_.readPages && isPageFile(path) && fs::exists(path, error);
  }

  /// Reads pages in processes, after all reader threads have ended.
  std::optional<Failure> readPages() {
    std::map<std::string, FileRead> readings;
    std::map<std::string, const Task*> tasks;
    std::vector<std::string> paths;
    for (const Task& task : pages_) {
      FileRead reading = readingOf(*task.candidate, task.candidate->stamp, task.known);
      const std::string path = reading.file.path;
      if (reading.same || reading.file.refused) {
        count(std::move(reading));
        continue;
      }
      paths.push_back(path);
      tasks[path] = &task;
      readings[path] = std::move(reading);
    }
    std::optional<Failure> failure;
    const auto takePage = [&](const std::string& path, Result<std::vector<LibrarySwitch>> switches) {
      FileRead& reading = readings[path];
      take(reading, std::move(switches), tasks[path]->origin);
      if (progress_.report) progress_.report(double(++pagesRead_) / double(paths.size()), path);
      count(std::move(reading));
      if (auto done = write(); !done && !failure) failure = done.failure();
    };
    if (!paths.empty())
      if (auto done = request_.readPages(paths, takePage); !done && !failure) failure = done.failure();
    if (auto done = write(); !done && !failure) failure = done.failure();
    return failure;
  }

  std::optional<Failure> read(const std::vector<Task>& tasks) {
    const int jobs = request_.jobs > 0 ? request_.jobs
                                       : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    Readers readers(tasks, jobs, progress_.cancelled);
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      auto one = readers.take();
      if (!one) {
        const auto kept = write();
        return kept ? Failure::cancelled() : kept.failure();
      }
      if (progress_.report) progress_.report(double(i + 1) / double(tasks.size()), one->file.path);
      count(std::move(*one));
      if (read_.size() + same_.size() >= batchFiles)
        if (auto done = write(); !done) return done.failure();
    }
    if (auto done = write(); !done) return done.failure();
    return {};
  }

  void count(FileRead one) {
    if (one.same) {
      countSame(one.file.path, known_.at(one.file.path));
      same_.emplace_back(one.file.path, one.file.stamp);
      return;
    }
    if (one.file.refused) {
      summary_.refusals.push_back(*one.file.refused);
    } else {
      ++summary_.imported;
      summary_.switches += one.file.switches.size();
      summary_.ratings += one.file.ratings.size();
    }
    read_.push_back(std::move(one.file));
  }

  Result<Done> write() {
    if (read_.empty() && same_.empty()) return Done{};
    auto done = store_.put(read_);
    if (done) done = store_.restamp(same_, {});
    read_.clear();
    same_.clear();
    return done;
  }

  const IndexRequest& request_;
  const IndexProgress& progress_;
  LibraryStore& store_;
  std::map<std::string, KnownFile> known_;
  std::vector<Task> pages_;
  std::size_t pagesRead_ = 0;
  std::vector<LibraryFile> read_;
  std::vector<std::pair<std::string, FileStamp>> same_;
  IndexSummary summary_;
};

}  // namespace

Result<IndexSummary> indexFolders(const IndexRequest& request, const IndexProgress& progress) {
  FolderSearch search(static_cast<bool>(request.readPages));
  for (const std::string& folder : request.folders)
    if (auto failure = search.into(folder)) return std::move(*failure);
  auto store = LibraryStore::openToWrite(request.database);
  if (!store) return store.failure();
  return IndexRun(request, progress, *store).over(search);
}

}  // namespace detent::importer
