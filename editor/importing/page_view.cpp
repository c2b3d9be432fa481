// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/importing/page_view.h"

#include <algorithm>
#include <cmath>
#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QLineEdit>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>
#include <utility>

#include "editor/document/described.h"
#include "editor/importing/finding_words.h"
#include "editor/importing/findings_painting.h"
#include "editor/importing/page_tool.h"
#include "editor/quantity/offered_units.h"
#include "editor/quantity/quantity.h"

namespace detent::editor {
namespace {

constexpr double leastZoom = 0.02, mostZoom = 200;  // widget pixels per page unit

constexpr int valueField_px = 96;

// Sets a tick. If one exists at this place, its value is replaced.
void setTick(AxisCorrection& axis, const AxisTick& tick, std::optional<std::size_t> replaces = {}) {
  auto same = std::find_if(axis.ticks.begin(), axis.ticks.end(),
                           [&](const AxisTick& other) { return other.at == tick.at; });
  if (replaces && *replaces < axis.ticks.size())
    same = axis.ticks.begin() + static_cast<std::ptrdiff_t>(*replaces);
  if (same == axis.ticks.end())
    axis.ticks.push_back(tick);
  else
    same->value = tick.value;
}

// Units that are printed at the axes or were given for them, so that the user can compare labels with the
// page; for other quantities the shown units.
DisplayUnits unitsOfPage(const ImportGraph& graph, DisplayUnits units) {
  const Corrections& given = graph.history.now();
  const auto& result = graph.good ? graph.good : graph.last;
  if (result && result->evidence) {
    const importer::AxisCalibration& axes = result->evidence->axes.calibration.value;
    for (const LengthUnit unit : offeredLengthUnits)
      if (symbolOf(unit) == axes.x.unit) units.length = unit;
    for (const ForceUnit unit : offeredForceUnits)
      if (symbolOf(unit) == axes.y.unit) units.force = unit;
  }
  if (given.xUnit) units.length = *given.xUnit;
  if (given.yUnit) units.force = *given.yUnit;
  return units;
}

QRectF rectOf(const importer::Box& box) { return {QPointF(box.x0, box.y0), QPointF(box.x1, box.y1)}; }

/// A field that handles Enter itself. Passed on to the page, Enter would open the field again.
class ValueEdit : public QLineEdit {
 public:
  using QLineEdit::QLineEdit;

 protected:
  void keyPressEvent(QKeyEvent* event) override {
    QLineEdit::keyPressEvent(event);
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) event->accept();
  }
};

}  // namespace

PageView::PageView(ImportState& state, ViewSettings& settings, QWidget* parent)
    : QWidget(parent), state_(state), settings_(settings), tool_(makeTool(PageToolKind::adjust, *this)) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setObjectName(QStringLiteral("pageView"));
  setAccessibleName(tr("Page with findings"));
  setAccessibleDescription(
      tr("The page with plot frame, axis ticks and curves as found. Tab moves through corners and ticks, "
         "arrow keys move the selected one, Enter opens its value."));
  connect(&state_, &ImportState::documentChanged, this, &PageView::takeCurrent);
  connect(&state_, &ImportState::currentChanged, this, &PageView::takeCurrent);
  connect(&state_, &ImportState::resultChanged, this, &PageView::takeResult);
  connect(&state_, &ImportState::correctionsChanged, this, qOverload<>(&QWidget::update));
  connect(&state_, &ImportState::pageChanged, this, [this](int page) {
    if (page == state_.currentPage()) takeCurrent();
    followEarlyClick();
  });
  connect(&settings_, &ViewSettings::changed, this, qOverload<>(&QWidget::update));
}

PageView::~PageView() = default;

void PageView::setTool(PageToolKind kind) {
  tool_->cancel();
  preview_.reset(), magnifier_.reset();
  toolKind_ = kind;
  retired_ = std::exchange(tool_, makeTool(kind, *this));
  endGesture();
  setCursor(tool_->cursor(mapFromGlobal(QCursor::pos())));
  emit toolChanged(kind);
  emit hint(tool_->hint());
  update();
}

const Corrections& PageView::shown() const {
  static const Corrections none;
  if (preview_) return *preview_;
  return state_.current() ? state_.current()->history.now() : none;
}

void PageView::setPreview(const std::optional<Corrections>& preview) {
  preview_ = preview;
  update();
}

