// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The key figures of a document's active state as an editable table.

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

/// One row per figure, in the order of model/key_figures.h, named in the vertical header too. A value typed
/// under `now` is one undo step: the smallest change of the curve that gives it and keeps the kept figures.
/// Values typed under `wanted` are collected; `preview` is the state that has all of them, until it is
/// applied or dropped. Both are solved in a worker: typed values are applied when their solve ends, in the
/// order typed, to the button at that time. GUI thread.
class KeyFiguresModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { figure, now, wanted, keep, columns };
  /// Limit of bent and measured curves in one solve: about 2 s, two and a half times the need of the
  /// samples.
  static constexpr std::size_t mostKnots = 2'000'000;

  KeyFiguresModel(ButtonDocument& document, ViewSettings& settings, QObject* parent = nullptr);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

  static KeyFigure figureOf(const QModelIndex& index) { return static_cast<KeyFigure>(index.row()); }
  /// Reason why a text cannot be read; empty if it can. Does not involve the curve.
  QString refusalOf(const QModelIndex& index, const QString& text) const;

  /// Reason why the active state has no such figure, and how to get it; empty if it has one.
  QString absenceOf(const QModelIndex& index) const;

  /// Doubt about a readable text; empty: none.
  QString doubtOf(const QModelIndex& index, const QString& text) const;

  bool anyWanted() const;
  /// The active state with all requested figures; nullopt without requests, or if impossible.
  const std::optional<ButtonState>& preview() const { return preview_; }
  /// Returns true while a solve runs, or waits for another edit to end.
  bool solving() const { return looking_ || !typed_.empty(); }
  /// Reason why there is no preview; empty with a preview or without requests.
  const QString& conflict() const { return conflict_; }
  /// Stretches of the curve that the preview, or the figure typed last, moves, and the figures that change
  /// with it: "Moves the press between 1.25 and 4 mm. Also changes: Valley force." Empty without either.
  const QString& moves() const { return moves_; }
  /// Clears moves() of the figure typed last; those of a preview stay true.
  void forgetMoves();
  /// Makes the preview one undo step and clears the requests.
  void take();
  void giveUp();

 signals:
  /// A value typed under `now` is impossible; `why` is the reason for the user.
  void refused(const QModelIndex& index, const QString& why);
  void accepted();
  void previewChanged();
  void solvingChanged();

 private:
  /// A typed figure to be applied.
  struct Typed {
    KeyFigure figure;
    double value;
    std::size_t state;
  };
  struct Question {
    Button button;
    std::size_t state = 0;
    std::vector<FigureTarget> targets;
  };
  using Solving = LatestAnswer<Question>;
  static TargetOutcome solved(const Solving::Query& query);
  void solveNext();
  void takeTyped(const TargetOutcome& outcome);
  void takeAhead(const TargetOutcome& outcome);
  void follow();
  void solveAhead();
  /// `set`: figures that the user has set, which are not named.
  QString movesBetween(const ButtonState& before, const ButtonState& after,
                       const std::vector<KeyFigure>& set) const;
  const ButtonState& state() const;
  QString shown(double value, KeyFigure which, bool exact) const;
  /// "Tactile drop 20 cN", for the history.
  QString changeOf(KeyFigure which, double value) const;
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
  QString conflict_, moves_;
  QTimer pause_;
  std::deque<Typed> typed_;  // the first is being solved
  bool looking_ = false;     // a preview is being solved
  Solving typedSolve_, aheadSolve_;
};

/// Quantity of the figure; work, shown in mJ, is a plain number.
Quantity quantityOf(KeyFigure figure);
/// "Peak force", translated.
QString termOf(KeyFigure figure);
/// Definition of the figure, from docs/reference/glossary.md.
QString definitionOf(KeyFigure figure);

}  // namespace detent::editor
