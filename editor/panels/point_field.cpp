// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/point_field.h"

#include <algorithm>
#include <cmath>
#include <QApplication>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMouseEvent>
#include <utility>

#include "editor/document/described.h"
#include "editor/document/graph_colors.h"
#include "editor/document/message_words.h"
#include "editor/tools/mark_edits.h"
#include "model/edits.h"

namespace detent::editor {
namespace {

constexpr int scrubStep_px = 4;
const QString widest = QStringLiteral("000.0000 cN/mm");
constexpr double away_px = 18;  // from the point, so that it stays visible
constexpr QuantityRange anyLength_mm{-ForceGraph::maxTravel_mm, ForceGraph::maxTravel_mm},
    anyForce{-ForceGraph::maxForce_N, ForceGraph::maxForce_N};

bool isContactPoint(MarkKind kind) {
  return kind == MarkKind::operatingPoint || kind == MarkKind::resetPoint;
}

}  // namespace

ScrubLabel::ScrubLabel(const QString& text, QuantityField& field) : QLabel(text), field_(field) {
  setBuddy(&field);
  setCursor(Qt::SizeHorCursor);
  setToolTip(tr("Drag to the right for more, to the left for less; with Shift ten times as fast"));
}

void ScrubLabel::mousePressEvent(QMouseEvent* event) { taken_px_ = event->pos().x(); }

void ScrubLabel::mouseMoveEvent(QMouseEvent* event) {
  const int steps = (event->pos().x() - taken_px_) / scrubStep_px;
  if (steps == 0) return;
  taken_px_ += steps * scrubStep_px;
  field_.stepBy(event->modifiers() & Qt::ShiftModifier ? 10 * steps : steps);
}

PointField::PointField(ButtonDocument& document, ViewSettings& settings, GraphCanvas& canvas)
    : QFrame(&canvas), document_(document), settings_(settings), canvas_(canvas), trouble_(new QLabel) {
  described(this, "pointField", {}, tr("Values of the selected point"));
  setFrameShape(QFrame::StyledPanel);
  setAutoFillBackground(true);
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(8, 6, 8, 6);
  grid->setVerticalSpacing(3);
  displacement_ = makeRow("pointDisplacement", tr("&Displacement"), Quantity::length);
  force_ = makeRow("pointForce", tr("&Force"), Quantity::force);
  slopeBefore_ = makeRow("pointSlopeBefore", tr("Slope &before"), Quantity::slope);
  slopeAfter_ = makeRow("pointSlope", tr("&Slope"), Quantity::slope);
  described(trouble_, "pointTrouble");
  trouble_->setWordWrap(true);
  grid->addWidget(trouble_, grid->rowCount(), 0, 1, 2);
  hide();
  connect(&document_.history(), &EditHistory::changed, this, [this] {
    if (isOpen() && !document_.history().dragging()) close();  // undone, or removed
  });
  connect(&settings_, &ViewSettings::changed, this, [this] {
    for (Row* row : {&displacement_, &force_, &slopeBefore_, &slopeAfter_})
      row->field->setUnits(settings_.units());
  });
  connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) {
    if (isOpen() && now && now != this && !isAncestorOf(now)) finish();
  });
}

PointField::~PointField() {
  if (isOpen()) cancel();
}

PointField::Row PointField::makeRow(const char* name, const QString& text, Quantity quantity) {
  auto* grid = static_cast<QGridLayout*>(layout());
  Row row;
  row.field = described(new QuantityField(quantity, settings_.units()), name);
  row.field->setRange(quantity == Quantity::length ? anyLength_mm : anyForce);
  row.field->setButtonSymbols(QAbstractSpinBox::NoButtons);  // its name can be dragged, its arrows are keys
  row.field->setFixedWidth(fontMetrics().horizontalAdvance(widest) + row.field->sizeHint().height());
  row.label = new ScrubLabel(text, *row.field);
  row.field->setAccessibleName(QString(text).remove('&'));
  row.field->installEventFilter(this);
  const int at = grid->rowCount();
  grid->addWidget(row.label, at, 0);
  grid->addWidget(row.field, at, 1);
  return row;
}

void PointField::show(Row& row, std::optional<double> value) {
  row.label->setVisible(value.has_value());
  row.field->setVisible(value.has_value());
  row.changed = false;
  row.field->disconnect(this);
  if (!value) return;
  row.field->setValue(*value);
  connect(row.field, &QuantityField::valueChanged, this, [this, &row] {
    row.changed = true;
    preview();
  });
}

void PointField::fill(const Mark& mark) {
  const StrokeCurve& curve = canvas_.state().graph.curve(mark.id.stroke);
  const auto index = isContactPoint(mark.id.kind) ? std::nullopt : knotAt(curve, mark.at.displacement_mm);
  knot_ = index ? std::optional(MarkId{MarkKind::knot, mark.id.stroke, *index}) : std::nullopt;
  show(displacement_, mark.at.displacement_mm);
  show(force_, isContactPoint(mark.id.kind) ? std::nullopt : std::optional(mark.at.force_N));
  const bool corner = index && isCorner(curve, *index);
  const Knot* knot = index ? &curve.knots()[*index] : nullptr;
  const bool before = corner && *index > 0, after = knot && *index + 1 < curve.knots().size();
  show(slopeBefore_, before ? std::optional(knot->slopeBefore_N_per_mm) : std::nullopt);
  show(slopeAfter_, after ? std::optional(knot->slopeAfter_N_per_mm) : std::nullopt);
  slopeAfter_.label->setText(before ? tr("Slope a&fter") : tr("&Slope"));
}