std::optional<FrameCorners> PageView::shownCorners() const {
  if (!state_.current()) return {};
  if (shown().frame) return shown().frame;
  return state_.current()->corners();
}

bool PageView::isReading() const {
  return state_.opening() || state_.working() ||
         (state_.isOpen() && state_.searchedPages() < state_.pageCount());
}

importer::Point PageView::toPage(QPointF widget) const {
  const QPointF p = pageToWidget_.inverted().map(widget);
  return {p.x(), p.y()};
}

importer::Point PageView::onPage(importer::Point page) const {
  const QRectF bounds = pageBounds();
  return {std::clamp(page.x, bounds.left(), bounds.right()),
          std::clamp(page.y, bounds.top(), bounds.bottom())};
}

GraphColors PageView::colors() const { return graphColors(false); }

QRectF PageView::pageBounds() const {
  if (state_.sheet()) return state_.sheet()->bounds;
  if (state_.currentPage() < 1) return {};
  return state_.page(state_.currentPage()).bounds;
}

int PageView::quarterTurns() const {
  const ImportGraph* graph = state_.current();
  return graph && graph->listed ? graph->listed->quarterTurns : 0;
}

void PageView::takeResult() {
  const ImportGraph* graph = state_.current();
  const auto source =
      graph ? (graph->last && graph->last->evidence && !graph->good ? graph->last : graph->good) : nullptr;
  if (source != drawnFrom_ || !source) {
    drawnFrom_ = source;
    drawn_ = source ? editor::drawnFrom(*source) : DrawnResult{};
  }
  update();
}

void PageView::takeCurrent() {
  takeResult();
  const ImportGraph* graph = state_.current();
  const std::optional<GraphId> id = graph ? std::optional(graph->id) : std::nullopt;
  if (state_.currentPage() != fittedPage_ || id != fitted_ || fit_ != Fit::none) {
    if (state_.currentPage() != fittedPage_ || id != fitted_) fit_ = id ? Fit::graph : Fit::page;
    if (!pageBounds().isEmpty()) fittedPage_ = state_.currentPage(), fitted_ = id;
    refit();
  }
  update();
}

void PageView::refit() {
  fitDue_ = tool_->busy();
  if (fit_ == Fit::none || fitDue_) return;
  const auto corners = shownCorners();
  if (fit_ == Fit::graph && corners) {
    QPolygonF outline;
    for (const auto& c : *corners) outline << QPointF(c.x, c.y);
    const QRectF frame = outline.boundingRect();
    const double room = 0.22 * std::max(frame.width(), frame.height());
    QRectF shownPart = frame.adjusted(-room, -room, room, room);
    if (!pageBounds().isEmpty()) shownPart &= pageBounds();
    fitRect(shownPart, 10);
  } else if (!pageBounds().isEmpty()) {
    fitRect(pageBounds(), 14);
  }
}

void PageView::fitRect(QRectF page, double margin) {
  if (page.isEmpty()) return;
  const QTransform turn = QTransform().rotate(90.0 * quarterTurns());
  const QRectF turned = turn.mapRect(page);
  const double scale =
      std::clamp(std::min((width() - 2 * margin) / turned.width(), (height() - 2 * margin) / turned.height()),
                 leastZoom, mostZoom);
  const QPointF middle = turned.center() * scale;
  setTransform(turn * QTransform::fromScale(scale, scale) *
               QTransform::fromTranslate(0.5 * width() - middle.x(), 0.5 * height() - middle.y()));
}

void PageView::setTransform(const QTransform& pageToWidget) {
  pageToWidget_ = pageToWidget;
  update();
}

void PageView::fitPage() {
  fit_ = Fit::page;
  refit();
}

void PageView::fitGraph() {
  fit_ = Fit::graph;
  refit();
}

void PageView::zoomBy(double factor) {
  const QPointF at = QRectF(rect()).center();
  const double now = std::sqrt(std::abs(pageToWidget_.determinant()));
  factor = std::clamp(now * factor, leastZoom, mostZoom) / now;
  fit_ = Fit::none;
  setTransform(pageToWidget_ * QTransform::fromTranslate(-at.x(), -at.y()) *
               QTransform::fromScale(factor, factor) * QTransform::fromTranslate(at.x(), at.y()));
}

void PageView::panBy(QPointF delta) {
  fit_ = Fit::none;
  setTransform(pageToWidget_ * QTransform::fromTranslate(delta.x(), delta.y()));
}

