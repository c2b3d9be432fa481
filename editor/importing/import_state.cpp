// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/importing/import_state.h"

#include <algorithm>
#include <cmath>
#include <QFileInfo>
#include <utility>

#include "editor/importing/mark_corrections.h"
#include "model/check.h"

namespace detent::editor {
namespace {

constexpr GraphId logGraph{1, 1};  // a force meter's log has one graph and no page

std::vector<AxisTick> usedTicks(GraphAxis axis, const importer::GraphEvidence& evidence) {
  const auto& calibration = evidence.axes.calibration.value;
  std::vector<AxisTick> ticks;
  for (const auto& tick : (axis == GraphAxis::x ? calibration.x : calibration.y).ticks) {
    if (tick.used) ticks.push_back({placeOfTick(axis, evidence, tick.position_px), tick.value});
  }
  return ticks;
}

/// Ticks at the two ends of an axis with the values that were found for them.
std::vector<AxisTick> endsFound(GraphAxis axis, const importer::GraphEvidence& evidence) {
  const FrameCorners corners = cornersOf(evidence);
  const auto& calibration = evidence.axes.calibration.value;
  const importer::AxisReading& reading = axis == GraphAxis::x ? calibration.x : calibration.y;
  AxisEnds ends{reading.min, reading.max};
  if (fallsOnPage(axis, evidence)) std::swap(ends.min, ends.max);
  return {{placeAlong(axis, corners, 0), ends.min}, {placeAlong(axis, corners, 1), ends.max}};
}

/// "4.0", "4,0", "120".
std::optional<double> numberIn(const std::string& text) {
  bool isNumber = false;
  const double value = QString::fromStdString(text).trimmed().replace(',', '.').toDouble(&isNumber);
  return isNumber ? std::optional(value) : std::nullopt;
}

std::size_t bytesOf(const ImportedGraph& result) {
  return result.view.bytes() + (result.evidence ? result.evidence->view.raster.rgb.size() : 0);
}

std::size_t bytesOf(const ImportGraph& graph) {
  std::size_t bytes = graph.last ? bytesOf(*graph.last) : 0;
  if (graph.good && graph.good != graph.last) bytes += bytesOf(*graph.good);
  return bytes;
}

bool wasCancelled(const ImportedGraph& imported) {
  return imported.failure && imported.failure->code == FailureCode::cancelled;
}

// Corners in the view that was read. The corners of a mirrored plot run the other way round on the page.
FrameCorners cornersInView(const importer::GraphEvidence& evidence) {
  FrameCorners corners;
  for (std::size_t i = 0; i < 4; ++i) corners[i] = evidence.view.viewToPage(evidence.frame.corners[i]);
  return corners;
}

FrameCorners uprightCorners(const importer::GraphEvidence& evidence, FrameCorners corners) {
  if (fallsOnPage(GraphAxis::x, evidence))
    std::swap(corners[0], corners[1]), std::swap(corners[3], corners[2]);
  if (fallsOnPage(GraphAxis::y, evidence))
    std::swap(corners[0], corners[3]), std::swap(corners[1], corners[2]);
  return corners;
}

}  // namespace

importer::Point placeOfTick(GraphAxis axis, const importer::GraphEvidence& evidence, double position_px) {
  const auto& corners = evidence.frame.corners;
  const importer::Point from = corners[3], to = axis == GraphAxis::x ? corners[2] : corners[0];
  const double length = axis == GraphAxis::x ? to.x - from.x : to.y - from.y;
  const double share = length == 0 ? 0 : (position_px - (axis == GraphAxis::x ? from.x : from.y)) / length;
  return evidence.view.viewToPage({from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)});
}

bool fallsOnPage(GraphAxis axis, const importer::GraphEvidence& evidence) {
  const auto& m = evidence.view.viewToPage.m;
  if (m[0] * m[4] - m[1] * m[3] >= 0) return false;  // the view is not mirrored
  return axis == GraphAxis::x ? m[0] < 0 : m[4] < 0;
}

FrameCorners cornersOf(const importer::GraphEvidence& evidence) {
  return uprightCorners(evidence, cornersInView(evidence));
}

