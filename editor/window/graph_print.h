// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A button on paper: the page a designer hands over.

class QPrinter;

namespace detent::editor {

class ButtonDocument;
class ViewSettings;

/// One page: the graph as a datasheet has it, the key figures of the state shown, where the graph comes from,
/// and the date; in the person's language and the shown units. False if the printer refused. GUI thread.
bool printGraph(QPrinter& printer, ButtonDocument& document, ViewSettings& settings);

}  // namespace detent::editor
