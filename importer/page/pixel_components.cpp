// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/page/pixel_components.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace detent::importer {
namespace {

/// The first column from `x` on with a marked pixel; `width` if there is none.
int nextMark(const std::uint8_t* row, int x, int width) {
  constexpr int word = sizeof(std::uint64_t);
  std::uint64_t eight = 0;
  while (x + word <= width && (std::memcpy(&eight, row + x, word), eight == 0)) x += word;
  while (x < width && row[x] == 0) ++x;
  return x;
}

/// Union-find over runs that touch; a set is represented by its first run (Tarjan 1975, with path halving).
class Touching {
 public:
  std::size_t add() {
    first_.push_back(first_.size());
    return first_.size() - 1;
  }
  std::size_t firstOf(std::size_t run) {
    while (first_[run] != run) run = first_[run] = first_[first_[run]];
    return run;
  }
  void join(std::size_t a, std::size_t b) {
    a = firstOf(a), b = firstOf(b);
    first_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> first_;
};

Box runBox(const PixelRun& run) {
  return {static_cast<double>(run.from), static_cast<double>(run.y), static_cast<double>(run.to),
          run.y + 1.0};
}

/// The first run of each component, in the order of the components.
std::vector<std::size_t> piecesInOrder(const std::vector<PixelRun>& runs, Touching& sets) {
  std::vector<std::size_t> order;
  // leftmost pixel of the component's first two rows, by its first run
  std::vector<int> leftmost(runs.size());
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const std::size_t first = sets.firstOf(k);
    if (first == k) order.push_back(k);
    if (first == k || (runs[k].y / 2 == runs[first].y / 2 && runs[k].from < leftmost[first]))
      leftmost[first] = runs[k].from;
  }
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(runs[a].y / 2, leftmost[a]) < std::pair(runs[b].y / 2, leftmost[b]);
  });
  return order;
}

}  // namespace

PixelComponents pixelComponentsOf(const std::uint8_t* mask, int width, int height, std::size_t stride) {
  PixelComponents found;
  Touching sets;
  std::vector<int> openAbove;  // per run: number of pixels whose upper neighbour is unmarked
  std::size_t above = 0;       // first run of the row above that may still touch a later run
  for (int y = 0; y < height; ++y) {
    const std::uint8_t* row = mask + static_cast<std::size_t>(y) * stride;
    const std::size_t rowStart = found.runs.size();
    for (int x = nextMark(row, 0, width); x < width; x = nextMark(row, x, width)) {
      const void* end = std::memchr(row + x, 0, static_cast<std::size_t>(width - x));
      const int to = end ? static_cast<int>(static_cast<const std::uint8_t*>(end) - row) : width;
      const std::size_t run = sets.add();
      found.runs.push_back({y, x, to, 0});
      openAbove.push_back(to - x);
      while (above < rowStart && (found.runs[above].y < y - 1 || found.runs[above].to < x)) ++above;
      for (std::size_t k = above; k < rowStart && found.runs[k].from <= to; ++k) {
        sets.join(run, k);
        openAbove.back() -= std::max(0, std::min(to, found.runs[k].to) - std::max(x, found.runs[k].from));
      }
      x = to;
    }
  }
  const std::vector<std::size_t> order = piecesInOrder(found.runs, sets);
  found.all.resize(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const PixelRun& run = found.runs[order[i]];
    found.runs[order[i]].piece = i;
    found.all[i].box = runBox(run);
  }
  for (std::size_t k = 0; k < found.runs.size(); ++k) {
    PixelRun& run = found.runs[k];
    run.piece = found.runs[sets.firstOf(k)].piece;
    PixelComponent& piece = found.all[run.piece];
    piece.box = piece.box.joined(runBox(run));
    piece.area_px += run.to - run.from;
    piece.runsAcross += 1;
    piece.runsDown += openAbove[k];
  }
  return found;
}

}  // namespace detent::importer