void PageView::setMagnifier(std::optional<QPointF> widget) {
  magnifier_ = widget;
  update();
}

std::optional<QColor> PageView::curveColorAt(QPointF widget) const {
  const PagePicture* picture = drawnFrom_ && !drawnFrom_->view.empty() ? &drawnFrom_->view : nullptr;
  const importer::Point page = toPage(widget);
  if (!picture || !picture->colorAt({page.x, page.y}))
    picture = state_.sheet() ? &state_.sheet()->picture : nullptr;
  if (!picture) return {};
  constexpr int reach = 3;  // pixels of the picture: a line is easier to hit than its pixel
  const double step = 1 / picture->pixelsPerUnit();
  std::vector<QColor> patch;
  for (int dy = -2 * reach; dy <= 2 * reach; ++dy) {
    for (int dx = -2 * reach; dx <= 2 * reach; ++dx) {
      if (const auto color = picture->colorAt({page.x + dx * step, page.y + dy * step}))
        patch.push_back(*color);
    }
  }
  if (patch.empty()) return {};
  auto byLightness = patch;
  std::nth_element(
      byLightness.begin(), byLightness.begin() + static_cast<std::ptrdiff_t>(byLightness.size() / 2),
      byLightness.end(), [](const QColor& a, const QColor& b) { return a.lightness() < b.lightness(); });
  const QColor background = byLightness[byLightness.size() / 2];
  const auto contrast = [&background](const QColor& c) {
    return std::hypot(c.red() - background.red(), c.green() - background.green(),
                      c.blue() - background.blue());
  };
  std::optional<QColor> best;
  for (int dy = -reach; dy <= reach; ++dy) {
    for (int dx = -reach; dx <= reach; ++dx) {
      const auto color = picture->colorAt({page.x + dx * step, page.y + dy * step});
      if (color && (!best || contrast(*color) > contrast(*best))) best = color;
    }
  }
  return best;
}

void PageView::ask(const TypedValue& field) {
  closeEditor();
  auto* editor = described(new ValueEdit(field.text, this), "tickValue", field.name, field.name);
  editor->setPlaceholderText(field.placeholder);
  editor->setFixedWidth(valueField_px);
  QPoint place = toWidget(field.at).toPoint() + field.beside;
  place.setX(std::clamp(place.x(), 2, std::max(2, width() - valueField_px - 4)));
  place.setY(std::clamp(place.y(), 2, std::max(2, height() - 30)));
  editor->move(place);
  editor->selectAll();
  editor->show();
  editor->setFocus();
  const auto now = readQuantity(field.text, field.axis.quantity, field.axis.units).value;
  connect(editor, &QLineEdit::returnPressed, this, [this, editor, field, now] {
    const QuantityReading typed = readQuantity(editor->text(), field.axis.quantity, field.axis.units, now);
    if (typed.value) {
      closeEditor();
      return field.take(typed.shown);
    }
    const QString why = refusalOf(typed, field.axis.quantity, field.axis.units);
    editor->setAccessibleDescription(why);
    QToolTip::showText(editor->mapToGlobal(editor->rect().bottomLeft()), why, editor);
    emit hint(why);
  });
  connect(editor, &QLineEdit::editingFinished, editor, [editor] {
    if (!editor->hasFocus()) editor->deleteLater();  // Enter leaves the field open if its text is no number
  });
}

void PageView::askValue(GraphAxis axis, importer::Point at, std::optional<std::size_t> replaces) {
  const bool isX = axis == GraphAxis::x;
  TypedValue field;
  field.at = at;
  field.beside = isX ? QPoint(-valueField_px / 2, 8) : QPoint(-valueField_px - 8, -12);
  field.name = isX ? tr("Value of the displacement tick") : tr("Value of the force tick");
  QString unit;
  if (state_.current() && drawnFrom_ && drawnFrom_->evidence) {
    const auto& calibration = drawnFrom_->evidence->axes.calibration.value;
    const importer::AxisReading& reading = isX ? calibration.x : calibration.y;
    unit = QString::fromStdString(reading.unit);
    if (const auto corners = shownCorners()) {
      const double share = shareAlong(axis, *corners, at).value_or(0);
      field.text = numberText(reading.min + share * (reading.max - reading.min), 4);
    }
  }
  if (replaces) field.text = numberText(shown().axis(axis).ticks[*replaces].value, 6);
  field.placeholder = unit.isEmpty() ? tr("value") : tr("value in %1").arg(unit);
  field.axis = axisQuantity(axis, unit.toStdString());
  field.take = [this, axis, at, replaces, isX](double value) {
    Corrections next = shown();
    endsToTicks(next.axis(axis), axis, shownCorners());
    setTick(next.axis(axis), {at, value}, replaces);
    state_.apply(next, isX ? tr("Set displacement tick") : tr("Set force tick"));
  };
  ask(field);
}

