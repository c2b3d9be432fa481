// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The command line of detent-edit.

#include <QString>
#include <QStringList>

namespace detent::editor {

struct Arguments {
  QStringList files;
  bool help = false, version = false;
  QString wrongUsage;  ///< a sentence; empty if the line can be carried out
};

/// `words` without the program's name. "--" ends the options; words after it are files. Options of Qt's own
/// ("-platform offscreen") are left to Qt.
Arguments argumentsFrom(const QStringList& words);

/// Text of --help.
QString helpText();

}  // namespace detent::editor
