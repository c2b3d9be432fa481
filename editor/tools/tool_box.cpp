// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/tool_box.h"

#include "editor/document/message_words.h"
#include "editor/tools/adding_tools.h"
#include "editor/tools/hit_test.h"
#include "editor/tools/select_tool.h"

namespace detent::editor {

ToolBox::ToolBox(ButtonDocument& document, ViewSettings& settings, GraphCanvas& canvas, QObject* parent)
    : QObject(parent),
      canvas_(canvas),
      drag_(document, canvas, [this](const QString& text) { emit said(text); }),
      context_{document,
               settings,
               canvas,
               drag_,
               [this](const QString& text) { emit said(text); },
               [this](FirstValue first) { emit valuesRequested(first); }},
      keyboard_(context_),
      tools_{std::make_unique<SelectTool>(context_),
             addKnotTool(context_),
             addJumpTool(context_),
             panTool(context_),
             zoomTool(context_),
             measureTool(context_)} {
  canvas_.setEvents(this);
  connect(&document.history().stack(), &QUndoStack::indexChanged, this, &ToolBox::graphReplaced);
  connect(&document, &ButtonDocument::activeStateChanged, this, &ToolBox::graphReplaced);
  connect(&document, &ButtonDocument::changed, this, [this] {
    if (!context_.busy()) saySelected(context_);
  });
  connect(&document.history(), &EditHistory::refused, this,
          [this](const Failure& why) { emit said(sentenceOf(why, context_.settings.units())); });
}

ToolBox::~ToolBox() { canvas_.setEvents(nullptr); }

void ToolBox::setTool(ToolKind kind) {
  if (kind == current_) return;
  cancelDrag();
  currentTool().leave();
  current_ = kind;
  currentTool().enter();
  canvas_.setCursor(currentTool().cursor());
  emit toolChanged(kind);
  emit said(currentTool().hint());
}

void ToolBox::cancelDrag() {
  if (!drag_.running()) return;
  drag_.cancel();
  currentTool().dragCancelled();
}

// The start of a drag and the places of a measurement no longer exist.
void ToolBox::graphReplaced() {
  cancelDrag();
  if (canvas_.feedback().measured) currentTool().leave();
}

bool ToolBox::pointerPressed(const PointerInput& input) {
  if (input.button == Qt::RightButton && !drag_.running()) {
    // The menu refers to the mark under the pointer, or to that of the label there.
    const auto marks = marksAt(canvas_, input.at_px);
    const auto mark = marks.empty() ? canvas_.flagAt(input.at_px) : std::optional(marks.front().id);
    if (mark) canvas_.setSelected(mark);
    return true;
  }
  if (input.button == Qt::LeftButton) leftDown_ = true;
  return currentTool().pressed(input);
}

// The mouse release may have gone to a dialog; a move without the button shows this.
bool ToolBox::pointerMoved(const PointerInput& input) {
  if (leftDown_ && !(input.buttons & Qt::LeftButton)) {
    PointerInput lost = input;
    lost.button = Qt::LeftButton;
    pointerReleased(lost);
  }
  return currentTool().moved(input);
}

bool ToolBox::pointerReleased(const PointerInput& input) {
  if (input.button == Qt::LeftButton) leftDown_ = false;
  return currentTool().released(input);
}

bool ToolBox::doubleClicked(const PointerInput& input) { return currentTool().doubleClicked(input); }

bool ToolBox::wantsKey(int key, Qt::KeyboardModifiers modifiers) const {
  if (drag_.running() && key == Qt::Key_Escape) return true;
  return keyboard_.wants(key, modifiers);
}

bool ToolBox::keyPressed(int key, Qt::KeyboardModifiers modifiers) {
  if (drag_.running() && key == Qt::Key_Escape) {
    cancelDrag();
    return true;
  }
  return keyboard_.pressed(key, modifiers);
}

void ToolBox::pointerLeft() {
  if (!drag_.running() && !canvas_.feedback().measured) canvas_.setFeedback({});
}

void ToolBox::contextMenu(const PointerInput&, QPoint global_px) {
  if (!drag_.running()) emit contextMenuRequested(global_px);
}

}  // namespace detent::editor
