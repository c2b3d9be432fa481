// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Shows whether a value of an import was found or given, and restores the found one.

#include <functional>
#include <optional>
#include <QLabel>
#include <QToolButton>

#include "editor/importing/import_state.h"

namespace detent::editor {

/// "found, 98 % sure" or "given" with a button that resets. GUI thread.
class OriginMark : public QWidget {
  Q_OBJECT

 public:
  /// `reset` is applied to the current graph as the step `label`; `state` must outlive this. `name` is the
  /// button's.
  OriginMark(ImportState& state, const QString& name, const QString& label,
             std::function<void(Corrections&)> reset, QWidget* parent = nullptr);

  /// Shows the origin. A found value without a confidence shows nothing.
  void setOrigin(bool given, std::optional<double> confidence = {});
  /// Sets other words for a found value.
  void say(const QString& words) { words_->setText(words); }
  void setResettable(bool resettable) { reset_->setVisible(resettable); }

 private:
  QLabel* words_;
  QToolButton* reset_;
};

/// The finding of one step among the evidence; null without evidence or where the step did not run.
const importer::StepFinding* stepOf(const std::shared_ptr<const importer::GraphEvidence>& evidence,
                                    importer::ImportStep step);
std::optional<double> confidenceOf(const std::shared_ptr<const importer::GraphEvidence>& evidence,
                                   importer::ImportStep step);

/// A label that wraps and whose text can be copied.
QLabel* wrappedLabel();
/// Gives the label the height of so many lines even with less text, so that nothing below it moves.
void reserveLines(QLabel& label, int lines);

}  // namespace detent::editor
