// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What people keep beside a button in its file: remarks, earlier forms, and what an edit has to keep together. No part of the
// button: nothing here is felt, and two buttons that differ in it alone are the same.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "model/button.h"
#include "model/sections.h"

namespace detent {

/// A remark at a place of a stroke; it stands on the curve whatever becomes of that.
struct Note {
  std::size_t state = 0;  ///< counted from 0; of a state the button does not have: kept, not shown
  Stroke stroke = Stroke::press;
  double displacement_mm = 0;  ///< beyond the stroke: at its nearer end
  std::string text;            ///< not empty
  friend bool operator==(const Note&, const Note&) = default;
};

/// A form of the button under a name.
struct NamedVersion {
  std::string name;                 ///< not empty, unique in the file
  std::string saved;                ///< ISO 8601, UTC; empty where not known
  std::vector<ButtonState> states;  ///< a valid button's
  friend bool operator==(const NamedVersion&, const NamedVersion&) = default;
};

/// A place of a stroke whose force and displacement no edit changes.
struct PinnedPoint {
  std::size_t state = 0;  ///< counted from 0
  Stroke stroke = Stroke::press;
  double displacement_mm = 0;
  friend bool operator==(const PinnedPoint&, const PinnedPoint&) = default;
};

/// What edits keep together.
struct EditLinks {
  bool oneTravelEnd = false;  ///< both strokes of all states end at one displacement
  std::optional<double>
      releaseBelowPress_N;  ///< >= 0: each release is its press less this (mirrorPressToRelease)
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
