// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/key_figures_panel.h"

#include <algorithm>
#include <QCheckBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>

#include "editor/document/graph_colors.h"
#include "editor/document/names_in_sight.h"
#include "editor/document/trouble_label.h"
#include "editor/panels/figure_drawing.h"
#include "editor/panels/key_figures_model.h"
#include "editor/panels/value_delegate.h"

namespace detent::editor {
namespace {

constexpr QSize panelPictureSize(132, 84);
constexpr int leastNumber = 3;  // characters before the decimal sign
constexpr int leastName = 9;    // characters of an elided name, as those of a tab
// Shown unless all figures are requested: those that datasheets give.
constexpr KeyFigure firstFigures[] = {
    KeyFigure::preTravel, KeyFigure::operatingForce, KeyFigure::peakForce,   KeyFigure::drop,
    KeyFigure::snapRatio, KeyFigure::resetTravel,    KeyFigure::totalTravel, KeyFigure::bottomOutForce};
constexpr int figureTextMargin_px = 12;
constexpr int leastWithMeaning_px = 340;
constexpr int patience_ms = 200;  // a shorter solve is not announced

}  // namespace

QString figuresText(const ButtonState& state, const DisplayUnits& units) {
  const KeyFigures figures = keyFiguresOf(state);
  QStringList lines;
  for (std::size_t i = 0; i < keyFigureCount; ++i) {
    const auto which = static_cast<KeyFigure>(i);
    if (!figures[which]) continue;
    const Quantity quantity = quantityOf(which);
    const bool isWork = keyFigureNames()[i].unit == FigureUnit::mJ;
    const QString unit = isWork ? QStringLiteral("mJ") : symbolOf(quantity, units);
    lines << QStringList{termOf(which), quantityText(*figures[which], quantity, units), unit}.join('\t');
  }
  return lines.join('\n') + '\n';
}

KeyFiguresPanel::KeyFiguresPanel(ButtonDocument& document, ViewSettings& settings, QWidget* parent)
    : QWidget(parent),
      model_(new KeyFiguresModel(document, settings, this)),
      table_(described(new ValueTable, "keyFiguresTable", {}, tr("Key figures of the button"))),
      about_(new QWidget),
      picture_(described(new QLabel, "keyFigurePicture")),
      meaning_(described(new QLabel, "keyFigureMeaning")),
      trouble_(new TroubleLabel("keyFiguresTrouble")),
      all_(described(new QCheckBox(tr("A&ll figures")), "allFigures",
                     tr("Show all key figures, not only the most used ones"))),
      take_(described(new QPushButton(tr("&Apply")), "takeFigures",
                      tr("Change the curve so that it has the target figures"))),
      giveUp_(described(new QPushButton(tr("&Cancel")), "giveUpFigures", tr("Clear all targets"))),
      solving_(described(new QLabel(tr("Solving…")), "keyFiguresSolving")),
      moves_(described(new QLabel, "keyFiguresMoves")) {
  setObjectName(QStringLiteral("keyFiguresPanel"));
  table_->setModel(model_);
  delegate_ = new ValueDelegate(
      [this](const QModelIndex& cell, const QString& text) { return model_->refusalOf(cell, text); },
      [this](const QModelIndex& cell, const QString& text) { return model_->doubtOf(cell, text); }, table_);
  table_->setItemDelegate(delegate_);
  table_->setVerticalHeader(new ShorteningHeader(Qt::Vertical, Qt::ElideRight, table_));
  table_->verticalHeader()->hide();
  table_->setUpForNumbers();
  table_->setTextElideMode(Qt::ElideMiddle);  // spring rates differ at the end of their names
  meaning_->setWordWrap(true);
  solving_->setMargin(6);
  solving_->hide();
  moves_->setMargin(6);
  moves_->setWordWrap(true);
  moves_->hide();
  patience_.setSingleShot(true);
  patience_.setInterval(patience_ms);
  setFocusProxy(table_);

  about_->setMinimumHeight(1);  // lets the window become low, at which this part is hidden
  auto* aboutLayout = new QHBoxLayout(about_);
  aboutLayout->setContentsMargins(6, 6, 6, 6);
  aboutLayout->addWidget(picture_);
  aboutLayout->addWidget(meaning_, 1);
  auto* buttons = new QHBoxLayout;
  buttons->setContentsMargins(6, 0, 6, 6);
  buttons->addWidget(all_);
  buttons->addStretch(1);
  buttons->addWidget(take_);
  buttons->addWidget(giveUp_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(table_, 1);
  layout->addWidget(solving_);
  layout->addWidget(moves_);
  layout->addWidget(trouble_);
  layout->addLayout(buttons);
  layout->addWidget(about_);

  connect(delegate_, &ValueDelegate::refused, this, &KeyFiguresPanel::showRefusal);
  connect(model_, &KeyFiguresModel::refused, this, &KeyFiguresPanel::showRefusal);
  connect(model_, &KeyFiguresModel::accepted, this, [this] { trouble_->say({}); });
  connect(model_, &KeyFiguresModel::previewChanged, this, &KeyFiguresPanel::showPreview);
  connect(model_, &KeyFiguresModel::solvingChanged, this, &KeyFiguresPanel::showSolving);
  connect(&patience_, &QTimer::timeout, solving_, &QLabel::show);
  connect(&document, &ButtonDocument::changed, this, [this] {
    trouble_->say(model_->conflict());
    showMoves();
  });
  connect(model_, &QAbstractItemModel::headerDataChanged, this, &KeyFiguresPanel::layOut);
  connect(table_, &ValueTable::editRefused, this, [this](const QModelIndex& cell) {
    if (const QString why = model_->absenceOf(cell); !why.isEmpty()) showRefusal(cell, why);
  });
  connect(model_, &QAbstractItemModel::dataChanged, this, &KeyFiguresPanel::showMeaning);
  connect(model_, &QAbstractItemModel::dataChanged, this, &KeyFiguresPanel::layOut);
  connect(table_->selectionModel(), &QItemSelectionModel::currentChanged, this, [this] {
    trouble_->say(model_->conflict());
    showMoves();
    showMeaning();
  });
  connect(all_, &QCheckBox::toggled, this, &KeyFiguresPanel::showRows);
  connect(table_, &QAbstractItemView::clicked, this, [this](const QModelIndex& cell) {
    if (cell.column() == KeyFiguresModel::now && cell.data().toString() == KeyFiguresModel::tr("Set…"))
      emit contactsRequested();
  });
  connect(take_, &QPushButton::clicked, model_, &KeyFiguresModel::take);
  connect(giveUp_, &QPushButton::clicked, model_, &KeyFiguresModel::giveUp);
  table_->viewport()->installEventFilter(this);
  showRows();
  showPreview();
  table_->setCurrentIndex(model_->index(static_cast<int>(KeyFigure::peakForce), KeyFiguresModel::now));
  showMeaning();
}

// A figure that is locked or has a target is always shown.
void KeyFiguresPanel::showRows() {
  const auto isSet = [this](int row) {
    return model_->index(row, KeyFiguresModel::keep).data(Qt::CheckStateRole) == Qt::Checked ||
           model_->index(row, KeyFiguresModel::wanted).data(Qt::FontRole).value<QFont>().bold();
  };
  for (int row = 0; row < model_->rowCount(); ++row) {
    const bool first = std::ranges::find(firstFigures, static_cast<KeyFigure>(row)) != std::end(firstFigures);
    table_->setRowHidden(row, !first && !all_->isChecked() && !isSet(row));
  }
  layOut();
}

// Numbers get the width they need, names the rest. In a narrow panel the targets, whose units stand beside
// them under `now`, have none, and names are elided, so that the boxes of `keep` are visible.
void KeyFiguresPanel::layOut() {
  int name_px = 0;
  for (int row = 0; row < model_->rowCount(); ++row)
    if (!table_->isRowHidden(row))
      name_px = std::max(name_px, table_->fontMetrics().horizontalAdvance(
                                      model_->index(row, KeyFiguresModel::figure).data().toString()));
  name_px += figureTextMargin_px;
  const int keep_px = table_->horizontalHeader()->sectionSizeHint(KeyFiguresModel::keep);
  table_->setColumnWidth(KeyFiguresModel::keep, keep_px);
  const auto othersIf = [&](bool narrow) {
    return keep_px + layOutNumbers(KeyFiguresModel::now, narrow) +
           layOutNumbers(KeyFiguresModel::wanted, narrow);
  };
  int others_px = othersIf(false);
  if (name_px + others_px > widthForColumns_px(*table_)) others_px = othersIf(true);
  const int leastName_px = leastName * table_->fontMetrics().averageCharWidth();
  keepNamesInSight(*table_, {KeyFiguresModel::figure, name_px, others_px, leastName_px});
}

/// Sets the column's width for its numbers and returns it in pixels.
int KeyFiguresPanel::layOutNumbers(int column, bool narrow) {
  const bool withUnits = !narrow || column == KeyFiguresModel::now;
  const int digit_px = table_->fontMetrics().horizontalAdvance(QLatin1Char('0'));
  int before_px = narrow ? 0 : leastNumber * digit_px, after_px = 0;
  QString widest;
  for (int row = 0; row < model_->rowCount(); ++row) {
    if (table_->isRowHidden(row)) continue;
    const QModelIndex cell = model_->index(row, column);
    const QVariant font = cell.data(Qt::FontRole);  // targets are bold
    const QFontMetrics metrics(font.isValid() ? font.value<QFont>().resolve(table_->font()) : table_->font());
    const auto [before, after] = ValueDelegate::atDecimal(cell, withUnits);
    before_px = std::max(before_px, metrics.horizontalAdvance(before));
    if (const int this_px = metrics.horizontalAdvance(after); this_px > after_px)
      after_px = this_px, widest = after;
  }
  delegate_->alignDecimals(column, widest, withUnits);
  table_->setColumnWidth(column, std::max(before_px + after_px + figureTextMargin_px,
                                          table_->horizontalHeader()->sectionSizeHint(column)));
  return table_->columnWidth(column);
}

// On a small screen the explanation is hidden first.
void KeyFiguresPanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  about_->setVisible(height() >= leastWithMeaning_px);
}

// The drawing beside the meaning has the colours of the theme.
void KeyFiguresPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) showMeaning();
}

