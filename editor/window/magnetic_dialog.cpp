// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/window/magnetic_dialog.h"

#include <algorithm>
#include <cmath>
#include <QDialogButtonBox>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <qcustomplot.h>

#include "editor/canvas/plot_dress.h"
#include "editor/canvas/unit_ticker.h"
#include "editor/document/form_widgets.h"
#include "editor/document/message_words.h"
#include "model/file/svg_plot.h"
#include "model/sampling.h"

namespace detent::editor {
namespace {

using playback::KeyEvent;
using playback::MagneticKeySettings;

constexpr QSize firstMagnetic_px{960, 620}, leastMagneticPlot_px{360, 300};
constexpr double thin_px = 1, curve_px = 2, closed_px = 4, eventSize_px = 11;

}  // namespace

MagneticDialog::MagneticDialog(Button button, const DisplayUnits& units, MagneticChoice choice,
                               QWidget* parent)
    : QDialog(parent),
      button_(std::move(button)),
      units_(units),
      choice_(std::move(choice)),
      readings_(wrappingLabel("magneticReadings")),
      events_(wrappingLabel("magneticEvents")),
      refusal_(wrappingLabel("magneticRefusal")),
      plot_(described(new QCustomPlot, QStringLiteral("magneticPlot"), {},
                      tr("Force graph and movement of the key"))),
      movement_(new QCPAxisRect(plot_)) {
  setObjectName(QStringLiteral("magneticDialog"));
  setWindowTitle(tr("Export for a magnetic keyboard"));
  setUpPlot();
  auto* columns = new QHBoxLayout;
  columns->addLayout(choices());
  columns->addWidget(plot_, 1);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
  accept_ = described(buttons->addButton(tr("&Export…"), QDialogButtonBox::AcceptRole),
                      QStringLiteral("magneticExport"), tr("Choose a location and write the C header"));
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(columns, 1);
  for (QWidget* widget :
       {static_cast<QWidget*>(events_), static_cast<QWidget*>(refusal_), static_cast<QWidget*>(buttons)})
    layout->addWidget(widget);
  resize(firstMagnetic_px);
  showChoice();
}

QLayout* MagneticDialog::choices() {
  const ButtonState& state = button_.states().front();
  const double usual_mm = state.operatingPoint_mm.value_or(state.graph.travel_mm() / 2);
  const playback::RapidTrigger usual;
  auto* form = new QFormLayout;
  actuate_ = lengthField(*form, "magneticActuate", tr("&Actuation point:"),
                         tr("Displacement at which the key closes (switches on)"), usual_mm);
  reset_ = lengthField(*form, "magneticReset", tr("&Release point:"),
                       tr("Displacement at which the key opens on its way up"),
                       playback::settingsFor(state, actuate_->value()).reset_mm);
  rapid_ = checkBox(*form, "magneticRapid", tr("Rapid &trigger"),
                    tr("The key opens and closes as the movement changes direction"));
  press_ = lengthField(*form, "magneticPress", tr("&Press distance:"),
                       tr("How far the key moves down from its highest position before it closes"),
                       usual.press_mm);
  release_ =
      lengthField(*form, "magneticRelease", tr("Release &distance:"),
                  tr("How far the key moves up from its deepest position before it opens"), usual.release_mm);
  continuous_ = checkBox(
      *form, "magneticContinuous", tr("&Continuous"),
      tr("Rapid trigger stays active until the key is fully released, even above the release point"));
  top_ = lengthField(*form, "magneticTop", tr("T&op dead zone:"),
                     tr("First part of the travel, in which the key is always open"), 0);
  bottom_ = lengthField(*form, "magneticBottom", tr("&Bottom dead zone:"),
                        tr("Last part of the travel, in which the key is always closed"), 0);
  down_ = lengthField(*form, "magneticDown", tr("Presses go do&wn to:"),
                      tr("How deep both presses of the example movement go"), state.graph.travel_mm());
  up_ =
      lengthField(*form, "magneticUp", tr("and &up to:"),
                  tr("Displacement at which the second press of the example movement begins"), usual_mm / 2);
  auto* read = plainButton("magneticRead", tr("Readin&gs…"),
                           tr("Load the readings of your sensor over the travel from a CSV file"));
  showReadings();
  auto* format = wrappingLabel(QStringLiteral("magneticFormat"));
  format->setText(tr("For your own sensor: a CSV file of two columns, the displacement from rest in mm, "
                     "increasing, and the reading in counts of your converter, which only rises or only "
                     "falls. Two rows or more. Example:") +
                  QStringLiteral("\ndisplacement_mm,reading\n0,2048\n2,2410\n4,3480"));
  connect(read, &QPushButton::clicked, this, [this] {
    const QString file =
        QFileDialog::getOpenFileName(this, tr("Readings of the sensor"), {}, tr("CSV") + " (*.csv)");
    if (!file.isEmpty()) readSensor(file);
  });
  auto* column = new QVBoxLayout;
  column->addLayout(form);
  for (QWidget* widget :
       {static_cast<QWidget*>(readings_), static_cast<QWidget*>(format), static_cast<QWidget*>(read)})
    column->addWidget(widget);
  column->addStretch(1);
  return column;
}

// Until it is typed, the release point keeps the button's own distance to the actuation point, or the usual
// one.
void MagneticDialog::take(const QuantityField& field) {
  choice_.typed[field.objectName()] = field.value();
  if (&field == actuate_ && !choice_.typed.contains(reset_->objectName())) {
    const QSignalBlocker silent(reset_);
    reset_->setValue(playback::settingsFor(button_.states().front(), actuate_->value()).reset_mm);
  }
  showChoice();
}

void MagneticDialog::setUpPlot() {
  plot_->plotLayout()->addElement(1, 0, movement_);
  putLegendAbove(*plot_);
  auto* margins = new QCPMarginGroup(plot_);
  for (QCPAxisRect* rect : {plot_->axisRect(), movement_}) {
    rect->setMarginGroup(QCP::msLeft | QCP::msRight, margins);
    for (const auto side : {QCPAxis::atBottom, QCPAxis::atLeft})
      rect->axis(side)->setTicker(QSharedPointer<UnitTicker>::create());
  }
  movement_->axis(QCPAxis::atLeft)->setRangeReversed(true);
  plot_->setMinimumSize(leastMagneticPlot_px);
}

QuantityField* MagneticDialog::lengthField(QFormLayout& form, const char* name, const QString& label,
                                           const QString& tip, double value_mm) {
  auto* field = described(new QuantityField(Quantity::length, units_), QString::fromLatin1(name), tip, tip);
  field->setRange({0, button_.states().front().graph.travel_mm()});
  field->setValue(choice_.typed.value(field->objectName(), value_mm).toDouble());
  form.addRow(label, field);
  fields_.push_back(field);
  connect(field, &QuantityField::valueChanged, this, [this, field] { take(*field); });
  connect(field, &QuantityField::refusalChanged, this, &MagneticDialog::showChoice);
  return field;
}

QCheckBox* MagneticDialog::checkBox(QFormLayout& form, const char* name, const QString& text,
                                    const QString& tip) {
  auto* box = described(new QCheckBox(text), QString::fromLatin1(name), tip);
  box->setChecked(choice_.typed.value(box->objectName()).toBool());
  form.addRow(box);
  connect(box, &QCheckBox::toggled, this, [this, box](bool on) {
    choice_.typed[box->objectName()] = on;
    showChoice();
  });
  return box;
}

MagneticKeySettings MagneticDialog::settings() const {
  MagneticKeySettings settings = playback::settingsFor(button_.states().front(), actuate_->value());
  settings.reset_mm = reset_->value();
  if (rapid_->isChecked())
    settings.rapid = playback::RapidTrigger{press_->value(), release_->value(), continuous_->isChecked()};
  settings.topDeadZone_mm = top_->value();
  settings.bottomDeadZone_mm = bottom_->value();
  return settings;
}

std::vector<double> MagneticDialog::turns_mm() const {
  return {0, down_->value(), up_->value(), down_->value(), 0};
}

std::string MagneticDialog::header() const {
  const double travel_mm = button_.states().front().graph.travel_mm();
  const auto assumed = playback::MagneticSensor::assumed(travel_mm, playback::usualNoise);
  return playback::keyHeaderFrom(button_, choice_.sensor.value_or(assumed), settings(), {});
}

void MagneticDialog::readSensor(const QString& file) {
  auto sensor =
      playback::MagneticSensor::fromCsv(QFile::encodeName(file).toStdString(), playback::usualNoise);
  if (!sensor) return readings_->setText(sentenceOf(sensor.failure(), units_));
  choice_.sensor = *std::move(sensor);
  choice_.sensorFile = QFileInfo(file).fileName();
  showReadings();
}

void MagneticDialog::showReadings() {
  readings_->setText(choice_.sensor ? tr("Readings from %1.").arg(choice_.sensorFile)
                                    : tr("No readings loaded: a magnet of the usual size is assumed."));
}

QString MagneticDialog::refusal() const {
  for (const QuantityField* field : fields_)
    if (field->isEnabled() && !field->acceptable()) return field->refusal();
  const auto possible = playback::checked(settings());
  return possible ? QString() : sentenceOf(possible.failure(), units_);
}

void MagneticDialog::showChoice() {
  if (!accept_) return;  // still being built
  for (QWidget* widget :
       {static_cast<QWidget*>(press_), static_cast<QWidget*>(release_), static_cast<QWidget*>(continuous_)})
    widget->setEnabled(rapid_->isChecked());
  const QString refused = refusal();
  refusal_->setText(refused);
  accept_->setEnabled(refused.isEmpty());
  draw();
}

void MagneticDialog::draw() {
  plot_->clearPlottables();
  plot_->clearItems();
  const GraphColors colors = dressPlot(*plot_);
  for (const auto side : {QCPAxis::atBottom, QCPAxis::atLeft}) dressAxis(*movement_->axis(side), colors);
  plot_->yAxis->setLabel(tr("Force (%1)").arg(units_.forceSymbol()));
  movement_->axis(QCPAxis::atBottom)->setLabel(tr("Displacement (%1)").arg(units_.lengthSymbol()));
  movement_->axis(QCPAxis::atLeft)->setLabel(tr("Distance moved (%1)").arg(units_.lengthSymbol()));
  const MagneticKeySettings chosen = settings();
  const auto events =
      refusal_->text().isEmpty() ? playback::eventsAlong(turns_mm(), chosen) : std::vector<KeyEvent>();
  drawCurves(events);
  drawMovement(events);
  for (QCPAxisRect* rect : {plot_->axisRect(), movement_}) drawLimits(*rect, chosen);
  QStringList words;
  for (const KeyEvent& event : events) {
    const QString at = quantityWithUnit(event.displacement_mm, Quantity::length, units_, 4);
    words << (event.closes ? tr("closes at %1").arg(at) : tr("opens at %1").arg(at));
  }
  const QString said = words.isEmpty() ? tr("The key stays open.") : tr("The key %1.").arg(words.join(", "));
  events_->setText(refusal_->text().isEmpty() ? said : QString());
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void MagneticDialog::drawCurves(const std::vector<KeyEvent>& events) {
  const GraphColors colors = graphColors(isDark(plot_->palette()));
  const ForceGraph& graph = button_.states().front().graph;
  for (const Stroke stroke : {Stroke::press, Stroke::release}) {
    if (stroke == Stroke::release && !graph.release()) continue;
    const bool press = stroke == Stroke::press;
    auto* curve = new QCPCurve(plot_->xAxis, plot_->yAxis);
    for (const CurvePoint& p : travelledSamples(graph, stroke))
      curve->addData(units_.lengthFrom(p.displacement_mm), units_.forceFrom(p.force_N));
    curve->setPen(
        QPen(press ? colors.press : colors.release, curve_px, press ? Qt::SolidLine : Qt::DashLine));
    curve->setName(press ? tr("Press") : tr("Release"));
  }
  for (const bool closes : {true, false}) {
    const StrokeCurve& curve = closes || !graph.release() ? graph.press() : *graph.release();
    auto* marks = new QCPCurve(plot_->xAxis, plot_->yAxis);
    for (const KeyEvent& event : events)
      if (event.closes == closes)
        marks->addData(units_.lengthFrom(event.displacement_mm),
                       units_.forceFrom(curve.force_N(event.displacement_mm)));
    marks->setLineStyle(QCPCurve::lsNone);
    const QColor color = closes ? colors.operatingPoint : colors.resetPoint;
    marks->setScatterStyle({closes ? QCPScatterStyle::ssTriangleInverted : QCPScatterStyle::ssTriangle, color,
                            closes ? color : colors.background, eventSize_px});
    marks->setName(closes ? tr("Key closes") : tr("Key opens"));
  }
  plot_->xAxis->setRange(0, (1 + SvgPlotStyle().roomBeyondEnd) * units_.lengthFrom(graph.travel_mm()));
  plot_->yAxis->rescale();
  plot_->yAxis->setRangeLower(std::min(0.0, plot_->yAxis->range().lower));
}

// Draws the displacement (to the right) along the travelled path (downwards): rest, press, lift, second
// press, release.
void MagneticDialog::drawMovement(const std::vector<KeyEvent>& events) {
  const GraphColors colors = graphColors(isDark(plot_->palette()));
  QCPAxis *x = movement_->axis(QCPAxis::atBottom), *y = movement_->axis(QCPAxis::atLeft);
  std::vector<KeyEvent> points = events;  // later also the turns, at which the key does not switch
  const std::vector<double> turns = turns_mm();
  double path_mm = 0;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    if (i > 0) path_mm += std::abs(turns[i] - turns[i - 1]);
    const auto after = std::find_if(points.begin(), points.end(),
                                    [&](const KeyEvent& point) { return point.path_mm > path_mm; });
    points.insert(after, {path_mm, turns[i], after != points.begin() && std::prev(after)->closes});
  }
  bool named = false;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const KeyEvent &from = points[i - 1], &to = points[i];
    auto* leg = new QCPCurve(x, y);
    for (const KeyEvent& point : {from, to})
      leg->addData(units_.lengthFrom(point.displacement_mm), units_.lengthFrom(point.path_mm));
    leg->setPen(from.closes ? QPen(colors.operatingPoint, closed_px) : QPen(colors.text, thin_px));
    leg->setName(tr("Key closed"));
    if (!from.closes || named) leg->removeFromLegend();
    named |= from.closes;
  }
  x->setRange(plot_->xAxis->range());
  y->setRange(0, units_.lengthFrom(std::max(path_mm, button_.states().front().graph.travel_mm())));
}

