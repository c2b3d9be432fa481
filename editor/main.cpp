// SPDX-License-Identifier: GPL-3.0-or-later
// detent-edit: shape a button by hand, see it, feel it.

#include <clocale>
#include <cstdio>
#include <exception>
#include <QApplication>
#include <QDir>
#include <QLibraryInfo>
#include <QStandardPaths>
#include <QTimer>

#include "editor/document/large_blocks.h"
#include "editor/importing/batch_import.h"
#include "editor/window/appearance.h"
#include "editor/window/arguments.h"
#include "editor/window/main_window.h"
#include "editor/window/stored_view.h"
#include "editor/window/translation.h"
#include "model/result.h"
#include "model/version.h"

namespace {

using namespace detent;
using namespace detent::editor;

int wrong(const QString& sentence, FailureCode code) {
  std::fprintf(stderr, "%s\n", qPrintable(sentence));
  return static_cast<int>(code);
}

// Answers options such as --help before a window system is needed.
std::optional<int> answeredAtOnce(const Arguments& arguments) {
  if (arguments.help) return std::fputs(qPrintable(helpText()), stdout), 0;
  if (arguments.version) return std::printf("detent-edit %s\n", version()), 0;
  if (!arguments.wrongUsage.isEmpty()) return wrong(arguments.wrongUsage, FailureCode::wrongUsage);
  return {};
}

// Returns true if there is no screen. Qt would then abort, as in a crash.
bool screenMissing(const QStringList& words) {
  const bool windowsByServer =
#if defined(Q_OS_UNIX) && !defined(Q_OS_MACOS)
      true;
#else
      false;
#endif
  for (const char* variable : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
    if (!qEnvironmentVariableIsEmpty(variable)) return false;
  return windowsByServer && words.filter("-platform").isEmpty() && !words.contains("-display");
}

void setUp(QCoreApplication& app, const QSettings& settings) {
  QLocale::setDefault(chosenLocale(settings));
  installTranslation(app, QLocale());
}

int run(QApplication& app) {
  const Arguments arguments = argumentsFrom(QCoreApplication::arguments().mid(1));  // without Qt's own
  QSettings settings;
  setUp(app, settings);
  ViewSettings view;
  restoreView(view, settings);
  Prompts prompts;
  RecoveryStore recovery(
      QDir(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation)).filePath("recovery"));
  MainWindow window({view, settings, prompts, recovery});
  window.show();
  QTimer::singleShot(0, &window, [&] {
    if (arguments.files.isEmpty()) window.restoreSession();
    window.files().offerRecovery();
    window.files().open(arguments.files);
  });
  return QApplication::exec();
}

}  // namespace

int main(int argc, char** argv) {
  giveLargeBlocksBack();
  QStringList words;
  for (int i = 1; i < argc; ++i) words << QString::fromLocal8Bit(argv[i]);
  QCoreApplication::setOrganizationName("Detent");
  QCoreApplication::setApplicationName("detent-edit");
  QCoreApplication::setApplicationVersion(version());
  try {
    if (words.value(0) == batchWorkerOption) {
      QCoreApplication app(argc, argv);
      setUp(app, QSettings());
      return importForBatch(words.mid(1));
    }
    if (const auto answered = answeredAtOnce(argumentsFrom(words))) return *answered;
    if (screenMissing(words))
      return wrong(
          "detent-edit: there is no screen to open a window on. Start it on a desktop, or set DISPLAY.",
          FailureCode::deviceTrouble);
    QGuiApplication::setHighDpiScaleFactorRoundingPolicy(Qt::HighDpiScaleFactorRoundingPolicy::PassThrough);
    QApplication::setStyle(outlinedStyle());
    QApplication app(argc, argv);
    // Qt has applied the desktop's locale to the C library too. Files and drawings use a decimal point; texts
    // for the user go through QLocale.
    std::setlocale(LC_NUMERIC, "C");
    QGuiApplication::setDesktopFileName("detent-edit");
    return run(app);
  } catch (const std::exception& fault) {
    std::fprintf(
        stderr,
        "detent-edit: internal fault: %s. Please report it; unsaved work is offered at the next start.\n",
        fault.what());
    return static_cast<int>(FailureCode::internalFault);
  }
}