namespace {

/// Returns the number that `text` prints in line with an axis' tick labels, if it lies beyond the axis' end,
/// where the scale has that value. Sets `place` to that position on the page.
std::optional<double> valueBeyond(GraphAxis axis, const importer::SeenText& text,
                                  const importer::GraphEvidence& evidence, importer::Point& place) {
  constexpr double leastShare = 1.02, mostOff = 0.015;  // shares of the axis' length
  const auto& reading =
      axis == GraphAxis::x ? evidence.axes.calibration.value.x : evidence.axes.calibration.value.y;
  const auto value = numberIn(text.utf8);
  if (!value || reading.max == reading.min) return {};
  const double share = (*value - reading.min) / (reading.max - reading.min);
  const auto& corners = evidence.frame.corners;
  const importer::Point from = corners[3], to = axis == GraphAxis::x ? corners[2] : corners[0];
  const importer::Point at{from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)};
  const importer::Point middle = text.box.middle();
  const double off_px = axis == GraphAxis::x ? middle.x - at.x : middle.y - at.y;
  const double length_px = axis == GraphAxis::x ? to.x - from.x : from.y - to.y;
  if (share < leastShare || std::abs(off_px) > mostOff * std::abs(length_px)) return {};
  const bool inLine = std::ranges::any_of(reading.ticks, [&](const importer::TickLabel& tick) {
    return tick.used && (axis == GraphAxis::x ? middle.y > tick.box.y0 && middle.y < tick.box.y1
                                              : text.box.x1 > tick.box.x0 && text.box.x0 < tick.box.x1);
  });
  if (!inLine) return {};
  place = evidence.view.viewToPage(at);
  return value;
}

}  // namespace

std::optional<ExtendedFrame> extendedFrame(GraphAxis axis, const importer::GraphEvidence& evidence) {
  constexpr double leastShare = 1.02;  // share of the axis' length; a nearer place is the frame's own end
  const FrameCorners corners = cornersInView(evidence);
  const auto& calibration = evidence.axes.calibration.value;
  std::optional<ExtendedFrame> extended;
  double furthest = leastShare;
  for (const auto& tick : (axis == GraphAxis::x ? calibration.x : calibration.y).ticks) {
    const auto share = shareAlong(axis, corners, placeOfTick(axis, evidence, tick.position_px));
    if (!tick.used || !share || *share < furthest) continue;
    furthest = *share;
    extended = ExtendedFrame{corners, tick.value};
  }
  for (const importer::SeenText& text : evidence.axes.texts) {
    importer::Point place;
    const auto value = valueBeyond(axis, text, evidence, place);
    const auto share = value ? shareAlong(axis, corners, place) : std::nullopt;
    if (!share || *share < furthest) continue;
    furthest = *share;
    extended = ExtendedFrame{corners, *value};
  }
  if (!extended) return {};
  const auto onwards = [&](std::size_t moved, std::size_t from) {
    const importer::Point a = corners[from], b = corners[moved];
    extended->corners[moved] = {a.x + furthest * (b.x - a.x), a.y + furthest * (b.y - a.y)};
  };
  axis == GraphAxis::x ? onwards(1, 0) : onwards(0, 3);
  axis == GraphAxis::x ? onwards(2, 3) : onwards(1, 2);
  extended->corners = uprightCorners(evidence, extended->corners);
  return extended;
}

std::optional<FrameCorners> ImportGraph::corners() const {
  if (history.now().frame) return history.now().frame;
  if (found) return found->corners;
  if (!listed) return {};
  const importer::Box& box = listed->frame;
  FrameCorners corners{{{box.x0, box.y0}, {box.x1, box.y0}, {box.x1, box.y1}, {box.x0, box.y1}}};
  // Upright means after the page's quarter turns, as a reader sees it.
  std::rotate(corners.begin(), corners.begin() + (4 - listed->quarterTurns) % 4, corners.end());
  return corners;
}

