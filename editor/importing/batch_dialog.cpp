// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/importing/batch_dialog.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>
#include <utility>

#include "editor/document/form_widgets.h"
#include "editor/document/message_words.h"
#include "editor/files/document_files.h"
#include "editor/files/input_kind.h"
#include "editor/importing/finding_words.h"
#include "model/file/button_file.h"

namespace detent::editor {
namespace {

enum Column { nameColumn, resultColumn, detailsColumn };
constexpr int rowRole = Qt::UserRole;
constexpr QSize firstBatchSize_px{860, 520};

bool isToCheck(const BatchResult& result) {
  return result.button && !result.checked && result.confidence < sureEnough;
}

QString inShort(const BatchResult& result) {
  if (result.button) {
    const QString sure = BatchDialog::tr("%1 %").arg(qRound(100 * result.confidence));
    if (result.checked) return sure + BatchDialog::tr(", checked");
    return isToCheck(result) ? sure + QObject::tr(", check it") : sure;
  }
  return result.question.isEmpty() ? BatchDialog::tr("Refused") : BatchDialog::tr("Question");
}

QString nameOfRow(const BatchResult& result) {
  QString graph = BatchDialog::tr("Page %1, graph %2").arg(result.graph.page).arg(result.graph.graph);
  if (result.curve == 0) return graph;
  return BatchDialog::tr("%1: %2").arg(
      graph, result.curveName.isEmpty() ? BatchDialog::tr("switch %1").arg(result.curve) : result.curveName);
}

}  // namespace

BatchDialog::BatchDialog(const ViewSettings& view, BatchActions actions, QWidget* parent)
    : QDialog(parent),
      view_(view),
      at_(std::move(actions)),
      list_(described(new QTreeWidget, "batchList", {}, tr("Results of the batch"))),
      progress_(described(new QProgressBar, "batchProgress", {}, tr("Files finished"))),
      summary_(wrappingLabel("batchSummary")) {
  setObjectName("batchDialog");
  setWindowTitle(tr("Import many files"));
  list_->setHeaderLabels({tr("File"), tr("Result"), tr("Details")});
  list_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  list_->setUniformRowHeights(true);
  list_->setAlternatingRowColors(true);
  list_->header()->setSectionResizeMode(resultColumn, QHeaderView::ResizeToContents);
  list_->header()->resizeSection(nameColumn, firstBatchSize_px.width() / 3);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(chooserRow());
  layout->addWidget(list_, 1);
  layout->addWidget(summary_);
  layout->addLayout(actionRow());
  connect(list_, &QTreeWidget::itemActivated, this, [this](QTreeWidgetItem* item) { correct(*item); });
  connect(list_, &QTreeWidget::itemSelectionChanged, this, &BatchDialog::follow);
  connect(&batch_, &BatchImport::started, this,
          [this](int file) { list_->topLevelItem(file)->setText(resultColumn, tr("Reading…")); });
  connect(&batch_, &BatchImport::finished, this, &BatchDialog::take);
  connect(&batch_, &BatchImport::ended, this, &BatchDialog::ended);
  summary_->setText(tr("Choose files or a folder. Every graph in them is imported in the background."));
  follow();
  resize(firstBatchSize_px);
}

QLayout* BatchDialog::chooserRow() {
  files_ = plainButton("batchFiles", tr("Choose &files…"),
                       tr("Choose files to import; they replace those in the list"));
  folder_ = plainButton("batchFolder", tr("Choose a f&older…"),
                        tr("Import all datasheets, pictures and tables in a folder and its subfolders"));
  stop_ = plainButton("batchStop", tr("S&top"), tr("Stop; finished files keep their results"));
  connect(files_, &QPushButton::clicked, this, [this] { start(at_.files(this)); });
  connect(folder_, &QPushButton::clicked, this, [this] {
    const QString folder = at_.folder(this);
    if (folder.isEmpty()) return;
    const QStringList paths = sheetsBelow(folder);
    if (paths.isEmpty()) summary_->setText(tr("No datasheet, picture or table was found in %1.").arg(folder));
    start(paths);
  });
  connect(stop_, &QPushButton::clicked, &batch_, &BatchImport::cancel);
  auto* row = new QHBoxLayout;
  row->addWidget(files_);
  row->addWidget(folder_);
  row->addWidget(progress_, 1);
  row->addWidget(stop_);
  return row;
}

QLayout* BatchDialog::actionRow() {
  correct_ = plainButton("batchCorrect", tr("Open in the &import dialogue"),
                         tr("Check what was found on the page, answer the question, or correct the result"));
  open_ = plainButton("batchOpen", tr("Open &buttons"), tr("Open the selected buttons in tabs"));
  save_ = plainButton("batchSave", tr("&Save buttons…"),
                      tr("Save the selected buttons in a folder, or all if none is selected"));
  auto* close = plainButton("batchClose", tr("Close"), {});
  connect(correct_, &QPushButton::clicked, this, [this] { correct(*list_->selectedItems().front()); });
  connect(open_, &QPushButton::clicked, this, [this] {
    for (const Row* row : chosen()) at_.open(row->path, *row->result.button);
  });
  connect(save_, &QPushButton::clicked, this, &BatchDialog::save);
  connect(close, &QPushButton::clicked, this, &QDialog::reject);
  auto* row = new QHBoxLayout;
  row->addWidget(correct_);
  row->addWidget(open_);
  row->addWidget(save_);
  row->addStretch();
  row->addWidget(close);
  return row;
}

void BatchDialog::start(const QStringList& paths) {
  if (paths.isEmpty()) return;
  batch_.cancel();
  list_->clear();
  rows_.clear();
  paths_ = paths;
  finished_ = 0;
  for (const QString& path : paths) {
    auto* item = new QTreeWidgetItem(list_, {QFileInfo(path).fileName(), tr("Waiting")});
    item->setToolTip(nameColumn, QDir::toNativeSeparators(path));
  }
  batch_.start(paths, view_.units());
  showProgress();
  follow();
}

/// Adds the results of a file. One button is one row; several are rows below the row of their file.
void BatchDialog::take(int file, const std::vector<BatchResult>& results) {
  QTreeWidgetItem& item = *list_->topLevelItem(file);
  const QString& path = paths_[file];
  ++finished_;
  if (results.size() == 1) {
    fill(item, item.text(nameColumn), path, results.front());
  } else {
    for (const BatchResult& result : results)
      fill(*new QTreeWidgetItem(&item), nameOfRow(result), path, result);
    item.setExpanded(true);
  }
  showProgress();
  follow();
}

void BatchDialog::fill(QTreeWidgetItem& item, const QString& name, const QString& path,
                       const BatchResult& result) {
  item.setText(nameColumn, name);
  item.setData(nameColumn, rowRole, static_cast<int>(rows_.size()));
  rows_.push_back({path, result});
  showResult(item);
}

const BatchDialog::Row* BatchDialog::rowOf(const QTreeWidgetItem& item) const {
  const QVariant row = item.data(nameColumn, rowRole);
  return row.isValid() ? &rows_[static_cast<std::size_t>(row.toInt())] : nullptr;
}

/// Shows the result of a row, and with it the number of buttons of its file.
void BatchDialog::showResult(QTreeWidgetItem& item) {
  const BatchResult& result = rowOf(item)->result;
  item.setText(resultColumn, inShort(result));
  item.setText(detailsColumn, result.question.isEmpty() ? result.reason : result.question);
  item.setToolTip(detailsColumn, result.reason);
  QTreeWidgetItem* file = item.parent();
  if (!file) return;
  int buttons = 0;
  for (int i = 0; i < file->childCount(); ++i) {
    const Row* row = rowOf(*file->child(i));
    buttons += row && row->result.button;
  }
  file->setText(resultColumn, tr("%1 of %2").arg(buttons).arg(file->childCount()));
}

/// A person may have drawn a frame where none was found: then the only row of the file, refused, is the one.
void BatchDialog::takeChecked(const QString& path, const importer::ImportReport& report) {
  const GraphId graph{report.page, report.graph};
  const auto curve = static_cast<int>(report.curve.value_or(0));
  QTreeWidgetItem *same = nullptr, *refused = nullptr;
  int ofFile = 0;
  for (QTreeWidgetItemIterator each(list_); *each; ++each) {
    const Row* row = rowOf(**each);
    if (!row || row->path != path) continue;
    ++ofFile;
    const auto& [id, known] = std::pair(row->result.graph, row->result.curve);
    if ((id == graph && (known == 0 || known == curve)) || id.page == 0) same = *each;
    if (!row->result.button) refused = *each;
  }
  QTreeWidgetItem* item = same ? same : ofFile == 1 ? refused : nullptr;
  if (!item) return;
  BatchResult& result = rows_[static_cast<std::size_t>(item->data(nameColumn, rowRole).toInt())].result;
  result = resultOf(graph, report, view_.units());
  result.checked = true;
  showResult(*item);
  showProgress();
  follow();
}

void BatchDialog::showProgress() {
  progress_->setRange(0, static_cast<int>(paths_.size()));
  progress_->setValue(finished_);
  int buttons = 0, toCheck = 0, questions = 0, refused = 0;
  for (const Row& row : rows_) {
    ++(row.result.button ? buttons : row.result.question.isEmpty() ? refused : questions);
    toCheck += isToCheck(row.result);
  }
  summary_->setText(tr("%1 of %2 files. Buttons: %3 (to check: %4), questions: %5, refused: %6.")
                        .arg(finished_)
                        .arg(paths_.size())
                        .arg(buttons)
                        .arg(toCheck)
                        .arg(questions)
                        .arg(refused));
}

void BatchDialog::ended() {
  for (int file = 0; file < list_->topLevelItemCount(); ++file) {
    QTreeWidgetItem& item = *list_->topLevelItem(file);
    if (item.childCount() == 0 && !rowOf(item)) item.setText(resultColumn, tr("Stopped"));
  }
  follow();
}

void BatchDialog::follow() {
  const bool running = batch_.isRunning();
  files_->setEnabled(!running);
  folder_->setEnabled(!running);
  stop_->setEnabled(running);
  correct_->setEnabled(list_->selectedItems().size() == 1);
  const bool any = !chosen().empty();
  open_->setEnabled(any && !list_->selectedItems().isEmpty());
  save_->setEnabled(any);
}

/// Buttons of the selected rows; of all rows if none is selected. A file stands for its graphs.
std::vector<const BatchDialog::Row*> BatchDialog::chosen() const {
  const bool all = list_->selectedItems().isEmpty();
  std::vector<const Row*> rows;
  for (QTreeWidgetItemIterator each(list_); *each; ++each) {
    const QTreeWidgetItem& item = **each;
    const Row* row = rowOf(item);
    const bool wanted = all || item.isSelected() || (item.parent() && item.parent()->isSelected());
    if (wanted && row && row->result.button) rows.push_back(row);
  }
  return rows;
}

void BatchDialog::correct(const QTreeWidgetItem& item) {
  const Row* row = rowOf(item);
  const QTreeWidgetItem& file = item.parent() ? *item.parent() : item;
  const GraphId graph = row ? row->result.graph : GraphId{};
  at_.correct(paths_[list_->indexOfTopLevelItem(const_cast<QTreeWidgetItem*>(&file))], graph);
}

/// Saves the chosen buttons without overwriting files: a name that exists gets a number.
void BatchDialog::save() {
  const QString folder = at_.folderToSave(this);
  if (folder.isEmpty()) return;
  const std::vector<const Row*> rows = chosen();  // read after the question, because more files have finished
  int saved = 0;
  for (const Row* row : rows) {
    const QString path = suggestedPath(ButtonDocument(*row->result.button), folder, ".button.json");
    const auto written = writeButtonFile(QFile::encodeName(path).toStdString(), *row->result.button);
    if (!written)
      return summary_->setText(
          tr("Saved %1 of %2 buttons. %3").arg(saved).arg(rows.size()).arg(sentenceOf(written.failure())));
    ++saved;
  }
  summary_->setText(tr("Buttons saved in %2: %1.").arg(saved).arg(QDir::toNativeSeparators(folder)));
}

void BatchDialog::done(int result) {
  batch_.cancel();
  QDialog::done(result);
}

}  // namespace detent::editor
