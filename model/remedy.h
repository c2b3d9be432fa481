// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What helps against a Failure, a doubt or what a warning speaks of. What a person can do differs from edge to edge
// (an option at the command line, a tool in the editor), so it is named here and worded there.

#include <concepts>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "model/message.h"

namespace detent {

enum class RemedyKind {
  advice,  ///< in words, the same at every edge
  // Decisions of an import that can be given by hand:
  giveFrame,      ///< the plot frame's corners
  giveXAxis,      ///< values at the frame's left and right edge
  giveYAxis,      ///< values at its lower and upper edge
  giveXUnit,      ///< unit of displacement
  giveYUnit,      ///< unit of force
  pickPress,      ///< the press curve's colour
  pickRelease,    ///< the release curve's colour
  addMask,        ///< over what is no curve
  setResolution,  ///< trace a picture of the page, drawn in this resolution
  swapStrokes,    ///< press is release
  choosePage,     ///< another page
  chooseGraph,    ///< another graph
  importAll,      ///< every graph
  // Only where limits can be set:
  raiseLimit,  ///< the limit that the problem names
};

/// "give-frame": as scripts see it.
std::string_view nameOf(RemedyKind kind);

struct Remedy {
  RemedyKind kind = RemedyKind::advice;
  /// Of advice the words, a sentence without its full stop; else what the command line says after the option:
  /// "if the plot stands elsewhere". May be empty.
  Message words = {};
};

/// The likeliest first. Words alone are advice.
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
  /// All but those of a kind that `is` says true of.
  template <std::predicate<RemedyKind> Is>
  Remedies without(Is is) const {
    Remedies left = *this;
    std::erase_if(left.all_, [&](const Remedy& each) { return is(each.kind); });
    return left;
  }

 private:
  std::vector<Remedy> all_;
};

/// As a program says it that takes options: "Pass --x-axis MIN:MAX, or --frame X0,Y0,X1,Y1 if the plot stands
/// elsewhere", without the last full stop. Empty without remedies.
std::string commandLineWords(const Remedies& remedies);

}  // namespace detent
