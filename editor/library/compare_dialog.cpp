// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/library/compare_dialog.h"

#include <algorithm>
#include <QApplication>
#include <QClipboard>
#include <QEvent>
#include <QHeaderView>
#include <QScreen>
#include <QScrollArea>
#include <QSplitter>

#include "editor/document/described.h"
#include "editor/document/message_words.h"
#include "editor/library/compare_plot.h"
#include "editor/library/difference_rows.h"
#include "model/sampling.h"

namespace detent::editor {
namespace {

constexpr int updateDelay_ms = 50;
constexpr int rowMargin_px = 8;
constexpr int firstPlot_px = 300, firstTable_px = 220;
constexpr QSize firstSize_px{860, 640};
constexpr QSize windowFrame_px{8, 40};  // what the desktop puts around a window

QTableWidget* differencesTable() {
  auto* table = described(new QTableWidget, "compareTable", {}, CompareDialog::tr("Differences"));
  table->verticalHeader()->hide();
  table->verticalHeader()->setDefaultSectionSize(table->fontMetrics().height() + rowMargin_px);
  table->setWordWrap(false);
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table->setSelectionBehavior(QAbstractItemView::SelectRows);
  table->setAlternatingRowColors(true);
  return table;
}

QPushButton* pushButton(const char* name, const QString& text, const QString& tip) {
  auto* button = described(new QPushButton(text), name, tip);
  button->setAutoDefault(false);
  return button;
}

}  // namespace

CompareDialog::CompareDialog(ViewSettings& settings, QWidget* parent) : QDialog(parent), settings_(settings) {
  setObjectName("compareDialog");
  setWindowTitle(tr("Compare buttons"));
  setWindowFlag(Qt::WindowMaximizeButtonHint);
  build();
  resize(firstSize_px.boundedTo(screen()->availableSize() - windowFrame_px));
  soon_.setSingleShot(true);
  soon_.setInterval(updateDelay_ms);
  connect(&soon_, &QTimer::timeout, this, &CompareDialog::update);
  connect(&settings_, &ViewSettings::changed, &soon_, qOverload<>(&QTimer::start));
}

CompareDialog::~CompareDialog() = default;

void CompareDialog::build() {
  plot_ = described(new ComparePlot, "comparePlot", {}, tr("The force graphs over each other"));
  table_ = differencesTable();
  auto* split = new QSplitter(Qt::Vertical);
  split->addWidget(plot_);
  split->addWidget(table_);
  split->setSizes({firstPlot_px, firstTable_px});
  distance_ = described(new QLabel, "compareDistance");
  distance_->setWordWrap(true);
  distance_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  reading_ = described(new QLabel, "compareReading");
  reading_->setWordWrap(true);
  reading_->setMinimumHeight(2 * fontMetrics().lineSpacing());  // so that nothing jumps when it comes
  connect(plot_, &ComparePlot::readingChanged, reading_, [this](const QString& reading) {
    reading_->setText(reading.isEmpty()
                          ? tr("Point at the graph to read values; click to pin a cursor and read "
                               "differences from there.")
                          : reading);
  });

  more_ = pushButton("compareAdd", tr("Compare &one more"), tr("Lay another open button over these"));
  connect(more_, &QPushButton::clicked, this, &CompareDialog::addNext);
  fewer_ = pushButton("compareRemove", tr("One &less"), tr("Take the last one away"));
  connect(fewer_, &QPushButton::clicked, this, &CompareDialog::removeLast);
  auto* swap = pushButton("compareExchange", tr("E&xchange A and B"), tr("Count differences the other way"));
  connect(swap, &QPushButton::clicked, this, &CompareDialog::exchange);
  auto* copy =
      pushButton("compareCopy", tr("&Copy the table"), tr("Copy the differences as CSV, in the units shown"));
  connect(copy, &QPushButton::clicked, this, [this] { QApplication::clipboard()->setText(tableText()); });
  auto* buttons = new QHBoxLayout;
  for (QPushButton* button : {more_, fewer_, swap, copy}) buttons->addWidget(button);
  buttons->addStretch();

  // Where the screen is too low for all of it, the middle scrolls; the buttons stay in reach.
  auto* middle = new QWidget;
  auto* compared = new QVBoxLayout(middle);
  compared->setContentsMargins(0, 0, 0, 0);
  compared->addLayout(rows_ = new QVBoxLayout);
  compared->addWidget(split, 1);
  compared->addWidget(reading_);
  compared->addWidget(distance_);
  forecast_ = described(new ForecastBar, "compareForecast");
  compared->addWidget(forecast_);
  auto* scroll = described(new QScrollArea, "compareScroll");
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidgetResizable(true);
  scroll->setWidget(middle);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(scroll, 1);
  layout->addLayout(buttons);
  addSide();
  addSide();
}

void CompareDialog::addSide() {
  auto made = std::make_unique<Side>();
  Side& side = *made;
  side.letter = QChar('A' + static_cast<char>(sides_.size()));
  side.row = new QWidget;
  auto* layout = new QHBoxLayout(side.row);
  layout->setContentsMargins(0, 0, 0, 0);
  side.button = new QComboBox;
  side.button->setObjectName("compareButton" + side.letter);
  side.button->setAccessibleName(tr("Button %1").arg(side.letter));
  side.button->setToolTip(tr("Button %1 of the comparison").arg(side.letter));
  side.state = new QComboBox;
  side.state->setObjectName("compareState" + side.letter);
  side.state->setAccessibleName(tr("State of button %1").arg(side.letter));
  side.state->setToolTip(tr("Which state of a self-locking button is compared"));
  layout->addWidget(new QLabel("<b>" + side.letter + "</b>"));
  layout->addWidget(side.button, 1);
  layout->addWidget(side.state);
  connect(side.button, &QComboBox::activated, this, [this, &side](int index) {
    if (index >= 0 && index < static_cast<int>(documents_.size()))
      choose(side, documents_[static_cast<std::size_t>(index)]);
  });
  connect(side.state, &QComboBox::activated, this, &CompareDialog::update);
  rows_->addWidget(side.row);
  sides_.push_back(std::move(made));
}

void CompareDialog::removeLast() {
  if (sides_.size() <= 2) return;
  delete sides_.back()->row;
  sides_.pop_back();
  update();
}

// The first that is not among them yet.
void CompareDialog::addNext() {
  const auto isCompared = [this](const ButtonDocument* document) {
    return std::any_of(sides_.begin(), sides_.end(),
                       [document](const auto& side) { return side->document == document; });
  };
  const auto next = std::find_if_not(documents_.begin(), documents_.end(), isCompared);
  if (!documents_.empty()) add(next != documents_.end() ? *next : documents_.front());
}

void CompareDialog::add(ButtonDocument* document) {
  if (sides_.size() >= mostSides) return;
  addSide();
  fillButtons(*sides_.back());
  choose(*sides_.back(), document);
  fillButtons(*sides_.back());
}

void CompareDialog::setDocuments(const std::vector<ButtonDocument*>& documents) {
  for (ButtonDocument* document : documents)
    if (std::find(documents_.begin(), documents_.end(), document) == documents_.end()) {
      connect(document, &ButtonDocument::changed, &soon_, qOverload<>(&QTimer::start));
      connect(document, &ButtonDocument::titleChanged, this, [this] {
        for (const auto& side : sides_) fillButtons(*side);
      });
    }
  documents_ = documents;
  for (const auto& side : sides_) {
    if (std::find(documents_.begin(), documents_.end(), side->document) == documents_.end())
      side->document = documents_.empty() ? nullptr : documents_.front();
    fillButtons(*side);
    fillStates(*side);
  }
  update();
}

void CompareDialog::compare(ButtonDocument* a, ButtonDocument* b) {
  sides_[0]->document = a;
  sides_[1]->document = b;
  for (const auto& side : sides_) {
    fillButtons(*side);
    fillStates(*side);
  }
  update();
}

void CompareDialog::choose(Side& side, ButtonDocument* document) {
  side.document = document;
  fillStates(side);
  update();
}

void CompareDialog::exchange() {
  Side &a = *sides_[0], &b = *sides_[1];
  const int stateA = a.state->currentIndex(), stateB = b.state->currentIndex();
  compare(b.document, a.document);
  a.state->setCurrentIndex(stateB);
  b.state->setCurrentIndex(stateA);
  update();
}

void CompareDialog::fillButtons(Side& side) {
  side.button->clear();
  for (ButtonDocument* document : documents_) {
    side.button->addItem(document->title());
    if (document == side.document) side.button->setCurrentIndex(side.button->count() - 1);
  }
}

void CompareDialog::fillStates(Side& side) {
  const int before = side.state->currentIndex();
  side.state->clear();
  if (!side.document) return;
  for (const ButtonState& state : side.document->button().states())
    side.state->addItem(QString::fromStdString(state.name));
  side.state->setVisible(side.state->count() > 1);
  if (before >= 0 && before < side.state->count()) side.state->setCurrentIndex(before);
}

const ButtonState* CompareDialog::stateOf(const Side& side) const {
  if (!side.document) return nullptr;
  const auto& states = side.document->button().states();
  const auto index = static_cast<std::size_t>(std::max(0, side.state->currentIndex()));
  return &states[std::min(index, states.size() - 1)];
}

void CompareDialog::update() {
  std::vector<const ButtonState*> states;
  std::vector<ComparedGraph> graphs;
  for (const auto& side : sides_) {
    // An edit may have added or taken a state.
    if (side->document && side->state->count() != static_cast<int>(side->document->button().states().size()))
      fillStates(*side);
    const ButtonState* state = stateOf(*side);
    if (!state) continue;
    states.push_back(state);
    graphs.push_back({side->letter, state->graph});
  }
  forecast_->setPair(sides_[0]->document, sides_[1]->document);
  more_->setEnabled(sides_.size() < mostSides && !documents_.empty());
  fewer_->setEnabled(sides_.size() > 2);
  plot_->setGraphs(std::move(graphs), settings_.units());
  fillTable(states);
  distance_->setText(states.size() < 2 ? tr("Open two buttons to compare them.") : distances(states));
}

QString CompareDialog::distances(const std::vector<const ButtonState*>& states) const {
  QStringList lines;
  for (std::size_t i = 1; i < states.size(); ++i) {
    const auto distance = detent::compare(polylinesOf(states.front()->graph), polylinesOf(states[i]->graph));
    const QString text =
        distance ? shownDistance(*distance, settings_.units()) : sentenceOf(distance.failure());
    lines << (states.size() > 2 ? tr("%1: %2").arg(sides_[i]->letter, text) : text);
  }
  return lines.join('\n');
}

void CompareDialog::fillTable(const std::vector<const ButtonState*>& states) {
  table_->clear();
  QStringList heads{tr("Figure")};
  for (std::size_t i = 0; i < states.size(); ++i) heads << sides_[i]->letter;
  for (std::size_t i = 1; i < states.size(); ++i) heads << tr("%1 \u2212 A").arg(sides_[i]->letter);
  heads << tr("Unit");
  table_->setColumnCount(static_cast<int>(heads.size()));
  table_->setHorizontalHeaderLabels(heads);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Interactive);
  table_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  if (states.size() < 2) return table_->setRowCount(0);