void PageView::askOrigin(importer::Point at) {
  TypedValue field;
  field.at = at;
  field.beside = QPoint(-valueField_px - 8, 8);
  field.name = tr("Value of both axes at their common corner");
  field.text = numberText(0);
  field.placeholder = tr("value of both axes");
  field.take = [this, at](double value) {
    Corrections next = shown();
    for (const GraphAxis axis : {GraphAxis::x, GraphAxis::y}) {
      endsToTicks(next.axis(axis), axis, shownCorners());
      setTick(next.axis(axis), {at, value});
    }
    state_.apply(next, tr("Set the origin"));
  };
  ask(field);
}

bool PageView::takeEditor() {
  if (auto* editor = findChild<QLineEdit*>(QStringLiteral("tickValue")); editor && editor->isVisibleTo(this))
    emit editor->returnPressed();
  const auto* refused = findChild<QLineEdit*>(QStringLiteral("tickValue"));
  return !refused || !refused->isVisibleTo(this);
}

bool PageView::closeEditor() {
  auto* editor = findChild<QLineEdit*>(QStringLiteral("tickValue"));
  if (!editor || !editor->isVisibleTo(this)) return false;
  editor->setObjectName({});
  setFocus();
  editor->hide();
  editor->deleteLater();
  return true;
}

// ---- painting

DisplayUnits PageView::units() const {
  const ImportGraph* graph = state_.current();
  return graph ? unitsOfPage(*graph, settings_.units()) : settings_.units();
}

void PageView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const bool dark = isDark(palette());
  painter.fillRect(rect(), dark ? QColor("#2a2e33") : QColor("#c9ced4"));
  if (pageBounds().isEmpty() || state_.currentPage() < 1) {
    drawEmpty(painter);
    return;
  }
  drawPage(painter);
  painter.setRenderHint(QPainter::Antialiasing);
  drawOtherFrames(painter);
  const ImportGraph* graph = state_.current();
  if (graph) {
    const bool stale = !graph->upToDate(state_.quality()) || hasPreview();
    paintFindings(painter, {drawn_, shown(), shownCorners(), pageToWidget_, units(), stale});
  }
  if (doubt_) drawDoubt(painter);
  tool_->paint(painter);
  drawMagnifier(painter);
  if (hasFocus()) {
    painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(rect()).adjusted(1, 1, -1, -1));
  }
}

void PageView::setDoubt(std::optional<GraphAxis> axis) {
  if (axis == doubt_) return;
  doubt_ = axis;
  update();
}

// A band outside the frame, where the labels of the axis are.
void PageView::drawDoubt(QPainter& painter) const {
  constexpr double band_px = 44, opacity = 0.16;
  const auto corners = shownCorners();
  if (!corners) return;
  const QPointF start = toWidget((*corners)[3]), end = toWidget((*corners)[*doubt_ == GraphAxis::x ? 2 : 0]);
  const QPointF inside = toWidget((*corners)[*doubt_ == GraphAxis::x ? 0 : 2]) - start;
  const QPointF along = end - start;
  const double length = std::hypot(along.x(), along.y());
  if (length == 0) return;
  QPointF outwards = QPointF(along.y(), -along.x()) / length * band_px;
  if (QPointF::dotProduct(outwards, inside) > 0) outwards = -outwards;
  QColor accent = palette().color(QPalette::Highlight);
  painter.setPen(QPen(accent, 2));
  accent.setAlphaF(static_cast<float>(opacity));
  painter.setBrush(accent);
  painter.drawPolygon(QPolygonF({start, end, end + outwards, start + outwards}));
}

