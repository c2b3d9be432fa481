// SPDX-License-Identifier: GPL-3.0-or-later
// measured_bench DATABASE: what the window of measured switches takes of a processor for all rows of a
// library. Lines "what<TAB>ms", medians of nine. QT_QPA_PLATFORM=offscreen; tests/bench/library.py prints the
// table.

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <QApplication>
#include <QPixmap>
#include <QTableView>
#include <vector>

#include "editor/measured/measured_table.h"
#include "editor/measured/switch_map.h"

using namespace detent;
using namespace detent::editor;

namespace {

template <class Work>
void tell(const char* what, const Work& work) {
  std::vector<double> times_ms;
  for (int round = 0; round < 9; ++round) {
    const std::clock_t begin = std::clock();
    work(round);
    times_ms.push_back(1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
  }
  std::ranges::sort(times_ms);
  std::printf("%s\t%.1f\n", what, times_ms[times_ms.size() / 2]);
}

}  // namespace

int main(int argc, char** argv) {
  const QApplication application(argc, argv);
  if (argc != 2) {
    std::fprintf(stderr, "measured_bench DATABASE\n");
    return 2;
  }
  const auto store = importer::LibraryStore::openToRead(argv[1]);
  auto switches = store ? store->switches() : Result<std::vector<importer::LibrarySwitch>>(store.failure());
  if (!switches || switches->empty()) {
    std::fprintf(stderr, "%s\n", switches ? "no switches" : switches.failure().sentence().c_str());
    return 3;
  }
  auto all = std::make_shared<MeasuredSwitches>();
  all->switches = std::move(*switches);
  all->map = importer::feelMapOf(all->switches);
  MeasuredTable table;
  table.setSwitches(all);
  SwitchMap map(table);
  map.resize(700, 500);
  map.setScales({{}, 0}, {{}, 1});
  const int peak = MeasuredTable::firstFigureColumn + static_cast<int>(KeyFigure::peakForce);
  std::printf("rows\t%d\n", table.rowCount());
  tell("filter by words", [&](int round) { table.setFilter({round % 2 == 0 ? "1" : "2", {}, {}}); });
  tell("filter by figures", [&](int round) {
    table.setFilter({{}, {}, {{KeyFigure::peakForce, 0.3 + 0.01 * round, 0.6}}});
  });
  table.setFilter({});
  tell("sort by a figure",
       [&](int round) { table.sort(peak, round % 2 == 0 ? Qt::AscendingOrder : Qt::DescendingOrder); });
  table.sort(-1);
  tell("feels like this",
       [&](int round) { table.rankBy(table.switches()[static_cast<std::size_t>(round)].shape); });
  QTableView view;
  view.setModel(&table);
  view.resize(900, 700);
  tell("scroll by a page", [&](int round) {
    view.scrollTo(table.index(500 * (round + 1) % table.rowCount(), 0), QAbstractItemView::PositionAtTop);
    view.grab();
  });
  tell("draw the map", [&](int) {
    map.redraw();
    map.replot();
    map.grab();
  });
  return 0;
}
