// SPDX-License-Identifier: GPL-3.0-or-later
// QTest classes of one program, each run by its name: editor_window_tests CLASS [QTEST-ARGUMENTS...].
#pragma once

#include <memory>
#include <QObject>

namespace detent::windowtests {

using MakeWindowTest = std::unique_ptr<QObject> (*)();
using PrepareWindowTest = bool (*)();

/// Registers a test class under its name. `prepare` runs once the application exists and before the class is
/// made; where it returns false, the class is skipped. Without widgets, the application is a
/// QCoreApplication.
struct WindowTestEntry {
  WindowTestEntry(
      const char* name, MakeWindowTest make, PrepareWindowTest prepare = [] { return true; },
      bool hasWidgets = true);
};

template <typename Test>
std::unique_ptr<QObject> makeWindowTest() {
  return std::make_unique<Test>();
}

}  // namespace detent::windowtests

/// DETENT_WINDOW_TEST(Class) or DETENT_WINDOW_TEST(Class, prepare), in place of QTEST_MAIN.
#define DETENT_WINDOW_TEST(Class, ...)                              \
  static const detent::windowtests::WindowTestEntry entryOf##Class( \
      #Class, detent::windowtests::makeWindowTest<Class> __VA_OPT__(, ) __VA_ARGS__);

/// In place of QTEST_GUILESS_MAIN.
#define DETENT_GUILESS_TEST(Class)                                  \
  static const detent::windowtests::WindowTestEntry entryOf##Class( \
      #Class, detent::windowtests::makeWindowTest<Class>, [] { return true; }, false);
