// SPDX-License-Identifier: GPL-3.0-or-later
// A path as the system's C functions take it.
#pragma once

#include <QFile>
#include <QString>
#include <string>

namespace detent::editor {

/// The path in the encoding of the file system.
inline std::string nativePath(const QString& path) { return QFile::encodeName(path).toStdString(); }

}  // namespace detent::editor