// The viewport has its size only when the table is shown.
bool KeyFiguresPanel::eventFilter(QObject* object, QEvent* event) {
  if (object == table_->viewport() && event->type() == QEvent::Resize) layOut();
  return QWidget::eventFilter(object, event);
}

void KeyFiguresPanel::showMeaning() {
  const QModelIndex current = table_->currentIndex();
  if (!current.isValid()) return;
  const KeyFigure figure = KeyFiguresModel::figureOf(current);
  const GraphColors colors = graphColors(isDark(palette()));
  picture_->setPixmap(keyFigurePicture(panelPictureSize, devicePixelRatioF(), figure, colors));
  picture_->setAccessibleName(termOf(figure));
  QString text = QStringLiteral("<b>%1</b><br>%2").arg(termOf(figure), definitionOf(figure).toHtmlEscaped());
  if (const QString why = model_->absenceOf(current); !why.isEmpty())
    text += QStringLiteral("<br><i>%1</i>").arg(why.toHtmlEscaped());
  meaning_->setText(text);
}

// A disabled button loses the keyboard focus, and Qt gives it to the next widget.
void KeyFiguresPanel::showPreview() {
  if ((take_->hasFocus() && !model_->preview()) || (giveUp_->hasFocus() && !model_->anyWanted()))
    table_->setFocus();
  take_->setEnabled(model_->preview().has_value());
  giveUp_->setEnabled(model_->anyWanted());
  trouble_->say(model_->conflict());
  showMoves();
}

void KeyFiguresPanel::showMoves() {
  moves_->setText(model_->moves());
  moves_->setVisible(!model_->moves().isEmpty());
}

void KeyFiguresPanel::showSolving() {
  if (!model_->solving()) {
    patience_.stop();
    return solving_->hide();
  }
  if (!patience_.isActive() && solving_->isHidden()) patience_.start();
}

void KeyFiguresPanel::showRefusal(const QModelIndex& index, const QString& why) {
  trouble_->say(why);
  model_->forgetMoves();
  moves_->hide();  // it would be read as a consequence of the refused value
  table_->scrollTo(index);
}

}  // namespace detent::editor
