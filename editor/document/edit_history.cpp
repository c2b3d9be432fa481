// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/document/edit_history.h"

#include <QHash>
#include <QUndoCommand>

#include "model/check.h"

namespace detent::editor {

/// The only command class: a button before and after.
class EditHistory::Step : public QUndoCommand {
 public:
  Step(EditHistory& history, Button before, Button after, const QString& label, QString mergeKey)
      : QUndoCommand(label),
        history_(history),
        before_(std::move(before)),
        after_(std::move(after)),
        mergeKey_(std::move(mergeKey)) {}

  void undo() override {
    DETENT_CHECK(history_.committed_ == after_, "undo starts from exactly what the step left");
    history_.set(before_);
  }
  void redo() override {
    DETENT_CHECK(history_.committed_ == before_, "redo starts from exactly what the step began with");
    history_.set(after_);
  }

  int id() const override { return mergeKey_.isEmpty() ? -1 : 1; }

  bool mergeWith(const QUndoCommand* other) override {
    const auto* step = static_cast<const Step*>(other);  // the id is the same, so the class is the same
    if (step->mergeKey_ != mergeKey_) return false;
    after_ = step->after_;
    setObsolete(after_ == before_);
    return true;
  }

 private:
  EditHistory& history_;
  Button before_, after_;
  QString mergeKey_;
};

EditHistory::EditHistory(Button button, QObject* parent) : QObject(parent), committed_(std::move(button)) {}

void EditHistory::set(const Button& button) {
  committed_ = button;
  emit changed();
}

Result<Button> EditHistory::ruled(const Button& next) const {
  return rule_ ? rule_(committed_, next) : Result<Button>(next);
}

void EditHistory::apply(const Button& next, const QString& label, const QString& mergeKey) {
  DETENT_CHECK(!dragging(), "a step is not applied in the middle of a drag");
  const Result<Button> kept = ruled(next);
  if (!kept) return emit refused(kept.failure());
  if (!(*kept == committed_)) stack_.push(new Step(*this, committed_, *kept, label, mergeKey));
}

void EditHistory::replace(const Button& next, const QString& label) {
  DETENT_CHECK(!dragging(), "a step is not applied in the middle of a drag");
  if (!(next == committed_)) stack_.push(new Step(*this, committed_, next, label, {}));
}

void EditHistory::beginDrag(const QString& label) {
  DETENT_CHECK(!dragging(), "one drag at a time");
  dragLabel_ = label;
}

void EditHistory::preview(const Button& next) {
  DETENT_CHECK(dragging(), "a preview belongs to a drag");
  const Result<Button> kept = ruled(next);
  if (!kept) return emit refused(kept.failure());
  preview_ = *kept;
  emit changed();
}

void EditHistory::finishDrag() {
  DETENT_CHECK(dragging(), "only a drag that has begun can finish");
  const QString label = *dragLabel_;
  const std::optional<Button> dragged = std::move(preview_);
  dragLabel_.reset();
  preview_.reset();
  if (dragged && !(*dragged == committed_)) {
    stack_.push(new Step(*this, committed_, *dragged, label, {}));  // the rule was applied to the preview
  } else if (dragged) {
    emit changed();
  }
}

void EditHistory::cancelDrag() {
  DETENT_CHECK(dragging(), "only a drag that has begun can be cancelled");
  dragLabel_.reset();
  if (!preview_) return;
  preview_.reset();
  emit changed();
}

}  // namespace detent::editor
