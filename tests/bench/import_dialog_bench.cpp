// SPDX-License-Identifier: GPL-3.0-or-later
// The import dialogue on a long document: time to the first thumbnail, the longest time the window did not
// answer, memory.
//
//   import_dialog_bench [--pages N] [--write docs/measurements]
//
// The document is made here: text pages, vector force graphs, and scanned pages of 300 dpi with a graph on
// them. Another process writes it, so that this one's memory is the dialogue's alone. The dialogue is opened,
// shows the first graph, is scrolled and zoomed, takes a correction of an axis, a mask and another quality,
// and goes on until all pages are searched. Run with QT_QPA_PLATFORM=offscreen or in a session.

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <QApplication>
#include <QElapsedTimer>
#include <QFile>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <QTextStream>
#include <thread>
#include <vector>

#include "editor/document/large_blocks.h"
#include "editor/importing/import_dialog.h"
#include "editor/importing/page_list.h"
#include "editor/importing/page_view.h"
#include "tests/editor/importing/stall_probe.h"

using namespace detent;
using namespace detent::editor;

namespace {

constexpr double barFirstThumbnail_s = 1.5, barStall_ms = 50, barMemory_MB = 400;

/// A force graph in a rectangle: frame, grid, numbers, titles, press and release in two colours.
void drawGraph(QPainter& painter, const QRectF& frame, int variant) {
  const double unit = frame.width() / 400;
  painter.setPen(QPen(QColor(200, 200, 200), unit));
  const QFont before = painter.font();
  QFont font(QStringLiteral("DejaVu Sans"));
  font.setPixelSize(std::max(1, static_cast<int>(14 * unit)));
  painter.setFont(font);
  for (int i = 0; i <= 8; ++i) {
    const double x = frame.left() + frame.width() * i / 8;
    painter.setPen(QPen(QColor(205, 205, 205), unit));
    painter.drawLine(QPointF(x, frame.top()), QPointF(x, frame.bottom()));
    painter.setPen(Qt::black);
    painter.drawText(QRectF(x - 30 * unit, frame.bottom() + 4 * unit, 60 * unit, 20 * unit), Qt::AlignCenter,
                     QString::number(0.5 * i));
  }
  for (int i = 0; i <= 6; ++i) {
    const double y = frame.bottom() - frame.height() * i / 6;
    painter.setPen(QPen(QColor(205, 205, 205), unit));
    painter.drawLine(QPointF(frame.left(), y), QPointF(frame.right(), y));
    painter.setPen(Qt::black);
    painter.drawText(QRectF(frame.left() - 50 * unit, y - 10 * unit, 44 * unit, 20 * unit),
                     Qt::AlignRight | Qt::AlignVCenter, QString::number(20 * i));
  }
  painter.setPen(QPen(Qt::black, 1.4 * unit));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(frame);
  painter.drawText(QRectF(frame.left(), frame.bottom() + 26 * unit, frame.width(), 22 * unit),
                   Qt::AlignCenter, QStringLiteral("Displacement [mm]"));
  painter.drawText(QRectF(frame.left() - 40 * unit, frame.top() - 28 * unit, 140 * unit, 22 * unit),
                   Qt::AlignLeft, QStringLiteral("Force [cN]"));
  for (const bool press : {true, false}) {
    QPolygonF line;
    for (int i = 0; i <= 300; ++i) {
      const double mm = 3.6 * i / 300;
      const double bump = std::exp(-std::pow((mm - 1.3 - 0.02 * variant) / 0.35, 2));
      const double cN =
          (press ? 25 : 15) + 12 * mm + (press ? 24 : 10) * bump + (mm > 3.4 ? 200 * (mm - 3.4) : 0);
      line << QPointF(frame.left() + frame.width() * mm / 4, frame.bottom() - frame.height() * cN / 120);
    }
    painter.setPen(QPen(press ? QColor(200, 30, 30) : QColor(20, 60, 200), 2 * unit));
    painter.drawPolyline(line);
  }
  painter.setFont(before);
}

void drawText(QPainter& painter, const QRectF& area, int page) {
  QFont font(QStringLiteral("DejaVu Sans"));
  font.setPixelSize(static_cast<int>(area.width() / 60));
  painter.setFont(font);
  painter.setPen(Qt::black);
  QString text;
  for (int i = 0; i < 60; ++i)
    text +=
        QStringLiteral("Page %1, clause %2: total travel, operating force and contact data as specified. ")
            .arg(page)
            .arg(i + 1);
  painter.drawText(area, Qt::TextWordWrap, text);
}

/// Every fourth page carries two vector graphs, every tenth is a 300 dpi scan with one; the others are text.
bool writeDocument(const QString& path, int pages) {
  QPdfWriter writer(path);
  writer.setPageSize(QPageSize(QPageSize::A4));
  writer.setResolution(300);
  writer.setPageMargins({});
  QPainter painter;
  if (!painter.begin(&writer)) return false;
  const QRectF sheet(0, 0, writer.width(), writer.height());
  for (int page = 1; page <= pages; ++page) {
    if (page > 1) writer.newPage();
    if (page % 10 == 5) {
      QImage scan(2480, 3508, QImage::Format_RGB32);
      scan.fill(QColor(250, 249, 246));
      QPainter onScan(&scan);
      onScan.setRenderHint(QPainter::Antialiasing);
      drawText(onScan, QRectF(200, 200, 2080, 1300), page);
      drawGraph(onScan, QRectF(500, 1800, 1400, 900), page);
      onScan.end();
      painter.drawImage(sheet, scan);
    } else {
      drawText(painter, QRectF(200, 200, sheet.width() - 400, 1000), page);
      if (page % 4 == 2) {
        drawGraph(painter, QRectF(500, 1300, 1300, 700), page);
        drawGraph(painter, QRectF(500, 2400, 1300, 700), page + 1);
      }
    }
  }
  return painter.end();
}

/// Peak of this process' resident memory; 0 where the system does not say.
double peakMemory_MB() {
  QFile status(QStringLiteral("/proc/self/status"));
  if (!status.open(QIODevice::ReadOnly)) return 0;
  static const QRegularExpression line(QStringLiteral("VmHWM:\\s+(\\d+) kB"));
  const auto match = line.match(QString::fromLatin1(status.readAll()));
  return match.hasMatch() ? match.captured(1).toDouble() / 1024 : 0;
}

/// A thread that only wakes every 2 ms: its lateness is caused by the machine, not by the dialogue.
class IdleThread {
 public:
  IdleThread()
      : thread_([this](const std::stop_token& stop) {
          constexpr std::chrono::milliseconds period(2);
          while (!stop.stop_requested()) {
            const auto due = std::chrono::steady_clock::now() + period;
            std::this_thread::sleep_until(due);
            const std::chrono::duration<double, std::milli> late = std::chrono::steady_clock::now() - due;
            if (late.count() > longest_ms_.load()) longest_ms_ = late.count();
          }
        }) {}
  double takeLongest_ms() { return longest_ms_.exchange(0); }