void MagneticDialog::drawLimits(QCPAxisRect& rect, const MagneticKeySettings& settings) {
  const GraphColors colors = graphColors(isDark(plot_->palette()));
  const auto place = [&](QCPItemPosition* position, double x, double y) {
    position->setAxisRect(&rect);
    position->setAxes(rect.axis(QCPAxis::atBottom), rect.axis(QCPAxis::atLeft));
    position->setTypeX(QCPItemPosition::ptPlotCoords);
    position->setTypeY(QCPItemPosition::ptAxisRectRatio);
    position->setCoords(units_.lengthFrom(x), y);
  };
  for (const bool actuation : {true, false}) {
    auto* line = new QCPItemLine(plot_);
    line->setClipAxisRect(&rect);
    place(line->start, actuation ? settings.actuate_mm : settings.reset_mm, 0);
    place(line->end, actuation ? settings.actuate_mm : settings.reset_mm, 1);
    line->setPen(QPen(actuation ? colors.operatingPoint : colors.resetPoint, thin_px, Qt::DashLine));
  }
  const std::pair<double, double> zones_mm[] = {
      {0, settings.topDeadZone_mm}, {settings.travel_mm - settings.bottomDeadZone_mm, settings.travel_mm}};
  for (const auto& [from_mm, to_mm] : zones_mm) {
    auto* zone = new QCPItemRect(plot_);
    zone->setClipAxisRect(&rect);
    place(zone->topLeft, from_mm, 0);
    place(zone->bottomRight, to_mm, 1);
    zone->setPen(Qt::NoPen);
    zone->setBrush(colors.grid);
    zone->setLayer(QStringLiteral("background"));
  }
}

void MagneticDialog::changeEvent(QEvent* event) {
  QDialog::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && accept_) draw();
}

}  // namespace detent::editor
