// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Remedies for a Failure, doubt or warning. The same remedy is an option on the command line and a tool in
// the editor, so it is a code here and worded there.

#include <concepts>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "model/message.h"

namespace detent {

enum class RemedyKind {
  advice,  ///< free text, the same at every edge
  // Import hints:
  giveFrame,      ///< the plot frame's corners
  giveXAxis,      ///< values at the frame's left and right edge
  giveYAxis,      ///< give the values at the lower and upper edge of the y axis
  giveXUnit,      ///< unit of displacement
  giveYUnit,      ///< unit of force
  pickPress,      ///< the press curve's colour
  pickRelease,    ///< the release curve's colour
  noRelease,      ///< the plot shows no release of this button
  addMask,        ///< mask what is not a curve
  setResolution,  ///< trace a picture of the page in this resolution
  swapStrokes,    ///< exchange press and release
  choosePage,     ///< another page
  chooseGraph,    ///< another graph
  importAll,      ///< every graph
  // Limits:
  raiseLimit,  ///< the limit named in the problem
  // Import hints that only a person can give:
  drawPress,     ///< points along the whole press curve
  drawRelease,   ///< points along the whole release curve
  chooseSwitch,  ///< one of the switches that the plot shows
  acceptAsIs,    ///< the word that the doubtful result is right
};

/// "give-frame": name for scripts.
std::string_view nameOf(RemedyKind kind);

struct Remedy {
  RemedyKind kind = RemedyKind::advice;
  /// For advice: a sentence without its full stop; else the condition after the option: "if the plot stands
  /// elsewhere". May be empty.
  Message words = {};
};

/// Remedies, most likely first. Words alone are advice.
class Remedies {
 public:
  Remedies() = default;
  Remedies(Remedy remedy) : all_{std::move(remedy)} {}
  Remedies(RemedyKind kind) : all_{{kind, {}}} {}
  Remedies(std::initializer_list<Remedy> remedies) : all_(remedies) {}
  template <class Words>
  requires std::constructible_from<Message, const Words&> Remedies(const Words& words) {
    Message message(words);
    if (!message.empty()) all_.push_back({RemedyKind::advice, std::move(message)});
  }

  bool empty() const { return all_.empty(); }
  auto begin() const { return all_.begin(); }
  auto end() const { return all_.end(); }
  bool include(RemedyKind kind) const;
  /// Returns all remedies except those whose kind satisfies `is`.
  template <std::predicate<RemedyKind> Is>
  Remedies without(Is is) const {
    Remedies left = *this;
    std::erase_if(left.all_, [&](const Remedy& each) { return is(each.kind); });
    return left;
  }

 private:
  std::vector<Remedy> all_;
};

/// Returns the wording for command lines: "Pass --x-axis MIN:MAX, or --frame X0,Y0,X1,Y1 if the plot stands
/// elsewhere", without the last full stop. "" without remedies.
std::string commandLineWords(const Remedies& remedies);

}  // namespace detent
