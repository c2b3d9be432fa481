// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/canvas/graph_canvas.h"

#include <algorithm>

#include "editor/canvas/page_underlay.h"
#include "editor/canvas/traced_points.h"
#include "editor/document/kept_page.h"

namespace detent::editor {
namespace {

constexpr double lens_px = 190, lensTimes = 5;

}  // namespace

GraphCanvas::GraphCanvas(ButtonDocument& document, ViewSettings& settings, QWidget* parent)
    : UnitPlot(settings, PlotQuantity::displacement, PlotQuantity::force, parent),
      document_(document),
      underlay_(new PageUnderlay(*this)),
      traced_(new TracedPoints(*this)) {
  setObjectName(QStringLiteral("graphCanvas"));
  setAccessibleName(tr("Force graph"));
  setAccessibleDescription(
      tr("Tab goes through the points of the graph, arrow keys move the selected one, Delete removes it."));
  connect(&document_, &ButtonDocument::changed, this, &GraphCanvas::graphChanged);
  connect(&document_, &ButtonDocument::activeStateChanged, this, &GraphCanvas::stateChanged);
  connect(&document_, &ButtonDocument::originChanged, this, &GraphCanvas::takeOrigin);
  connect(&document_, &ButtonDocument::annotationsChanged, this, qOverload<>(&QWidget::update));
  connect(&settings, &ViewSettings::changed, this, &GraphCanvas::takeSettings);
  takeOrigin();
  fit();
}

const ButtonState& GraphCanvas::state() const { return document_.button().states()[document_.activeState()]; }

const GraphValues& GraphCanvas::values() const {
  if (!values_) values_ = valuesOf(document_.graph());
  return *values_;
}

const std::vector<CurvePoint>& GraphCanvas::tracedPoints(Stroke stroke) const { return traced_->of(stroke); }

bool GraphCanvas::hasUnderlay() const { return !underlay_->empty(); }

void GraphCanvas::graphChanged() {
  values_.reset();
  followSelection();
  update();
}

// The marks of the state shown before do not exist in this one, so the selection is cleared.
void GraphCanvas::stateChanged() {
  values_.reset();
  setSelection({});
  update();
}

void GraphCanvas::followSelection() {
  if (selectionThere_.empty() && selection_.empty()) return;
  if (document_.activeState() != selectedState_) return setSelection({});
  std::vector<MarkId> now;
  const MarkedState after{state(), values()};
  for (const MarkId& mark : selectionThere_)
    if (const auto same = sameMark(mark, *selectedOn_, after)) now.push_back(*same);
  if (now != selection_) {
    selection_ = std::move(now);
    showSelection();
  }
  if (!document_.history().dragging()) rememberSelection();
}

void GraphCanvas::rememberSelection() {
  selectedOn_ = MarkedState{state(), values()};
  selectionThere_ = selection_;
  selectedState_ = document_.activeState();
}

void GraphCanvas::takeOrigin() {
  underlay_->clear();
  traced_->setPoints({}, {});
  if (const auto& origin = document_.origin()) {
    traced_->setPoints(origin->strokes.press.points,
                       origin->strokes.release ? origin->strokes.release->points : std::vector<CurvePoint>{});
  }
  if (const auto page = document_.page()) underlay_->setPage(page->picture, page->pixelToAxes);
  const auto& from = document_.button().provenance();
  underlay_->setFrame(from ? frameOf(*from).value_or(QRectF()) : QRectF());
  takeSettings();
}

void GraphCanvas::colorsChanged() { takeSettings(); }

void GraphCanvas::takeSettings() {
  underlay_->setDarkPaper(isDark(palette()));
  underlay_->setOpacity(settings().underlayOpacity());
  const bool pointsWanted = settings().residualsShown() || settings().snap().toTracedPoints;
  traced_->setShown(pointsWanted);
  if (pointsWanted) document_.wantOrigin();
  replot(QCustomPlot::rpQueuedReplot);
}

void GraphCanvas::setFeedback(const CanvasFeedback& feedback) {
  if (feedback == feedback_) return;
  feedback_ = feedback;
  update();
}

std::optional<MarkId> GraphCanvas::selected() const {
  return selection_.empty() ? std::nullopt : std::optional(selection_.back());
}

bool GraphCanvas::isSelected(MarkId mark) const {
  return std::find(selection_.begin(), selection_.end(), mark) != selection_.end();
}

void GraphCanvas::setSelected(const std::optional<MarkId>& selected) {
  setSelection(selected ? std::vector{*selected} : std::vector<MarkId>{});
}

void GraphCanvas::setSelection(std::vector<MarkId> marks) {
  std::erase_if(marks, [this](const MarkId& mark) { return !placeOf(mark, state(), values()); });
  const bool changes = marks != selection_;
  selection_ = std::move(marks);
  rememberSelection();
  if (changes) showSelection();
}

void GraphCanvas::showSelection() {
  const auto last = selected();
  const auto at = last ? placeOf(*last, state(), values()) : std::nullopt;
  setAccessibleName(selection_.size() > 1
                        ? tr("Force graph: %n points selected", nullptr, static_cast<int>(selection_.size()))
                    : at ? tr("Force graph: %1").arg(describe({*last, *at}, settings().units()))
                         : tr("Force graph"));
  emit selectionChanged();
  update();
}

void GraphCanvas::showPreview(std::optional<ButtonState> preview) {
  if (preview == preview_) return;
  preview_ = std::move(preview);
  update();
}

void GraphCanvas::showReference(std::optional<Reference> reference) {
  reference_ = std::move(reference);
  if (fitted()) fit();
  update();
}

void GraphCanvas::showSpread(std::vector<StateSpread> states) {
  spread_ = std::move(states);
  update();
}

void GraphCanvas::showFinger(std::optional<FingerPosition> finger) {
  if (!finger && !finger_) return;
  finger_ = finger;
  update();
}

void GraphCanvas::setMagnifierShown(bool shown) {
  magnifierShown_ = shown;
  update();
}

void GraphCanvas::setHandlesShown(bool shown) {
  handlesShown_ = shown;
  update();
}

std::unique_ptr<GraphCanvas> GraphCanvas::forPicture(const QPalette& palette) const {
  auto canvas = std::make_unique<GraphCanvas>(document_, settings());
  canvas->setFont(font());
  canvas->setPalette(palette);
  canvas->setHandlesShown(handlesShown_);
  canvas->spread_ = spread_;
  canvas->showRange(shownRange());
  return canvas;
}

void GraphCanvas::renderTo(QPaintDevice& device, QSize size, const QPalette& palette) const {
  QCPPainter painter(&device);
  painter.setMode(QCPPainter::pmVectorized, true);
  painter.setMode(QCPPainter::pmNoCaching, true);
  forPicture(palette)->drawAsPicture(painter, size);
}

QImage GraphCanvas::renderImage(QSize size_px, double devicePixelRatio) const {
  QImage image(size_px, QImage::Format_ARGB32_Premultiplied);
  image.fill(colors().background);
  image.setDevicePixelRatio(devicePixelRatio);
  QCPPainter painter(&image);
  forPicture(palette())->drawAsPicture(painter, (QSizeF(size_px) / devicePixelRatio).toSize());
  return image;
}

// Exported pictures omit handles and feedback.
GraphScene GraphCanvas::scene() const {
  static const CanvasFeedback nothing;
  GraphScene scene{state(),
                   values(),
                   colors(),
                   settings().units(),
                   exporting() ? nothing : feedback_,
                   {},
                   std::nullopt,
                   nullptr,
                   {},
                   {},
                   handlesShown_ && !exporting(),
                   readingErrorOf(document_.button())};
  if (!exporting()) {
    scene.selection = selection_;
    scene.finger = finger_;
    if (reference_) scene.reference = &*reference_;
    if (feedback_.draggedFrom && document_.history().dragging())
      scene.before = &document_.history().committed().states()[document_.activeState()];
  }
  const auto& states = document_.button().states();
  if (states.size() > 1) scene.otherState = &states[document_.activeState() == 0 ? 1 : 0];
  scene.notes = document_.annotations().notes;
  scene.pinned = document_.annotations().links.pinned;
  scene.stateIndex = document_.activeState();
  if (preview_) scene.preview = &*preview_;
  if (document_.activeState() < spread_.size()) scene.spread = &spread_[document_.activeState()];
  if (settings().residualsShown()) {
    scene.tracedPress = traced_->of(Stroke::press);
    scene.tracedRelease = traced_->of(Stroke::release);
  }
  return scene;
}

QRectF GraphCanvas::contentRange() const {
  double start = 0, end = document_.graph().travel_mm(), low = 0, high = values().highest_N;
  const auto include = [&](const ForceGraph& graph) {
    for (const Stroke stroke : {Stroke::press, Stroke::release}) {
      if (stroke == Stroke::release && !graph.release()) continue;
      const StrokeCurve& curve = graph.curve(stroke);
      const auto [lowest, highest] = curve.forceRange_N();
      start = std::min(start, curve.start_mm());
      end = std::max(end, curve.end_mm());
      low = std::min(low, lowest);
      high = std::max(high, highest);
    }
  };
  for (const ButtonState& state : document_.button().states()) {
    include(state.graph);
    for (const SpeedGraph& speed : state.otherSpeeds) include(speed.graph);
  }
  if (reference_) include(reference_->state.graph);
  return {start, low, end - start, high - low};
}

std::optional<MarkId> GraphCanvas::flagAt(QPointF at_px) const {
  for (const Flag& flag : flags_)
    if (flag.box_px.contains(at_px)) return flag.mark;
  return {};
}

void GraphCanvas::drawContent(QPainter& painter, const PlotMapping& map) const {
  GraphScene drawn = scene();
  flags_.clear();
  if (!exporting()) drawn.flags = &flags_;
  paintGraph(painter, map, drawn);
  if (exporting()) return;
  if (magnifierShown_ && feedback_.dragged) drawMagnifier(painter, map);
  if (feedback_.refused) paintRefusalReason(painter, map, scene());
}

// The magnifier is drawn in the corner farthest from the dragged point, so that it never hides the point.
void GraphCanvas::drawMagnifier(QPainter& painter, const PlotMapping& map) const {
  const QPointF at_px = map.toPixel(feedback_.dragged->displacement_mm, feedback_.dragged->force_N);
  const double size = std::min({lens_px, 0.45 * map.clip_px.width(), 0.6 * map.clip_px.height()});
  if (size < 60) return;
  QRectF lens(0, 0, size, size);
  const bool right = at_px.x() < map.clip_px.center().x(), below = at_px.y() < map.clip_px.center().y();
  lens.moveTopLeft({right ? map.clip_px.right() - size - 12 : map.clip_px.left() + 12,
                    below ? map.clip_px.bottom() - size - 12 : map.clip_px.top() + 12});
  const PlotMapping magnified =
      map.magnified({feedback_.dragged->displacement_mm, feedback_.dragged->force_N}, lens, lensTimes);
  painter.save();
  painter.fillRect(lens, colors().background);
  underlay_->paint(painter, magnified);
  paintCurves(painter, magnified, scene());
  const QPointF middle = lens.center();
  painter.setPen(QPen(feedback_.refused ? colors().refused : colors().selection, 1));
  painter.drawLine(middle + QPointF(-14, 0), middle + QPointF(14, 0));
  painter.drawLine(middle + QPointF(0, -14), middle + QPointF(0, 14));
  painter.setPen(QPen(colors().axis, 1.5));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(lens);
  painter.restore();
}

// ---- events

PointerInput GraphCanvas::inputOf(const QMouseEvent* event) const {
  const QPointF at = mapping().toPlot(event->position());
  return {event->position(), {at.x(), at.y()}, event->button(), event->buttons(), event->modifiers()};
}

// Tab visits the points before it leaves the widget; keys that tools use are not shortcuts.
bool GraphCanvas::event(QEvent* event) {
  if (events_ && event->type() == QEvent::ShortcutOverride) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (events_->wantsKey(key->key(), key->modifiers())) {
      event->accept();
      return true;
    }
  }
  if (events_ && event->type() == QEvent::KeyPress) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if ((key->key() == Qt::Key_Tab || key->key() == Qt::Key_Backtab) &&
        events_->keyPressed(key->key(), key->modifiers()))
      return true;
  }
  return UnitPlot::event(event);
}

