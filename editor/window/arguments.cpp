// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/window/arguments.h"

namespace detent::editor {
namespace {

// Of QGuiApplication and QApplication; most take a value, as the next word or behind "=".
const QStringList qtOptionsWithValue = {"platform",        "platformpluginpath", "platformtheme", "plugin",
                                        "qwindowgeometry", "qwindowicon",        "qwindowtitle",  "session",
                                        "style",           "stylesheet",         "display",       "geometry"};
const QStringList qtSwitches = {"reverse", "widgetcount"};

}  // namespace

Arguments argumentsFrom(const QStringList& words) {
  Arguments arguments;
  bool optionsEnded = false;
  for (qsizetype i = 0; i < words.size(); ++i) {
    const QString& word = words[i];
    const QString bare = word.mid(word.startsWith("--") ? 2 : 1);
    if (optionsEnded || !word.startsWith('-') || word == "-")
      arguments.files << word;
    else if (word == "--")
      optionsEnded = true;
    else if (word == "--help" || word == "-h")
      arguments.help = true;
    else if (word == "--version")
      arguments.version = true;
    else if (qtOptionsWithValue.contains(bare))
      ++i;
    else if (qtSwitches.contains(bare) || qtOptionsWithValue.contains(bare.section('=', 0, 0)))
      continue;
    else if (arguments.wrongUsage.isEmpty())
      arguments.wrongUsage = QString("detent-edit: %1 is not an option. See detent-edit --help.").arg(word);
  }
  return arguments;
}

// Not translated: scripts and manual pages rely on it.
QString helpText() {
  return QStringLiteral(
      "Shape a button by hand, see it, feel it. Displacement in mm and force in N inside; other units are a\n"
      "choice of the view.\n"
      "\n"
      "Usage: detent-edit [FILES...]\n"
      "\n"
      "  FILES      *.button.json, or CSV as detent-graph writes it: each opens in a tab.\n"
      "             PNG, JPEG, BMP, TIFF, WebP, PDF, SVG, or a force meter's CSV: opens in the import "
      "dialogue.\n"
      "\n"
      "  -h, --help     this text\n"
      "  --version      the version\n"
      "\n"
      "A file that cannot be opened is said in the window; the others open all the same. Unsaved work is "
      "kept\n"
      "every 2 seconds and offered again after a crash. Qt's own options, such as -platform, are "
      "understood.\n"
      "\n"
      "DETENT_EDIT_GEOMETRY=FILE writes names and screen places of all widgets to FILE as JSON, for tests.\n"
      "\n"
      "Exit codes: 0 done, 1 internal fault, 2 wrong usage, 6 no screen to open a window on.\n");
}

}  // namespace detent::editor