std::optional<ResultBrief> ImportGraph::brief() const {
  if (!last) return letGo;
  ResultBrief brief;
  brief.failed = last->failure.has_value();
  if (good) {
    const importer::ImportReport& report = *good->report;
    brief.doubtful = report.doubt.has_value();
    brief.confidence = report.confidence;
    brief.x = report.x, brief.y = report.y;
  }
  return brief;
}

void ImportGraph::letResultGo() {
  letGo = brief();
  last.reset(), good.reset(), unmarked.reset();
  if (pending == 0) requested = false;
}

std::vector<SwitchChoice> ImportGraph::switches() const {
  if (!last || !last->evidence || last->evidence->switches.size() < 2) return {};
  const std::vector<importer::PlotSwitch>& all = last->evidence->switches;
  std::vector<SwitchChoice> choices;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto byName = importer::chosenSwitch(all, last->evidence->traces, all[i].name);
    const bool named = !all[i].name.empty() && byName && *byName == i;
    choices.push_back({named ? all[i].name : std::to_string(i + 1), &all[i]});
  }
  return choices;
}

bool ImportGraph::upToDate(importer::Quality quality) const {
  return pending == 0 && last && last->report && requested && requestedWith == history.now() &&
         requestedQuality == quality;
}

ImportState::ImportState(QObject* parent) : QObject(parent), client_(this) {
  connect(&client_, &ImportClient::answered, this,
          [this](ImportClient::Ticket ticket, const std::shared_ptr<const Answer>& answer) {
            if (const auto* imported = std::get_if<ImportedGraph>(answer.get())) {
              takeImport(ticket, answer, *imported);
            } else {
              take(ticket, *answer);
            }
          });
  connect(&client_, &ImportClient::progressed, this,
          [this](ImportClient::Ticket ticket, double fraction, importer::ImportStep step) {
            const ImportGraph* graph = current();
            if (ticket == openTicket_ || (graph && graph->pending == ticket)) emit progressed(fraction, step);
          });
}

void ImportState::openFile(const QString& path) {
  open(OpenFile{path}, QFileInfo(path).fileName());
  path_ = path;
}

void ImportState::continueDraft(const ImportDraft& draft) {
  quality_ = draft.quality;
  if (draft.picture.isEmpty())
    openFile(draft.path);
  else
    openPicture(QImage(draft.picture));
  toRestore_ = draft.graphs;
  toSelect_ = draft.current;
}

ImportDraft ImportState::draft() const {
  ImportDraft draft{path_, {}, quality_, current_, toRestore_};
  for (const auto& [id, graph] : graphs_)
    if (!(graph.history.now() == Corrections{}))
      draft.graphs.push_back({id, graph.history.now(), !graph.listed.has_value() && !isForceLog()});
  return draft;
}

// Restores the graphs of a page after it was searched: found graphs by their numbers, the others by their
// drawn frames.
void ImportState::restoreGraphs(int page) {
  std::optional<GraphId> restored;
  for (const DraftGraph& each : toRestore_) {
    if (each.id.page != page) continue;
    // not found again, so there is nothing to correct
    if (!each.framedByHand && !graphs_.contains(each.id)) continue;
    ImportGraph& graph = graphs_[each.id];
    graph.id = each.id;
    graph.history.apply(each.corrections, tr("Continue"));
    restored = each.id;
  }
  std::erase_if(toRestore_, [page](const DraftGraph& each) { return each.id.page == page; });
  if (restored) emit graphsChanged();
  if (toSelect_ && toSelect_->page == page) {
    if (graphs_.contains(*toSelect_)) restored = toSelect_;
    toSelect_.reset();  // selected once, so that a later search does not change the selection
  }
  if (restored) selectGraph(*restored);
}

void ImportState::openPicture(const QImage& picture) {
  const QString name = tr("Pasted picture");
  open(OpenPicture{picture, name}, name);
  pasted_ = picture;
}

void ImportState::open(Query query, const QString& name) {
  client_.forgetAll();
  toAccept_.clear();
  name_ = name;
  path_.clear(), pasted_ = {};
  toRestore_.clear(), toSelect_.reset();
  facts_.reset(), openFailure_.reset();
  pages_.clear(), graphs_.clear();
  currentPage_ = 0, current_.reset(), sheet_.reset();
  lookedAt_.clear();
  sheetTicket_ = 0;
  openTicket_ = client_.ask(std::move(query), Urgency::now);
  emit documentChanged();
}

