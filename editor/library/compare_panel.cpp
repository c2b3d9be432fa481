// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/library/compare_panel.h"

#include <algorithm>
#include <QApplication>
#include <QClipboard>
#include <QEvent>
#include <QHeaderView>
#include <QScrollArea>

#include "editor/document/described.h"
#include "editor/document/form_widgets.h"
#include "editor/document/graph_colors.h"
#include "editor/document/message_words.h"
#include "editor/document/names_in_sight.h"
#include "editor/library/compare_plot.h"
#include "editor/library/difference_rows.h"
#include "model/sampling.h"

namespace detent::editor {
namespace {

constexpr int updateDelay_ms = 50;
constexpr int rowMargin_px = 8, swatch_px = 12;
constexpr int leastPlot_px = 160;
constexpr int leastFigures_px = 370;      // least width of the figures beside the plot
constexpr double sideBySideAspect = 1.3;  // width over height from which the figures stand beside the plot
constexpr int leastTableRows = 5;
constexpr int longestHead = 16;  // characters of a column's head

QTableWidget* differencesTable() {
  auto* table = described(new QTableWidget, "compareTable", {}, ComparePanel::tr("Differences"));
  table->setVerticalHeader(new ShorteningHeader(Qt::Vertical, Qt::ElideRight, table));
  table->setHorizontalHeader(new ShorteningHeader(Qt::Horizontal, Qt::ElideMiddle, table));
  table->verticalHeader()->hide();
  table->verticalHeader()->setDefaultSectionSize(table->fontMetrics().height() + rowMargin_px);
  table->setMinimumHeight((leastTableRows + 1) * (table->fontMetrics().height() + rowMargin_px));
  table->setWordWrap(false);
  table->setTabKeyNavigation(false);
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table->setSelectionBehavior(QAbstractItemView::SelectRows);
  table->setAlternatingRowColors(true);
  return table;
}

/// A field of a CSV line (RFC 4180), always quoted.
QString quotedField(QString text) { return '"' + text.replace('"', QStringLiteral("\"\"")) + '"'; }

template <class Button>
Button* button(const char* name, const QString& text, const QString& tip) {
  auto* made = described(new Button, name, tip);
  made->setText(text);
  return made;
}

}  // namespace

ComparePanel::ComparePanel(ViewSettings& settings, QWidget* parent) : QWidget(parent), settings_(settings) {
  setObjectName("comparePanel");
  build();
  soon_.setSingleShot(true);
  soon_.setInterval(updateDelay_ms);
  connect(&soon_, &QTimer::timeout, this, &ComparePanel::update);
  connect(&settings_, &ViewSettings::changed, &soon_, qOverload<>(&QTimer::start));
}

ComparePanel::~ComparePanel() = default;

void ComparePanel::build() {
  split_ = new QSplitter(Qt::Vertical);
  split_->setChildrenCollapsible(false);
  split_->addWidget(plotSide());
  split_->addWidget(figureSide());
  split_->setStretchFactor(0, 1);  // the graphs take the additional space of a larger window
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(split_);
  addSide();
  addSide();
}

QWidget* ComparePanel::plotSide() {
  plot_ = described(new ComparePlot, "comparePlot", {}, tr("Overlaid force graphs"));
  plot_->setMinimumHeight(leastPlot_px);
  reading_ = wrappingLabel("compareReading");
  reading_->setMinimumHeight(2 * fontMetrics().lineSpacing());  // so that nothing moves when the text appears
  connect(plot_, &ComparePlot::readingChanged, reading_, [this](const QString& reading) {
    reading_->setText(
        reading.isEmpty()
            ? tr("Point at the graph to read values. Click to set a cursor and read differences from there.")
            : reading);
  });
  auto* difference = button<QToolButton>("compareDifference", tr("&Difference"),
                                         tr("Show differences from the first button below the graph"));
  difference->setCheckable(true);
  connect(difference, &QToolButton::toggled, plot_, &ComparePlot::showDifferences);
  auto* picture = button<QToolButton>("comparePicture", tr("&Picture…"),
                                      tr("Save the graphs with their names as PNG, SVG or PDF"));
  connect(picture, &QToolButton::clicked, this, &ComparePanel::pictureRequested);
  auto* copy = button<QToolButton>("compareCopyPicture", tr("C&opy the picture"),
                                   tr("Copy the graphs with their names as a picture"));
  connect(copy, &QToolButton::clicked, this,
          [this] { QApplication::clipboard()->setImage(plot_->picture()); });
  auto* tools = new QHBoxLayout;
  for (QToolButton* tool : {difference, picture, copy}) tools->addWidget(tool);
  tools->addStretch();
  belowPlot_ = new QBoxLayout(QBoxLayout::TopToBottom);
  belowPlot_->addWidget(reading_, 1);
  belowPlot_->addLayout(tools);
  auto* side = new QWidget;
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(4, 2, 4, 2);
  column->addWidget(plot_, 1);
  column->addLayout(belowPlot_);
  return side;
}

QWidget* ComparePanel::figureSide() {
  table_ = differencesTable();
  table_->viewport()->installEventFilter(this);
  distance_ = wrappingLabel("compareDistance");
  forecast_ = described(new ForecastBar, "compareForecast");
  more_ = button<QPushButton>("compareAdd", tr("&Add button"), tr("Overlay another open button"));
  connect(more_, &QPushButton::clicked, this, &ComparePanel::addNext);
  fewer_ = button<QPushButton>("compareRemove", tr("&Remove button"), tr("Remove the last button"));
  connect(fewer_, &QPushButton::clicked, this, &ComparePanel::removeLast);
  auto* swap = button<QPushButton>("compareExchange", tr("S&wap"),
                                   tr("Swap the first two buttons; differences change their sign"));
  connect(swap, &QPushButton::clicked, this, &ComparePanel::exchange);
  auto* copy = button<QPushButton>("compareCopy", tr("Copy the &table"),
                                   tr("Copy the differences as CSV, in the units shown"));
  connect(copy, &QPushButton::clicked, this, [this] { QApplication::clipboard()->setText(tableText()); });
  auto* buttons = new QHBoxLayout;
  for (QPushButton* each : {more_, fewer_, swap}) buttons->addWidget(each);
  buttons->addStretch();
  auto* below = new QHBoxLayout;
  below->addWidget(copy);
  below->addStretch();
  figures_ = new QWidget;
  auto* column = new QVBoxLayout(figures_);
  column->setContentsMargins(4, 2, 4, 2);
  column->addLayout(rows_ = new QVBoxLayout);
  column->addLayout(buttons);
  column->addWidget(table_, 1);
  column->addLayout(below);
  column->addWidget(distance_);
  column->addWidget(forecast_);
  auto* side = new QWidget;
  auto* either = new QVBoxLayout(side);
  either->setContentsMargins(0, 0, 0, 0);
  either->addWidget(figures_);
  either->addWidget(alone_ = offerSide());
  // The content scrolls if it has too little room.
  auto* scroll = described(new QScrollArea, "compareScroll", {}, tr("Comparison table"));
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setWidgetResizable(true);
  scroll->setWidget(side);
  return scroll;
}

QWidget* ComparePanel::offerSide() {
  auto* side = described(new QWidget, "compareAlone");
  auto* column = new QVBoxLayout(side);
  QLabel* what = wrappingLabel("compareWhat");
  what->setText(tr("A comparison needs a second button. Choose where it comes from:"));
  column->addWidget(what);
  column->addLayout(ways_ = new QVBoxLayout);
  column->addStretch();
  return side;
}

void ComparePanel::offer(const QList<QAction*>& ways) {
  while (QLayoutItem* item = ways_->takeAt(0)) {
    item->widget()->deleteLater();  // later, because the click may come from it
    delete item;
  }
  for (QAction* way : ways) ways_->addWidget(buttonOf(*way, "compare_"));
}

bool ComparePanel::isAlone() const {
  return documents_.empty() || (documents_.size() == 1 && documents_.front()->button().states().size() == 1);
}

void ComparePanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  const auto way = width() > sideBySideAspect * height() ? Qt::Horizontal : Qt::Vertical;
  if (way == split_->orientation()) return;
  split_->setOrientation(way);
  belowPlot_->setDirection(way == Qt::Horizontal ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
  giveRoomToFigures();
}

// Beside the plot the figures get the width of their table, at most half of the panel; with four buttons and
// more the plot keeps 60 % of a window of 1366 x 768. Below it they get half of the height.
void ComparePanel::giveRoomToFigures() {
  const bool beside = split_->orientation() == Qt::Horizontal;
  const int all_px = beside ? width() : height();
  int figures_px = all_px / 2;
  neededTable_px_ = tableWidth_px();
  if (beside) {
    const double most = sides_.size() < 4 ? 0.5 : 0.28;  // of the panel
    figures_px = std::max(leastFigures_px, std::min(static_cast<int>(most * all_px), neededTable_px_));
  }
  split_->setSizes({all_px - figures_px, figures_px});
}

void ComparePanel::addSide() {
  auto made = std::make_unique<Side>();
  Side& side = *made;
  side.letter = QChar('A' + static_cast<char>(sides_.size()));
  side.row = new QWidget;
  auto* layout = new QHBoxLayout(side.row);
  layout->setContentsMargins(0, 0, 0, 0);
  const int number = static_cast<int>(sides_.size()) + 1;
  side.swatch = new QLabel;
  side.button = described(new QComboBox, QStringLiteral("compareButton") + side.letter,
                          tr("Button %1 of the comparison").arg(number), tr("Button %1").arg(number));
  side.button->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  side.state =
      described(new QComboBox, QStringLiteral("compareState") + side.letter,
                tr("State of a self-locking button to compare"), tr("State of button %1").arg(number));
  layout->addWidget(side.swatch);
  layout->addWidget(side.button, 1);
  layout->addWidget(side.state);
  connect(side.button, &QComboBox::activated, this, [this, &side](int index) {
    if (index >= 0 && index < static_cast<int>(documents_.size()))
      choose(side, documents_[static_cast<std::size_t>(index)]);
  });
  connect(side.state, &QComboBox::activated, this, &ComparePanel::update);
  rows_->addWidget(side.row);
  sides_.push_back(std::move(made));
  showColors();
}

void ComparePanel::showColors() {
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    QPixmap swatch(QSize(swatch_px, swatch_px));
    swatch.fill(seriesColor(i, isDark(palette())));
    sides_[i]->swatch->setPixmap(swatch);
  }
}

