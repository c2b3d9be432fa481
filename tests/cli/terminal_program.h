// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A program at a terminal of its own: keys in, screen out.

#include <cerrno>
#include <csignal>
#include <functional>
#include <string>
#include <vector>

#include <poll.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

namespace detent::tests {

class TerminalProgram {
 public:
  /// Starts `command` in `folder`.
  TerminalProgram(const std::vector<std::string>& command, const std::string& folder) {
    const winsize size{40, 200, 0, 0};
    pid_ = ::forkpty(&master_, nullptr, nullptr, &size);
    if (pid_ != 0) return;
    std::vector<char*> words;
    for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    if (::chdir(folder.c_str()) == 0) ::execvp(words[0], words.data());
    ::_exit(127);
  }
  ~TerminalProgram() {
    if (pid_ > 0) {
      ::kill(pid_, SIGKILL);
      ::waitpid(pid_, nullptr, 0);
    }
    ::close(master_);
  }
  TerminalProgram(const TerminalProgram&) = delete;
  TerminalProgram& operator=(const TerminalProgram&) = delete;

  bool type(const std::string& keys) {
    return ::write(master_, keys.data(), keys.size()) == static_cast<ssize_t>(keys.size());
  }
  /// Everything shown so far.
  const std::string& screen() {
    read(0);
    return screen_;
  }
  /// Waits until `words` stand on the screen behind place `from`.
  bool shows(const std::string& words, double seconds, std::size_t from = 0) {
    return waits(seconds, [&] { return screen_.find(words, from) != std::string::npos; });
  }
  /// Waits for the end; the exit code, or -1.
  int exitCode(double seconds) {
    if (!waits(seconds, [&] { return ended_; })) return -1;
    int status = 0;
    ::waitpid(pid_, &status, 0);
    pid_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

 private:
  bool waits(double seconds, const std::function<bool()>& done) {
    for (int left_ms = static_cast<int>(1000 * seconds); !done() && left_ms > 0; left_ms -= 10) {
      if (!read(10)) ::poll(nullptr, 0, ended_ ? 10 : 0);
    }
    return done();
  }
  bool read(int wait_ms) {
    pollfd waiting{master_, POLLIN, 0};
    while (!ended_ && ::poll(&waiting, 1, wait_ms) > 0) {
      char text[4096];
      const ssize_t count = ::read(master_, text, sizeof text);
      if (count > 0) screen_.append(text, static_cast<std::size_t>(count));
      if (count == 0 || (count < 0 && errno != EINTR && errno != EAGAIN)) ended_ = true;
      wait_ms = 0;
    }
    return ended_;
  }

  int master_ = -1;
  pid_t pid_ = -1;
  bool ended_ = false;
  std::string screen_;
};

}  // namespace detent::tests