 private:
  std::atomic<double> longest_ms_ = 0;
  std::jthread thread_;  // last member, because the thread uses the others
};

struct Figures {
  int pages = 0, graphs = 0;
  double firstThumbnail_s = 0, firstResult_s = 0, allPages_s = 0;
  struct Part {
    QString name;
    double stall_ms = 0, own_ms = 0, idle_ms = 0, memory_MB = 0;
  };
  std::vector<Part> parts;
  double memory_MB = 0;
  double longest(double Part::*figure) const {
    double most = 0;
    for (const Part& part : parts) most = std::max(most, part.*figure);
    return most;
  }
};

/// Ends the benchmark if it takes ten minutes.
template <class Predicate>
void waitFor(Predicate predicate) {
  constexpr int patience_ms = 600000;
  if (QTest::qWaitFor(predicate, patience_ms)) return;
  std::fprintf(stderr, "import_dialog_bench: waited for ten minutes in vain\n");
  std::exit(1);
}

bool ready(const ImportState& state) { return state.current() && state.current()->last && !state.working(); }

Figures run(const QString& path, int pages) {
  Figures figures;
  figures.pages = pages;
  ViewSettings settings;
  ImportDialog dialog(settings);
  dialog.show();
  QTest::qWait(300);
  auto* view = dialog.findChild<PageView*>();
  auto* list = dialog.findChild<PageList*>();
  ImportState& state = view->state();
  IdleThread idle;
  StallProbe probe;
  const auto part = [&](const char* name) {
    figures.parts.push_back({QString::fromLatin1(name), static_cast<double>(probe.longest_ms()),
                             probe.longestOwn_ms(), idle.takeLongest_ms(), peakMemory_MB()});
    probe.restart();
  };

  QElapsedTimer clock;
  clock.start();
  dialog.openFile(path);
  waitFor([&] { return state.pageCount() > 0 && !state.page(1).thumbnail.isNull(); });
  figures.firstThumbnail_s = 1e-3 * static_cast<double>(clock.elapsed());
  waitFor([&] { return ready(state); });
  figures.firstResult_s = 1e-3 * static_cast<double>(clock.elapsed());
  part("opening, to the first result");

  for (int row = 0; row < list->model()->rowCount(); row += 6) {
    list->scrollTo(list->model()->index(row, 0));
    QTest::qWait(20);
  }
  for (int i = 0; i < 30; ++i) {
    view->zoomBy(i < 15 ? 1.25 : 0.8);
    QTest::qWait(10);
  }
  view->fitGraph();
  part("scrolling and zooming");

  Corrections next = state.current()->history.now();
  next.x.min = 0, next.x.max = 4.1;
  state.apply(next, QStringLiteral("Displacement range"));
  waitFor([&] { return ready(state); });
  next.masks.push_back({0, 0, 30, 30});
  state.apply(next, QStringLiteral("Mask"));
  waitFor([&] { return ready(state); });
  state.setQuality(importer::Quality::precise);
  waitFor([&] { return ready(state); });
  state.undo();
  waitFor([&] { return ready(state); });
  part("correcting");

  waitFor([&] { return state.searchedPages() == state.pageCount(); });
  figures.allPages_s = 1e-3 * static_cast<double>(clock.elapsed());
  part("searching the other pages");

  const auto graphs = state.graphs();
  figures.graphs = static_cast<int>(graphs.size());
  for (std::size_t i = 0; i < graphs.size(); i += 3) {
    state.selectGraph(graphs[i]);
    waitFor([&] { return ready(state) && state.sheet(); });
  }
  part("going through graphs");
  figures.memory_MB = peakMemory_MB();
  return figures;
}

QString tableOf(const Figures& f) {
  QString text;
  QTextStream out(&text);
  const auto verdict = [](bool held) { return held ? "held" : "missed"; };
  out.setRealNumberNotation(QTextStream::FixedNotation);
  out << "| figure | measured | bar | |\n|---|---|---|---|\n";
  out.setRealNumberPrecision(2);
  out << "| first thumbnail | " << f.firstThumbnail_s << " s | " << barFirstThumbnail_s << " s | "
      << verdict(f.firstThumbnail_s <= barFirstThumbnail_s) << " |\n";
  out << "| first graph imported | " << f.firstResult_s << " s | | |\n";
  out << "| all pages searched, while being worked with | " << f.allPages_s << " s | | |\n";
  out.setRealNumberPrecision(0);
  const double stall_ms = f.longest(&Figures::Part::stall_ms);
  out << "| longest stall of the window | " << stall_ms << " ms | " << barStall_ms << " ms | "
      << verdict(stall_ms <= barStall_ms) << " |\n";
  out << "| longest work of the window's own thread | " << f.longest(&Figures::Part::own_ms) << " ms | "
      << barStall_ms << " ms | " << verdict(f.longest(&Figures::Part::own_ms) <= barStall_ms) << " |\n";
  out << "| lateness of a thread that only sleeps | " << f.longest(&Figures::Part::idle_ms) << " ms | | |\n";
  out << "| peak memory | " << f.memory_MB << " MB | " << barMemory_MB << " MB | "
      << verdict(f.memory_MB <= barMemory_MB) << " |\n";
  out << "\n| part of the run | stall | own work | a thread that only sleeps | peak memory so far "
         "|\n|---|---|---|---|---|\n";
  for (const auto& part : f.parts)
    out << "| " << part.name << " | " << part.stall_ms << " ms | " << part.own_ms << " ms | " << part.idle_ms
        << " ms | " << part.memory_MB << " MB |\n";
  return text;
}

}  // namespace

