// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/editor/window_tests.h"

#include <cstdio>
#include <map>
#include <QApplication>
#include <QTest>
#include <string>
#include <vector>

#include "editor/importing/batch_import.h"

namespace detent::windowtests {
namespace {

struct Entry {
  MakeWindowTest make;
  PrepareWindowTest prepare;
  bool hasWidgets;
};

std::map<std::string, Entry>& entries() {
  static std::map<std::string, Entry> all;
  return all;
}

}  // namespace

WindowTestEntry::WindowTestEntry(const char* name, MakeWindowTest make, PrepareWindowTest prepare,
                                 bool hasWidgets) {
  entries()[name] = {make, prepare, hasWidgets};
}

}  // namespace detent::windowtests

int main(int argc, char** argv) {
  using namespace detent::windowtests;
  if (argc > 1 && std::string(argv[1]) == detent::editor::batchWorkerOption) {
    const QCoreApplication app(argc, argv);
    return detent::editor::importForBatch(QCoreApplication::arguments().mid(2));
  }
  const auto found = argc > 1 ? entries().find(argv[1]) : entries().end();
  if (found == entries().end()) {
    std::fprintf(stderr, "usage: editor_window_tests CLASS [QTEST-ARGUMENTS...]; the classes are:\n");
    for (const auto& [name, entry] : entries()) std::fprintf(stderr, "  %s\n", name.c_str());
    return 2;
  }
  QCoreApplication::setAttribute(Qt::AA_Use96Dpi, true);  // as QTEST_MAIN does
  const std::unique_ptr<QCoreApplication> app(found->second.hasWidgets ? new QApplication(argc, argv)
                                                                       : new QCoreApplication(argc, argv));
  if (!found->second.prepare()) return 0;
  std::vector<char*> rest{argv[0]};
  rest.insert(rest.end(), argv + 2, argv + argc);
  const std::unique_ptr<QObject> test = found->second.make();
  return QTest::qExec(test.get(), static_cast<int>(rest.size()), rest.data());
}
