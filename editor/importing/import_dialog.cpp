#include "editor/importing/import_dialog.h"

#include <QDialogButtonBox>
#include <QDragEnterEvent>
#include <QLabel>
#include <QListWidget>
#include <QMimeData>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include "editor/importing/import_state.h"

namespace detent::editor {

struct ImportDialog::Impl {
  Impl(ImportDialog& itsDialog, ViewSettings& itsSettings) : dialog(itsDialog), settings(itsSettings) {}

  void showGraphs() {
    list->clear();
    for (const GraphId id : state.graphs()) {
      auto* item = new QListWidgetItem(tr("Page %1, graph %2").arg(id.page).arg(id.graph), list);
      item->setIcon(QIcon(QPixmap::fromImage(state.graph(id)->thumbnail)));
    }
  }
  void showResult() {
    const ImportGraph* graph = state.current();
    if (state.openFailure()) {
      status->setText(QString::fromStdString(state.openFailure()->sentence()));
    } else if (graph && graph->last && graph->last->report) {
      status->setText(QString::fromStdString(graph->last->report->brief()));
    } else if (graph && graph->last && graph->last->failure) {
      status->setText(QString::fromStdString(graph->last->failure->sentence()));
    }
    import->setEnabled(graph && graph->good);
  }

  ImportDialog& dialog;
  ViewSettings& settings;
  ImportState state;
  QListWidget* list = nullptr;
  QLabel* status = nullptr;
  QProgressBar* progress = nullptr;
  QPushButton* import = nullptr;
};

ImportDialog::ImportDialog(ViewSettings& settings, QWidget* parent)
    : QDialog(parent), impl_(std::make_unique<Impl>(*this, settings)) {
  setWindowTitle(tr("Import a force graph"));
  setAcceptDrops(true);
  auto* column = new QVBoxLayout(this);
  column->addWidget(impl_->list = new QListWidget);
  column->addWidget(impl_->status = new QLabel);
  impl_->status->setWordWrap(true);
  column->addWidget(impl_->progress = new QProgressBar);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
  impl_->import = buttons->addButton(tr("Import"), QDialogButtonBox::AcceptRole);
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(impl_->import, &QPushButton::clicked, &impl_->state, &ImportState::acceptAll);
  connect(&impl_->state, &ImportState::graphsChanged, this, [this] { impl_->showGraphs(); });
  connect(&impl_->state, &ImportState::resultChanged, this, [this] { impl_->showResult(); });
  connect(&impl_->state, &ImportState::documentChanged, this, [this] { impl_->showResult(); });
  connect(&impl_->state, &ImportState::accepted, this, &ImportDialog::imported);
  connect(&impl_->state, &ImportState::allAccepted, this, &QDialog::accept);
  connect(&impl_->state, &ImportState::progressed, this,
          [this](double fraction) { impl_->progress->setValue(static_cast<int>(100 * fraction)); });
  connect(impl_->list, &QListWidget::currentRowChanged, this, [this](int row) {
    const auto graphs = impl_->state.graphs();
    if (row >= 0) impl_->state.selectGraph(graphs[static_cast<std::size_t>(row)]);
  });
}

ImportDialog::~ImportDialog() = default;

void ImportDialog::openFile(const QString& path) { impl_->state.openFile(path); }
void ImportDialog::openPicture(const QImage& picture) { impl_->state.openPicture(picture); }

void ImportDialog::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls() || event->mimeData()->hasImage()) event->acceptProposedAction();
}

void ImportDialog::dropEvent(QDropEvent* event) {
  const QMimeData* mime = event->mimeData();
  if (mime->hasUrls() && !mime->urls().isEmpty()) {
    openFile(mime->urls().front().toLocalFile());
  } else if (mime->hasImage()) {
    openPicture(qvariant_cast<QImage>(mime->imageData()));
  }
}

void ImportDialog::keyPressEvent(QKeyEvent* event) { QDialog::keyPressEvent(event); }

}  // namespace detent::editor