void GraphCanvas::mousePressEvent(QMouseEvent* event) {
  if (panWith(event, Qt::MiddleButton)) return;
  if (events_) events_->pointerPressed(inputOf(event));
}

void GraphCanvas::mouseMoveEvent(QMouseEvent* event) {
  const PointerInput input = inputOf(event);
  if (!panWith(event, Qt::MiddleButton) && events_) events_->pointerMoved(input);
  emit cursorMoved(input.at);
}

void GraphCanvas::mouseReleaseEvent(QMouseEvent* event) {
  if (panWith(event, Qt::MiddleButton)) return;
  if (events_) events_->pointerReleased(inputOf(event));
}

void GraphCanvas::mouseDoubleClickEvent(QMouseEvent* event) {
  if (events_ && event->button() == Qt::LeftButton) events_->doubleClicked(inputOf(event));
}

void GraphCanvas::keyPressEvent(QKeyEvent* event) {
  if (events_ && events_->keyPressed(event->key(), event->modifiers())) return;
  UnitPlot::keyPressEvent(event);
}

void GraphCanvas::leaveEvent(QEvent* event) {
  UnitPlot::leaveEvent(event);
  if (events_) events_->pointerLeft();
  emit cursorMoved({});
}

void GraphCanvas::contextMenuEvent(QContextMenuEvent* event) {
  if (!events_) return;
  QPointF at_px = event->pos();
  if (event->reason() == QContextMenuEvent::Keyboard && selected()) {
    if (const auto place = placeOf(*selected(), state(), values()))
      at_px = mapping().toPixel(place->displacement_mm, place->force_N);
  }
  const QPointF at = mapping().toPlot(at_px);
  events_->contextMenu({at_px, {at.x(), at.y()}, Qt::NoButton, Qt::NoButton, event->modifiers()},
                       mapToGlobal(at_px.toPoint()));
}

void GraphCanvas::resizeEvent(QResizeEvent* event) {
  UnitPlot::resizeEvent(event);
  if (fitted()) fit();
}

}  // namespace detent::editor
