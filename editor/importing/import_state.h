// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// State of the import dialogue: the open document, its pages and graphs, corrections for each, and the last
// results. Widgets draw it and call it; it queries the import thread and never waits.

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <QObject>
#include <set>
#include <string>
#include <vector>

#include "editor/importing/corrections.h"
#include "editor/importing/import_client.h"
#include "editor/importing/import_draft.h"

namespace detent::editor {

/// One page of the document, as far as it is known.
struct ImportPage {
  QImage thumbnail;  ///< null until it was drawn
  QRectF bounds;     ///< page units
  bool searched = false;
  std::optional<Failure> failure;  ///< reason why the page cannot be read
  std::vector<importer::RejectedFrame> rejected;
  ImportClient::Ticket thumbnailTicket = 0, searchTicket = 0;
};

/// Figures of a result that was released.
struct ResultBrief {
  bool failed = false, doubtful = false;
  double confidence = 0;
  std::optional<importer::AxisReading> x, y;
};

/// One of several switches in a plot.
struct SwitchChoice {
  /// value of Corrections::curve that takes this switch: its name, or its number if several have that name
  std::string curve;
  const importer::PlotSwitch* itself = nullptr;  ///< lives as long as the result it came with
};

/// One graph, found or framed by hand, with its corrections and results.
struct ImportGraph {
  GraphId id;
  std::optional<importer::ListedGraph> listed;  ///< empty if framed by hand, and for a force meter's log
  QImage thumbnail;
  bool ticked = false;  ///< ticked to be imported with the others
  /// names or numbers (Corrections::curve) of the switches to be imported, if the graph has several
  std::set<std::string> tickedCurves;
  bool confirmed = false;  ///< a person has checked the doubtful result against the page
  CorrectionHistory history;

  std::shared_ptr<const ImportedGraph> last;  ///< newest answer, good or not; null before the first
  std::shared_ptr<const ImportedGraph> good;  ///< newest answer with a report; stays while later ones fail
  std::shared_ptr<const ImportedGraph> unmarked;  ///< `good` without the points given by hand
  /// for `good`: points that cannot be moved to the place where the user put them
  std::vector<Failure> refusedMarks;
  std::optional<ResultBrief> letGo;  ///< figures of the released result
  std::optional<FoundAxes> found;    ///< ticks and corners as found, to which "reset" goes back
  std::optional<importer::AxisReading> foundX, foundY;

  ImportClient::Ticket pending = 0;
  Corrections requestedWith;  ///< corrections of the newest query
  importer::Quality requestedQuality = importer::Quality::standard;
  bool requested = false;

  /// The switches that the newest reading saw in the plot, if there are several, with what chooses each of
  /// them.
  std::vector<SwitchChoice> switches() const;
  /// Returns true if the user said that an axis measures another quantity.
  bool isOther() const { return history.now().xIsOther || history.now().yIsOther; }
  /// Returns true if one of its results can be accepted: neither another quantity nor an open doubt.
  bool isAcceptable(const ImportedGraph& result) const {
    return !isOther() && (!result.report->doubt || confirmed);
  }
  bool framedByHand() const { return history.now().frame.has_value(); }
  /// Present corners in page units: the given ones, else the found ones; empty before either exists.
  std::optional<FrameCorners> corners() const;
  /// Brief of the newest results, or of released ones; empty before the first.
  std::optional<ResultBrief> brief() const;
  /// Keeps the brief only; the result is requested again when it is shown.
  void letResultGo();
  /// Returns true if there is a report for exactly the present settings.
  bool upToDate(importer::Quality quality) const;
};

/// GUI thread.
class ImportState : public QObject {
  Q_OBJECT

 public:
  explicit ImportState(QObject* parent = nullptr);

  /// Opens a file; like openPicture it closes the previous one.
  void openFile(const QString& path);
  void openPicture(const QImage& picture);
  /// Opens the sheet of a draft again and gives its graphs the corrections they had, as they are found.
  void continueDraft(const ImportDraft& draft);
  /// Unsaved corrections; the caller writes the `picture` of a pasted one.
  ImportDraft draft() const;
  /// Null unless a picture was pasted.
  const QImage& pastedPicture() const { return pasted_; }

  bool opening() const { return openTicket_ != 0; }
  bool isOpen() const { return facts_.has_value(); }
  bool isForceLog() const { return facts_ && facts_->pages == 0; }
  QString documentName() const { return name_; }
  int pageCount() const { return facts_ ? facts_->pages : 0; }
  const std::optional<Failure>& openFailure() const { return openFailure_; }

  const ImportPage& page(int number) const;  ///< 1 to pageCount() (checked)
  /// Pages searched so far; when it reaches pageCount() all graphs are known.
  int searchedPages() const;
  std::vector<GraphId> graphs() const;
  const ImportGraph* graph(GraphId id) const;
  /// Number of buttons that acceptAll() would give for the ticked items: graphs, and switches of one graph.
  int tickedCount() const;