void PageView::drawPage(QPainter& painter) const {
  const QRectF paper = pageToWidget_.mapRect(pageBounds());
  painter.fillRect(paper.translated(3, 3), QColor(0, 0, 0, 60));
  painter.fillRect(paper, Qt::white);
  if (const PageSheet* sheet = state_.sheet()) {
    sheet->picture.draw(painter, pageToWidget_);
    // The graph's own view is sharper if a document was rendered for it.
    const bool sharper = drawnFrom_ && drawnFrom_->graph.page == state_.currentPage() &&
                         !drawnFrom_->view.empty() &&
                         drawnFrom_->view.pixelsPerUnit() > 1.2 * sheet->picture.pixelsPerUnit();
    const double shown = std::sqrt(std::abs(pageToWidget_.determinant())) * devicePixelRatioF();
    if (sharper && shown > sheet->picture.pixelsPerUnit()) drawnFrom_->view.draw(painter, pageToWidget_);
  } else if (const QImage& thumbnail = state_.page(state_.currentPage()).thumbnail; !thumbnail.isNull()) {
    const QTransform toPage = QTransform::fromScale(pageBounds().width() / thumbnail.width(),
                                                    pageBounds().height() / thumbnail.height()) *
                              QTransform::fromTranslate(pageBounds().left(), pageBounds().top());
    painter.save();
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.setTransform(toPage * pageToWidget_, true);
    painter.drawImage(QPointF(0, 0), thumbnail);
    painter.restore();
  }
  // Blended with the background, so that findings stand out.
  if (state_.current())
    painter.fillRect(paper, hasDarkBackground() ? QColor(0, 0, 0, 90) : QColor(255, 255, 255, 80));
}

/// The page's background as a whole, from its thumbnail.
bool PageView::hasDarkBackground() const {
  const QImage& thumbnail = state_.page(state_.currentPage()).thumbnail;
  if (thumbnail.isNull()) return false;
  if (thumbnail.cacheKey() != backgroundOf_) {
    backgroundOf_ = thumbnail.cacheKey();
    int dark = 0, all = 0;
    constexpr int step = 8;
    for (int y = step / 2; y < thumbnail.height(); y += step) {
      for (int x = step / 2; x < thumbnail.width(); x += step, ++all) {
        if (qGray(thumbnail.pixel(x, y)) < 100) ++dark;
      }
    }
    darkBackground_ = 2 * dark > all;
  }
  return darkBackground_;
}

void PageView::drawEmpty(QPainter& painter) const {
  const QColor text = palette().color(QPalette::WindowText);
  if (state_.isOpen() && state_.isForceLog()) return;
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(text, 1.5, Qt::DashLine));
  painter.setBrush(Qt::NoBrush);
  const QRectF zone = QRectF(rect()).adjusted(40, 40, -40, -40);
  if (!state_.isOpen() && !state_.opening()) painter.drawRoundedRect(zone, 12, 12);
  painter.setPen(text);
  QFont font = painter.font();
  font.setPointSizeF(1.2 * font.pointSizeF());
  painter.setFont(font);
  const QString words = state_.opening() || state_.isOpen()
                            ? tr("Opening %1 …").arg(state_.documentName())
                            : tr("Drop a datasheet or a force meter's log here,\npaste a picture of a graph "
                                 "(%1),\nor open a file (%2).")
                                  .arg(QKeySequence(QKeySequence::Paste).toString(QKeySequence::NativeText),
                                       QKeySequence(QKeySequence::Open).toString(QKeySequence::NativeText));
  painter.drawText(zone, Qt::AlignCenter | Qt::TextWordWrap, words);
}

void PageView::drawOtherFrames(QPainter& painter) const {
  painter.setBrush(Qt::NoBrush);
  for (const GraphId id : state_.graphs()) {
    const ImportGraph* graph = state_.graph(id);
    if (id.page != state_.currentPage() || graph == state_.current()) continue;
    const auto corners = graph->corners();
    if (!corners) continue;
    QPolygonF outline;
    for (const auto& c : *corners) outline << toWidget(c);
    painter.setPen(QPen(QColor(255, 255, 255, 200), 4));
    painter.drawPolygon(outline);
    painter.setPen(QPen(QColor("#00805c"), 2, Qt::DotLine));
    painter.drawPolygon(outline);
  }
  if (state_.current()) return;
  for (const auto& rejected : state_.page(state_.currentPage()).rejected) {
    const QRectF frame = pageToWidget_.mapRect(rectOf(rejected.frame));
    painter.setPen(QPen(QColor(255, 255, 255, 200), 5));
    painter.drawRect(frame);
    painter.setPen(QPen(palette().color(QPalette::Highlight), 2.5, Qt::DashLine));
    painter.drawRect(frame);
  }
}

