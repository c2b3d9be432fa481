// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The page with everything that was found on it, and the tool that corrects it.

#include <functional>
#include <memory>
#include <optional>
#include <QTransform>
#include <QWidget>

#include "editor/document/graph_colors.h"
#include "editor/document/view_settings.h"
#include "editor/importing/axis_quantity.h"
#include "editor/importing/drawn_result.h"
#include "editor/importing/import_state.h"

namespace detent::editor {

class PageTool;
enum class PageToolKind {
  adjust,
  scale,
  drawFrame,
  pressColor,
  releaseColor,
  drawPress,
  drawRelease,
  maskBox,
  maskBrush,
  pan
};

/// Draws page, findings and corrections; wheel zooms at the pointer, middle button or space drags the page.
/// GUI thread.
class PageView : public QWidget {
  Q_OBJECT
  Q_PROPERTY(QTransform pageToWidget READ pageToWidget)
  Q_PROPERTY(bool reading READ isReading)

 public:
  /// Both must outlive it.
  PageView(ImportState& state, ViewSettings& settings, QWidget* parent = nullptr);
  ~PageView() override;

  PageToolKind tool() const { return toolKind_; }
  void setTool(PageToolKind kind);

  void zoomBy(double factor);
  void fitPage();
  void fitGraph();

  // -- for tools --
  ImportState& state() { return state_; }
  const ImportState& state() const { return state_; }
  /// Corrections as being dragged, otherwise as stored.
  const Corrections& shown() const;
  void setPreview(const std::optional<Corrections>& preview);
  bool hasPreview() const { return preview_.has_value(); }
  std::optional<FrameCorners> shownCorners() const;
  const DrawnResult& drawn() const { return drawn_; }
  QTransform pageToWidget() const { return pageToWidget_; }
  /// Returns true while an import may still change what the page shows.
  bool isReading() const;
  QPointF toWidget(importer::Point page) const { return pageToWidget_.map(QPointF(page.x, page.y)); }
  importer::Point toPage(QPointF widget) const;
  /// A point moved onto the page.
  importer::Point onPage(importer::Point page) const;
  GraphColors colors() const;
  /// Units of the labels: those of the page's axes, so that a person can compare both; without a graph, the
  /// display units.
  DisplayUnits units() const;
  /// Colour of the mark nearest to a point: the pixel that differs most from the background around it.
  std::optional<QColor> curveColorAt(QPointF widget) const;
  void panBy(QPointF widgetDelta);
  /// Opens a field for the value at a place of an axis; the typed value becomes one step.
  void askValue(GraphAxis axis, importer::Point at, std::optional<std::size_t> replaces);
  /// Asks for the value that both axes have in the corner where they meet: one step sets a tick on each.
  void askOrigin(importer::Point at);
  /// Shows a sentence about the attempted action in place of the tool's hint.
  void say(const QString& sentence) { emit hint(sentence); }
  /// Marks the axis that is in question; nullopt: none.
  void setDoubt(std::optional<GraphAxis> axis);
  /// Position of the magnifier; nullopt hides it.
  void setMagnifier(std::optional<QPointF> widget);
  /// Accepts the open value field on the page, as Enter does; false if it cannot be read and stays open.
  bool takeEditor();

 signals:
  void toolChanged(PageToolKind kind);
  void hint(const QString& text);  ///< effect of the tool, or the reason of a refusal

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;
  bool focusNextPrevChild(bool next) override;
  QSize sizeHint() const override { return {720, 600}; }
  QSize minimumSizeHint() const override { return {200, 140}; }

 private:
  enum class Fit { page, graph, none };
  /// A value that is typed at a place of the page.
  struct TypedValue {
    QString name, text, placeholder;
    importer::Point at;
    QPoint beside;  ///< offset of the field from the place
    AxisQuantity axis;
    std::function<void(double)> take;  ///< in the printed unit
  };
  void ask(const TypedValue& field);
  bool closeEditor();  ///< closes the field of a tick's value; returns false if none is open
  void takeResult();
  void takeCurrent();
  void refit();       ///< waits for endGesture during a gesture
  void endGesture();  ///< does delayed work, unless another gesture is running
  void fitRect(QRectF page, double margin);
  void setTransform(const QTransform& pageToWidget);
  QRectF pageBounds() const;
  int quarterTurns() const;
  void drawPage(QPainter& painter) const;
  bool hasDarkBackground() const;
  void drawEmpty(QPainter& painter) const;
  void drawOtherFrames(QPainter& painter) const;
  void drawMagnifier(QPainter& painter) const;
  void drawDoubt(QPainter& painter) const;
  std::optional<std::size_t> rejectedAt(QPointF widget) const;
  std::optional<GraphId> graphAt(QPointF widget) const;
  /// Selects the graph at a place, or adopts a rejected rectangle there as a graph.
  void selectAt(QPointF widget);
  void followEarlyClick();

  ImportState& state_;
  ViewSettings& settings_;
  std::unique_ptr<PageTool> tool_;
  /// previous tool; kept, because it may be the one that requested its successor
  std::unique_ptr<PageTool> retired_;
  PageToolKind toolKind_ = PageToolKind::adjust;
  std::optional<Corrections> preview_;
  DrawnResult drawn_;
  std::shared_ptr<const ImportedGraph> drawnFrom_;  ///< good result the curves come from
  QTransform pageToWidget_;
  Fit fit_ = Fit::graph;
  bool fitDue_ = false;  ///< a refit is pending until the gesture ends
  QPointF inWindow_;     ///< position of the top left corner when the gesture began or last moved
  std::optional<GraphId> fitted_;
  int fittedPage_ = 0;
  std::optional<QPointF> panFrom_, magnifier_;
  std::optional<GraphAxis> doubt_;
  /// A click on a page that was not searched yet; handled after the search.
  struct EarlyClick {
    int page = 0;
    importer::Point at;
  };
  std::optional<EarlyClick> earlyClick_;
  bool spaceDown_ = false;
  mutable qint64 backgroundOf_ = 0;  ///< key of the thumbnail from which the background was read
  mutable bool darkBackground_ = false;
};

}  // namespace detent::editor
