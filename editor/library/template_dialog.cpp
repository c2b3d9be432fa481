// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/library/template_dialog.h"

#include <algorithm>
#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "editor/document/described.h"
#include "editor/library/graph_picture.h"

namespace detent::editor {
namespace {

constexpr QSize pictureSize_px{120, 84};

}  // namespace

TemplateDialog::TemplateDialog(QWidget* parent) : QDialog(parent), templates_(buttonTemplates()) {
  setObjectName("templateDialog");
  setWindowTitle(tr("New button"));
  list_ = described(new QListWidget, "templateList", {}, tr("Templates"));
  list_->setIconSize(pictureSize_px);
  list_->setSpacing(2);
  list_->setWordWrap(true);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  const GraphColors colors = graphColors(isDark(palette()));
  for (const ButtonTemplate& entry : templates_) {
    const QPixmap picture =
        QPixmap::fromImage(graphPicture(entry.button, pictureSize_px, devicePixelRatioF(), colors));
    QIcon icon(picture);
    icon.addPixmap(picture, QIcon::Selected);  // not tinted
    auto* item = new QListWidgetItem(icon, entry.name + "\n" + entry.description);
    item->setData(Qt::AccessibleTextRole, entry.name + ": " + entry.description);
    list_->addItem(item);
  }
  list_->setCurrentRow(1);
  connect(list_, &QListWidget::itemActivated, this, &QDialog::accept);

  auto* hint =
      new QLabel(tr("Start from a template and shape it, or drop a datasheet on the window instead."));
  hint->setWordWrap(true);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  buttons->button(QDialogButtonBox::Ok)->setText(tr("Create"));
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(hint);
  layout->addWidget(list_, 1);
  layout->addWidget(buttons);
  resize(460, 540);
}

const ButtonTemplate& TemplateDialog::chosen() const {
  return templates_[static_cast<std::size_t>(std::max(0, list_->currentRow()))];
}

void TemplateDialog::choose(const QString& id) {
  for (std::size_t i = 0; i < templates_.size(); ++i)
    if (templates_[i].id == id) list_->setCurrentRow(static_cast<int>(i));
}

}  // namespace detent::editor