void PageView::drawMagnifier(QPainter& painter) const {
  if (!magnifier_ || !state_.sheet()) return;
  constexpr double radius = 64, power = 4;
  const double side = magnifier_->x() + 2.6 * radius < width() ? 1 : -1,
               above = magnifier_->y() - 2.6 * radius > 0 ? -1 : 1;
  const QPointF middle = *magnifier_ + QPointF(side * 1.4 * radius, above * 1.4 * radius);
  const QTransform enlarged = pageToWidget_ * QTransform::fromTranslate(-magnifier_->x(), -magnifier_->y()) *
                              QTransform::fromScale(power, power) *
                              QTransform::fromTranslate(middle.x(), middle.y());
  QPainterPath glass;
  glass.addEllipse(middle, radius, radius);
  painter.save();
  painter.setClipPath(glass);
  painter.fillPath(glass, Qt::white);
  state_.sheet()->picture.draw(painter, enlarged);
  if (drawnFrom_ && drawnFrom_->graph.page == state_.currentPage() && !drawnFrom_->view.empty())
    drawnFrom_->view.draw(painter, enlarged);
  if (const auto corners = shownCorners()) {
    QPolygonF outline;
    for (const auto& c : *corners) outline << enlarged.map(QPointF(c.x, c.y));
    painter.setPen(QPen(QColor("#00805c"), 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolygon(outline);
  }
  painter.setPen(QPen(QColor(200, 16, 46, 200), 1));
  painter.drawLine(middle - QPointF(10, 0), middle + QPointF(10, 0));
  painter.drawLine(middle - QPointF(0, 10), middle + QPointF(0, 10));
  painter.restore();
  painter.setPen(QPen(QColor("#5b626b"), 2));
  painter.setBrush(Qt::NoBrush);
  painter.drawEllipse(middle, radius, radius);
}

// ---- mouse and keys

// Keeps the page still during a gesture, although a message above that appears or disappears moves the view.
void PageView::resizeEvent(QResizeEvent*) {
  refit();
  const QPointF moved = mapTo(window(), QPointF()) - inWindow_;
  inWindow_ += moved;
  if (tool_->busy()) setTransform(pageToWidget_ * QTransform::fromTranslate(-moved.x(), -moved.y()));
}

void PageView::endGesture() {
  if (fitDue_ && !tool_->busy()) refit();
}

void PageView::wheelEvent(QWheelEvent* event) {
  const QPoint pixels = event->pixelDelta();
  if (!pixels.isNull() && !(event->modifiers() & Qt::ControlModifier)) {
    panBy(pixels);
  } else {
    const QPointF at = event->position();
    const double now = std::sqrt(std::abs(pageToWidget_.determinant()));
    const double factor =
        std::clamp(now * std::pow(1.0015, event->angleDelta().y()), leastZoom, mostZoom) / now;
    fit_ = Fit::none;
    setTransform(pageToWidget_ * QTransform::fromTranslate(-at.x(), -at.y()) *
                 QTransform::fromScale(factor, factor) * QTransform::fromTranslate(at.x(), at.y()));
  }
  event->accept();
}

void PageView::mousePressEvent(QMouseEvent* event) {
  if (!tool_->busy()) inWindow_ = mapTo(window(), QPointF());
  if (event->button() == Qt::MiddleButton || (spaceDown_ && event->button() == Qt::LeftButton)) {
    panFrom_ = event->position();
    setCursor(Qt::ClosedHandCursor);
    return;
  }
  if (state_.currentPage() < 1 || tool_->press(*event)) return;
  if (event->button() != Qt::LeftButton) return;
  earlyClick_.reset();
  if (!state_.isForceLog() && !state_.page(state_.currentPage()).searched) {
    earlyClick_ = EarlyClick{state_.currentPage(), toPage(event->position())};
    emit hint(tr("This page is still being searched. Your click takes effect as soon as that is done."));
    return;
  }
  selectAt(event->position());
}

void PageView::selectAt(QPointF widget) {
  if (const auto id = graphAt(widget)) return state_.selectGraph(*id);
  if (const auto index = rejectedAt(widget)) {
    const auto& box = state_.page(state_.currentPage()).rejected[*index].frame;
    state_.addGraph({{{box.x0, box.y0}, {box.x1, box.y0}, {box.x1, box.y1}, {box.x0, box.y1}}});
  }
}

void PageView::followEarlyClick() {
  if (!earlyClick_ || earlyClick_->page != state_.currentPage() ||
      !state_.page(state_.currentPage()).searched)
    return;
  const QPointF at = toWidget(earlyClick_->at);
  earlyClick_.reset();
  emit hint(tool_->hint());
  selectAt(at);
}

void PageView::mouseMoveEvent(QMouseEvent* event) {
  if (panFrom_) {
    panBy(event->position() - *panFrom_);
    panFrom_ = event->position();
    return;
  }
  tool_->move(*event);
  const bool overOther = toolKind_ == PageToolKind::adjust && !tool_->busy() &&
                         (graphAt(event->position()) || rejectedAt(event->position()));
  setCursor(spaceDown_  ? QCursor(Qt::OpenHandCursor)
            : overOther ? QCursor(Qt::PointingHandCursor)
                        : tool_->cursor(event->position()));
}

void PageView::mouseReleaseEvent(QMouseEvent* event) {
  if (panFrom_) {
    panFrom_.reset();
    return;
  }
  tool_->release(*event);
  endGesture();
  emit hint(tool_->hint());
}

void PageView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (!tool_->doubleClick(*event)) return mousePressEvent(event);
  endGesture();
}

void PageView::contextMenuEvent(QContextMenuEvent* event) {
  if (state_.currentPage() < 1 || tool_->busy() || !tool_->menu(event->pos(), event->globalPos()))
    QWidget::contextMenuEvent(event);
}

void PageView::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && closeEditor()) return;
  if (event->key() == Qt::Key_Escape && tool_->busy()) {
    tool_->cancel();
    endGesture();
    return;
  }
  if (event->key() == Qt::Key_Escape && toolKind_ != PageToolKind::adjust)
    return setTool(PageToolKind::adjust);
  if (event->key() == Qt::Key_Space && !event->isAutoRepeat()) {
    spaceDown_ = true;
    setCursor(Qt::OpenHandCursor);
    return;
  }
  if (event->key() == Qt::Key_Plus || event->key() == Qt::Key_Equal) return zoomBy(1.25);
  if (event->key() == Qt::Key_Minus) return zoomBy(0.8);
  if (!tool_->key(*event)) return QWidget::keyPressEvent(event);
  endGesture();
}

