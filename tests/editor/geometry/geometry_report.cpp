// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/editor/geometry/geometry_report.h"

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QDateTime>
#include <QFile>
#include <QHeaderView>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QSaveFile>
#include <QTabBar>
#include <QTableWidget>
#include <QTransform>
#include <QWidget>
#include <QWindow>

#include <qcustomplot.h>

namespace detent::editor {
namespace {

constexpr int period_ms = 100;

QJsonArray rectJson(const QRect& rect) { return {rect.x(), rect.y(), rect.width(), rect.height()}; }

QRect onScreen(const QWidget& widget, const QRect& rect) {
  return {widget.mapToGlobal(rect.topLeft()), rect.size()};
}

QString textOf(const QWidget& widget) {
  if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) return button->text();
  if (const auto* label = qobject_cast<const QLabel*>(&widget)) return label->text();
  if (const auto* edit = qobject_cast<const QLineEdit*>(&widget)) return edit->text();
  if (const auto* combo = qobject_cast<const QComboBox*>(&widget)) return combo->currentText();
  return {};
}

QJsonObject axesJson(const QCustomPlot& plot) {
  const auto axis = [](const QCPAxis& a) { return QJsonArray{a.label(), a.range().lower, a.range().upper}; };
  return {{"x", axis(*plot.xAxis)},
          {"y", axis(*plot.yAxis)},
          {"rect", rectJson(onScreen(plot, plot.axisRect()->rect()))}};
}

QJsonArray transformJson(const QTransform& t) { return {t.m11(), t.m12(), t.m21(), t.m22(), t.dx(), t.dy()}; }

QJsonArray actionsJson(const QMenu& menu) {
  QJsonArray all;
  for (QAction* action : menu.actions())
    if (!action->isSeparator())
      all.append(QJsonObject{{"name", action->objectName()},
                             {"text", action->text()},
                             {"enabled", action->isEnabled()},
                             {"rect", rectJson(onScreen(menu, menu.actionGeometry(action)))}});
  return all;
}

// The visible cells of a table: row, column, text and rectangle.
QJsonArray cellsJson(const QTableView& table) {
  QJsonArray all;
  const QAbstractItemModel* model = table.model();
  for (int row = 0; model && row < model->rowCount(); ++row)
    for (int column = 0; column < model->columnCount(); ++column) {
      const QModelIndex index = model->index(row, column);
      const QRect rect = table.visualRect(index).intersected(table.viewport()->rect());
      if (rect.isEmpty()) continue;
      QJsonObject cell{{"row", row},
                       {"column", column},
                       {"text", index.data().toString()},
                       {"rect", rectJson(onScreen(*table.viewport(), rect))}};
      if (!table.verticalHeader()->isHidden()) cell["name"] = model->headerData(row, Qt::Vertical).toString();
      all.append(cell);
    }
  return all;
}

QJsonObject widgetJson(const QWidget& widget) {
  QJsonObject object{{"name", widget.objectName()},
                     {"class", widget.metaObject()->className()},
                     {"window", widget.window()->objectName()},
                     {"rect", rectJson(onScreen(widget, widget.rect()))},
                     {"enabled", widget.isEnabled()},
                     {"focus", widget.hasFocus()}};
  if (const QString text = textOf(widget); !text.isEmpty()) object["text"] = text;
  if (const auto* button = qobject_cast<const QAbstractButton*>(&widget); button && button->isCheckable())
    object["checked"] = button->isChecked();
  if (const auto* plot = qobject_cast<const QCustomPlot*>(&widget)) object["axes"] = axesJson(*plot);
  // properties of PageView (editor/importing/page_view.h)
  if (const QVariant page = widget.property("pageToWidget"); page.isValid()) {
    object["page"] = transformJson(page.value<QTransform>());
    object["reading"] = widget.property("reading").toBool();
  }
  if (const auto* menu = qobject_cast<const QMenu*>(&widget)) object["actions"] = actionsJson(*menu);
  if (const auto* table = qobject_cast<const QTableView*>(&widget)) object["cells"] = cellsJson(*table);
  if (const auto* tabs = qobject_cast<const QTabBar*>(&widget)) {
    QJsonArray texts;
    for (int i = 0; i < tabs->count(); ++i) texts.append(tabs->tabText(i));
    object["tabs"] = texts;
  }
  return object;
}

// Qt's internal widgets have names too, but they are of no use to a test.
bool worthTelling(const QWidget& widget) {
  return widget.isVisible() && !widget.objectName().isEmpty() && !widget.objectName().startsWith("qt_");
}

}  // namespace

QByteArray geometryJson() {
  QJsonArray windows, widgets;
  for (const QWidget* window : QApplication::topLevelWidgets())
    if (window->isVisible())
      windows.append(QJsonObject{{"title", window->windowTitle()},
                                 {"name", window->objectName()},
                                 {"active", window->isActiveWindow()},
                                 {"modal", window->isModal()},
                                 {"exposed", window->windowHandle() && window->windowHandle()->isExposed()},
                                 {"rect", rectJson(onScreen(*window, window->rect()))}});
  for (const QWidget* widget : QApplication::allWidgets())
    if (worthTelling(*widget)) widgets.append(widgetJson(*widget));
  return QJsonDocument(QJsonObject{{"windows", windows}, {"widgets", widgets}})
      .toJson(QJsonDocument::Compact);
}

GeometryReport::GeometryReport(QString file, QObject* parent) : QObject(parent), file_(std::move(file)) {
  timer_.setInterval(period_ms);
  connect(&timer_, &QTimer::timeout, this, &GeometryReport::write);
  timer_.start();
  QTimer::singleShot(0, this, &GeometryReport::write);
}

void GeometryReport::write() {
  const QByteArray now = geometryJson();
  if (now == last_) {
    QFile same(file_);
    if (same.open(QIODevice::ReadWrite | QIODevice::ExistingOnly)) {
      same.setFileTime(QDateTime::currentDateTime(), QFileDevice::FileModificationTime);
      return;
    }
  }
  QSaveFile file(file_);
  if (file.open(QIODevice::WriteOnly) && file.write(now) == now.size() && file.commit()) last_ = now;
}

}  // namespace detent::editor