void ImportState::take(ImportClient::Ticket ticket, const Answer& answer) {
  if (const auto* failure = std::get_if<Failure>(&answer)) return takeFailure(ticket, *failure);
  if (const auto* facts = std::get_if<DocumentFacts>(&answer)) return takeFacts(*facts);
  if (const auto* thumbnail = std::get_if<PageThumbnail>(&answer)) return takeThumbnail(*thumbnail);
  if (const auto* found = std::get_if<FoundGraphs>(&answer)) return takeGraphs(*found);
  if (const auto* sheet = std::get_if<PageSheet>(&answer)) {
    sheet_ = std::make_shared<const PageSheet>(*sheet);
    sheetTicket_ = 0;
    emit currentChanged();
  }
}

void ImportState::takeFailure(ImportClient::Ticket ticket, const Failure& failure) {
  if (ticket == openTicket_) {
    openTicket_ = 0;
    openFailure_ = failure;
    emit documentChanged();
    return;
  }
  const bool sheetFailed = ticket == sheetTicket_;
  if (sheetFailed) sheetTicket_ = 0;
  for (int number = 1; number <= pageCount(); ++number) {
    ImportPage& page = pageRef(number);
    const bool ofSheet = sheetFailed && number == currentPage_;
    if (page.thumbnailTicket != ticket && page.searchTicket != ticket && !ofSheet) continue;
    if (page.thumbnailTicket == ticket) page.thumbnailTicket = 0;
    if (page.searchTicket == ticket) page.searched = true, page.searchTicket = 0;
    page.failure = failure;
    emit pageChanged(number);
    if (number == currentPage_) emit currentChanged();
    return;
  }
}

void ImportState::takeFacts(const DocumentFacts& facts) {
  openTicket_ = 0;
  facts_ = facts;
  pages_.resize(static_cast<std::size_t>(facts.pages));
  currentPage_ = std::min(1, facts.pages);
  emit documentChanged();
  if (isForceLog()) {
    graphs_[logGraph].id = logGraph;
    restoreGraphs(logGraph.page);
    emit graphsChanged();
    selectGraph(logGraph);
    return;
  }
  askForPages();
  if (toSelect_ && (toSelect_->page < 1 || toSelect_->page > facts.pages)) toSelect_.reset();
  showPage(toSelect_ ? toSelect_->page : 1);
}

void ImportState::askForPages() {
  constexpr int firstPages = 8;  // number of pages that a list shows before it reports which are visible
  for (int number = 1; number <= std::min(firstPages, pageCount()); ++number)
    pageRef(number).thumbnailTicket =
        client_.ask(ReadThumbnail{number}, number == 1 ? Urgency::visible : Urgency::background);
  for (int number = 1; number <= pageCount(); ++number)
    pageRef(number).searchTicket = client_.ask(FindGraphs{number, quality_}, Urgency::background);
}

void ImportState::setVisiblePages(int first, int last) {
  for (int number = std::max(1, first); number <= std::min(last, pageCount()); ++number) {
    ImportPage& page = pageRef(number);
    if (!page.thumbnail.isNull() || page.failure) continue;
    client_.forget(page.thumbnailTicket);
    page.thumbnailTicket = client_.ask(ReadThumbnail{number}, Urgency::visible);
  }
}

void ImportState::takeThumbnail(const PageThumbnail& thumbnail) {
  ImportPage& page = pageRef(thumbnail.page);
  page.thumbnail = thumbnail.picture;
  page.bounds = thumbnail.bounds;
  page.thumbnailTicket = 0;
  emit pageChanged(thumbnail.page);
}