void PageView::keyReleaseEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Space && !event->isAutoRepeat()) {
    spaceDown_ = false;
    setCursor(tool_->cursor(mapFromGlobal(QCursor::pos())));
    return;
  }
  QWidget::keyReleaseEvent(event);
}

bool PageView::focusNextPrevChild(bool next) {
  if (hasFocus() && tool_->selectNext(next)) {
    emit hint(tool_->hint());
    return true;
  }
  return QWidget::focusNextPrevChild(next);
}

std::optional<std::size_t> PageView::rejectedAt(QPointF widget) const {
  if (state_.currentPage() < 1 || state_.current()) return {};
  const auto& rejected = state_.page(state_.currentPage()).rejected;
  for (std::size_t i = 0; i < rejected.size(); ++i) {
    if (pageToWidget_.mapRect(rectOf(rejected[i].frame)).contains(widget)) return i;
  }
  return {};
}

std::optional<GraphId> PageView::graphAt(QPointF widget) const {
  const importer::Point page = toPage(widget);
  for (const GraphId id : state_.graphs()) {
    const ImportGraph* graph = state_.graph(id);
    if (id.page != state_.currentPage() || graph == state_.current()) continue;
    if (const auto corners = graph->corners()) {
      QPolygonF outline;
      for (const auto& c : *corners) outline << QPointF(c.x, c.y);
      if (outline.containsPoint({page.x, page.y}, Qt::OddEvenFill)) return id;
    }
  }
  return {};
}

bool PageView::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip && state_.currentPage() > 0) {
    const auto* help = static_cast<QHelpEvent*>(event);
    if (const auto id = graphAt(help->pos())) {
      QToolTip::showText(help->globalPos(), tr("Graph %1: click to import it").arg(id->graph), this);
    } else if (const auto index = rejectedAt(help->pos())) {
      const Advice advice =
          adviceFor(state_.page(state_.currentPage()).rejected[*index].why, state_.documentName());
      QToolTip::showText(
          help->globalPos(),
          tr("Not recognised as a force graph: %1 Click to import it by hand.").arg(advice.problem), this);
    } else {
      QToolTip::hideText();
    }
    return true;
  }
  return QWidget::event(event);
}

}  // namespace detent::editor
