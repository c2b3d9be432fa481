// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/importing/axis_box.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <QPushButton>
#include <QToolTip>
#include <QVBoxLayout>
#include <utility>

#include "editor/document/graph_colors.h"
#include "editor/importing/axis_quantity.h"
#include "editor/quantity/offered_units.h"

namespace detent::editor {
namespace {

// Marks a field whose text cannot be read and shows the reason beside it. The text stays.
void showRefusal(QLineEdit& edit, const QString& why) {
  QPalette colors = edit.palette();
  colors.setColor(QPalette::Text, why.isEmpty() ? edit.parentWidget()->palette().color(QPalette::Text)
                                                : graphColors(isDark(edit.palette())).refused);
  edit.setPalette(colors);
  edit.setAccessibleDescription(why);
  if (why.isEmpty()) return QToolTip::hideText();
  QToolTip::showText(edit.mapToGlobal(edit.rect().bottomLeft()), why, &edit);
}

void giveUpTyping(QLineEdit& edit) {
  if (!edit.isModified()) return;
  edit.setModified(false);
  showRefusal(edit, {});
}

}  // namespace

AxisBox::AxisBox(ImportState& state, GraphAxis axis, QWidget* parent)
    : QGroupBox(parent),
      state_(state),
      axis_(axis),
      min_(new QLineEdit),
      max_(new QLineEdit),
      unit_(new QComboBox),
      details_(wrappedLabel()),
      extend_(new QPushButton) {
  const bool isX = axis == GraphAxis::x;
  range_ = new OriginMark(state, isX ? QStringLiteral("resetX") : QStringLiteral("resetY"),
                          isX ? tr("Reset displacement axis") : tr("Reset force axis"),
                          [axis](Corrections& c) { c.axis(axis) = {}; });
  unitOrigin_ = new OriginMark(state, isX ? QStringLiteral("resetXUnit") : QStringLiteral("resetYUnit"),
                               isX ? tr("Reset displacement unit") : tr("Reset force unit"),
                               [isX](Corrections& c) { isX ? c.xUnit.reset() : c.yUnit.reset(); });
  nameFields();
  build();
}

void AxisBox::nameFields() {
  const bool isX = axis_ == GraphAxis::x;
  min_->setObjectName(isX ? QStringLiteral("xMin") : QStringLiteral("yMin"));
  max_->setObjectName(isX ? QStringLiteral("xMax") : QStringLiteral("yMax"));
  unit_->setObjectName(isX ? QStringLiteral("xUnit") : QStringLiteral("yUnit"));
  min_->setAccessibleName(isX ? tr("Displacement at the left edge of the plot frame")
                              : tr("Force at the lower edge of the plot frame"));
  max_->setAccessibleName(isX ? tr("Displacement at the right edge of the plot frame")
                              : tr("Force at the upper edge of the plot frame"));
  unit_->setAccessibleName(isX ? tr("Unit of the displacement axis as printed")
                               : tr("Unit of the force axis as printed"));
  for (QLineEdit* edit : {min_, max_}) {
    edit->setMinimumWidth(40);
    edit->setToolTip(edit->accessibleName() + tr(", in the printed unit"));
  }
  unit_->setPlaceholderText(tr("as found"));
  unit_->setToolTip(unit_->accessibleName());
  unit_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  unit_->setMinimumContentsLength(4);  // "ozf", so that the row fits into a narrow window
}

void AxisBox::build() {
  if (axis_ == GraphAxis::x)
    for (const LengthUnit unit : offeredLengthUnits) unit_->addItem(unitText(symbolOf(unit)));
  else
    for (const ForceUnit unit : offeredForceUnits) unit_->addItem(unitText(symbolOf(unit)));
  connect(min_, &QLineEdit::editingFinished, this, [this] { takeEnd(false); });
  connect(max_, &QLineEdit::editingFinished, this, [this] { takeEnd(true); });
  connect(unit_, &QComboBox::activated, this,
          [this](int index) { takeUnit(static_cast<std::size_t>(index)); });
  auto* column = new QVBoxLayout(this);
  column->addLayout(rangeRow());
  column->addWidget(directionRow());
  column->addLayout(originRow());
  column->addLayout(unitRow());
  reserveLines(*details_, 2);
  column->addWidget(details_);
  column->addWidget(extend_);
  extend_->setObjectName(axis_ == GraphAxis::x ? QStringLiteral("xExtend") : QStringLiteral("yExtend"));
  extend_->setToolTip(
      tr("Some tick labels of this axis lie outside the plot frame. Move the edge of the frame to include "
         "them"));
  extend_->hide();
  details_->setForegroundRole(QPalette::PlaceholderText);
}

QHBoxLayout* AxisBox::rangeRow() {
  auto* row = new QHBoxLayout;
  row->setSpacing(3);
  const bool isX = axis_ == GraphAxis::x;
  auto* first = new QLabel(isX ? tr("Left") : tr("Bottom"));
  auto* last = new QLabel(isX ? tr("Right") : tr("Top"));
  first->setBuddy(min_), last->setBuddy(max_);
  for (QWidget* each : std::initializer_list<QWidget*>{first, min_, last, max_, unit_}) row->addWidget(each);
  ofPage_.insert(ofPage_.end(), {first, min_, last, max_});
  return row;
}

// Shown where the printed numbers do not give the direction: two buttons name it, and a click reverses it.
QWidget* AxisBox::directionRow() {
  const bool isX = axis_ == GraphAxis::x;
  direction_ = new QWidget;
  auto* row = new QHBoxLayout(direction_);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(new QLabel(isX ? tr("Displacement grows:") : tr("Force grows:")));
  rises_ = new QToolButton, falls_ = new QToolButton;
  rises_->setText(isX ? tr("to the right") : tr("upwards"));
  falls_->setText(isX ? tr("to the left") : tr("downwards"));
  rises_->setObjectName(isX ? QStringLiteral("xRises") : QStringLiteral("yRises"));
  falls_->setObjectName(isX ? QStringLiteral("xFalls") : QStringLiteral("yFalls"));
  for (QToolButton* button : {rises_, falls_}) {
    button->setCheckable(true);
    button->setFocusPolicy(Qt::StrongFocus);
    row->addWidget(button);
    connect(button, &QToolButton::clicked, this, [this, button] { turn(button == falls_); });
  }
  row->addStretch();
  direction_->hide();
  return direction_;
}

QHBoxLayout* AxisBox::originRow() {
  auto* row = new QHBoxLayout;
  auto* ticks = new QPushButton(tr("Set on page…"));
  ticks->setToolTip(tr("Click ticks of the axis on the page and type their values"));
  connect(ticks, &QPushButton::clicked, this, &AxisBox::ticksRequested);
  auto* name = new QLabel(tr("Range:"));
  row->addWidget(ticks);
  row->addStretch();
  row->addWidget(name);
  row->addWidget(range_);
  ofPage_.insert(ofPage_.end(), {ticks, name});
  return row;
}

QHBoxLayout* AxisBox::unitRow() {
  auto* row = new QHBoxLayout;
  auto* name = new QLabel(tr("Unit:"));
  row->addStretch();
  row->addWidget(name);
  row->addWidget(unitOrigin_);
  ofPage_.push_back(name);
  return row;
}

// ---- what is typed

void AxisBox::takeUnit(std::size_t index) {
  if (axis_ == GraphAxis::x)
    state_.correct(tr("Displacement unit"), [index](Corrections& c) { c.xUnit = offeredLengthUnits[index]; });
  else
    state_.correct(tr("Force unit"), [index](Corrections& c) { c.yUnit = offeredForceUnits[index]; });
}

QuantityReading AxisBox::typedIn(const QLineEdit& field) const {
  const AxisQuantity shownAxis = axisQuantity(axis_, unit_->currentText().toStdString());
  std::optional<double> now = &field == max_ ? maxShown_ : minShown_;
  if (now) *now *= shownUnitOf(shownAxis.quantity, shownAxis.units);
  return readQuantity(field.text(), shownAxis.quantity, shownAxis.units, now);
}

void AxisBox::takeEnd(bool isMax) {
  QLineEdit *edit = isMax ? max_ : min_, *otherEdit = isMax ? min_ : max_;
  if (!edit->isModified()) return;
  const QuantityReading value = typedIn(*edit), other = typedIn(*otherEdit);
  const AxisQuantity shownAxis = axisQuantity(axis_, unit_->currentText().toStdString());
  if (!value.value && takeWithUnit(*edit, isMax)) return;
  showRefusal(*edit, value.value ? QString() : refusalOf(value, shownAxis.quantity, shownAxis.units));
  if (!value.value) return;  // the text stays, so that the user can correct it
  if (other.value && other.shown == value.shown) return showRefusal(*edit, noLength());
  edit->setModified(false);
  const std::optional<double> otherShown = other.value ? std::optional(other.shown) : std::nullopt;
  // the other end was typed first and waited for this one
  const bool bothTyped = otherShown && otherEdit->isModified();
  if (bothTyped) {
    otherEdit->setModified(false);
    showRefusal(*otherEdit, {});
  }
  setEnd(isMax, value.shown, otherShown, bothTyped, {});
}

QString AxisBox::noLength() const {
  return axis_ == GraphAxis::x
             ? tr("Left and right have the same value. Type the value printed at each end.")
             : tr("Bottom and top have the same value. Type the value printed at each end.");
}

// Reads "60 gf" if no unit is known yet: the number and the axis' unit together.
bool AxisBox::takeWithUnit(QLineEdit& edit, bool isMax) {
  if (!unit_->currentText().isEmpty()) return false;
  for (int i = 0; i < unit_->count(); ++i) {
    const AxisQuantity shownAxis = axisQuantity(axis_, unit_->itemText(i).toStdString());
    if (!edit.text().trimmed().endsWith(unit_->itemText(i))) continue;
    const QuantityReading value = readQuantity(edit.text(), shownAxis.quantity, shownAxis.units);
    if (!value.value) continue;
    const QuantityReading other =
        readQuantity((isMax ? min_ : max_)->text(), shownAxis.quantity, shownAxis.units);
    if (other.value && other.shown == value.shown) return false;
    showRefusal(edit, {});
    edit.setModified(false);
    setEnd(isMax, value.shown, {}, false, static_cast<std::size_t>(i));
    return true;
  }
  return false;
}

void AxisBox::setEnd(bool isMax, double value, std::optional<double> other, bool otherToo,
                     std::optional<std::size_t> unit) {
  const bool isX = axis_ == GraphAxis::x;
  state_.correct(isX ? tr("Displacement range") : tr("Force range"), [&](Corrections& c) {
    std::optional<double> min = value, max = otherToo ? other : std::nullopt;
    if (isMax) std::swap(min, max);
    const ImportGraph* graph = state_.current();
    giveEnds(c.axis(axis_), axis_, min, max, graph ? graph->corners() : std::nullopt);
    if (unit && isX) c.xUnit = offeredLengthUnits[*unit];
    if (unit && !isX) c.yUnit = offeredForceUnits[*unit];
  });
}

void AxisBox::turn(bool falls) {
  state_.correct(tr("Direction of the axis"), [&](Corrections& c) {
    AxisCorrection& ends = c.axis(axis_);
    if (ends.min && ends.max && (*ends.min > *ends.max) != falls) std::swap(ends.min, ends.max);
  });
  follow(false);  // the clicked button shows the axis' actual direction again
}

QLineEdit* AxisBox::refusedField() {
  for (const bool isMax : {false, true}) takeEnd(isMax);
  for (QLineEdit* edit : {min_, max_})
    if (edit->isModified() && edit->isVisible()) return edit;
  return nullptr;
}

// ---- what is shown

void AxisBox::follow(bool ofLog) {
  const bool isX = axis_ == GraphAxis::x;
  setTitle(isX ? (ofLog ? tr("Displacement in the file") : tr("Displacement axis (horizontal)"))
               : (ofLog ? tr("Force in the file") : tr("Force axis (vertical)")));
  for (QWidget* each : ofPage_) each->setVisible(!ofLog);
  const ImportGraph* graph = state_.current();
  if (const auto id = graph ? std::optional(graph->id) : std::nullopt; id != shownGraph_) {
    shownGraph_ = id;
    for (QLineEdit* edit : {min_, max_}) giveUpTyping(*edit);
  }
  const auto shown = graph ? (graph->good ? graph->good : graph->last) : nullptr;
  const Corrections none;
  const Corrections& given = graph ? graph->history.now() : none;
  const importer::AxisReading* reading = nullptr;
  std::optional<AxisEnds> onPage;
  if (shown && shown->evidence) {
    const auto& calibration = shown->evidence->axes.calibration.value;
    reading = isX ? &calibration.x : &calibration.y;
    onPage = AxisEnds{reading->min, reading->max};
    if (fallsOnPage(axis_, *shown->evidence)) std::swap(onPage->min, onPage->max);
  }
  const AxisCorrection& correction = given.axis(axis_);
  showEnds(correction, onPage);
  showUnit(given, reading);
  range_->setOrigin(!correction.empty(), reading ? std::optional(reading->sure) : std::nullopt);
  const QString details = detailsOf(correction, reading);
  details_->setText(details);
  details_->setVisible(!ofLog);
  const bool bothGiven = correction.min && correction.max;
  direction_->setVisible(!ofLog && bothGiven && (!reading || reading->ticks.size() < 2));
  falls_->setChecked(bothGiven && *correction.min > *correction.max);
  rises_->setChecked(!falls_->isChecked());
  followExtension(shown && !given.frame ? shown->evidence.get() : nullptr, reading);
}

void AxisBox::followExtension(const importer::GraphEvidence* evidence, const importer::AxisReading* reading) {
  const auto extended = evidence && reading ? extendedFrame(axis_, *evidence) : std::nullopt;
  extend_->disconnect(this);
  extend_->setVisible(extended.has_value());
  if (!extended) return;
  extend_->setText(
      tr("Extend the plot frame from %1 to %2")
          .arg(endText(reading->max, reading->max - reading->min), numberText(extended->value, 5)));
  connect(extend_, &QPushButton::clicked, this, [this, corners = extended->corners] {
    state_.correct(tr("Extend plot frame"), [&](Corrections& c) { c.frame = corners; });
  });
}

// Ends are named by their place on the page, whether the values rise or fall.
void AxisBox::showEnds(const AxisCorrection& given, const std::optional<AxisEnds>& found) {
  const auto show = [&](QLineEdit& edit, std::optional<double>& now, std::optional<double> givenEnd,
                        double foundEnd) {
    now = givenEnd ? givenEnd : found ? std::optional(foundEnd) : std::nullopt;
    if (edit.isModified()) return;
    const QString text = givenEnd ? numberText(*givenEnd, 5)
                         : found  ? endText(foundEnd, std::abs(found->max - found->min))
                                  : QString();
    if (text == edit.text()) return;  // keeps the selection in an unchanged field
    edit.setText(text);
    if (edit.hasFocus()) edit.selectAll();  // the next typed text replaces this one
  };
  show(*min_, minShown_, given.min, found ? found->min : 0);
  show(*max_, maxShown_, given.max, found ? found->max : 0);
}

void AxisBox::showUnit(const Corrections& given, const importer::AxisReading* found) {
  const bool isX = axis_ == GraphAxis::x, isGiven = isX ? given.xUnit.has_value() : given.yUnit.has_value();
  QString unit = found ? QString::fromStdString(found->unit) : QString();
  if (isGiven) unit = isX ? unitText(symbolOf(*given.xUnit)) : unitText(symbolOf(*given.yUnit));
  unit_->setCurrentIndex(unit_->findText(unit));
  unitOrigin_->setOrigin(isGiven);
  if (!isGiven && found) unitOrigin_->say(found->unitFound ? tr("as printed") : tr("not printed, a guess"));
}

QString AxisBox::detailsOf(const AxisCorrection& given, const importer::AxisReading* found) const {
  QStringList details;
  const auto numbers = found ? std::ssize(found->ticks) : 0;
  const auto agreeing = found ? std::ranges::count_if(found->ticks, &importer::TickLabel::agrees) : 0;
  if (given.ticks.size() == 1)
    details << (agreeing > 0 ? tr("1 tick set") : tr("1 tick set; set one more to define the axis"));
  else if (!given.ticks.empty())
    details << tr("%1 ticks set").arg(given.ticks.size());
  if (numbers > 0 && !given.empty())
    details << tr("%1 of %2 printed numbers agree with your values").arg(agreeing).arg(numbers);
  else if (numbers > 0)
    details << tr("%1 of %2 printed numbers used (deviation %3 px)")
                   .arg(agreeing)
                   .arg(numbers)
                   .arg(fixedText(found->residual_px, 2));
  if (found && !found->title.empty()) details << tr("titled “%1”").arg(QString::fromStdString(found->title));
  return details.join(QStringLiteral("; "));
}

}  // namespace detent::editor