void ImportState::takeGraphs(const FoundGraphs& found) {
  const int number = found.thumbnail.page;
  takeThumbnail(found.thumbnail);
  ImportPage& page = pageRef(number);
  page.searched = true;
  page.searchTicket = 0;
  page.rejected = found.rejected;
  for (const FoundGraph& each : found.graphs) {
    const GraphId id{number, each.listed.graph};
    ImportGraph& graph = graphs_[id];
    graph.id = id;
    graph.listed = each.listed;
    graph.thumbnail = each.thumbnail;
  }
  emit pageChanged(number);
  emit graphsChanged();
  restoreGraphs(number);
  if (!current_ && !toSelect_ && !found.graphs.empty()) {
    const auto surest = std::max_element(
        found.graphs.begin(), found.graphs.end(),
        [](const FoundGraph& a, const FoundGraph& b) { return a.listed.confidence < b.listed.confidence; });
    selectGraph({number, surest->listed.graph});
  } else if (number == currentPage_) {
    emit currentChanged();
  }
}

const ImportPage& ImportState::page(int number) const {
  DETENT_CHECK(number >= 1 && number <= pageCount(), "pages count from 1");
  return pages_[static_cast<std::size_t>(number - 1)];
}

int ImportState::searchedPages() const {
  return static_cast<int>(
      std::count_if(pages_.begin(), pages_.end(), [](const ImportPage& page) { return page.searched; }));
}

std::vector<GraphId> ImportState::graphs() const {
  std::vector<GraphId> ids;
  for (const auto& each : graphs_) ids.push_back(each.first);
  return ids;
}

const ImportGraph* ImportState::graph(GraphId id) const {
  const auto found = graphs_.find(id);
  return found == graphs_.end() ? nullptr : &found->second;
}

ImportGraph* ImportState::currentRef() {
  if (!current_) return nullptr;
  const auto found = graphs_.find(*current_);
  return found == graphs_.end() ? nullptr : &found->second;
}

int ImportState::tickedCount() const { return static_cast<int>(ticked().size()); }

void ImportState::setTicked(GraphId id, bool ticked) {
  const auto found = graphs_.find(id);
  if (found == graphs_.end() || found->second.ticked == ticked) return;
  found->second.ticked = ticked;
  emit graphsChanged();
}

void ImportState::setCurveTicked(const std::string& curve, bool ticked) {
  ImportGraph* graph = currentRef();
  if (!graph || graph->tickedCurves.contains(curve) == ticked) return;
  if (ticked)
    graph->tickedCurves.insert(curve);
  else
    graph->tickedCurves.erase(curve);
  emit graphsChanged();
}

void ImportState::showPage(int number) {
  if (number < 1 || number > pageCount()) return;
  const bool another = number != currentPage_;
  currentPage_ = number;
  if (another) sheet_.reset();
  if (another || !sheet_) askForSheet();
  if (current_ && current_->page != number) current_.reset();
  emit currentChanged();
}

void ImportState::askForSheet() {
  client_.forget(sheetTicket_);
  sheetTicket_ = client_.ask(ReadSheet{currentPage_}, Urgency::visible);
}

void ImportState::selectGraph(GraphId id) {
  if (!graph(id)) return;
  if (!isForceLog() && id.page != currentPage_) {
    currentPage_ = id.page;
    sheet_.reset();
    askForSheet();
  }
  current_ = id;
  letOldResultsGo();
  ImportGraph& graph = *currentRef();
  if (graph.pending == 0 && !graph.upToDate(quality_)) askForImport(graph, Urgency::now);
  emit currentChanged();
  emit correctionsChanged();
  emit resultChanged();
}

/// Releases old results. A result holds the pixels it was read from and a picture of them, 10 to 60 MB;
/// besides the current one only small results are kept (docs/develop/decisions/1020-memory-of-imports.md).
void ImportState::letOldResultsGo() {
  constexpr std::size_t mostBytes = std::size_t{24} << 20;
  std::erase(lookedAt_, *current_);
  std::size_t bytes = 0;
  const auto goes = [&](GraphId id) {
    ImportGraph& graph = graphs_.at(id);
    bytes += bytesOf(graph);
    if (bytes <= mostBytes) return false;
    if (graph.pending != 0 && !accepting()) client_.forget(std::exchange(graph.pending, 0));
    graph.letResultGo();
    return true;
  };
  std::erase_if(lookedAt_, goes);
  lookedAt_.insert(lookedAt_.begin(), *current_);
}

