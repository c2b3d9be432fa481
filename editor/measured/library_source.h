// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Reads and fills the library's file without stopping the window.

#include <atomic>
#include <functional>
#include <memory>
#include <QObject>
#include <QString>
#include <QThreadPool>

#include "editor/measured/measured_table.h"

namespace detent::editor {

struct LibraryRequest {
  importer::IndexRequest index;
  bool pages = false;  ///< pages and pictures of datasheets too: seconds each
};

/// One worker thread executes the requests in order. GUI thread; answers come through the event loop.
class LibrarySource : public QObject {
  Q_OBJECT

 public:
  explicit LibrarySource(QObject* parent = nullptr);
  ~LibrarySource() override;  ///< cancels running work and waits for it

  /// Loads a library; `loaded` or `failed` follows. A library that cannot be read, for example that of
  /// another version, is rebuilt from `orFrom`'s folders as by index().
  void load(const QString& database, LibraryRequest orFrom = {});
  /// Emits `indexed` or `failed`, then the signals of load(); `progressed` meanwhile.
  void index(LibraryRequest request);
  /// Ends an index run; files read so far are kept and loaded.
  void cancel();
  /// Emits `failed` for each switch that cannot be read, then `opened` once with all the others.
  void open(const std::vector<importer::LibrarySwitch>& entries);

 signals:
  void loaded(const QString& database, std::shared_ptr<const detent::editor::MeasuredSwitches> switches);
  void indexed(const detent::importer::IndexSummary& summary);
  void progressed(double fraction, const QString& file);
  /// All switches of one call of open() that could be read.
  void opened(const std::vector<detent::Button>& buttons);
  void failed(const QString& sentence);

 private:
  void loadHere(const QString& database);  // worker thread
  void indexHere(LibraryRequest request);  // worker thread
  /// Reader of pages on the worker's thread, page by page, as in the import window.
  importer::PageReader pageReader();
  void run(std::function<void()> work);

  std::atomic<bool> cancelled_{false};
  QThreadPool worker_;  // last member, because its thread uses the others
};

}  // namespace detent::editor
