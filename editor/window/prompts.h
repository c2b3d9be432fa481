// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The questions that stop the work, in one place, so that tests can answer them.

#include <optional>
#include <QStringList>
#include <QWidget>
#include <string>

#include "editor/window/device_export_dialog.h"
#include "editor/window/graph_export_dialog.h"
#include "model/button.h"

class QPrinter;

namespace detent::editor {

enum class SaveChoice { save, discard, cancel };

/// Asks a person; every function opens one modal dialogue. GUI thread.
class Prompts {
 public:
  Prompts() = default;
  virtual ~Prompts() = default;
  Prompts(const Prompts&) = delete;
  Prompts& operator=(const Prompts&) = delete;

  /// These have unsaved changes and are about to be closed.
  virtual SaveChoice unsaved(QWidget* parent, const QStringList& titles);
  /// Empty: cancelled. `filters` as QFileDialog has them.
  virtual QStringList filesToOpen(QWidget* parent, const QString& title, const QString& folder,
                                  const QStringList& filters);
  virtual QString folder(QWidget* parent, const QString& title, const QString& at);
  virtual QString fileToSave(QWidget* parent, const QString& title, const QString& suggested,
                             const QString& filter);
  /// Something that cannot be taken back; `act` is the text of the button that does it.
  virtual bool confirm(QWidget* parent, const QString& question, const QString& act);
  /// The button to start from.
  virtual std::optional<Button> newButton(QWidget* parent);
  /// Requests the device for which a press of the button is written.
  virtual std::optional<DeviceChoice> deviceExport(QWidget* parent, const Button& button);
  /// Format of the button's graph.
  virtual std::optional<GraphExport> graphExport(QWidget* parent, const Button& button,
                                                 const DisplayUnits& units);
  /// C header with the settings of a magnetic keyboard's key.
  virtual std::optional<std::string> magneticKey(QWidget* parent, const Button& button,
                                                 const DisplayUnits& units);
  /// Requests the printer; false: cancelled.
  virtual bool printer(QWidget* parent, QPrinter& printer);
  /// A text, changed or not; nullopt: cancelled.
  virtual std::optional<QString> text(QWidget* parent, const QString& title, const QString& label,
                                      const QString& now);
};

}  // namespace detent::editor
