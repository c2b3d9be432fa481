// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Shuffles that give the same order on every machine: the C++ standard fixes the generator, but not the
// distributions of the standard library.

#include <cstdint>
#include <random>
#include <string_view>
#include <utility>
#include <vector>

namespace detent::playback {

/// Name of the random generator and shuffle, as a study's files state it.
inline constexpr const char* generatorName = "mt19937_64, Fisher-Yates by rejection";
using StudyRandom = std::mt19937_64;

/// A generator seeded by a text: the first 64 bits of its SHA-256.
StudyRandom randomSeededBy(std::string_view text);

/// Uniform in 0 <= result < bound. bound >= 1.
inline std::uint64_t drawBelow(StudyRandom& random, std::uint64_t bound) {
  const std::uint64_t usable = StudyRandom::max() - StudyRandom::max() % bound;
  for (;;) {
    const std::uint64_t drawn = random();
    if (drawn < usable) return drawn % bound;
  }
}

/// 0 <= result < 1.
inline double drawShare(StudyRandom& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

template <class Item>
void shuffle(std::vector<Item>& items, StudyRandom& random) {
  for (std::size_t left = items.size(); left > 1; --left)
    std::swap(items[left - 1], items[drawBelow(random, left)]);
}

}  // namespace detent::playback