/// Index of the side's button among those that can be chosen; -1 if it has none.
int ComparePanel::placeOf(const Side& side) const {
  const auto at = std::ranges::find(documents_, side.document);
  return at != documents_.end() ? static_cast<int>(at - documents_.begin()) : -1;
}

void ComparePanel::removeLast() {
  if (sides_.size() <= 2) return;
  delete sides_.back()->row;
  sides_.pop_back();
  chosen_ = true;
  update();
}

// Adds the first open button that is not compared yet.
void ComparePanel::addNext() {
  const auto next = std::ranges::find_if(documents_, [this](auto* document) { return !compares(*document); });
  if (!documents_.empty()) add(next != documents_.end() ? *next : documents_.front());
}

void ComparePanel::add(ButtonDocument* document) {
  if (sides_.size() >= mostSides) return;
  addSide();
  fillButtons(*sides_.back());
  choose(*sides_.back(), document);
  fillButtons(*sides_.back());
}

void ComparePanel::setDocuments(const std::vector<ButtonDocument*>& documents) {
  for (ButtonDocument* document : documents)
    if (std::find(documents_.begin(), documents_.end(), document) == documents_.end()) {
      connect(document, &ButtonDocument::changed, &soon_, qOverload<>(&QTimer::start));
      connect(document, &ButtonDocument::titleChanged, this, [this] {
        for (const auto& side : sides_) fillButtons(*side);
        soon_.start();
      });
    }
  documents_ = documents;
  for (const auto& side : sides_) {
    if (std::find(documents_.begin(), documents_.end(), side->document) == documents_.end()) {
      side->document = documents_.empty() ? nullptr : documents_.front();
      chosen_ = false;
    }
    fillButtons(*side);
    fillStates(*side);
  }
  update();
}