int main(int argc, char** argv) {
  detent::editor::giveLargeBlocksBack();  // memory setting of detent-edit
  QApplication app(argc, argv);
  const QStringList arguments = app.arguments();
  const auto valueOf = [&](const char* option) {
    const auto at = arguments.indexOf(QLatin1String(option));
    return at >= 0 && at + 1 < arguments.size() ? arguments[at + 1] : QString();
  };
  const int pages = valueOf("--pages").isEmpty() ? 40 : valueOf("--pages").toInt();
  if (const QString path = valueOf("--make"); !path.isEmpty()) return writeDocument(path, pages) ? 0 : 1;

  QTemporaryDir folder;
  const QString document = folder.filePath(QStringLiteral("long.pdf"));
  if (QProcess::execute(
          app.applicationFilePath(),
          {QStringLiteral("--make"), document, QStringLiteral("--pages"), QString::number(pages)}) != 0) {
    std::fprintf(stderr, "import_dialog_bench: the document could not be written\n");
    return 1;
  }
  const Figures figures = run(document, pages);
  const QString table = tableOf(figures);
  std::printf("%d pages, %d graphs\n\n%s", figures.pages, figures.graphs, qPrintable(table));
  if (const QString docs = valueOf("--write"); !docs.isEmpty()) {
    QFile file(docs + QStringLiteral("/bench-import-dialog.md"));
    if (!file.open(QIODevice::WriteOnly | QIODevice::Text)) return 1;
    QTextStream out(&file);
    out << "# Import dialogue: a long document\n\nMade by `import_dialog_bench --write docs/measurements` "
           "(tests/bench/import_dialog_bench.cpp, which says how) on a document of "
        << figures.pages << " pages with " << figures.graphs
        << " graphs: text, vector graphs and 300 dpi scans. A stall is how much later than due the window's "
           "event loop came "
           "round, other programs' time included. Two figures tell what of it is the dialogue's: the "
           "processor time of the window's "
           "thread in one round of its event loop, and how late a thread came meanwhile that does nothing "
           "but sleep. Memory is the "
           "peak of the whole process.\n\n"
        << table;
  }
  return 0;
}