void ImportState::setQuality(importer::Quality quality) {
  if (quality == quality_) return;
  quality_ = quality;
  if (ImportGraph* graph = currentRef()) askForImport(*graph, Urgency::now);
  emit correctionsChanged();
  emit resultChanged();
}

void ImportState::apply(const Corrections& next, const QString& label, const QString& mergeKey) {
  ImportGraph* graph = currentRef();
  if (!graph || !graph->history.apply(next, label, mergeKey)) return;
  graph->confirmed = false;
  askForImport(*graph, Urgency::now);
  emit correctionsChanged();
  emit resultChanged();
}

void ImportState::correct(const QString& label, const std::function<void(Corrections&)>& edit) {
  if (!current()) return;
  Corrections next = current()->history.now();
  edit(next);
  apply(next, label);
}

void ImportState::undo() {
  ImportGraph* graph = currentRef();
  if (!graph || !graph->history.canUndo()) return;
  graph->history.undo();
  askForImport(*graph, Urgency::now);
  emit correctionsChanged();
  emit resultChanged();
}

void ImportState::redo() {
  ImportGraph* graph = currentRef();
  if (!graph || !graph->history.canRedo()) return;
  graph->history.redo();
  askForImport(*graph, Urgency::now);
  emit correctionsChanged();
  emit resultChanged();
}

void ImportState::addGraph(const FrameCorners& frame) {
  if (currentPage_ < 1) return;
  GraphId id{currentPage_, 1};
  while (graphs_.contains(id)) ++id.graph;
  ImportGraph& graph = graphs_[id];
  graph.id = id;
  Corrections corrections;
  corrections.frame = frame;
  graph.history.apply(corrections, tr("Draw plot frame"));
  emit graphsChanged();
  selectGraph(id);
}

void ImportState::tickAll() {
  const bool all =
      std::all_of(graphs_.begin(), graphs_.end(), [](const auto& each) { return each.second.ticked; });
  for (auto& [id, graph] : graphs_) graph.ticked = !all;
  emit graphsChanged();
  emit resultChanged();
}

void ImportState::selectNext(int by) {
  const std::vector<GraphId> all = graphs();
  if (all.empty()) return;
  auto at = std::lower_bound(all.begin(), all.end(), current_.value_or(GraphId{currentPage_, 0}));
  std::ptrdiff_t next = at - all.begin() + by;
  if (!current_ && by > 0) --next;  // if the current page has no graph, the first graph after it is next
  selectGraph(all[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(next, 0, std::ssize(all) - 1))]);
}

void ImportState::setConfirmed(bool confirmed) {
  if (ImportGraph* graph = currentRef()) graph->confirmed = confirmed;
  emit resultChanged();
}

bool ImportState::working() const { return current() && current()->pending != 0; }

void ImportState::cancel() {
  toAccept_.clear();
  ImportGraph* graph = currentRef();
  if (!graph || graph->pending == 0) return;
  client_.forget(graph->pending);
  graph->pending = 0;
  graph->requested = false;
  emit resultChanged();
}

void ImportState::stopAll() {
  client_.forgetAll();
  toAccept_.clear();
  openTicket_ = sheetTicket_ = 0;
  for (ImportPage& page : pages_) page.thumbnailTicket = page.searchTicket = 0;
  for (auto& each : graphs_) {
    if (each.second.pending != 0) each.second.requested = false;
    each.second.pending = 0;
  }
  emit resultChanged();
}

void ImportState::askForImport(ImportGraph& graph, Urgency urgency) {
  client_.forget(graph.pending);
  graph.requestedWith = graph.history.now();
  graph.requestedQuality = quality_;
  graph.requested = true;
  graph.pending =
      client_.ask(ImportOne{graph.id, hintsFrom(graph.requestedWith, graph.found), quality_}, urgency);
}

