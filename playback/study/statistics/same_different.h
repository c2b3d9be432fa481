// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Distance of two stimuli (d') from trials in which two are felt and called the same or different. Macmillan
// & Creelman, Detection Theory: A User's Guide (2005), chapter 9. Any thread.

#include <cstddef>
#include <optional>
#include <vector>

namespace detent::playback {

/// Counts of answers to trials with two different stimuli, and with one stimulus twice.
struct SameDifferentCount {
  /// trials with different stimuli, and how many of them were called different
  std::size_t different = 0, hits = 0;
  /// trials with equal stimuli, and how many of them were called different
  std::size_t same = 0, falseAlarms = 0;
  friend bool operator==(const SameDifferentCount&, const SameDifferentCount&) = default;
};

SameDifferentCount sumOf(const std::vector<SameDifferentCount>& counts);

struct SameDifferentDPrime {
  /// `differencing`: for mixed pairs, the participant compares the difference of the two with a criterion.
  /// `independent`: for one known pair, each of the two is identified first, without bias. 0 if there are no
  /// more hits than false alarms.
  double differencing = 0, independent = 0;
  /// lower end of the 95 % interval by the likelihood of the differencing model (Christensen & Brockhoff,
  /// Journal de la SFdS 2009), with independent trials
  double low = 0;
  std::optional<double> high;  ///< upper end; none if the answers do not bound it
  bool moved = false;          ///< a share of 0 or 1 was moved by half an answer (Macmillan & Kaplan 1985)
};

/// There must be trials of both kinds.
SameDifferentDPrime dPrimeOf(const SameDifferentCount& count);

/// Exact probability of at least as many hits if nobody can distinguish the two stimuli, however often each
/// person says "different". `persons` has one count for each person.
double guessedP(const std::vector<SameDifferentCount>& persons);

}  // namespace detent::playback
