// SPDX-License-Identifier: GPL-3.0-or-later
// What the library takes to read a file, without Python: read_bench FILE COUNT prints the median of the
// processor time in ms. For tests/bench/python_module.py.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "importer/importer.h"

int main(int argc, char** argv) {
  using namespace detent::importer;
  const int count = argc == 3 ? std::atoi(argv[2]) : 0;
  if (count < 1) {
    std::fprintf(stderr, "read_bench FILE COUNT\n");
    return 2;
  }
  std::vector<double> took_ms;
  for (int i = 0; i < count; ++i) {
    const std::clock_t begun = std::clock();
    ImportRequest request;
    request.path = argv[1];
    auto session = ImportSession::open(request.path, request.limits);
    const bool read = session && session->attempt(request, {}).report;
    if (!read) return 3;
    took_ms.push_back(1000.0 * static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC);
  }
  std::nth_element(took_ms.begin(), took_ms.begin() + count / 2, took_ms.end());
  std::printf("%.4f\n", took_ms[static_cast<std::size_t>(count / 2)]);
  return 0;
}
