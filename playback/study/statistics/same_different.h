// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Distance of two stimuli (d') from trials in which two are felt and called the same or different. Macmillan
// & Creelman, Detection Theory: A User's Guide (2005), chapter 9. Any thread.

#include <cstddef>
#include <optional>
#include <vector>

namespace detent::playback {

/// Answers to trials with two different stimuli, and with one stimulus twice.
struct SameDifferentCount {
  std::size_t different = 0, hits = 0;    ///< of those, called different
  std::size_t same = 0, falseAlarms = 0;  ///< of those, called different
  friend bool operator==(const SameDifferentCount&, const SameDifferentCount&) = default;
};

SameDifferentCount sumOf(const std::vector<SameDifferentCount>& counts);

struct SameDifferentDPrime {
  /// The participant compares the difference of the two with a criterion; for mixed pairs. And: each of the
  /// two is identified first, without bias; for one pair that is known. 0 where there are no more hits than
  /// false alarms.
  double differencing = 0, independent = 0;
  double low = 0;              ///< 95 % by the likelihood of the differencing model (Christensen & Brockhoff,
                               ///< Journal de la SFdS 2009), trials independent
  std::optional<double> high;  ///< none: the answers do not bound it
  bool moved = false;          ///< a share of 0 or 1 was moved by half an answer (Macmillan & Kaplan 1985)
};

/// Both kinds of trials must be there.
SameDifferentDPrime dPrimeOf(const SameDifferentCount& count);

/// P(so many hits or more) where nobody tells the two apart, however often each person says "different"; one
/// count for each person, exact.
double guessedP(const std::vector<SameDifferentCount>& persons);

}  // namespace detent::playback
