// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the desks of the window work with: the tabs, the disk's folders, the person's answers.

#include <QDir>
#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>

#include "editor/files/recovery_store.h"
#include "editor/window/prompts.h"
#include "editor/window/tab_area.h"

namespace detent::editor {

/// All of it outlives the desks. GUI thread.
struct DeskPlaces {
  QWidget& window;  ///< parent of dialogues
  TabArea& tabs;
  NoticeBar& notices;  ///< for what belongs to no tab
  ViewSettings& view;
  QSettings& settings;
  Prompts& prompts;
  RecoveryStore& recovery;

  /// Where the person opened or saved last; their documents at first.
  QString folder() const {
    const QString last = settings.value("files/folder").toString();
    return QFileInfo(last).isDir() ? last
                                   : QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  }
  void rememberFolder(const QString& path) const {
    settings.setValue("files/folder", QFileInfo(path).absolutePath());
  }
};

/// A path as the person's system writes it.
inline QString shownPath(const QString& path) { return QDir::toNativeSeparators(path); }

}  // namespace detent::editor