  int currentPage() const { return currentPage_; }
  const ImportGraph* current() const { return current_ ? graph(*current_) : nullptr; }
  /// Picture of the current page; while a new one is read, null.
  const PageSheet* sheet() const { return sheet_.get(); }
  void showPage(int number);
  void selectGraph(GraphId id);
  void setTicked(GraphId id, bool ticked);
  /// One of several switches in the current graph; `curve` as SwitchChoice.
  void setCurveTicked(const std::string& curve, bool ticked);
  /// Ticks all graphs found so far, or unticks all if all are ticked.
  void tickAll();
  /// Selects the graph `by` places further in reading order, across pages; stops at the first and the last.
  void selectNext(int by);
  /// Thumbnails of these pages are read first.
  void setVisiblePages(int first, int last);

  importer::Quality quality() const { return quality_; }
  void setQuality(importer::Quality quality);

  /// A step of the current graph's corrections, undoable.
  void apply(const Corrections& next, const QString& label, const QString& mergeKey = {});
  /// The same, as an edit of the present corrections; does nothing without a current graph.
  void correct(const QString& label, const std::function<void(Corrections&)>& edit);
  void undo();
  void redo();
  /// A graph that was not found: the frame is given on the current page.
  void addGraph(const FrameCorners& frame);
  void setConfirmed(bool confirmed);

  bool working() const;
  /// Stops the running import; the last good result stays.
  void cancel();
  /// Stops all work; known results stay.
  void stopAll();

  /// Imports the ticked graphs and switches (without any, the current graph): `accepted` is emitted for each
  /// result, then `allAccepted`. At the first one that fails or is in doubt, `acceptStopped` is emitted
  /// instead, and that graph becomes the current one.
  void acceptAll();
  bool accepting() const { return !toAccept_.empty(); }

 signals:
  void documentChanged();  ///< opened, failed to open
  void pageChanged(int number);
  void graphsChanged();
  void currentChanged();  ///< another page or graph was selected, or the page's picture arrived
  void correctionsChanged();
  void resultChanged();  ///< The current graph has a new answer, or work on it began or ended.
  void progressed(double fraction, importer::ImportStep step);
  void accepted(std::shared_ptr<const importer::ImportReport> report);
  void allAccepted();
  void acceptStopped();

 private:
  void open(Query query, const QString& name);
  void take(ImportClient::Ticket ticket, const Answer& answer);
  void takeFacts(const DocumentFacts& facts);
  void takeThumbnail(const PageThumbnail& thumbnail);
  void takeGraphs(const FoundGraphs& found);
  void takeImport(ImportClient::Ticket ticket, const std::shared_ptr<const Answer>& kept,
                  const ImportedGraph& imported);
  void takeFailure(ImportClient::Ticket ticket, const Failure& failure);
  void askForPages();
  void askForSheet();
  void askForImport(ImportGraph& graph, Urgency urgency);
  void letOldResultsGo();
  void rememberFound(ImportGraph& graph, const ImportedGraph& imported);
  /// A requested graph, or one of the switches in it.
  struct Wanted {
    GraphId graph;
    std::string curve;  ///< empty: the curve that the corrections choose
  };
  std::vector<Wanted> ticked() const;
  bool isUsable(const ImportGraph& graph) const;
  void choose(ImportGraph& graph, const std::string& curve);
  void giveOut(ImportGraph& graph, const std::string& curve);
  void acceptNext();
  ImportPage& pageRef(int number) { return pages_[static_cast<std::size_t>(number - 1)]; }
  ImportGraph* currentRef();
  void restoreGraphs(int page);

  ImportClient client_;
  ImportClient::Ticket openTicket_ = 0, sheetTicket_ = 0;
  QString name_, path_;
  QImage pasted_;
  std::vector<DraftGraph> toRestore_;  ///< corrections whose graphs are not known yet
  std::optional<GraphId> toSelect_;
  std::optional<DocumentFacts> facts_;
  std::optional<Failure> openFailure_;
  std::vector<ImportPage> pages_;
  std::map<GraphId, ImportGraph> graphs_;
  int currentPage_ = 0;
  std::optional<GraphId> current_;
  std::vector<GraphId> lookedAt_;  ///< most recent first
  std::shared_ptr<const PageSheet> sheet_;
  importer::Quality quality_ = importer::Quality::standard;
  std::vector<Wanted> toAccept_;
};

/// A found tick's place on the page.
importer::Point placeOfTick(GraphAxis axis, const importer::GraphEvidence& evidence, double position_px);
/// Returns true if the axis' values fall to the right or upwards on the page. Such a plot is read in a
/// mirror, where the values of its AxisReading rise.
bool fallsOnPage(GraphAxis axis, const importer::GraphEvidence& evidence);
/// Corners of the evidence's frame in page units, from the upper left one clockwise as the page shows them.
FrameCorners cornersOf(const importer::GraphEvidence& evidence);

/// The frame extended to numbers of one axis that stand beyond it.
struct ExtendedFrame {
  FrameCorners corners;
  double value = 0;  ///< the number at its new end, in the axis' unit
};
/// The frame extended to tick labels; empty if none is clearly outside at the right or upper end.
std::optional<ExtendedFrame> extendedFrame(GraphAxis axis, const importer::GraphEvidence& evidence);

}  // namespace detent::editor
