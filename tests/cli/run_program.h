// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Runs a built program in a folder of its own and returns its output, exit code and files.

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <sys/wait.h>

namespace detent::tests {

struct ProgramResult {
  int exitCode = -1;  ///< -1: ended by a signal
  std::string out, err;
};

/// A fresh folder under the current one, removed at the end.
class ProgramFolder {
 public:
  explicit ProgramFolder(const std::string& name) : path_(std::filesystem::current_path() / (name + ".out")) {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ~ProgramFolder() {
    std::error_code error;
    std::filesystem::remove_all(path_, error);
  }
  ProgramFolder(const ProgramFolder&) = delete;
  ProgramFolder& operator=(const ProgramFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
  }
  std::string read(const std::string& name) const {
    std::ifstream file(path_ / name, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }
  std::set<std::string> files() const {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(path_))
      names.insert(entry.path().filename().string());
    return names;
  }

  /// Runs `program` with arguments, started in this folder; its output is kept outside the folder.
  ProgramResult run(const std::string& program, const std::vector<std::string>& arguments) const {
    const std::string out = path_.string() + ".stdout", err = path_.string() + ".stderr";
    std::string command = "cd " + quoted(path_.string()) + " && " + quoted(program);
    for (const std::string& argument : arguments) command.append(" ").append(quoted(argument));
    const int status =
        std::system((command + " >" + quoted(out) + " 2>" + quoted(err) + " </dev/null").c_str());
    ProgramResult result;
    result.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    result.out = contents(out);
    result.err = contents(err);
    std::filesystem::remove(out);
    std::filesystem::remove(err);
    return result;
  }

 private:
  static std::string quoted(const std::string& text) {
    std::string out(1, '\'');
    for (char c : text) {
      if (c == '\'')
        out.append("'\\''");
      else
        out.push_back(c);
    }
    out.push_back('\'');
    return out;
  }
  static std::string contents(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }
  std::filesystem::path path_;
};

}  // namespace detent::tests