void ComparePanel::compare(ButtonDocument* first, ButtonDocument* second) {
  chosen_ = false;
  sides_[0]->document = first;
  sides_[1]->document = second;
  for (const auto& side : sides_) {
    fillButtons(*side);
    fillStates(*side);
  }
  update();
}

void ComparePanel::compare(std::vector<ButtonDocument*> documents) {
  if (documents.empty()) return;
  documents.resize(std::clamp(documents.size(), std::size_t{2}, mostSides), documents.front());
  while (sides_.size() > documents.size()) {
    delete sides_.back()->row;
    sides_.pop_back();
  }
  while (sides_.size() < documents.size()) addSide();
  for (std::size_t i = 2; i < documents.size(); ++i) sides_[i]->document = documents[i];
  compare(documents[0], documents[1]);
}

bool ComparePanel::compares(const ButtonDocument& document) const {
  return std::ranges::any_of(sides_, [&](const auto& side) { return side->document == &document; });
}

void ComparePanel::choose(Side& side, ButtonDocument* document) {
  side.document = document;
  chosen_ = true;
  fillStates(side);
  update();
}

void ComparePanel::exchange() {
  Side &a = *sides_[0], &b = *sides_[1];
  const int stateA = a.state->currentIndex(), stateB = b.state->currentIndex();
  compare(b.document, a.document);
  chosen_ = true;
  a.state->setCurrentIndex(stateB);
  b.state->setCurrentIndex(stateA);
  update();
}