// Beside the point, or above or below it, where it is visible; else in the corner farthest from it.
void PointField::place(CurvePoint at) {
  layout()->activate();
  resize(sizeHint());
  const QPointF point = canvas_.mapping().toPixel(at.displacement_mm, at.force_N);
  const QRectF room = canvas_.rect();
  const double w = width(), h = height();
  const auto within = [](double from, double length, double most) {
    return std::clamp(from, 0.0, std::max(0.0, most - length));
  };
  const double x = within(point.x() - w / 2, w, room.width()),
               y = within(point.y() - h / 2, h, room.height());
  const QPointF candidates[] = {{point.x() + away_px, y},
                                {point.x() - away_px - w, y},
                                {x, point.y() + away_px},
                                {x, point.y() - away_px - h}};
  QPointF chosen(point.x() < room.center().x() ? std::max(0.0, room.width() - w) : 0,
                 point.y() < room.center().y() ? std::max(0.0, room.height() - h) : 0);
  for (const QPointF& place : candidates)
    if (room.contains(QRectF(place, QSizeF(w, h)))) {
      chosen = place;
      break;
    }
  move(chosen.toPoint());
}

bool PointField::open(FirstValue first) {
  auto id = canvas_.selected();
  if (!id || document_.history().dragging()) return false;
  if (id->kind == MarkKind::slopeBefore || id->kind == MarkKind::slopeAfter) id->kind = MarkKind::knot;
  const auto at = placeOf(*id, canvas_.state(), canvas_.values());
  if (!at || id->kind == MarkKind::section) {
    emit said(tr("Select a point to type its values."));
    return false;
  }
  mark_ = Mark{*id, *at};
  questionText_.clear();
  trouble_->clear();
  trouble_->hide();
  fill(*mark_);
  document_.history().beginDrag(tr("Set: %1").arg(nameOf(*id)));
  place(*at);
  QFrame::show();
  raise();
  QuantityField* field =
      first == FirstValue::force && force_.field->isVisible() ? force_.field : displacement_.field;
  field->setFocus(Qt::TabFocusReason);
  field->selectAll();
  return true;
}

// From the original button: first the position, then the slopes at the knot there.
Result<Button> PointField::edited() const {
  const std::size_t state = document_.activeState();
  Result<Button> next = document_.history().committed();
  CurvePoint to = mark_->at;
  if (displacement_.changed) to.displacement_mm = displacement_.field->value();
  if (force_.changed) to.force_N = force_.field->value();
  if (displacement_.changed || force_.changed) next = moveMark(*next, state, *mark_, to);
  for (const Row* row : {&slopeBefore_, &slopeAfter_}) {
    if (!next || !row->changed || !knot_) continue;
    const auto index = knotAt(next->states()[state].graph.curve(knot_->stroke), to.displacement_mm);
    if (!index) continue;
    const MarkKind side = row == &slopeBefore_ ? MarkKind::slopeBefore : MarkKind::slopeAfter;
    next = setMarkSlope(*next, state, {side, knot_->stroke, *index}, row->field->value());
  }
  return next ? document_.history().ruled(*next) : next;
}

void PointField::preview() {
  if (!document_.history().dragging()) return close();  // undone meanwhile
  const Result<Button> next = edited();
  const QString why = next ? QString() : sentenceOf(next.failure(), settings_.units());
  if (next) document_.history().preview(*next);
  QPalette colors = palette();
  colors.setColor(QPalette::WindowText, graphColors(isDark(palette())).refused);
  trouble_->setPalette(colors);
  trouble_->setText(why);
  trouble_->setVisible(!why.isEmpty());
  adjustSize();
}

// Questions an unusual number once.
bool PointField::odd() {
  for (const Row* row : {&displacement_, &force_}) {
    if (!row->changed) continue;
    const QString text = row->field->text();
    const QString question = doubtOf(text, row->field->value(), row->field->quantity(), settings_.units());
    if (question.isEmpty() || text == questionText_) continue;
    questionText_ = text;
    trouble_->setText(question);
    trouble_->show();
    adjustSize();
    return true;
  }
  return false;
}

void PointField::finish() {
  if (!isOpen()) return;
  close();
  if (document_.history().dragging()) document_.history().finishDrag();
}

void PointField::cancel() {
  close();
  if (document_.history().dragging()) document_.history().cancelDrag();
}

void PointField::close() {
  mark_.reset();
  hide();
}

bool PointField::eventFilter(QObject* object, QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride &&
      !(static_cast<QKeyEvent*>(event)->modifiers() & (Qt::ControlModifier | Qt::AltModifier))) {
    event->accept();  // letters typed here select no tool
    return true;
  }
  if (event->type() != QEvent::KeyPress || !isOpen()) return QFrame::eventFilter(object, event);
  const int key = static_cast<QKeyEvent*>(event)->key();
  if (key == Qt::Key_Escape) {
    cancel();
    canvas_.setFocus();
    return true;
  }
  if (key != Qt::Key_Return && key != Qt::Key_Enter) return QFrame::eventFilter(object, event);
  for (const Row* row : {&displacement_, &force_, &slopeBefore_, &slopeAfter_})
    if (row->field->isVisible() && !row->field->acceptable()) {
      trouble_->setText(row->field->refusal());
      trouble_->show();
      adjustSize();
      return true;
    }
  if (!edited() || odd()) return true;  // reported below the fields
  finish();
  canvas_.setFocus();
  return true;
}

}  // namespace detent::editor
