// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/statistics/shuffle.h"

#include "model/sha256.h"

namespace detent::playback {

StudyRandom randomSeededBy(std::string_view text) {
  constexpr std::size_t hexDigitsOf64Bits = 16;
  return StudyRandom(std::stoull(sha256Hex(text).substr(0, hexDigitsOf64Bits), nullptr, 16));
}

}  // namespace detent::playback
