// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/remedy.h"

#include <algorithm>

namespace detent {
namespace {

struct RemedyNames {
  std::string_view name;
  const char* option;  ///< option to pass; null: none, see commandLineWords
};

RemedyNames namesOf(RemedyKind kind) {
  switch (kind) {
    case RemedyKind::advice:
      return {"advice", nullptr};
    case RemedyKind::giveFrame:
      return {"give-frame", "--frame X0,Y0,X1,Y1"};
    case RemedyKind::giveXAxis:
      return {"give-x-axis", "--x-axis MIN:MAX"};
    case RemedyKind::giveYAxis:
      return {"give-y-axis", "--y-axis MIN:MAX"};
    case RemedyKind::giveXUnit:
      return {"give-x-unit", "--x-unit"};
    case RemedyKind::giveYUnit:
      return {"give-y-unit", "--y-unit"};
    case RemedyKind::pickPress:
      return {"pick-press", "--press-color"};
    case RemedyKind::pickRelease:
      return {"pick-release", "--release-color"};
    case RemedyKind::noRelease:
      return {"no-release", "--no-release"};
    case RemedyKind::addMask:
      return {"add-mask", "--mask X0,Y0,X1,Y1"};
    case RemedyKind::setResolution:
      return {"set-resolution", "--dpi"};
    case RemedyKind::swapStrokes:
      return {"swap-strokes", "--swap-strokes"};
    case RemedyKind::drawPress:
      return {"draw-press", "--press-line X0,Y0,X1,Y1,... along the whole curve"};
    case RemedyKind::drawRelease:
      return {"draw-release", "--release-line X0,Y0,X1,Y1,... along the whole curve"};
    case RemedyKind::chooseSwitch:
      return {"choose-switch", "--curve NAME|N"};
    case RemedyKind::acceptAsIs:
      return {"accept-as-is", "--sure 0"};
    case RemedyKind::choosePage:
      return {"choose-page", "--page"};
    case RemedyKind::chooseGraph:
      return {"choose-graph", "--graph (--list shows the graphs that were found)"};
    case RemedyKind::importAll:
      return {"import-all", "--all"};
    case RemedyKind::raiseLimit:
      return {"raise-limit", nullptr};
  }
  return {"advice", nullptr};
}

/// Returns true if both are given together, like the two sides of one decision.
bool belongTogether(RemedyKind a, RemedyKind b) {
  return (a == RemedyKind::giveXAxis && b == RemedyKind::giveYAxis) ||
         (a == RemedyKind::pickPress && b == RemedyKind::pickRelease) ||
         (a == RemedyKind::choosePage && b == RemedyKind::chooseGraph);
}

}  // namespace

std::string_view nameOf(RemedyKind kind) { return namesOf(kind).name; }

bool Remedies::include(RemedyKind kind) const {
  return std::any_of(all_.begin(), all_.end(), [kind](const Remedy& r) { return r.kind == kind; });
}

std::string commandLineWords(const Remedies& remedies) {
  std::string options, sentences;
  const Remedy* before = nullptr;
  for (const Remedy& remedy : remedies) {
    const std::string words = english(remedy.words);
    if (const char* option = namesOf(remedy.kind).option) {
      if (before) options += belongTogether(before->kind, remedy.kind) ? " and " : ", or ";
      options += option + (words.empty() ? "" : " " + words);
      before = &remedy;
    } else {
      if (!sentences.empty()) sentences += remedy.kind == RemedyKind::raiseLimit ? ", or " : ". ";
      sentences += remedy.kind != RemedyKind::raiseLimit ? words
                   : sentences.empty()                   ? "Raise the limit"
                                                         : "raise the limit";
    }
  }
  if (!options.empty()) options = "Pass " + options;
  return options + (options.empty() || sentences.empty() ? "" : ". ") + sentences;
}

}  // namespace detent
