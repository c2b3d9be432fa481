// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/window/graph_export_dialog.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLocale>
#include <QPainter>
#include <QScopedValueRollback>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>

#include "editor/document/described.h"
#include "editor/quantity/offered_units.h"

namespace detent::editor {
namespace {

constexpr QuantityRange widths_mm{60, 600}, heights_mm{60, 400}, lengths_mm{-1000, 1000},
    forces_N{-1000, 1000};
constexpr double widestTolerance = 0.5, widestTolerance_N = 1e4;
constexpr double pxPerPoint = 96.0 / 72;
constexpr QSize leastPicture_px{220, 150}, first_px{860, 640};

QComboBox* choiceOf(const char* name, const QString& tip, const QStringList& offered) {
  auto* box = described(new QComboBox, QString::fromLatin1(name), tip, tip);
  box->addItems(offered);
  return box;
}

template <class Units>
QStringList symbolsOf(const Units& units) {
  QStringList symbols;
  for (const auto unit : units) symbols << unitText(symbolOf(unit));
  return symbols;
}

QCheckBox* checkOf(const char* name, const QString& text, const QString& tip) {
  return described(new QCheckBox(text), QString::fromLatin1(name), tip, tip);
}

QuantityField* fieldOf(const char* name, const QString& tip, Quantity quantity, QuantityRange range) {
  auto* field = described(new QuantityField(quantity, {}), QString::fromLatin1(name), tip, tip);
  field->setRange(range);
  return field;
}

template <class Units, class Unit>
int indexOf(const Units& units, Unit unit) {
  return static_cast<int>(std::find(units.begin(), units.end(), unit) - units.begin());
}

}  // namespace

GraphExportDialog::GraphExportDialog(Button button, const DisplayUnits& units, QWidget* parent)
    : QDialog(parent),
      button_(std::move(button)),
      picture_(described(new QLabel, QStringLiteral("graphPicture"), {}, tr("Preview"))),
      refusal_(described(new QLabel, QStringLiteral("graphRefusal"))) {
  setObjectName(QStringLiteral("graphExportDialog"));
  setWindowTitle(tr("Export the graph"));
  auto* choices = new QWidget;
  auto* forms = new QVBoxLayout(choices);
  for (QFormLayout* form : {madeFor(), axes(), shown()}) forms->addLayout(form);
  forms->addStretch(1);
  auto* scrolled = new QScrollArea;  // a low screen has no room for all fields
  scrolled->setWidget(choices);
  scrolled->setWidgetResizable(true);
  scrolled->setFrameShape(QFrame::NoFrame);
  scrolled->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scrolled->setMinimumWidth(choices->sizeHint().width() + scrolled->verticalScrollBar()->sizeHint().width());
  auto* columns = new QHBoxLayout;
  columns->addWidget(scrolled);
  picture_->setMinimumSize(leastPicture_px);
  picture_->setAlignment(Qt::AlignCenter);
  columns->addWidget(picture_, 1);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
  accept_ = described(buttons->addButton(tr("&Export…"), QDialogButtonBox::AcceptRole),
                      QStringLiteral("graphExport"), tr("Choose a location and write the file"));
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(columns);
  refusal_->setWordWrap(true);
  layout->addWidget(refusal_);
  layout->addWidget(buttons);

  const bool german = QLocale().language() == QLocale::German;
  language_->setCurrentIndex(german ? 1 : 0);
  decimalSign_->setCurrentIndex(german ? 1 : 0);
  length_->setCurrentIndex(indexOf(offeredLengthUnits, units.length));
  force_->setCurrentIndex(indexOf(offeredForceUnits, units.force));
  connect(preset_, &QComboBox::currentIndexChanged, this, &GraphExportDialog::takePreset);
  for (QComboBox* box : {format_, language_, decimalSign_, second_, font_})
    connect(box, &QComboBox::currentIndexChanged, this, &GraphExportDialog::showChoice);
  for (QComboBox* box : {length_, force_})
    connect(box, &QComboBox::currentIndexChanged, this, &GraphExportDialog::takeUnits);
  for (QCheckBox* box : {monochrome_, callouts_, dimensions_})
    connect(box, &QCheckBox::toggled, this, &GraphExportDialog::showChoice);
  // Only one of the two tolerances counts: typing one clears the other, before the picture follows.
  connect(tolerance_, &QuantityField::valueChanged, this, [this] { toleranceForce_->setValue(0); });
  connect(toleranceForce_, &QuantityField::valueChanged, this, [this] { tolerance_->setValue(0); });
  for (QuantityField* field : {tolerance_, toleranceForce_, width_, height_, xFrom_, xTo_, yFrom_, yTo_}) {
    connect(field, &QuantityField::valueChanged, this, &GraphExportDialog::showChoice);
    connect(field, &QuantityField::refusalChanged, this, &GraphExportDialog::showChoice);
  }
  connect(fontSize_, &QSpinBox::valueChanged, this, &GraphExportDialog::showChoice);
  takeUnits();
  takePreset();
  resize(first_px);
}

QFormLayout* GraphExportDialog::madeFor() {
  auto* form = new QFormLayout;
  preset_ = choiceOf("graphPreset", tr("Purpose of the graph"), {tr("Datasheet"), tr("Paper"), tr("Slide")});
  format_ = choiceOf("graphFormat", tr("Format of the file"),
                     {tr("Drawing (SVG)"), tr("PDF"), tr("Picture (PNG)")});
  width_ = fieldOf("graphWidth", tr("Width of the graph"), Quantity::length, widths_mm);
  height_ = fieldOf("graphHeight", tr("Height of the graph of one state"), Quantity::length, heights_mm);
  font_ = choiceOf("graphFont", tr("Font"), {tr("Sans-serif"), tr("Serif")});
  fontSize_ = described(new QSpinBox, "graphFontSize", tr("Size of the font"), tr("Size of the font"));
  fontSize_->setRange(5, 30);
  fontSize_->setSuffix(QStringLiteral(" pt"));
  form->addRow(tr("&Preset:"), preset_);
  form->addRow(tr("&Format:"), format_);
  form->addRow(tr("&Width:"), width_);
  form->addRow(tr("&Height:"), height_);
  form->addRow(tr("F&ont:"), font_);
  form->addRow(tr("Font &size:"), fontSize_);
  return form;
}

QFormLayout* GraphExportDialog::axes() {
  auto* form = new QFormLayout;
  language_ = choiceOf("graphLanguage", tr("Language of the labels"),
                       {QStringLiteral("English"), QStringLiteral("Deutsch")});
  decimalSign_ =
      choiceOf("graphDecimalSign", tr("Decimal separator"), {tr("Point (1.5)"), tr("Comma (1,5)")});
  length_ = choiceOf("graphLength", tr("Unit of the displacement"), symbolsOf(offeredLengthUnits));
  force_ = choiceOf("graphForce", tr("Unit of the force"), symbolsOf(offeredForceUnits));
  second_ = choiceOf("graphSecond", tr("Unit of a second scale at the right side"),
                     QStringList(tr("none")) + symbolsOf(offeredForceUnits));
  form->addRow(tr("Lan&guage:"), language_);
  form->addRow(tr("&Decimal separator:"), decimalSign_);
  form->addRow(tr("D&isplacement in:"), length_);
  form->addRow(tr("Fo&rce in:"), force_);
  form->addRow(tr("Second s&cale:"), second_);
  xFrom_ = axisEnd("graphXFrom", tr("Where the displacement axis begins"), Quantity::length);
  xTo_ = axisEnd("graphXTo", tr("Where the displacement axis ends"), Quantity::length);
  yFrom_ = axisEnd("graphYFrom", tr("Where the force axis begins"), Quantity::force);
  yTo_ = axisEnd("graphYTo", tr("Where the force axis ends"), Quantity::force);
  form->addRow(tr("Displ&acement from:"), xFrom_);
  form->addRow(tr("to:"), xTo_);
  form->addRow(tr("Force fro&m:"), yFrom_);
  form->addRow(tr("to:"), yTo_);
  return form;
}

QuantityField* GraphExportDialog::axisEnd(const char* name, const QString& tip, Quantity quantity) {
  const QuantityRange range = quantity == Quantity::length ? lengths_mm : forces_N;
  QuantityField* field = fieldOf(name, tip, quantity, range);
  field->setLowestText(tr("automatic"));
  field->setValue(range.lowest);
  return field;
}

QFormLayout* GraphExportDialog::shown() {
  auto* form = new QFormLayout;
  monochrome_ = checkOf("graphMonochrome", tr("&Black and white"),
                        tr("Draw the press in black, the release in black and dashed"));
  callouts_ = checkOf("graphCallouts", tr("&Label points"),
                      tr("Label tactile points, operating and reset point and bottom-out with their values"));
  dimensions_ = checkOf("graphDimensions", tr("Dimensio&ns"),
                        tr("Show pre-travel and differential travel as dimension lines"));
  tolerance_ = fieldOf("graphTolerance", tr("Tolerance band, as a share of the press force"), Quantity::share,
                       {0, widestTolerance});
  toleranceForce_ = fieldOf("graphToleranceForce", tr("Tolerance band, as a force above and below the press"),
                            Quantity::force, {0, widestTolerance_N});
  for (QuantityField* field : {tolerance_, toleranceForce_}) field->setLowestText(tr("none"));
  for (QCheckBox* box : {monochrome_, callouts_, dimensions_}) form->addRow(box);
  form->addRow(tr("&Tolerance ±:"), tolerance_);
  form->addRow(tr("or ± force:"), toleranceForce_);
  return form;
}

void GraphExportDialog::takePreset() {
  const SvgPlotStyle style = styleOf(static_cast<GraphPreset>(preset_->currentIndex()), units());
  const QScopedValueRollback quiet(filling_, true);
  width_->setValue(*style.width_mm);
  height_->setValue(*style.width_mm * style.height_px / style.width_px);
  fontSize_->setValue(static_cast<int>(std::lround(style.fontSize_px / pxPerPoint)));
  monochrome_->setChecked(style.monochrome);
  callouts_->setChecked(style.callouts);
  dimensions_->setChecked(style.dimensions);
  filling_ = false;
  showChoice();
}

void GraphExportDialog::takeUnits() {
  for (QuantityField* field : {xFrom_, xTo_, yFrom_, yTo_, toleranceForce_}) field->setUnits(units());
  showChoice();
}

DisplayUnits GraphExportDialog::units() const {
  DisplayUnits units;
  units.length = offeredLengthUnits[static_cast<std::size_t>(length_->currentIndex())];
  units.force = offeredForceUnits[static_cast<std::size_t>(force_->currentIndex())];
  return units;
}

std::optional<detent::AxisEnds> GraphExportDialog::endsFrom(const QuantityField& first,
                                                            const QuantityField& last,
                                                            const Ticks& whole) const {
  const bool begins = first.value() != first.range().lowest, ends = last.value() != last.range().lowest;
  if (!begins && !ends) return {};
  const double unit = shownUnitOf(first.quantity(), units());
  return detent::AxisEnds{begins ? first.value() / unit : whole.first,
                          ends ? last.value() / unit : whole.last()};
}

GraphExport GraphExportDialog::choice() const {
  GraphExport chosen;
  chosen.format = static_cast<GraphFileFormat>(format_->currentIndex());
  chosen.language = static_cast<PlotLanguage>(language_->currentIndex());
  SvgPlotStyle& style = chosen.style;
  style = styleOf(static_cast<GraphPreset>(preset_->currentIndex()), units());
  setSize(style, width_->value(), height_->value());
  style.fontSize_px = fontSize_->value() * pxPerPoint;
  style.decimalSign = decimalSign_->currentIndex() == 0 ? '.' : ',';
  if (font_->currentIndex() == 1) style.font = "DejaVu Serif, Times New Roman, serif";
  style.monochrome = monochrome_->isChecked();
  style.callouts = callouts_->isChecked();
  style.dimensions = dimensions_->isChecked();
  if (tolerance_->value() > 0) style.tolerance = tolerance_->value();
  if (toleranceForce_->value() > 0) style.tolerance_N = toleranceForce_->value();
  if (second_->currentIndex() > 0)
    style.secondForceUnit = offeredForceUnits[static_cast<std::size_t>(second_->currentIndex() - 1)];
  SvgPlotStyle tickToTick = style;
  tickToTick.roomBeyondEnd = 0;
  const PlotFrame whole = frameOfPlot(button_.states().front(), tickToTick);
  style.xEnds = endsFrom(*xFrom_, *xTo_, whole.x);
  style.yEnds = endsFrom(*yFrom_, *yTo_, whole.y);
  return chosen;
}

QString GraphExportDialog::refusal() const {
  for (const QuantityField* field :
       {width_, height_, xFrom_, xTo_, yFrom_, yTo_, tolerance_, toleranceForce_})
    if (!field->acceptable()) return field->accessibleName() + QStringLiteral(": ") + field->refusal();
  const SvgPlotStyle style = choice().style;
  if (!hasRoom(style))
    return tr(
        "The font is too large for this size: there is no room for the curves. Choose a smaller font or a "
        "larger graph.");
  for (const auto& ends : {style.xEnds, style.yEnds})
    if (ends && !(ends->lowest < ends->highest))
      return tr("An axis must begin below its end. Type a smaller start or a larger end.");
  return {};
}

void GraphExportDialog::showChoice() {
  if (filling_) return;
  const QString why = refusal();
  refusal_->setText(why);
  refusal_->setVisible(!why.isEmpty());
  accept_->setEnabled(why.isEmpty());
  if (!why.isEmpty()) return;
  const GraphExport chosen = choice();
  SvgPlotStyle style = chosen.style;
  style.words = plotWords(chosen.language);
  QStringList missing;
  for (const std::string& label : labelsWithoutRoom(button_, style)) missing << QString::fromStdString(label);
  refusal_->setVisible(!missing.isEmpty());
  if (!missing.isEmpty())
    refusal_->setText(tr("Labels without room are left out: %1. Choose a larger graph or a smaller font.")
                          .arg(missing.join(QStringLiteral("; "))));
  const QSizeF size = graphSize_mm(button_, style).scaled(picture_->size(), Qt::KeepAspectRatio);
  QImage image((size * devicePixelRatioF()).toSize(), QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  paintGraph(painter, QRectF(image.rect()), button_, style);
  painter.end();
  image.setDevicePixelRatio(devicePixelRatioF());
  picture_->setPixmap(QPixmap::fromImage(image));
}

void GraphExportDialog::resizeEvent(QResizeEvent* event) {
  QDialog::resizeEvent(event);
  QMetaObject::invokeMethod(this, &GraphExportDialog::showChoice, Qt::QueuedConnection);  // laid out by then
}

}  // namespace detent::editor
