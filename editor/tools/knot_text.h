// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Stretches of a graph as text for the clipboard: between tabs, windows, and spreadsheets.

#include <optional>
#include <QString>
#include <vector>

#include "editor/canvas/graph_marks.h"
#include "model/edits.h"

namespace detent::editor {

/// Knots of the two strokes by displacement; empty for a stroke without any.
struct GraphStretch {
  std::vector<Knot> press, release;
  bool empty() const { return press.empty() && release.empty(); }
  friend bool operator==(const GraphStretch&, const GraphStretch&) = default;
};

/// The stretch of each stroke between its first and last selected knot, or a section with knots at its ends.
/// Empty if nothing of a stroke is selected.
GraphStretch stretchOfMarks(const std::vector<MarkId>& marks, const ButtonState& state,
                            const GraphValues& values);

/// A header and a line per knot, in mm, N and N/mm with decimal points, whatever the locale and the shown
/// units; numbers come back bit for bit.
QString textOf(const GraphStretch& stretch);
/// The stretch that textOf() wrote; nullopt for any other text.
std::optional<GraphStretch> stretchFrom(const QString& text);

/// Replaces the same range of the strokes that the stretch has. Refused for a missing release.
Result<Button> pasteStretch(const Button& button, std::size_t state, const GraphStretch& stretch);

}  // namespace detent::editor
