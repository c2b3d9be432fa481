// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Converts the JSON of each format to waves, before they become samples.

#include <cstddef>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "model/message.h"
#include "model/result.h"
#include "playback/interchange/played_wave.h"
#include "playback/interchange/player_conventions.h"

namespace detent::playback {

struct ReferenceWaves {
  std::vector<PlayedWave> waves;
  std::size_t events = 0;
  std::vector<Message> notes;

  /// Adds a note unless it is there already.
  void note(Message message);
};

/// A value in a file with its path ("Pattern[3].Event.Time"). Refuses by throwing a Failure, which
/// `referenceFromText` catches: no other function of this folder lets one escape.
class JsonPlace {
 public:
  JsonPlace(const nlohmann::json& value, std::string place, const std::string& file)
      : value_(value), place_(std::move(place)), file_(file) {}

  bool has(const char* key) const { return value_.is_object() && value_.contains(key); }
  /// The member of this name; refuses if this is no object or has no such member.
  JsonPlace at(const char* key) const;
  /// The elements; refuses if this is no list.
  std::vector<JsonPlace> elements() const;
  /// A finite number within [low, high].
  double number(double low, double high) const;
  double numberOr(const char* key, double otherwise, double low, double high) const;
  std::string text() const;
  std::string textOr(const char* key, const std::string& otherwise) const;

  [[noreturn]] void refuse(Message problem, const Message& remedy) const;

 private:
  const nlohmann::json& value_;
  std::string place_;
  const std::string& file_;
};

ReferenceWaves ahapWaves(const JsonPlace& file);
ReferenceWaves hapticWaves(const JsonPlace& file);
ReferenceWaves hjifWaves(const JsonPlace& file);

}  // namespace detent::playback
