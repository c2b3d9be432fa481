// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The questions that block the window, in one place, so that tests can answer them.

#include <optional>
#include <QStringList>
#include <QWidget>
#include <string>

#include "editor/window/device_export_dialog.h"
#include "editor/window/graph_export_dialog.h"
#include "editor/window/magnetic_dialog.h"
#include "model/button.h"

class QPrinter;

namespace detent::editor {

enum class SaveChoice { save, discard, cancel };

/// Asks the user; every function opens one modal dialogue. GUI thread.
class Prompts {
 public:
  Prompts() = default;
  virtual ~Prompts() = default;
  Prompts(const Prompts&) = delete;
  Prompts& operator=(const Prompts&) = delete;

  /// Asks about the unsaved changes of buttons that are about to be closed.
  virtual SaveChoice unsaved(QWidget* parent, const QStringList& titles);
  /// `filters` as QFileDialog takes them; an empty result: cancelled.
  virtual QStringList filesToOpen(QWidget* parent, const QString& title, const QString& folder,
                                  const QStringList& filters);
  virtual QString folder(QWidget* parent, const QString& title, const QString& at);
  /// `chosen` becomes the one of several filters (separated by ";;") that was chosen.
  virtual QString fileToSave(QWidget* parent, const QString& title, const QString& suggested,
                             const QString& filter, QString* chosen = nullptr);
  /// Asks before an action that cannot be undone; `act` is the text of its button.
  virtual bool confirm(QWidget* parent, const QString& question, const QString& act);
  /// Asks for the button to start from.
  virtual std::optional<Button> newButton(QWidget* parent);
  /// Requests the device for which a press of the button is written.
  virtual std::optional<DeviceChoice> deviceExport(QWidget* parent, const Button& button);
  /// Asks for the settings of the graph's picture.
  virtual std::optional<GraphExport> graphExport(QWidget* parent, const Button& button,
                                                 const DisplayUnits& units);
  /// Asks for the settings of a magnetic keyboard's key, initially `choice`, which becomes what was chosen
  /// even if it is cancelled; returns the C header.
  virtual std::optional<std::string> magneticKey(QWidget* parent, const Button& button,
                                                 const DisplayUnits& units, MagneticChoice& choice);
  /// Requests the printer; false: cancelled.
  virtual bool printer(QWidget* parent, QPrinter& printer);
  /// Asks for a text, initially `text`; nullopt: cancelled.
  virtual std::optional<QString> text(QWidget* parent, const QString& title, const QString& label,
                                      const QString& now);
};

}  // namespace detent::editor
