// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/library/origin.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <utility>

#include "model/text.h"

namespace detent::importer {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t readBytes = 4096;  // a licence states its name at the beginning

std::string beginningOf(const fs::path& file) {
  std::string text(readBytes, '\0');
  std::ifstream in(file, std::ios::binary);
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0)));
  return text;
}

/// The licence file of one folder, the first by name; empty where there is none.
fs::path licenceFileIn(const fs::path& folder) {
  fs::path first;
  std::error_code error;
  for (fs::directory_iterator entry(folder, fs::directory_options::skip_permission_denied, error), end;
       !error && entry != end; entry.increment(error)) {
    const std::string name = lowered(entry->path().filename().string());
    if (!name.starts_with("license") && !name.starts_with("licence") && !name.starts_with("copying"))
      continue;
    std::error_code unknown;
    if (!entry->is_regular_file(unknown)) continue;
    if (first.empty() || entry->path() < first) first = entry->path();
  }
  return first;
}

/// Phrases of licence texts with the usual names of the licences; the first match counts.
constexpr std::array<std::pair<std::string_view, const char*>, 12> licences{{
    {"attribution-noncommercial-sharealike", "CC BY-NC-SA"},
    {"attribution-noncommercial", "CC BY-NC"},
    {"attribution-sharealike", "CC BY-SA"},
    {"attribution 4.0", "CC BY 4.0"},
    {"attribution 3.0", "CC BY 3.0"},
    {"cc0 1.0", "CC0 1.0"},
    {"apache license", "Apache-2.0"},
    {"gnu affero general public license", "AGPL"},
    {"gnu lesser general public license", "LGPL"},
    {"gnu general public license", "GPL"},
    {"mozilla public license", "MPL"},
    {"mit license", "MIT"},
}};

constexpr std::size_t shownBytes = 80;  // shown of a licence whose name is not known

}  // namespace

std::string licenceNamed(std::string_view text) {
  const std::string low = lowered(text);
  for (const auto& [words, name] : licences)
    if (low.find(words) != std::string::npos) return name;
  if (low.find("permission is hereby granted, free of charge") != std::string::npos) return "MIT";
  const std::string_view rest = trimmed(text);
  return std::string(trimmed(rest.substr(0, std::min(rest.find('\n'), shownBytes))));
}

std::string creditFrom(std::string_view gitConfig) {
  const std::size_t key = gitConfig.find("url = ");
  if (key == std::string_view::npos) return {};
  std::string_view url = gitConfig.substr(key + 6);
  url = trimmed(url.substr(0, url.find('\n')));
  if (url.ends_with(".git")) url.remove_suffix(4);
  const std::size_t name = url.find_last_of('/');
  if (name == std::string_view::npos || name == 0) return {};
  const std::size_t owner = url.find_last_of("/:", name - 1);
  if (owner == std::string_view::npos) return {};
  return std::string(url.substr(owner + 1));
}

Origins::Origins(std::string givenLicence, std::string givenCredit)
    : givenLicence_(std::move(givenLicence)), givenCredit_(std::move(givenCredit)) {}

Origin Origins::of(const fs::path& folder, const fs::path& root) {
  Origin origin = found(folder, root);
  if (!givenLicence_.empty()) origin.licence = givenLicence_;
  if (!givenCredit_.empty()) origin.credit = givenCredit_;
  return origin;
}

Origin Origins::found(const fs::path& folder, const fs::path& root) {
  if (const auto known = seen_.find(folder); known != seen_.end()) return known->second;
  Origin origin;
  const bool isRoot = folder == root || folder == folder.parent_path();
  if (!isRoot) origin = found(folder.parent_path(), root);
  if (const fs::path file = licenceFileIn(folder); !file.empty())
    if (std::string name = licenceNamed(beginningOf(file)); !name.empty()) origin.licence = std::move(name);
  if (std::string credit = creditFrom(beginningOf(folder / ".git" / "config")); !credit.empty())
    origin.credit = std::move(credit);
  seen_[folder] = origin;
  return origin;
}

}  // namespace detent::importer
