// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/window/help_window.h"

#include <algorithm>
#include <QCoreApplication>
#include <QDesktopServices>
#include <QDialogButtonBox>
#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QGridLayout>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <vector>

#include "editor/document/form_widgets.h"
#include "editor/feel/setup_widgets.h"
#include "editor/panels/figure_drawing.h"

namespace detent::editor {
namespace {

constexpr QSize guideSize_px{860, 760}, glossaryPicture_px{250, 170};
constexpr int besidePicture_px = 80, glossaryColumns = 3;  // margins and scroll bar of the guide

/// A page of Markdown with pictures no wider than the window. Other programs open links to the web.
class GuidePages : public QTextBrowser {
 public:
  explicit GuidePages(QLabel& note) : note_(note) {
    setOpenLinks(false);
    connect(this, &QTextBrowser::anchorClicked, this, &GuidePages::follow);
  }

  QVariant loadResource(int type, const QUrl& name) override {
    QVariant loaded = QTextBrowser::loadResource(type, name);
    if (type != QTextDocument::ImageResource) return loaded;
    const QImage picture = QImage::fromData(loaded.toByteArray());
    const int room_px = std::max(1, window()->width() - besidePicture_px);
    return picture.width() <= room_px ? loaded : picture.scaledToWidth(room_px, Qt::SmoothTransformation);
  }

  void follow(const QUrl& link) {
    const QUrl page = source().resolved(link);
    const bool isPage = page.isLocalFile() && page.path().endsWith(QLatin1String(".md"));
    if (page.isLocalFile() && !QFileInfo(page.toLocalFile()).isFile()) {
      note_.setText(GuideWindow::tr("%1 is part of Detent's sources; it is not installed with the program.")
                        .arg(page.fileName()));
      note_.show();
    } else if (isPage) {
      setSource(page.adjusted(QUrl::RemoveFragment));
    } else {
      QDesktopServices::openUrl(page);
    }
  }

