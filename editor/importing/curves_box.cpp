// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/importing/curves_box.h"

#include <algorithm>
#include <cmath>
#include <QVBoxLayout>

#include "editor/document/described.h"
#include "editor/importing/finding_words.h"
#include "editor/importing/swatch.h"

namespace detent::editor {
namespace {

/// Colour of the curve that a stroke was traced on; transparent if it is not known.
QColor colorOfStroke(const std::shared_ptr<const ImportedGraph>& imported, Stroke stroke) {
  const QColor unknown(Qt::transparent);
  if (!imported || !imported->report || !imported->evidence) return unknown;
  const importer::StrokePair& pair = imported->report->strokes;
  const importer::StrokePoints* points = stroke == Stroke::press ? &pair.press
                                         : pair.release          ? &*pair.release
                                                                 : nullptr;
  if (!points || points->points_px.empty()) return unknown;
  const importer::Point middle = points->points_px[points->points_px.size() / 2];
  for (const auto& trace : imported->evidence->traces) {
    const bool on = std::any_of(trace.points_px.begin(), trace.points_px.end(), [&](importer::Point p) {
      return std::hypot(p.x - middle.x, p.y - middle.y) < 1.5;
    });
    if (on) return colorFrom(trace.color);
  }
  return unknown;
}

}  // namespace

CurvesBox::CurvesBox(ImportState& state, ViewSettings& settings, QWidget* parent)
    : QGroupBox(tr("Curves"), parent),
      state_(state),
      settings_(settings),
      swap_(new QCheckBox(tr("Swap press and release"))),
      strokes_(wrappedLabel()) {
  auto* column = new QVBoxLayout(this);
  column->addLayout(strokeRow(Stroke::press));
  column->addLayout(strokeRow(Stroke::release));
  column->addWidget(swap_);
  swap_->setObjectName(QStringLiteral("swapStrokes"));
  connect(swap_, &QCheckBox::clicked, &state_, [this](bool on) {
    state_.correct(tr("Swap press and release"), [on](Corrections& c) { c.swapStrokes = on; });
  });
  column->addWidget(strokes_);
  strokes_->setForegroundRole(QPalette::PlaceholderText);
  column->addLayout(maskRow());
  column->addLayout(resolutionRow());
}

QHBoxLayout* CurvesBox::strokeRow(Stroke stroke) {
  const bool isPress = stroke == Stroke::press;
  auto* button = new QPushButton(isPress ? tr("Press curve…") : tr("Release curve…"));
  button->setObjectName(isPress ? QStringLiteral("pickPress") : QStringLiteral("pickRelease"));
  button->setToolTip(isPress ? tr("Click the press curve on the page")
                             : tr("Click the release curve on the page"));
  connect(button, &QPushButton::clicked, this, [this, isPress] {
    emit toolRequested(isPress ? PageToolKind::pressColor : PageToolKind::releaseColor);
  });
  auto* origin = new OriginMark(state_, button->objectName() + QStringLiteral("Reset"),
                                isPress ? tr("Reset press curve") : tr("Reset release curve"),
                                [isPress](Corrections& c) {
                                  (isPress ? c.pressColor : c.releaseColor).reset();
                                  (isPress ? c.drawn.press : c.drawn.release).clear();
                                  if (!isPress) c.noRelease = false;
                                });
  (isPress ? press_ : release_) = button;
  (isPress ? pressOrigin_ : releaseOrigin_) = origin;
  ofPage_.push_back(button);
  auto* row = new QHBoxLayout;
  row->addWidget(button);
  row->addStretch();
  row->addWidget(origin);
  return row;
}

QHBoxLayout* CurvesBox::maskRow() {
  auto* box = new QPushButton(tr("Mask…"));
  box->setToolTip(tr("Drag rectangles over parts that are not a curve"));
  connect(box, &QPushButton::clicked, this, [this] { emit toolRequested(PageToolKind::maskBox); });
  noMasks_ = described(new QToolButton, "removeMasks");
  noMasks_->setText(tr("Remove all"));
  noMasks_->setAutoRaise(true);
  connect(noMasks_, &QToolButton::clicked, &state_,
          [this] { state_.correct(tr("Remove masks"), [](Corrections& c) { c.masks.clear(); }); });
  auto* row = new QHBoxLayout;
  row->addWidget(box);
  row->addWidget(masks_ = new QLabel);
  row->addStretch();
  row->addWidget(noMasks_);
  ofPage_.insert(ofPage_.end(), {box, masks_});
  return row;
}

QHBoxLayout* CurvesBox::resolutionRow() {
  auto* label = new QLabel(tr("Resolution"));
  dpi_ = new QuantityField(Quantity::resolution, {});
  label->setBuddy(dpi_);
  dpi_->setObjectName(QStringLiteral("dpi"));
  dpi_->setRange({0, 1200});
  dpi_->setLowestText(tr("automatic"));
  dpi_->setKeyboardTracking(false);
  dpi_->setToolTip(tr("Resolution of the page picture that is traced, in dots per inch"));
  dpi_->setAccessibleName(dpi_->toolTip());
  connect(dpi_, &QuantityField::valueChanged, &state_, [this](double value) {
    state_.correct(tr("Resolution"),
                   [value](Corrections& c) { c.dpi = value > 0 ? std::optional(value) : std::nullopt; });
  });
  dpiOrigin_ = new OriginMark(state_, QStringLiteral("resetDpi"), tr("Reset resolution"),
                              [](Corrections& c) { c.dpi.reset(); });
  auto* row = new QHBoxLayout;
  row->addWidget(label);
  row->addWidget(dpi_);
  row->addStretch();
  row->addWidget(dpiOrigin_);
  ofPage_.insert(ofPage_.end(), {label, dpi_});
  return row;
}

void CurvesBox::follow(bool ofLog) {
  const ImportGraph* graph = state_.current();
  const Corrections none;
  const Corrections& given = graph ? graph->history.now() : none;
  const auto foundColor = [&](Stroke stroke) { return colorOfStroke(graph ? graph->good : nullptr, stroke); };
  press_->setIcon(
      swatchOf({given.pressColor ? colorFrom(*given.pressColor) : foundColor(Stroke::press)}, palette()));
  release_->setIcon(swatchOf(
      {given.releaseColor ? colorFrom(*given.releaseColor) : foundColor(Stroke::release)}, palette()));
  pressOrigin_->setOrigin(given.pressColor || !given.drawn.press.empty());
  releaseOrigin_->setOrigin(given.releaseColor || !given.drawn.release.empty() || given.noRelease);
  swap_->setChecked(given.swapStrokes);
  const auto* strokes =
      graph && graph->good ? stepOf(graph->good->evidence, importer::ImportStep::strokes) : nullptr;
  strokes_->setText(strokes ? inWords(strokes->evidence, settings_.units()) : QString());
  strokes_->setVisible(strokes && !strokes->evidence.empty());
  masks_->setText(given.masks.empty()       ? tr("none")
                  : given.masks.size() == 1 ? tr("1 area masked")
                                            : tr("%1 areas masked").arg(given.masks.size()));
  noMasks_->setVisible(!given.masks.empty());
  const QSignalBlocker quiet(dpi_);
  dpi_->setValue(given.dpi.value_or(0));
  dpiOrigin_->setOrigin(given.dpi.has_value());
  for (QWidget* each : ofPage_) each->setVisible(!ofLog);
}

}  // namespace detent::editor
