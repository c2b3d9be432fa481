// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A button on paper: its name, its graph, its values.

class QPrinter;

namespace detent::editor {

class ButtonDocument;
class GraphWorkspace;
class ViewSettings;

/// One page: the graph over the full width, beneath it tactile points, turns and contacts of the state shown,
/// in the shown units. False if the printer refused. GUI thread.
bool printGraph(QPrinter& printer, const ButtonDocument& document, GraphWorkspace& workspace,
                const ViewSettings& settings);

}  // namespace detent::editor