 private:
  QLabel& note_;
};

/// An entry of the glossary.
struct Entry {
  const char* name;  ///< object name of the picture's widget
  std::vector<KeyFigure> figures;
  QString term, meaning;
};

std::vector<Entry> glossaryEntries() {
  using enum KeyFigure;
  return {
      {"glossaryOperating",
       {operatingForce},
       GlossaryWindow::tr("Operating point"),
       GlossaryWindow::tr(
           "Where the contact closes while the button is pressed. Keyboards call it the actuation point. Its "
           "force is the operating force.")},
      {"glossaryPeak",
       {peakForce},
       GlossaryWindow::tr("Tactile peak"),
       GlossaryWindow::tr(
           "The force to overcome before the button gives way. The finger feels the drop behind it as a "
           "click.")},
      {"glossaryBottomOut",
       {bottomOutForce},
       GlossaryWindow::tr("Bottom-out"),
       GlossaryWindow::tr("Where the button meets its end stop: from here on the force rises steeply, up to "
                          "the end of the travel.")},
      {"glossaryTravel",
       {preTravel, overTravel},
       GlossaryWindow::tr("Pre-travel and over-travel"),
       GlossaryWindow::tr(
           "The way to the operating point, and the way from there to the end. Both together are the total "
           "travel.")},
      {"glossaryHysteresis",
       {hysteresis, resetTravel},
       GlossaryWindow::tr("Reset point and hysteresis"),
       GlossaryWindow::tr("On its way back the button pushes less (dashed), and the contact opens later, at "
                          "the reset point. "
                          "The area between the curves is the energy that a press loses.")},
      {"glossarySnap",
       {snapRatio},
       GlossaryWindow::tr("Snap ratio"),
       GlossaryWindow::tr(
           "The drop behind the peak, as a share of the peak force: 0 % for a linear button, about 40 % and "
           "more for a crisp one.")}};
}

QPixmap glossaryPicture(const std::vector<KeyFigure>& figures, double devicePixelRatio,
                        const GraphColors& colors, const QFont& font) {
  constexpr int besideAxis_px = 18;
  QPixmap picture(glossaryPicture_px * devicePixelRatio);
  picture.setDevicePixelRatio(devicePixelRatio);
  picture.fill(colors.background);
  QPainter painter(&picture);
  const QRectF plot =
      QRectF(QPointF(), glossaryPicture_px).adjusted(besideAxis_px, 0, 0, -besideAxis_px / 2.0);
  for (const KeyFigure figure : figures) paintKeyFigure(painter, plot, figure, colors, colors.refused);
  painter.setFont(font);
  painter.setPen(colors.text);
  painter.drawText(QRectF(QPointF(), glossaryPicture_px).adjusted(0, 0, -6, -2),
                   Qt::AlignRight | Qt::AlignBottom, GlossaryWindow::tr("travel"));
  painter.rotate(-90);
  painter.drawText(QRectF(-plot.bottom(), 1, plot.height() - 6, besideAxis_px), Qt::AlignRight | Qt::AlignTop,
                   GlossaryWindow::tr("force"));
  return picture;
}

}  // namespace

QString documentsFolder() {
  for (const char* place : {"/../share/detent/docs", "/../../../docs"}) {
    const QDir folder(QCoreApplication::applicationDirPath() + QLatin1String(place));
    if (folder.exists(QStringLiteral("guide/user-guide.md"))) return folder.canonicalPath();
  }
  return {};
}

GuideWindow::GuideWindow(const QString& folder, QWidget* parent) : QDialog(parent) {
  setObjectName("guideWindow");
  setWindowTitle(tr("User's guide"));
  QLabel* note = noteLabel("guideNote");
  auto* pages = described(new GuidePages(*note), "guidePages", {}, tr("User's guide"));
  auto* back = plainButton("guideBack", tr("&Back"), tr("Previous page"));
  auto* start = plainButton("guideStart", tr("&Contents"), tr("The first page of the guide"));
  auto* search = described(new QLineEdit, "guideSearch", tr("Press Enter to find the next match"),
                           tr("Find on this page"));
  search->setPlaceholderText(tr("Find on this page"));
  search->setClearButtonEnabled(true);
  back->setEnabled(false);
  connect(pages, &QTextBrowser::sourceChanged, note, &QWidget::hide);
  connect(pages, &QTextBrowser::backwardAvailable, back, &QWidget::setEnabled);
  connect(back, &QPushButton::clicked, pages, &QTextBrowser::backward);
  const QUrl first = QUrl::fromLocalFile(folder + QStringLiteral("/guide/user-guide.md"));
  connect(start, &QPushButton::clicked, pages, [pages, first] { pages->setSource(first); });
  connect(search, &QLineEdit::returnPressed, pages, [pages, search] {
    if (pages->find(search->text())) return;
    pages->moveCursor(QTextCursor::Start);  // the search continues from the top
    pages->find(search->text());
  });
  auto* row = new QHBoxLayout;
  row->addWidget(back);
  row->addWidget(start);
  row->addStretch();
  row->addWidget(search);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(row);
  layout->addWidget(pages, 1);
  layout->addWidget(note);
  note->hide();
  resize(guideSize_px);  // pictures are as wide as the window
  if (folder.isEmpty()) {
    pages->setPlainText(
        tr("The guide is not installed. It belongs in the folder share/detent/docs beside the "
           "program's folder. Install the package again."));
    start->setEnabled(false);
  } else {
    pages->setSource(first);
  }
}

GlossaryWindow::GlossaryWindow(QWidget* parent) : QDialog(parent) {
  setObjectName("glossaryWindow");
  setWindowTitle(tr("Glossary"));
  auto* page = new QWidget;
  auto* grid = new QGridLayout(page);
  int place = 0;
  for (const Entry& entry : glossaryEntries()) {
    auto* picture = described(new QLabel, entry.name, {}, entry.term);
    auto* term = new QLabel(QStringLiteral("<b>%1</b>").arg(entry.term.toHtmlEscaped()));
    auto* meaning = new QLabel(entry.meaning);
    meaning->setWordWrap(true);
    meaning->setFixedWidth(glossaryPicture_px.width());
    auto* cell = new QVBoxLayout;
    for (QLabel* label : {picture, term, meaning}) cell->addWidget(label);
    cell->addStretch();
    grid->addLayout(cell, place / glossaryColumns, place % glossaryColumns);
    ++place;
  }
  auto* scrolled = new QScrollArea;  // a low screen has no room for all of them
  scrolled->setWidget(page);
  scrolled->setWidgetResizable(true);
  scrolled->setFrameShape(QFrame::NoFrame);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(
      new QLabel(tr("Solid: the press. Dashed: the release. Red: the part that the term names.")));
  layout->addWidget(scrolled, 1);
  layout->addWidget(buttons);
  drawPictures();
  constexpr QSize around_px{60, 110};
  resize(page->sizeHint() + around_px);
}

void GlossaryWindow::drawPictures() {
  const GraphColors colors = graphColors(isDark(palette()));
  for (const Entry& entry : glossaryEntries())
    if (auto* picture = findChild<QLabel*>(QLatin1String(entry.name)))
      picture->setPixmap(glossaryPicture(entry.figures, devicePixelRatioF(), colors, font()));
}

void GlossaryWindow::changeEvent(QEvent* event) {
  QDialog::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) drawPictures();
}

}  // namespace detent::editor
