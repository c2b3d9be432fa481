// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/axes/light_model.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <sstream>

#include "importer/lexicon/letters.h"

namespace detent::importer {
namespace {

// Indices of parts in the table of a .traineddata file (tesseract/ccutil/tessdatamanager.h).
constexpr std::size_t wordList = 19, lettersOfLines = 21;
constexpr std::size_t mostParts = 64;
constexpr unsigned firstPrivate = 0xE100,
                   privateCount = 0xF8FF - firstPrivate;  // the engine itself uses U+E003 to U+E009
constexpr std::size_t reserved = 3;  // space, joined, broken: the engine knows them by name

std::string privateName(std::size_t letter) {
  return utf8Of(std::u32string(1, static_cast<char32_t>(firstPrivate + letter)));
}

using Parts = std::vector<std::optional<std::string_view>>;

/// Reads the table: a count and the offsets, -1 for an absent part. Each part ends where the next one begins.
std::optional<Parts> partsOf(std::string_view data) {
  std::int32_t count = 0;
  if (data.size() < sizeof count) return {};
  std::memcpy(&count, data.data(), sizeof count);
  const std::size_t head = sizeof count + static_cast<std::size_t>(std::max(0, count)) * sizeof(std::int64_t);
  if (count <= static_cast<std::int32_t>(lettersOfLines) || count > static_cast<std::int32_t>(mostParts) ||
      data.size() < head)
    return {};
  std::vector<std::int64_t> offsets(static_cast<std::size_t>(count));
  std::memcpy(offsets.data(), data.data() + sizeof count, head - sizeof count);
  Parts parts;
  for (const std::int64_t from : offsets) {
    parts.emplace_back();
    if (from < 0) continue;
    auto to = static_cast<std::int64_t>(data.size());
    for (const std::int64_t other : offsets)
      if (other > from) to = std::min(to, other);
    if (from < static_cast<std::int64_t>(head) || from > to) return {};
    parts.back() = data.substr(static_cast<std::size_t>(from), static_cast<std::size_t>(to - from));
  }
  return parts;
}

std::string joined(const Parts& parts) {
  const auto count = static_cast<std::int32_t>(parts.size());
  std::vector<std::int64_t> offsets;
  auto at = static_cast<std::int64_t>(sizeof count + parts.size() * sizeof(std::int64_t));
  for (const auto& part : parts) {
    offsets.push_back(part ? at : -1);
    if (part) at += static_cast<std::int64_t>(part->size());
  }
  std::string data(static_cast<std::size_t>(at), '\0');
  std::memcpy(data.data(), &count, sizeof count);
  std::memcpy(data.data() + sizeof count, offsets.data(), offsets.size() * sizeof(std::int64_t));
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (parts[i] && !parts[i]->empty())
      std::memcpy(data.data() + static_cast<std::size_t>(offsets[i]), parts[i]->data(), parts[i]->size());
  return data;
}

/// The list of letters with private names. A line has the form LETTER PROPERTIES... NORMAL-FORM, separated by
/// blanks, then a tab and a remark. Empty if the list has another format.
std::string renamedList(std::string_view list, std::vector<std::string>& letters) {
  std::istringstream in{std::string(list)};
  std::string line;
  std::getline(in, line);
  std::string out = line + "\n";
  while (std::getline(in, line)) {
    const std::string properties = line.substr(0, line.find('\t'));
    const auto letterEnd = properties.find(' '), normalAt = properties.rfind(' ');
    if (letterEnd == std::string::npos || letterEnd == 0 || letters.size() >= privateCount) return {};
    letters.push_back(properties.substr(0, letterEnd));
    if (letters.size() <= reserved) {
      out += line + "\n";
      continue;
    }
    const std::string name = privateName(letters.size() - 1);
    out.append(name)
        .append(properties, letterEnd, normalAt - letterEnd)
        .append(" ")
        .append(name)
        .append("\n");
  }
  return letters.size() > reserved ? out : std::string();
}

}  // namespace

std::optional<LightModel> LightModel::from(std::string_view traineddata) {
  auto parts = partsOf(traineddata);
  if (!parts || !(*parts)[lettersOfLines]) return {};
  LightModel model;
  const std::string list = renamedList(*(*parts)[lettersOfLines], model.letters_);
  if (list.empty()) return {};
  (*parts)[lettersOfLines] = list;
  (*parts)[wordList].reset();  // not loaded, because words of a language would turn "gf" into "of"
  model.bytes_ = joined(*parts);
  return model;
}

std::string LightModel::renamed(std::string_view letters) const {
  std::string out;
  for (const char letter : letters) {
    const auto known = std::find(letters_.begin(), letters_.end(), std::string(1, letter));
    if (known != letters_.end()) out += privateName(static_cast<std::size_t>(known - letters_.begin()));
  }
  return out;
}

std::string LightModel::original(std::string_view answer) const {
  std::string out;
  for (std::size_t i = 0; i < answer.size(); ++i) {
    const auto byte = [&](std::size_t k) {
      return i + k < answer.size() ? static_cast<unsigned char>(answer[i + k]) : 0U;
    };
    const unsigned code =
        (byte(0) & 0xF0) == 0xE0 ? (byte(0) & 0x0F) << 12 | (byte(1) & 0x3F) << 6 | (byte(2) & 0x3F) : 0;
    if (code < firstPrivate || code - firstPrivate >= letters_.size()) {
      out += answer[i];
      continue;
    }
    out += letters_[code - firstPrivate];
    i += 2;
  }
  return out;
}

}  // namespace detent::importer