  const DisplayUnits& units = settings_.units();
  const auto rows = differencesOf(states);
  table_->setRowCount(static_cast<int>(rows.size()));
  for (int i = 0; i < table_->rowCount(); ++i) {
    const DifferenceRow& row = rows[static_cast<std::size_t>(i)];
    QStringList texts{row.name};
    for (const auto& value : row.values) texts << shownValue(value, row.measure, units);
    for (std::size_t other = 1; other < states.size(); ++other) texts << shownDifference(row, other, units);
    texts << shownUnit(row.measure, units);
    for (int column = 0; column < texts.size(); ++column) {
      auto* item = new QTableWidgetItem(texts[column]);
      if (column != 0 && column != texts.size() - 1)
        item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      table_->setItem(i, column, item);
    }
  }
}

QString CompareDialog::tableText() const {
  const auto quoted = [](QString text) { return '"' + text.replace('"', QStringLiteral("\"\"")) + '"'; };
  QStringList heads{QStringLiteral("figure")};
  const std::size_t count = table_->columnCount() < 3 ? 0 : sides_.size();
  for (std::size_t i = 0; i < count; ++i) heads << sides_[i]->letter.toLower();
  for (std::size_t i = 1; i < count; ++i) heads << sides_[i]->letter.toLower() + QStringLiteral("_minus_a");
  heads << QStringLiteral("unit");
  QStringList lines{heads.join(',')};
  for (int row = 0; row < table_->rowCount(); ++row) {
    QStringList fields;
    for (int column = 0; column < table_->columnCount(); ++column)
      fields << quoted(table_->item(row, column)->text());
    lines << fields.join(',');
  }
  return lines.join('\n') + '\n';
}

void CompareDialog::changeEvent(QEvent* event) {
  QDialog::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) soon_.start();
}

}  // namespace detent::editor
