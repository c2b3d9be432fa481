// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Undo by value (docs/develop/architecture.md): a button is a few hundred bytes, so a step keeps the button before
// and after. Three rules: a drag is one step, an unfinished one restores, a step that changes nothing is
// dropped.

#include <functional>
#include <optional>
#include <QObject>
#include <QString>
#include <QUndoStack>

#include "model/button.h"

namespace detent::editor {

/// The button being edited, and every button it has been. GUI thread.
class EditHistory : public QObject {
  Q_OBJECT

 public:
  explicit EditHistory(Button button, QObject* parent = nullptr);

  /// What is shown: the preview of a running drag, else the committed button.
  const Button& button() const { return preview_ ? *preview_ : committed_; }
  const Button& committed() const { return committed_; }

  /// What an edit becomes before it is shown or kept, or why it cannot be (model/links.h). From the committed button.
  using Rule = std::function<Result<Button>(const Button& before, const Button& next)>;
  void setRule(Rule rule) { rule_ = std::move(rule); }
  /// What apply and preview would make of it.
  Result<Button> ruled(const Button& next) const;

  /// One finished step. Steps with the same non-empty `mergeKey` directly after each other become one (arrow
  /// keys).
  void apply(const Button& next, const QString& label, const QString& mergeKey = {});
  /// One step to a button that no hand has made: read again, recovered, an earlier version. Under no rule.
  void replace(const Button& next, const QString& label);

  /// A drag: any number of previews, then finish (one step) or cancel (as before). Previews are no steps.
  void beginDrag(const QString& label);
  void preview(const Button& next);
  void finishDrag();
  void cancelDrag();
  bool dragging() const { return dragLabel_.has_value(); }

  QUndoStack& stack() { return stack_; }
  const QUndoStack& stack() const { return stack_; }

  void markSaved() { stack_.setClean(); }
  bool modified() const { return !stack_.isClean(); }

 signals:
  /// What `button()` gives has changed.
  void changed();
  /// The rule let nothing of a step or preview through; all is as it was.
  void refused(const detent::Failure& why);

 private:
  class Step;
  void set(const Button& button);

  Button committed_;
  std::optional<Button> preview_;
  std::optional<QString> dragLabel_;
  Rule rule_;
  QUndoStack stack_;
};

}  // namespace detent::editor
