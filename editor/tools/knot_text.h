// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Stretches of a graph as text, for the clipboard: between tabs, windows, and spreadsheets.

#include <optional>
#include <QString>
#include <vector>

#include "editor/canvas/graph_marks.h"
#include "model/edits.h"

namespace detent::editor {

/// Knots of the two strokes, each by displacement; a stroke that gives nothing is empty.
struct GraphStretch {
  std::vector<Knot> press, release;
  bool empty() const { return press.empty() && release.empty(); }
  friend bool operator==(const GraphStretch&, const GraphStretch&) = default;
};

/// What the marks cover: of each stroke the stretch between its first and last selected knot, or a section
/// with knots at its ends. Empty where nothing of a stroke is selected.
GraphStretch stretchOfMarks(const std::vector<MarkId>& marks, const ButtonState& state,
                            const GraphValues& values);

/// A header and a line per knot, in mm, N and N/mm with decimal points, whatever the locale and the units
/// shown; the numbers come back bit for bit.
QString textOf(const GraphStretch& stretch);
/// nullopt for any text that is not exactly of this form.
std::optional<GraphStretch> stretchFrom(const QString& text);

/// Puts the stretch where it stood: what is between its ends, of the strokes it has, is replaced. Refused for
/// a release where the graph has none.
Result<Button> pasteStretch(const Button& button, std::size_t state, const GraphStretch& stretch);

}  // namespace detent::editor
