// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The key figures of a document's active state as a table that can be typed into.

#include <array>
#include <deque>
#include <optional>
#include <QAbstractTableModel>
#include <QTimer>
#include <vector>

#include "editor/document/button_document.h"
#include "editor/document/latest_request.h"
#include "editor/document/view_settings.h"
#include "editor/quantity/quantity.h"
#include "model/key_figures.h"
#include "model/targets/targets.h"

namespace detent::editor {

/// One row per figure, in the order of model/key_figures.h; its vertical header names them too. What is typed under `now` is one undo step at once: the
/// smallest change of the curve that gives it and leaves the kept figures as they are. What is typed under `wanted` is
/// gathered; `preview` is the state that has all of it, until it is taken or given up. Both are solved beside the window:
/// what is typed is done when its solve has ended, in the order typed, on the button as it is then. GUI thread.
class KeyFiguresModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { figure, now, wanted, keep, columns };
  /// What one solve may bend and measure: some 2 s, and two and a half times what the samples need.
  static constexpr std::size_t mostKnots = 2'000'000;

  KeyFiguresModel(ButtonDocument& document, ViewSettings& settings, QObject* parent = nullptr);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

  static KeyFigure figureOf(const QModelIndex& index) { return static_cast<KeyFigure>(index.row()); }
  /// Why a text cannot stand in a cell; empty where it can be read. Asks nothing of the curve.
  QString refusalOf(const QModelIndex& index, const QString& text) const;

  /// What is odd about a text that can be read; empty: nothing.
  QString doubtOf(const QModelIndex& index, const QString& text) const;

  bool anyWanted() const;
  /// The active state as it would be; empty where nothing is wanted, or where it cannot be had.
  const std::optional<ButtonState>& preview() const { return preview_; }
  /// A solve is under way, or waits until nobody holds the button.
  bool solving() const { return looking_ || !typed_.empty(); }
  /// Why not; empty where there is a preview, or nothing is wanted.
  const QString& conflict() const { return conflict_; }
  /// The preview becomes one undo step, and nothing is wanted any more.
  void take();
  void giveUp();

 signals:
  /// Something typed under `now` cannot be had; `why` says it to the person.
  void refused(const QModelIndex& index, const QString& why);
  void accepted();
  void previewChanged();
  void solvingChanged();

 private:
  /// One figure that is to be had at once.
  struct Typed {
    KeyFigure figure;
    double value;
    std::size_t state;
  };
  struct Asked {
    Button button;
    std::size_t state = 0;
    std::vector<FigureTarget> targets;
  };
  using Solving = LatestAnswer<Asked>;
  static TargetOutcome solved(const Solving::Asked& asked);
  void solveNext();
  void takeTyped(const TargetOutcome& outcome);
  void takeAhead(const TargetOutcome& outcome);
  void follow();
  void lookAhead();
  const ButtonState& state() const;
  QString shown(double value, KeyFigure which, bool exact) const;
  std::vector<FigureTarget> kept() const;
  bool setNow(const QModelIndex& index, const QString& text);
  bool setWanted(const QModelIndex& index, const QString& text);
  std::optional<double> read(const QModelIndex& index, const QString& text) const;

  ButtonDocument& document_;
  ViewSettings& settings_;
  KeyFigures figures_;
  std::array<std::optional<double>, keyFigureCount> wanted_;
  std::array<bool, keyFigureCount> kept_{};
  std::optional<ButtonState> preview_;
  std::optional<Button> previewed_;
  KeyFigures ahead_;
  QString conflict_;
  QTimer pause_;
  std::deque<Typed> typed_;  // the first is being solved
  bool looking_ = false;     // a preview is being solved
  Solving typedSolve_, aheadSolve_;
};

/// What the number means; work, which is shown in mJ, is a plain number.
Quantity quantityOf(KeyFigure figure);
/// "Peak force", in the person's language.
QString termOf(KeyFigure figure);
/// What it is: the sentence of docs/reference/glossary.md.
QString definitionOf(KeyFigure figure);

}  // namespace detent::editor
