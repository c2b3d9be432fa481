// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Exports of a tab in other formats.

#include <functional>
#include <QObject>

#include "editor/window/controller_context.h"

namespace detent::editor {

class ComparePanel;

/// Asks for the path, writes whole files, and shows problems in the tab. GUI thread.
class ExportController : public QObject {
  Q_OBJECT

 public:
  explicit ExportController(const ControllerContext& context, QObject* parent = nullptr);

  void csv(DocumentTab& tab);
  /// CSV at even steps or at given travels, which the user types.
  void csvAt(DocumentTab& tab);
  /// CSV with decimal commas, and semicolons between the fields.
  void semicolonCsv(DocumentTab& tab);
  /// Exports the graph for printing, with the settings of a dialogue.
  void graph(DocumentTab& tab);
  void png(DocumentTab& tab);
  /// Exports the comparison's plot; problems are shown in `tab`.
  void comparison(DocumentTab& tab, const ComparePanel& comparison);
  void wav(DocumentTab& tab);
  /// A folder of tables with their description.
  void dataPackage(DocumentTab& tab);
  /// Exports the shown state for WebPlotDigitizer.
  void tracedProject(DocumentTab& tab);
  /// The button as a web page anyone can press.
  void page(DocumentTab& tab);
  /// A press in the format of another device, which a dialogue requests.
  void device(DocumentTab& tab);

  /// Settings of a magnetic keyboard's key, as a C header for its firmware.
  void magneticKey(DocumentTab& tab);

 signals:
  /// Something was written: a sentence for the status bar.
  void done(const QString& sentence);

 private:
  /// `ending` is added to a name without one. A folder has no ending. `chosen` as in Prompts::fileToSave.
  void write(DocumentTab& tab, const QString& title, const QString& filter, const QString& ending,
             const std::function<Result<Done>(const QString&)>& writeTo, QString* chosen = nullptr);
  /// Writes samples in the units shown or, if the user chooses that, in mm and N.
  void samples(DocumentTab& tab, const QString& kind,
               const std::function<Result<Done>(const QString&, const DisplayUnits&)>& writeTo);

  ControllerContext at_;
};

}  // namespace detent::editor