void ImportState::rememberFound(ImportGraph& graph, const ImportedGraph& imported) {
  if (!imported.evidence) return;
  const Corrections& given = graph.requestedWith;
  const bool axesFound = given.x.empty() && given.y.empty();
  if (!graph.found) graph.found = FoundAxes{cornersOf(*imported.evidence), {}, {}};
  if (!given.frame) graph.found->corners = cornersOf(*imported.evidence);
  if (!axesFound) return;
  graph.found->xTicks = usedTicks(GraphAxis::x, *imported.evidence);
  graph.found->yTicks = usedTicks(GraphAxis::y, *imported.evidence);
  graph.found->xEnds = endsFound(GraphAxis::x, *imported.evidence);
  graph.found->yEnds = endsFound(GraphAxis::y, *imported.evidence);
  graph.foundX = imported.evidence->axes.calibration.value.x;
  graph.foundY = imported.evidence->axes.calibration.value.y;
}

void ImportState::takeImport(ImportClient::Ticket ticket, const std::shared_ptr<const Answer>& kept,
                             const ImportedGraph& imported) {
  const auto place = graphs_.find(imported.graph);
  if (place == graphs_.end() || place->second.pending != ticket) return;  // stale
  ImportGraph& graph = place->second;
  graph.pending = 0;
  if (wasCancelled(imported)) {
    graph.requested = false;
  } else {
    graph.last = std::shared_ptr<const ImportedGraph>(kept, &imported);
    if (imported.report) {
      const MarkedImport marked = withMarks(imported, graph.requestedWith.marks);
      graph.refusedMarks = marked.refused;
      graph.unmarked = graph.last;
      if (marked.imported.report != imported.report)
        graph.last = std::make_shared<const ImportedGraph>(marked.imported);
      graph.good = graph.last;
    }
    rememberFound(graph, imported);
  }
  if (current_ == imported.graph) {
    emit correctionsChanged();
    emit resultChanged();
  }
  emit graphsChanged();
  if (accepting()) acceptNext();
}

std::vector<ImportState::Wanted> ImportState::ticked() const {
  std::vector<Wanted> wanted;
  for (const auto& [id, graph] : graphs_) {
    for (const std::string& curve : graph.tickedCurves) wanted.push_back({id, curve});
    if (graph.ticked && graph.tickedCurves.empty()) wanted.push_back({id, {}});
  }
  return wanted;
}

void ImportState::acceptAll() {
  toAccept_ = ticked();
  if (toAccept_.empty() && current_) toAccept_.push_back({*current_, {}});
  acceptNext();
}

void ImportState::choose(ImportGraph& graph, const std::string& curve) {
  Corrections next = graph.history.now();
  next.curve = curve;
  if (!graph.history.apply(next, tr("Choose switch"))) return;
  graph.confirmed = false;
  if (current_ == graph.id) emit correctionsChanged();
}

bool ImportState::isUsable(const ImportGraph& graph) const {
  return graph.upToDate(quality_) && graph.isAcceptable(*graph.last);
}

void ImportState::giveOut(ImportGraph& graph, const std::string& curve) {
  graph.tickedCurves.erase(curve);
  if (graph.tickedCurves.empty()) graph.ticked = false;
  const auto report = graph.last->report;
  if (current_ != graph.id) graph.letResultGo();  // the receiver owns the result now
  emit accepted(report);
}

void ImportState::acceptNext() {
  while (!toAccept_.empty()) {
    const Wanted wanted = toAccept_.front();
    ImportGraph& graph = graphs_.at(wanted.graph);
    if (graph.pending != 0) return;  // continues when the answer arrives
    if (!wanted.curve.empty()) choose(graph, wanted.curve);
    const bool answered =
        graph.requested && graph.requestedWith == graph.history.now() && graph.requestedQuality == quality_;
    if (!graph.upToDate(quality_) && !answered) {
      askForImport(graph, Urgency::now);
      if (current_ == graph.id) emit resultChanged();
      return;
    }
    if (!isUsable(graph)) {
      toAccept_.clear();
      selectGraph(wanted.graph);
      emit acceptStopped();
      return;
    }
    toAccept_.erase(toAccept_.begin());
    giveOut(graph, wanted.curve);
  }
  emit allAccepted();
}

}  // namespace detent::editor
