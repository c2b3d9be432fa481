// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Environment of the window's controllers: the tabs, folders on the disk, and the user's answers.

#include <QDir>
#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>

#include "editor/files/recovery_store.h"
#include "editor/window/prompts.h"
#include "editor/window/tab_area.h"

namespace detent::editor {

/// All of it outlives the controllers. GUI thread.
struct ControllerContext {
  QWidget& window;  ///< parent of dialogues
  TabArea& tabs;
  NoticeBar& notices;  ///< notices that belong to no tab
  ViewSettings& view;
  QSettings& settings;
  Prompts& prompts;
  RecoveryStore& recovery;

  /// Folder of the last file that was opened or saved; at first the user's documents, or its replacement. A
  /// missing folder would appear in the dialogue as the name of a file.
  QString folder(const char* key = "files/folder") const {
    for (const QString& each : {settings.value(key).toString(), settings.value("files/folder").toString(),
                                QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)})
      if (QFileInfo(each).isDir()) return each;
    return QDir::homePath();
  }
  /// Folder of the last file that was saved or exported. Pages that are looked at do not change it.
  QString folderToSave() const { return folder("files/savedIn"); }
  /// Folder of the last page that was imported; saving elsewhere does not change it.
  QString folderToImport() const { return folder("files/importedFrom"); }
  void rememberFolder(const QString& folder) const { settings.setValue("files/folder", folder); }
  void rememberFolderOf(const QString& path) const { rememberFolder(QFileInfo(path).absolutePath()); }
  void rememberImportedFrom(const QString& folder) const {
    rememberFolder(folder);
    settings.setValue("files/importedFrom", folder);
  }
  void rememberImportOf(const QString& path) const { rememberImportedFrom(QFileInfo(path).absolutePath()); }
  void rememberSavedIn(const QString& folder) const {
    rememberFolder(folder);
    settings.setValue("files/savedIn", folder);
  }
};

/// A path in the notation of the user's system.
inline QString shownPath(const QString& path) { return QDir::toNativeSeparators(path); }

}  // namespace detent::editor
