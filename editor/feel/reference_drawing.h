// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Signals of other programs.

#include <string>
#include <vector>

#include "editor/feel/drawn_signal.h"

namespace detent::editor {

/// An AHAP, .haptic, HJIF or sound file beside a button's own signal.
struct ReferenceDrawing : DrawnSignal {
  std::vector<Message> notes;  ///< parts of the file that are not played, or played differently
};

/// Reads and draws `file`. Some 100 ms; any thread.
ReferenceDrawing referenceDrawingOf(const std::string& file);

}  // namespace detent::editor
