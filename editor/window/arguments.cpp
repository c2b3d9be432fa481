#include "editor/window/arguments.h"

namespace detent::editor {

Arguments argumentsFrom(const QStringList& words) {
  Arguments arguments;
  bool optionsEnded = false;
  for (const QString& word : words) {
    if (optionsEnded || !word.startsWith('-') || word == "-")
      arguments.files << word;
    else if (word == "--")
      optionsEnded = true;
    else if (word == "--help" || word == "-h")
      arguments.help = true;
    else if (word == "--version")
      arguments.version = true;
    else if (arguments.wrongUsage.isEmpty())
      arguments.wrongUsage = QString("detent-edit: %1 is no option. See detent-edit --help.").arg(word);
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
      "Exit codes: 0 done, 1 internal fault, 2 wrong usage.\n");
}

}  // namespace detent::editor
