// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/annotations_panel.h"

#include <algorithm>
#include <cmath>
#include <QDateTime>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLocale>
#include <QScopedValueRollback>
#include <QScrollArea>
#include <QTimer>
#include <QVBoxLayout>

#include "editor/canvas/graph_canvas.h"
#include "editor/document/described.h"
#include "editor/document/message_words.h"
#include "model/links.h"

namespace detent::editor {
namespace {

constexpr double firstOffset_N = 0.05;  // used without a release beside the press
constexpr int margin_px = 3;            // small, because German texts need the space on small screens
constexpr QuantityRange offsets_N{0, ForceGraph::maxForce_N};
constexpr int listRows = 3;

QTreeWidget* listOf(const char* name, const QString& accessible, const QStringList& heads) {
  auto* list = described(new QTreeWidget, name, {}, accessible);
  list->setHeaderLabels(heads);
  list->setRootIsDecorated(false);
  list->setAlternatingRowColors(true);
  list->setMinimumHeight((listRows + 1) * (list->fontMetrics().height() + 6));
  list->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
  list->setTabKeyNavigation(false);
  list->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
  return list;
}

/// Mean distance of the release below the press; below 0 if it lies above.
double offsetOf_N(const ForceGraph& graph) {
  if (!graph.release()) return firstOffset_N;
  const double from = std::max(graph.press().start_mm(), graph.release()->start_mm()),
               to = std::min(graph.press().end_mm(), graph.release()->end_mm());
  if (!(from < to)) return firstOffset_N;
  return (graph.press().area_mJ(from, to) - graph.release()->area_mJ(from, to)) / (to - from);
}

/// Rounded to four digits, so that the user recognises typed numbers.
double rounded(double value) {
  if (!(value > 0)) return 0;
  const double step = std::pow(10, std::floor(std::log10(value)) - 3);
  return std::round(value / step) * step;
}

std::string utcNow() { return QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString(); }

}  // namespace

AnnotationsPanel::AnnotationsPanel(ButtonDocument& document, ViewSettings& settings, GraphCanvas& canvas)
    : document_(document),
      settings_(settings),
      canvas_(canvas),
      notes_(listOf("notesList", tr("Notes"), {tr("Position"), tr("Note")})),
      versions_(listOf("versionsList", tr("Versions"), {tr("Version"), tr("Created")})),
      noteText_(described(new QLineEdit, "noteText",
                          tr("Note for the selected point. Press Enter to add the note."), tr("New note"))),
      versionName_(described(
          new QLineEdit, "versionName",
          tr("Name under which the present state of the button is kept. Press Enter to add the version."),
          tr("Name of the version"))),
      oneEnd_(described(new QCheckBox(tr("All strokes e&nd at the same travel")), "linkOneEnd",
                        tr("Moving the end of one stroke also moves the ends of all strokes in all states"))),
      releaseFollows_(
          described(new QCheckBox(tr("&Release follows press, lower by")), "linkRelease",
                    tr("Edits of the press also move the release. The release keeps its shape."))),
      offset_(described(new QuantityField(Quantity::force, settings.units()), "linkOffset",
                        tr("How far the release lies below the press on average. Another value moves the "
                           "whole release up or down."))),
      pins_(described(new QLabel, "linkPins")) {
  setObjectName("annotationsPanel");
  auto* inside = new QWidget;
  auto* column = new QVBoxLayout(inside);
  column->setContentsMargins(margin_px, margin_px, margin_px, margin_px);
  column->addWidget(notesBox(), 1);
  column->addWidget(versionsBox(), 1);
  column->addWidget(linksBox());
  auto* scroll = new QScrollArea;
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setAccessibleName(tr("Notes"));
  scroll->setWidgetResizable(true);
  scroll->setWidget(inside);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(scroll);
  setFocusProxy(noteText_);
  for (QLineEdit* field : {noteText_, versionName_}) field->installEventFilter(this);
  connect(&document_, &ButtonDocument::annotationsChanged, this, &AnnotationsPanel::follow);
  connect(&settings_, &ViewSettings::changed, this, &AnnotationsPanel::follow);
  connect(&document_, &ButtonDocument::changed, this, &AnnotationsPanel::showOffset);
  connect(&document_, &ButtonDocument::activeStateChanged, this, &AnnotationsPanel::showOffset);
  follow();
}

// An empty field has nothing to undo, so Undo applies to the button.
bool AnnotationsPanel::eventFilter(QObject* watched, QEvent* event) {
  const auto* field = qobject_cast<QLineEdit*>(watched);
  if (!field || event->type() != QEvent::ShortcutOverride) return QWidget::eventFilter(watched, event);
  const auto& key = static_cast<const QKeyEvent&>(*event);
  const bool passes = (key.matches(QKeySequence::Undo) && !field->isUndoAvailable()) ||
                      (key.matches(QKeySequence::Redo) && !field->isRedoAvailable());
  if (passes) event->ignore();
  return passes;
}

QPushButton* AnnotationsPanel::addButton(QLayout& row, const char* name, const QString& text,
                                         const QString& tip) {
  auto* button = described(new QPushButton(text), name, tip);
  row.addWidget(button);
  return button;
}

QWidget* AnnotationsPanel::notesBox() {
  auto* box = new QGroupBox(tr("Notes"));
  auto* column = new QVBoxLayout(box);
  column->addWidget(notes_);
  noteText_->setPlaceholderText(tr("New note at the selected point"));
  auto* row = new QHBoxLayout;
  row->addWidget(noteText_, 1);
  removeNote_ = addButton(*row, "noteRemove", tr("Remove"), tr("Remove the selected note"));
  column->addLayout(row);
  connect(noteText_, &QLineEdit::returnPressed, this, &AnnotationsPanel::addNote);
  connect(removeNote_, &QPushButton::clicked, this, [this] {
    Annotations next = document_.annotations();
    if (const int at = chosen(*notes_); at >= 0) next.notes.erase(next.notes.begin() + at);
    document_.annotate(std::move(next), tr("Remove a note"));
  });
  connect(notes_, &QTreeWidget::itemChanged, this, &AnnotationsPanel::renamed);
  connect(notes_, &QTreeWidget::itemSelectionChanged, this,
          [this] { removeNote_->setEnabled(chosen(*notes_) >= 0); });
  return box;
}

QWidget* AnnotationsPanel::versionsBox() {
  auto* box = new QGroupBox(tr("Versions"));
  auto* column = new QVBoxLayout(box);
  column->addWidget(versions_);
  versionName_->setPlaceholderText(tr("Version name…"));
  auto* nameRow = new QHBoxLayout;
  nameRow->addWidget(versionName_, 1);
  removeVersion_ = addButton(*nameRow, "versionRemove", tr("Remove"), tr("Remove the selected version"));
  column->addLayout(nameRow);
  auto* row = new QHBoxLayout;
  goBack_ = addButton(*row, "versionGoBack", tr("Restore"), tr("Restore the button to the selected version"));
  openVersion_ = addButton(*row, "versionOpen", tr("Open in new tab"),
                           tr("Open the selected version as a new button, to compare it"));
  column->addLayout(row);
  connect(versionName_, &QLineEdit::returnPressed, this, &AnnotationsPanel::keepVersion);
  connect(goBack_, &QPushButton::clicked, this, &AnnotationsPanel::goBack);
  connect(openVersion_, &QPushButton::clicked, this, &AnnotationsPanel::openVersion);
  connect(removeVersion_, &QPushButton::clicked, this, [this] {
    Annotations next = document_.annotations();
    if (const int at = chosen(*versions_); at >= 0) next.versions.erase(next.versions.begin() + at);
    document_.annotate(std::move(next), tr("Remove a version"));
  });
  connect(versions_, &QTreeWidget::itemChanged, this, &AnnotationsPanel::renamed);
  connect(versions_, &QTreeWidget::itemSelectionChanged, this, [this] {
    for (QPushButton* button : {goBack_, openVersion_, removeVersion_})
      button->setEnabled(chosen(*versions_) >= 0);
  });
  return box;
}

QWidget* AnnotationsPanel::linksBox() {
  auto* box = new QGroupBox(tr("Links"));
  auto* column = new QVBoxLayout(box);
  column->addWidget(oneEnd_);
  auto* row = new QHBoxLayout;
  column->addWidget(releaseFollows_);
  constexpr int indent_px = 24;  // indent of items below a check box
  row->addSpacing(indent_px);
  row->addWidget(offset_);
  row->addStretch();
  column->addLayout(row);
  auto* pinRow = new QHBoxLayout;
  pinRow->addWidget(pins_, 1);
  unpin_ = addButton(*pinRow, "linkUnpin", tr("Unlock all"),
                     tr("Unlock all points, so that they can be moved again"));
  column->addLayout(pinRow);
  offset_->setRange(offsets_N);
  offset_->setKeyboardTracking(false);
  const auto changed = [this] {
    if (filling_) return;
    EditLinks links = document_.annotations().links;
    links.oneTravelEnd = oneEnd_->isChecked();
    const bool follows = releaseFollows_->isChecked();
    if (follows != links.releaseBelowPress_N.has_value())
      links.releaseBelowPress_N = follows ? std::optional(std::max(0.0, offset_N())) : std::nullopt;
    link(links, tr("Change links"));
  };
  connect(oneEnd_, &QCheckBox::toggled, this, changed);
  connect(releaseFollows_, &QCheckBox::toggled, this, changed);
  connect(offset_, &QuantityField::valueChanged, this, [this](double typed_N) {
    EditLinks links = document_.annotations().links;
    if (filling_ || !links.releaseBelowPress_N) return;
    const double lower_N = typed_N - offset_N();  // before the link changes what is shown
    links.releaseBelowPress_N = typed_N;
    link(links, tr("Lower the release"), lower_N);
  });
  connect(unpin_, &QPushButton::clicked, this, [this] {
    EditLinks links = document_.annotations().links;
    links.pinned.clear();
    link(links, tr("Unlock all"));
  });
  return box;
}

int AnnotationsPanel::chosen(const QTreeWidget& list) {
  const QList<QTreeWidgetItem*> items = list.selectedItems();
  return items.isEmpty() ? -1 : list.indexOfTopLevelItem(items.front());
}

// Changes links, which act on later edits, and lowers the releases in the same step. If impossible, both
// stay.
void AnnotationsPanel::link(const EditLinks& links, const QString& label, double lower_N) {
  EditHistory& history = document_.history();
  if (history.dragging()) return follow();
  Result<Button> lowered = history.committed();
  if (lower_N != 0) lowered = lowerReleases(*lowered, lower_N);
  if (lowered) lowered = history.ruled(*lowered);
  if (!lowered) {
    emit said(sentenceOf(lowered.failure(), settings_.units()));
    return follow();
  }
  Annotations next = document_.annotations();
  next.links = links;
  if (next == document_.annotations() && *lowered == history.committed()) return;
  history.stack().beginMacro(label);
  document_.annotate(std::move(next), label);
  history.replace(*lowered, label);
  history.stack().endMacro();
}

void AnnotationsPanel::addNote() {
  const auto selected = canvas_.selected();
  const auto at = selected ? placeOf(*selected, canvas_.state(), canvas_.values()) : std::nullopt;
  if (!at) return emit said(tr("Select a point first; the note will be attached to it."));
  const QString text = noteText_->text().trimmed();
  if (text.isEmpty() || document_.history().dragging()) return;
  Annotations next = document_.annotations();
  next.notes.push_back({document_.activeState(), selected->stroke, at->displacement_mm, text.toStdString()});
  noteText_->setText({});  // without an undo step of its own
  document_.annotate(std::move(next), tr("Note: %1").arg(text));
}

void AnnotationsPanel::keepVersion() {
  const QString name = versionName_->text().trimmed();
  if (name.isEmpty() || document_.history().dragging()) return;
  Annotations next = document_.annotations();
  const auto same = [&](const NamedVersion& version) { return version.name == name.toStdString(); };
  if (std::any_of(next.versions.begin(), next.versions.end(), same))
    return emit said(tr("There is a version called “%1” already. Give this one another name.").arg(name));
  next.versions.push_back({name.toStdString(), utcNow(), document_.history().committed().states()});
  versionName_->setText({});
  document_.annotate(std::move(next), tr("Add version: %1").arg(name));
}

void AnnotationsPanel::goBack() {
  const int at = chosen(*versions_);
  EditHistory& history = document_.history();
  if (at < 0 || history.dragging()) return;
  const NamedVersion& version = document_.annotations().versions[static_cast<std::size_t>(at)];
  const Button& now = history.committed();
  if (const auto then = Button::fromStates(now.name(), version.states, now.provenance()))
    history.replace(*then, tr("Restore version: %1").arg(QString::fromStdString(version.name)));
}

void AnnotationsPanel::openVersion() {
  const int at = chosen(*versions_);
  if (at < 0) return;
  const NamedVersion& version = document_.annotations().versions[static_cast<std::size_t>(at)];
  const QString name = QStringLiteral("%1, %2").arg(document_.title(), QString::fromStdString(version.name));
  if (const auto then = Button::fromStates(name.toStdString(), version.states,
                                           document_.history().committed().provenance()))
    emit versionOpened(*then);
}

// A note's text or a version's name was edited in its list.
void AnnotationsPanel::renamed(QTreeWidgetItem* item) {
  if (filling_) return;
  Annotations next = document_.annotations();
  const bool note = item->treeWidget() == notes_;
  const auto at = static_cast<std::size_t>(item->treeWidget()->indexOfTopLevelItem(item));
  const std::string text = item->text(note ? 1 : 0).trimmed().toStdString();
  const auto same = [&](const NamedVersion& version) { return version.name == text; };
  const bool taken = !note && std::any_of(next.versions.begin(), next.versions.end(), same);
  if (text.empty() || taken || document_.history().dragging()) return follow();
  (note ? next.notes[at].text : next.versions[at].name) = text;
  // The list is refilled only after its editor has closed.
  QTimer::singleShot(0, this, [this, next, note] {
    if (!document_.history().dragging())
      document_.annotate(next, note ? tr("Change a note") : tr("Rename a version"));
  });
}

void AnnotationsPanel::follow() {
  filling_ = true;
  fillNotes();
  fillVersions();
  followLinks();
  filling_ = false;
}

void AnnotationsPanel::fillNotes() {
  notes_->clear();
  const auto& notes = document_.annotations().notes;
  for (std::size_t i = 0; i < notes.size(); ++i) {
    const Note& note = notes[i];
    const QString place = QStringLiteral("%1: %2").arg(i + 1).arg(
        quantityWithUnit(note.displacement_mm, Quantity::length, settings_.units(), 4));
    const QString stroke = note.stroke == Stroke::press ? tr("press") : tr("release");
    auto* item = new QTreeWidgetItem({place + ", " + stroke, QString::fromStdString(note.text)});
    item->setToolTip(1, item->text(1));
    item->setFlags(item->flags() | Qt::ItemIsEditable);
    notes_->addTopLevelItem(item);
  }
  notes_->resizeColumnToContents(0);
  removeNote_->setEnabled(false);
}

void AnnotationsPanel::fillVersions() {
  versions_->clear();
  for (const NamedVersion& version : document_.annotations().versions) {
    const QDateTime saved = QDateTime::fromString(QString::fromStdString(version.saved), Qt::ISODate);
    auto* item = new QTreeWidgetItem({QString::fromStdString(version.name),
                                      QLocale().toString(saved.toLocalTime(), QLocale::ShortFormat)});
    item->setFlags(item->flags() | Qt::ItemIsEditable);
    versions_->addTopLevelItem(item);
  }
  versions_->resizeColumnToContents(0);
  for (QPushButton* button : {goBack_, openVersion_, removeVersion_}) button->setEnabled(false);
}

double AnnotationsPanel::offset_N() const {
  return offsetOf_N(document_.button().states()[document_.activeState()].graph);
}

// Shows the current distance of the strokes, also after an edit of the release itself.
void AnnotationsPanel::showOffset() {
  const QScopedValueRollback filling(filling_, true);
  const DisplayUnits& units = settings_.units();
  const bool hasRelease = document_.button().states()[document_.activeState()].graph.release().has_value();
  offset_->setEnabled(hasRelease && document_.annotations().links.releaseBelowPress_N);
  offset_->setValue(rounded(units.forceFrom(std::max(0.0, offset_N()))) / units.forceFrom(1));
}

void AnnotationsPanel::followLinks() {
  const EditLinks& links = document_.annotations().links;
  oneEnd_->setChecked(links.oneTravelEnd);
  releaseFollows_->setChecked(links.releaseBelowPress_N.has_value());
  offset_->setUnits(settings_.units());
  showOffset();
  pins_->setText(links.pinned.empty() ? tr("No locked points. Press P to lock the selected one.")
                                      : tr("Locked points: %1").arg(links.pinned.size()));
  pins_->setWordWrap(true);
  unpin_->setEnabled(!links.pinned.empty());
}

}  // namespace detent::editor