void ComparePanel::fillButtons(Side& side) {
  side.button->clear();
  side.button->addItems(distinctTitles(documents_));
  side.button->setCurrentIndex(placeOf(side));
}

void ComparePanel::fillStates(Side& side) {
  const int before = side.state->currentIndex();
  side.state->clear();
  if (!side.document) return;
  for (const ButtonState& state : side.document->button().states())
    side.state->addItem(QString::fromStdString(state.name));
  side.state->setVisible(side.state->count() > 1);
  if (before >= 0 && before < side.state->count()) side.state->setCurrentIndex(before);
}

const ButtonState* ComparePanel::stateOf(const Side& side) const {
  if (!side.document) return nullptr;
  const auto& states = side.document->button().states();
  const auto index = static_cast<std::size_t>(std::max(0, side.state->currentIndex()));
  return &states[std::min(index, states.size() - 1)];
}

void ComparePanel::update() {
  std::vector<const ButtonState*> states;
  std::vector<ComparedGraph> graphs;
  const QStringList titles = distinctTitles(documents_);
  for (const auto& side : sides_) {
    // An edit may have added or removed a state.
    if (side->document && side->state->count() != static_cast<int>(side->document->button().states().size()))
      fillStates(*side);
    const ButtonState* state = stateOf(*side);
    if (!state) continue;
    states.push_back(state);
    side->name = titles.value(placeOf(*side));
    if (const QString named = side->state->currentText(); !named.isEmpty())
      side->name += QStringLiteral(" (%1)").arg(named);
    graphs.push_back({side->name, state->graph});
    if (isAlone()) break;
  }
  forecast_->setPair(sides_[0]->document, sides_[1]->document);
  more_->setEnabled(sides_.size() < mostSides && !documents_.empty());
  fewer_->setEnabled(sides_.size() > 2);
  plot_->setGraphs(std::move(graphs), settings_.units());
  fillTable(states);
  distance_->setText(distances(states));
  figures_->setVisible(!isAlone());
  alone_->setVisible(isAlone());
}

QString ComparePanel::distances(const std::vector<const ButtonState*>& states) const {
  QStringList lines;
  for (std::size_t i = 1; i < states.size(); ++i) {
    const auto distance = detent::compare(polylinesOf(states.front()->graph), polylinesOf(states[i]->graph));
    const QString text =
        distance ? shownDistance(*distance, settings_.units()) : sentenceOf(distance.failure());
    lines << (states.size() > 2 ? tr("%1: %2").arg(sides_[i]->name, text) : text);
  }
  return lines.join('\n');
}

void ComparePanel::fillTable(const std::vector<const ButtonState*>& states) {
  const int columnsBefore = table_->columnCount();
  table_->clear();
  QStringList heads{tr("Figure")}, whole{tr("Figure")};
  for (std::size_t i = 0; i < states.size(); ++i) {
    whole << sides_[i]->name;
    heads << whole.back();
  }
  for (std::size_t i = 1; i < states.size(); ++i) {
    whole << tr("%1 − %2").arg(sides_[i]->name, sides_[0]->name);
    heads << QStringLiteral("\u0394 ") + sides_[i]->name;
  }
  heads << tr("Unit");
  whole << heads.back();
  table_->setColumnCount(static_cast<int>(heads.size()));
  table_->setHorizontalHeaderLabels(heads);
  for (int column = 0; column < table_->columnCount(); ++column)
    table_->horizontalHeaderItem(column)->setToolTip(whole[column]);
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
      if (column == 0) item->setToolTip(row.name);
      table_->setItem(i, column, item);
    }
    auto* name = new QTableWidgetItem(row.name);
    name->setToolTip(row.name);
    table_->setVerticalHeaderItem(i, name);
  }
  // Other buttons, units or values may need more room; with less, the user's division stays.
  if (table_->columnCount() != columnsBefore || tableWidth_px() > neededTable_px_) giveRoomToFigures();
  layOutTable();
}

