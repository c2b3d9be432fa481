// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/window/arguments.h"

#include <algorithm>
#include <QCommandLineParser>

namespace detent::editor {
namespace {

// Of QGuiApplication and QApplication; most take a value, as the next word or behind "=".
const QStringList qtOptionsWithValue = {"platform",        "platformpluginpath", "platformtheme", "plugin",
                                        "qwindowgeometry", "qwindowicon",        "qwindowtitle",  "session",
                                        "style",           "stylesheet",         "display",       "geometry"};
const QStringList qtSwitches = {"reverse", "widgetcount"};

}  // namespace

Arguments argumentsFrom(const QStringList& words) {
  QCommandLineParser parser;
  parser.setSingleDashWordOptionMode(QCommandLineParser::ParseAsLongOptions);  // as Qt's own are spelt
  parser.addOptions({{{"h", "help"}, {}}, {"version", {}}});
  for (const QString& name : qtOptionsWithValue) parser.addOption({name, {}, "value"});
  for (const QString& name : qtSwitches) parser.addOption({name, {}});
  parser.parse(QStringList("detent-edit") + words);
  Arguments arguments{parser.positionalArguments(), parser.isSet("help"), parser.isSet("version"), {}};
  const QStringList unknown = parser.unknownOptionNames();
  if (unknown.isEmpty()) return arguments;
  const auto typed = std::find_if(words.begin(), words.end(), [&](const QString& word) {
    return word.startsWith(QLatin1Char('-')) &&
           word.section(QLatin1Char('='), 0, 0).endsWith(unknown.first());
  });
  arguments.wrongUsage = QString("detent-edit: %1 is not an option. See detent-edit --help.")
                             .arg(typed == words.end() ? "--" + unknown.first() : *typed);
  return arguments;
}

// Not translated: scripts and manual pages rely on it.
QString helpText() {
  return QStringLiteral(
      "Shape a button by hand, see it, feel it. Files and options are in mm and N; the window can show "
      "other\n"
      "units.\n"
      "\n"
      "Usage: detent-edit [FILES...]\n"
      "\n"
      "  FILES      *.button.json, or CSV as detent-graph writes it: each opens in a tab.\n"
      "             PNG, JPEG, BMP, TIFF, WebP, GIF, PDF, SVG, or a force meter's CSV: opens in the import "
      "dialogue.\n"
      "\n"
      "  -h, --help     print this text and exit\n"
      "  --version      print the version and exit\n"
      "\n"
      "The window names files that cannot be opened and opens the others. Unsaved work is saved every 2\n"
      "seconds and offered after a crash. Qt's own options, such as -platform, are accepted.\n"
      "\n"
      "Exit codes: 0 done, 1 internal fault, 2 wrong usage, 6 no screen to open a window on.\n");
}

}  // namespace detent::editor
