// SPDX-License-Identifier: GPL-3.0-or-later
// Plugin that a test loads into detent-edit to learn its widgets (e2e/desktop.py).
// QT_QPA_GENERIC_PLUGINS=widget_geometry starts the report; QT_PLUGIN_PATH names the folder whose folder
// "generic" holds the plugin. DETENT_WIDGET_GEOMETRY names the file, because Qt cuts the parameters of a
// plugin at commas, and a path may have one.

#include <QGenericPlugin>

#include "tests/editor/geometry/geometry_report.h"

namespace detent::editor {

class GeometryPlugin : public QGenericPlugin {
  Q_OBJECT
  Q_PLUGIN_METADATA(IID QGenericPluginFactoryInterface_iid FILE "geometry_plugin.json")

 public:
  QObject* create(const QString& /*key*/, const QString& /*parameters*/) override {
    return new GeometryReport(qEnvironmentVariable("DETENT_WIDGET_GEOMETRY"));
  }
};

}  // namespace detent::editor

#include "geometry_plugin.moc"
