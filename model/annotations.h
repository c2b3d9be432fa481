// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Data stored beside a button in its file: notes, named versions and links. They are not part of the button:
// two buttons that differ only in these are equal.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "model/button.h"
#include "model/sections.h"

namespace detent {

/// A remark at a place on a stroke. It follows the curve when the curve changes.
struct Note {
  std::size_t state = 0;  ///< counted from 0; kept but not shown if the button has no such state
  Stroke stroke = Stroke::press;
  double displacement_mm = 0;  ///< clamped to the stroke
  std::string text;            ///< not empty
  friend bool operator==(const Note&, const Note&) = default;
};

/// A named earlier form of the button.
struct NamedVersion {
  std::string name;                 ///< not empty, unique in the file
  std::string saved;                ///< ISO 8601, UTC; empty if unknown
  std::vector<ButtonState> states;  ///< states of a valid button
  friend bool operator==(const NamedVersion&, const NamedVersion&) = default;
};

/// A place on a stroke whose force and displacement no edit may change.
struct PinnedPoint {
  std::size_t state = 0;  ///< counted from 0
  Stroke stroke = Stroke::press;
  double displacement_mm = 0;
  friend bool operator==(const PinnedPoint&, const PinnedPoint&) = default;
};

/// Constraints that later edits keep.
struct EditLinks {
  /// an edit that moves one stroke's end moves the ends of all strokes of all states
  bool oneTravelEnd = false;
  /// >= 0: each release moves along with edits of its press; their mean distance when the link was last set
  std::optional<double> releaseBelowPress_N;
  std::vector<PinnedPoint> pinned;
  bool empty() const { return !oneTravelEnd && !releaseBelowPress_N && pinned.empty(); }
  friend bool operator==(const EditLinks&, const EditLinks&) = default;
};

struct Annotations {
  std::vector<Note> notes;
  std::vector<NamedVersion> versions;
  EditLinks links;
  bool empty() const { return notes.empty() && versions.empty() && links.empty(); }
  friend bool operator==(const Annotations&, const Annotations&) = default;
};

}  // namespace detent