int ComparePanel::nameWidth() const {
  return static_cast<const QAbstractItemView*>(table_)->sizeHintForColumn(0) + rowMargin_px;
}

/// Width of a column of numbers, or of the units with their heading.
int ComparePanel::leastWidth(int column) const {
  const int text_px = static_cast<const QAbstractItemView*>(table_)->sizeHintForColumn(column) + 1;
  const bool isUnit = column == table_->columnCount() - 1;
  return isUnit ? std::max(text_px, table_->horizontalHeader()->sectionSizeHint(column)) : text_px;
}

/// Width of a column with its heading, up to the limit of a heading.
int ComparePanel::wishedWidth(int column) const {
  const int longest_px = longestHead * fontMetrics().horizontalAdvance(QLatin1Char('x'));
  return std::max(leastWidth(column),
                  std::min(table_->horizontalHeader()->sectionSizeHint(column), longest_px));
}

/// Number of columns of values, which are named after buttons; those of differences follow.
int ComparePanel::valueColumns() const { return (table_->columnCount() - 1) / 2; }

/// Width of the whole table with the buttons' names above their values.
int ComparePanel::tableWidth_px() const {
  // the table's own scroll bar, that of the area around it, and the margins
  int needed_px = 2 * (style()->pixelMetric(QStyle::PM_ScrollBarExtent) + rowMargin_px) + nameWidth();
  for (int column = 1; column < table_->columnCount(); ++column)
    needed_px += column <= valueColumns() ? wishedWidth(column) : leastWidth(column);
  return needed_px;
}

// Numbers get the width they need; the remaining width goes in equal parts first to the names above values,
// then to those above differences, then to those of the rows.
void ComparePanel::layOutTable() {
  const int columns = table_->columnCount();
  if (columns < 3 || table_->rowCount() == 0) return;
  NamedTable needed{0, nameWidth()};
  int spare_px = widthForColumns_px(*table_) - needed.names_px;
  for (int column = 1; column < columns; ++column) spare_px -= leastWidth(column);
  const int differences = valueColumns() + 1;
  for (const auto& [first, end] : {std::pair{1, differences}, {differences, columns}})
    for (int column = first; column < end; ++column) {
      const int least_px = leastWidth(column);
      const int part_px = std::max(0, spare_px) / (end - column);
      const int more_px = std::min(wishedWidth(column) - least_px, part_px);
      table_->setColumnWidth(column, least_px + more_px);
      spare_px -= more_px;
      needed.numbers_px += least_px + more_px;
    }
  keepNamesInSight(*table_, needed);
}

bool ComparePanel::eventFilter(QObject* object, QEvent* event) {
  if (object == table_->viewport() && event->type() == QEvent::Resize) layOutTable();
  return QWidget::eventFilter(object, event);
}

QString ComparePanel::tableText() const {
  QStringList heads{QStringLiteral("figure")};
  const std::size_t count = table_->columnCount() < 3 ? 0 : sides_.size();
  for (std::size_t i = 0; i < count; ++i) heads << quotedField(sides_[i]->name);
  for (std::size_t i = 1; i < count; ++i)
    heads << quotedField(sides_[i]->name + QStringLiteral(" - ") + sides_[0]->name);
  heads << QStringLiteral("unit");
  QStringList lines{heads.join(',')};
  for (int row = 0; row < table_->rowCount(); ++row) {
    QStringList fields;
    for (int column = 0; column < table_->columnCount(); ++column)
      fields << quotedField(table_->item(row, column)->text());
    lines << fields.join(',');
  }
  return lines.join('\n') + '\n';
}

void ComparePanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() != QEvent::PaletteChange) return;
  showColors();
  soon_.start();
}

}  // namespace detent::editor
