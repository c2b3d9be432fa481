// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/measured/library_source.h"

#include <QElapsedTimer>
#include <QFile>

#include "editor/document/message_words.h"

namespace detent::editor {

LibrarySource::LibrarySource(QObject* parent) : QObject(parent) {
  worker_.setMaxThreadCount(1);
  qRegisterMetaType<std::shared_ptr<const MeasuredSwitches>>();
}

LibrarySource::~LibrarySource() {
  cancelled_ = true;
  worker_.clear();
  worker_.waitForDone();
}

void LibrarySource::cancel() { cancelled_ = true; }

void LibrarySource::run(std::function<void()> work) { worker_.start(std::move(work)); }

void LibrarySource::load(const QString& database, LibraryRequest orFrom) {
  cancelled_ = false;
  run([this, database, orFrom = std::move(orFrom)]() mutable {
    const bool isReadable(importer::LibraryStore::openToRead(QFile::encodeName(database).toStdString()));
    if (isReadable || orFrom.index.folders.empty()) return loadHere(database);
    indexHere(std::move(orFrom));
  });
}

void LibrarySource::loadHere(const QString& database) {
  const auto store = importer::LibraryStore::openToRead(QFile::encodeName(database).toStdString());
  if (!store) return emit failed(sentenceOf(store.failure()));
  auto switches = store->switches();
  if (!switches) return emit failed(sentenceOf(switches.failure()));
  auto all = std::make_shared<MeasuredSwitches>();
  all->switches = std::move(*switches);
  all->map = importer::feelMapOf(all->switches);
  const auto ratings = store->ratings();
  if (!ratings) return emit failed(sentenceOf(ratings.failure()));
  all->ratings = importer::RatingsByName(*ratings);
  emit loaded(database, std::move(all));
}

importer::PageReader LibrarySource::pageReader() {
  return [this](const std::vector<std::string>& paths, const auto& take) -> Result<Done> {
    for (const std::string& path : paths) {
      if (cancelled_) return Failure::cancelled();
      const auto buttons = importer::readPageButtons(path, importer::Quality::standard);
      take(path, buttons ? importer::switchesOfPage(*buttons, path)
                         : Result<std::vector<importer::LibrarySwitch>>(buttons.failure()));
    }
    return Done{};
  };
}

void LibrarySource::index(LibraryRequest request) {
  cancelled_ = false;
  run([this, request = std::move(request)]() mutable { indexHere(std::move(request)); });
}

void LibrarySource::indexHere(LibraryRequest request) {
  constexpr qint64 reportEvery_ms = 50;
  QElapsedTimer sinceReport;
  importer::IndexProgress progress;
  progress.cancelled = [this] { return cancelled_.load(); };
  progress.report = [&](double fraction, const std::string& file) {
    if (sinceReport.isValid() && sinceReport.elapsed() < reportEvery_ms) return;
    sinceReport.start();
    emit progressed(fraction, QFile::decodeName(QByteArray::fromStdString(file)));
  };
  if (request.pages) request.index.readPages = pageReader();
  const auto summary = importer::indexFolders(request.index, progress);
  if (!summary)
    emit failed(sentenceOf(summary.failure()));
  else
    emit indexed(*summary);
  loadHere(QFile::decodeName(QByteArray::fromStdString(request.index.database)));
}

void LibrarySource::open(const std::vector<importer::LibrarySwitch>& entries) {
  run([this, entries] {
    std::vector<Button> buttons;
    for (const importer::LibrarySwitch& entry : entries) {
      auto button = importer::buttonOf(entry, importer::Quality::standard);
      if (button)
        buttons.push_back(*std::move(button));
      else
        emit failed(sentenceOf(button.failure()));
    }
    emit opened(buttons);
  });
}

}  // namespace detent::editor
