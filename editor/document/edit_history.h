// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Undo by value (docs/develop/architecture.md): a button is a few hundred bytes, so a step keeps the button
// before and after. A drag is one step, a cancelled drag restores, a step without change is dropped.

#include <functional>
#include <optional>
#include <QObject>
#include <QString>
#include <QUndoStack>

#include "model/button.h"

namespace detent::editor {

/// The edited button and its history. GUI thread.
class EditHistory : public QObject {
  Q_OBJECT

 public:
  explicit EditHistory(Button button, QObject* parent = nullptr);

  /// The shown button: the preview of a running drag, else the committed one.
  const Button& button() const { return preview_ ? *preview_ : committed_; }
  const Button& committed() const { return committed_; }

  /// Changes an edit before it is shown or stored, or refuses it (model/links.h). `before`: the committed
  /// button.
  using Rule = std::function<Result<Button>(const Button& before, const Button& next)>;
  void setRule(Rule rule) { rule_ = std::move(rule); }
  /// Returns `next` with the rule applied to it, as apply and preview do.
  Result<Button> ruled(const Button& next) const;

  /// One finished step. Consecutive steps with the same non-empty `mergeKey` become one (arrow keys).
  void apply(const Button& next, const QString& label, const QString& mergeKey = {});
  /// One step to a button that does not come from an edit: one read from a file, recovered, or an earlier
  /// version. No rule is applied.
  void replace(const Button& next, const QString& label);

  /// A drag: any number of previews, then finish (one step) or cancel (restores). Previews are no steps.
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
  /// The result of `button()` changed.
  void changed();
  /// The rule refused a step or preview; nothing changed.
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
