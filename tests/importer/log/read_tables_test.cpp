// SPDX-License-Identifier: GPL-3.0-or-later
// Layouts of tables that instruments, programs and people write, each of one known button.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>

#include <catch2/catch.hpp>

#include "importer/log/force_log.h"
#include "tests/importer/log/written_sheet.h"

using namespace detent;
using namespace detent::importer;

namespace {

class LayoutFile {
 public:
  explicit LayoutFile(const std::string& content, const std::string& name = "log.txt")
      : path_(std::filesystem::temp_directory_path() /
              ("detent_layout_test_" + std::to_string(++count_) + "_" + name)) {
    std::ofstream(path_, std::ios::binary) << content;
  }
  ~LayoutFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  std::string path() const { return path_.string(); }

 private:
  static inline int count_ = 0;
  std::filesystem::path path_;
};

constexpr double travel_mm = 4;

/// A tactile button of 4 mm: rises, falls, bottoms out at 1.6 N.
double buttonForce_N(double x, bool press) {
  const double bump = 0.35 * std::exp(-std::pow((x - 1.1) / 0.4, 2));
  const double bottom = x > 3.6 ? 2.2 * (x - 3.6) : 0;
  const double loss = press ? 0 : 0.12 * std::min(1.0, std::min(x, travel_mm - x));
  return 0.18 * x + bump + bottom - loss;
}

/// Rows of press and release, each made by `row` of its place, force and number.
std::string rowsOf(const std::function<std::string(double x, double f, int row)>& row, bool release = true) {
  constexpr int steps = 160;
  std::string text;
  int number = 0;
  for (int i = 0; i <= steps; ++i)
    text += row(travel_mm * i / steps, buttonForce_N(travel_mm * i / steps, true), number++);
  for (int i = steps - 1; i >= 0 && release; --i)
    text += row(travel_mm * i / steps, buttonForce_N(travel_mm * i / steps, false), number++);
  return text;
}

std::string formatted(const char* form, auto... values) {
  char text[200];
  std::snprintf(text, sizeof text, form, values...);
  return text;
}

void checkButton(const ForceLog& log, bool release = true, double within_N = 0.012) {
  for (const CurvePoint& p : log.strokes.press.points)
    REQUIRE(p.force_N == Approx(buttonForce_N(p.displacement_mm, true)).margin(within_N));
  CHECK(log.strokes.press.points.back().displacement_mm == Approx(travel_mm).margin(0.05));
  REQUIRE(log.strokes.release.has_value() == release);
  if (release)
    for (const CurvePoint& p : log.strokes.release->points)
      REQUIRE(p.force_N == Approx(buttonForce_N(p.displacement_mm, false)).margin(within_N));
}

}  // namespace

TEST_CASE("the columns of a button are found among others") {
  struct Layout {
    const char* name;
    std::string text;
    bool release = true;
  };
  const auto decimalComma = [](std::string text) {
    for (char& c : text)
      if (c == '.') c = ',';
    return text;
  };
  const std::vector<Layout> layouts = {
      {"strain, stress, speed and energy before them",
       "Time (s),Compressive strain (mm/mm),Stress (N/mm²),Speed (mm/s),Energy (N·mm),Extension (mm),Load "
       "(N)\n" +
           rowsOf([](double x, double f, int n) {
             return formatted("%.2f,%.4f,%.4f,%.3f,%.4f,%.4f,%.4f\n", 0.05 * n, x / 12, f / 78, 0.5,
                              x * f / 2, x, f);
           })},
      {"units in a line of their own, results above",
       "\"Maximum "
       "Load\";\"Travel\"\n\"(N)\";\"(mm)\"\n\"1,6\";\"4,0\"\n\"1,5\";\"3,9\"\n\n\"Time\";\"Load\";"
       "\"Extension\"\n\"(s)\";\"(N)\";\"(mm)\"\n" +
           rowsOf([&](double x, double f, int n) {
             return decimalComma(formatted("\"%.2f\";\"%.4f\";\"%.4f\"\n", 0.05 * n, f, x));
           })},
      {"units behind every number, force first, no heading",
       rowsOf([](double x, double f, int) { return formatted("%.4f N,%.4f mm\n", f, x); })},
      {"units in columns beside, dates before", rowsOf([](double x, double f, int n) {
         return formatted("2026/01/02,10:20:%02d.%03d,%.4f,N,%.4f,mm\n", n / 20, n % 20 * 50, f, x);
       })},
      {"line breaks in titles",
       "\"Time\n(s)\",\"Force\n(N)\",\"Travel\n(mm)\"\n" +
           rowsOf([](double x, double f, int n) { return formatted("%.2f,%.4f,%.4f\n", 0.05 * n, f, x); })},
      {"a factor in the unit", "Travel (mm),Force (x0.1 N)\n" + rowsOf([](double x, double f, int) {
                                 return formatted("%.4f,%.3f\n", x, 10 * f);
                               })},
      {"decanewton", "Travel (mm),Load (daN)\n" +
                         rowsOf([](double x, double f, int) { return formatted("%.4f,%.5f\n", x, f / 10); })},
      {"steps with their size above",
       "# steps_per_mm = 800\n# counts_per_newton = 25000\nsteps,counts\n" +
           rowsOf([](double x, double f, int) { return formatted("%.0f,%.0f\n", x * 800, f * 25000); })},
      {"units named above",
       "Force unit: cN\nDisplacement unit: µm\n\nDisplacement,Force\n" +
           rowsOf([](double x, double f, int) { return formatted("%.0f,%.2f\n", x * 1000, f * 100); })},
      {"raw counts and grams", "ms steps pos_mm raw grams\n" + rowsOf([](double x, double f, int n) {
                                 return formatted("%d %.0f %.4f %.0f %.3f\n", 40 * n, x * 400, x,
                                                  84000 + 40000 * f, f / 0.00980665);
                               })},
      {"load cells and their total",
       "Time (s),Travel (mm),Cell 1 (N),Cell 2 (N),Total force (N)\n" + rowsOf([](double x, double f, int n) {
         return formatted("%.2f,%.4f,%.5f,%.5f,%.5f\n", 0.05 * n, x, 0.6 * f, 0.4 * f, f);
       })},
      {"both systems of units",
       "Travel (mm),Travel (in),Force (N),Force (lbf)\n" + rowsOf([](double x, double f, int) {
         return formatted("%.4f,%.6f,%.4f,%.6f\n", x, x / 25.4, f, f / 4.4482216);
       })},
      {"an axis that stands still", "X (mm),Y (mm),Z (mm),Fz (N)\n" + rowsOf([](double x, double f, int n) {
                                      return formatted("%.4f,%.4f,%.4f,%.4f\n", 12.5 + 0.001 * (n % 3), 40.0,
                                                       x, f);
                                    })},
      {"words of direction", "Direction,Position (mm),Force (N)\n" + rowsOf([](double x, double f, int n) {
                               return formatted("%s,%.4f,%.4f\n", n <= 160 ? "Forward" : "Reverse", x, f);
                             })},
      {"a stage that counts down from afar", "Height (mm),Force (N)\n" + rowsOf([](double x, double f, int) {
                                               return formatted("%.4f,%.4f\n", 52.4 - x, f);
                                             })},
      {"a stage's place", "Position (mm),Force (N)\n" + rowsOf([](double x, double f, int) {
                            return formatted("%.4f,%.4f\n", 52.4 + x, f);
                          })},
      {"peak hold",
       "Travel (mm),Force (N),Peak (N)\n" +
           [] {
             double most = 0;
             return rowsOf(
                 [&](double x, double f, int) {
                   return most = std::max(most, f), formatted("%.4f,%.4f,%.4f\n", x, f, most);
                 },
                 false);
           }(),
       false},
      {"bounds around a mean",
       "Travel (mm),Press min (N),Press mean (N),Press max (N)\n" +
           rowsOf([](double x, double f,
                     int) { return formatted("%.4f,%.4f,%.4f,%.4f\n", x, 0.9 * f, f, 1.1 * f); },
                  false),
       false},
      {"Maximum and Mean below",
       "Travel (mm),Force (N)\n" +
           rowsOf([](double x, double f, int) { return formatted("%.4f,%.4f\n", x, f); }, false) +
           "Max,1.6\nMean,0.6\nMin,0\n",
       false},
  };
  for (const Layout& layout : layouts) {
    CAPTURE(layout.name);
    const LayoutFile file(layout.text);
    const auto log = readForceLog(file.path());
    if (!log) FAIL(log.failure().sentence());
    CHECK(log->confidence > 0.9);
    checkButton(*log, layout.release);
  }
}

TEST_CASE("a line above a table is its title, with however many delimiters behind it") {
  const auto rows = [](bool press, const char* form, double first, double second, bool forceFirst,
                       int steps = 160) {
    std::string text;
    for (int i = 0; i <= steps; ++i) {
      const double x = press ? travel_mm * i / steps : travel_mm * (steps - i) / steps;
      const double f = buttonForce_N(x, press);
      text += formatted(form, first * (forceFirst ? f : x), second * (forceFirst ? x : f));
    }
    return text;
  };
  const std::string press = rows(true, "%.4f;%.4f\n", 1, 1, false),
                    release = rows(false, "%.4f;%.4f\n", 1, 1, false);
  const std::string titles = "Travel (mm);Force (N)\n";
  for (const std::string& text : {
           "Press\n" + titles + press + "\nRelease\n" + titles + release,
           "Press;\n" + titles + press + ";\nRelease;\n" + titles + release,
           "Essai 4;;;\nAller;;;\nCourse (mm);Effort (N);;\n" + press +
               ";;;\nRetour;;;\nCourse (mm);Effort (N);;\n" + release,
           "Belastung;\nWeg;Kraft\nmm;N\n" + press + "Entlastung;\nWeg;Kraft\nmm;N\n" + release,
           "Press;\n" + titles + press + ";\nRelease;\nForce (N);Travel (mm)\n" +
               rows(false, "%.4f;%.4f\n", 1, 1, true),
           "Press;\n" + titles + press + ";\nRelease;\nForce (mN);Travel (um)\n" +
               rows(false, "%.2f;%.1f\n", 1000, 1000, true),
           "Press;\nForce (cN);Travel (mm)\n" + rows(true, "%.2f;%.4f\n", 100, 1, true, 100) +
               ";\nRelease;\n" + titles + release,
       }) {
    CAPTURE(text.substr(0, 60), text.substr(text.size() - 60));
    const LayoutFile file(text);
    const auto log = readForceLog(file.path());
    if (!log) FAIL(log.failure().sentence());
    CHECK(log->confidence > 0.9);
    checkButton(*log);
  }
}

TEST_CASE("strokes in columns of their own are recognised by their names") {
  const auto beside = [](const char* header, const char* form, bool swapped) {
    std::string text = header;
    constexpr int steps = 160;
    for (int i = 0; i <= steps; ++i) {
      const double x = travel_mm * i / steps, y = travel_mm - x;
      text += swapped ? formatted(form, y, buttonForce_N(y, false), x, buttonForce_N(x, true))
                      : formatted(form, x, buttonForce_N(x, true), y, buttonForce_N(y, false));
    }
    return text;
  };
  const char* form = "%.4f,%.5f,%.4f,%.5f\n";
  for (const std::string& text :
       {beside("Press,,Release,\nX (mm),Y (N),X (mm),Y (N)\n", form, false),
        beside("Release,,Press,\nDisplacement (mm),Force (N),Displacement (mm),Force (N)\n", form, true),
        beside(
            "Loading displacement (mm),Loading force (N),Unloading displacement (mm),Unloading force (N)\n",
            form, false)}) {
    CAPTURE(text.substr(0, 90));
    const LayoutFile file(text);
    const auto log = readForceLog(file.path());
    if (!log) FAIL(log.failure().sentence());
    checkButton(*log);
  }
}

TEST_CASE("remarks beside a table leave its titles and units in force") {
  const auto rows = [](const char* remark) {
    return rowsOf([&](double x, double f, int n) {
      return formatted("%.4f;%.5f%s\n", x, f / 0.278013851, n < 3 ? remark : "");
    });
  };
  for (const std::string& text : {
           "Travel [mm];Force [ozf];;k = 0.12 N/mm\n;;;Fmax;2.1\n" + rows(""),
           "Travel [mm];Force [ozf];;k = 0.12 N/mm\n;;;Fmax;2.1\n" + rows(";;F1;2.1"),
           "Travel [mm];Force [ozf]\n;;;Fmax (N);2.1\n;;;checked\n" + rows(""),
           "Travel;Force\n;;;Fmax;2.1\nmm;ozf;;;\n" + rows(""),
           "Travel (mm);Force (ozf);;Operator\n;;;;\n;;;Fmax;2.1\n" + rows(""),
           "Travel;Force\nmm;ozf\n;;;Fmax;2.1\n" + rows(";;;3.4"),
       }) {
    CAPTURE(text.substr(0, 70));
    const LayoutFile file(text);
    const auto log = readForceLog(file.path());
    if (!log) FAIL(log.failure().sentence());
    CHECK(log->xUnit == "mm");
    CHECK(log->yUnit == "ozf");
    checkButton(*log);
  }
}

TEST_CASE("tables that are no force log are refused for what they are") {
  struct Refused {
    const char* header;
    const char* said;
  };
  for (const Refused& each : {Refused{"time_s,temperature_C", "no column holds"},
                              Refused{"Strain (%),Stress (MPa)", "no column holds"},
                              Refused{"Angle (deg),Torque (N·mm)", "no column holds"},
                              Refused{"Capacity (Ah),Voltage (V)", "no column holds"},
                              Refused{"Time (s),Force (N)", "no column holds displacements"},
                              Refused{"Time (s),Position (mm)", "no column holds forces"},
                              Refused{"Frequency (Hz),Gain (dB)", "no column holds"},
                              Refused{"Travel (mm),Samples [N]", "no column holds forces"},
                              Refused{"Travel (mm),Shock [g]", "no column holds forces"},
                              Refused{"Travel (mm),Force (N m)", "no column holds forces"},
                              Refused{"Travel (mm),Impulse (N s)", "no column holds forces"},
                              Refused{"Wear (mm),Force (N)", "no column holds displacements"},
                              Refused{"Turns,Force (N)", "no column holds displacements"},
                              Refused{"x (mm),y (mm),z (mm)", "no column holds forces"}}) {
    CAPTURE(each.header);
    const std::string header = each.header;
    const bool three = std::count(header.begin(), header.end(), ',') == 2;
    const LayoutFile file(header + "\n" + rowsOf([&](double x, double f, int) {
                            return three ? formatted("%.4f,%.4f,%.4f\n", x, f, 2 * x)
                                         : formatted("%.4f,%.4f\n", x, f);
                          }));
    const auto log = readForceLog(file.path());
    REQUIRE_FALSE(log);
    CHECK(log.failure().code == FailureCode::noForceGraph);
    CHECK(log.failure().sentence().find(each.said) != std::string::npos);
    CHECK(log.failure().sentence().find("--x-unit") == std::string::npos);
  }
}

TEST_CASE("key lines above a table give the units of X and Y") {
  const auto rows = [](double mm, double newton, bool forceFirst) {
    return rowsOf([=](double x, double f, int) {
      return formatted("%.5f;%.5f\n", forceFirst ? f * newton : x * mm, forceFirst ? x * mm : f * newton);
    });
  };
  for (const std::string& text : {
           "X-Kanal;Weg\nX-Einheit;mm\nY-Kanal;Kraft\nY-Einheit;cN\n\nX;Y\n" + rows(1, 100, false),
           "X-Unit: um\nY-Unit: cN\n\nX;Y\n" + rows(1000, 100, false),
           "X unit = mm\nY unit = cN\n\nTravel;Force\n" + rows(1, 100, false),
           "Y-Einheit;cN\nX-Einheit;mm\n\nY;X\n" + rows(1, 100, true),
           "X-Einheit;mm\nY-Einheit;cN\n\nKraft;Weg\n" + rows(1, 100, true),
       }) {
    CAPTURE(text.substr(0, 70));
    const LayoutFile file(text);
    const auto log = readForceLog(file.path());
    if (!log) FAIL(log.failure().sentence());
    CHECK(log->yUnit == "cN");
    checkButton(*log);
  }
}

TEST_CASE("a unit that is not known is a question, never newton") {
  const LayoutFile file("Travel (mm),Force (furl)\n" +
                        rowsOf([](double x, double f, int) { return formatted("%.4f,%.4f\n", x, f); }));
  const LogReading reading = readLog(file.path());
  REQUIRE_FALSE(reading.log);
  CHECK(reading.log.failure().code == FailureCode::notCertain);
  REQUIRE(reading.question);
  CHECK(reading.question->choices.front().option == "--y-unit N");
  LogHints newton;
  newton.yUnit = ForceUnit::newton;
  const auto log = readForceLog(file.path(), newton);
  REQUIRE(log);
  checkButton(*log);
}

TEST_CASE("titles that speak for neither a displacement nor a force are refused") {
  const auto rows = [](const char* form) {
    return rowsOf([&](double x, double f, int) { return formatted(form, x, f, 0.5 * f); });
  };
  for (const std::string& text :
       {"Foo,Bar\n" + rows("%.4f,%.4f\n"), "std,average,more\n" + rows("%.4f,%.4f,%.4f\n"),
        "raw,average,std,stdstd\n" + rows("%.4f,%.4f,%.4f\n")}) {
    CAPTURE(text.substr(0, 30));
    const LayoutFile file(text);
    const auto log = readForceLog(file.path());
    REQUIRE_FALSE(log);
    CHECK(log.failure().code == FailureCode::noForceGraph);
    CHECK(log.failure().sentence().find("no column holds displacements") != std::string::npos);
  }
}

TEST_CASE("a column whose name no list knows is a question, whatever its unit") {
  struct Case {
    const char *header, *option;
  };
  for (const Case& c : {Case{"Travel (mm),Fluffiness (N)", "--force-column 2"},
                        Case{"Travel (mm),Fluffiness", "--force-column 2"},
                        Case{"Teeth,Force (N)", "--displacement-column 1"},
                        Case{"Foo (mm),Bar (N)", "--displacement-column 1 --force-column 2"}}) {
    CAPTURE(c.header);
    const LayoutFile file(std::string(c.header) + "\n" +
                          rowsOf([](double x, double f, int) { return formatted("%.4f,%.4f\n", x, f); }));
    const LogReading reading = readLog(file.path());
    REQUIRE_FALSE(reading.log);
    CHECK(reading.log.failure().code == FailureCode::notCertain);
    REQUIRE(reading.question);
    REQUIRE(reading.question->choices.size() == 1);
    CHECK(reading.question->choices.front().option == c.option);
    LogHints answer;
    answer.columns.displacement = "1", answer.columns.force = "2";
    const auto log = readForceLog(file.path(), answer);
    REQUIRE(log);
    checkButton(*log);
  }
  for (const char* header :
       {"Travel (mm),CH1 (N)", "s (mm),Total (N)", "X1 (mm),Y1 (N)", "Kanal 1 (mm),Kanal 2 (N)"}) {
    CAPTURE(header);
    const LayoutFile file(std::string(header) + "\n" +
                          rowsOf([](double x, double f, int) { return formatted("%.4f,%.4f\n", x, f); }));
    const auto log = readForceLog(file.path());
    if (!log) FAIL(log.failure().sentence());
    checkButton(*log);
  }
}

TEST_CASE("the force as the sensor gave it goes before its filtered copy") {
  for (const char* header : {"pos_mm,force_raw_N,force_filtered_N", "pos_mm,raw force (N),smoothed force (N)",
                             "Travel (mm),Force unfiltered (N),Force filtered (N)"}) {
    CAPTURE(header);
    double filtered = 0;
    const LayoutFile file(std::string(header) + "\n" + rowsOf([&](double x, double f, int) {
                            filtered += 0.1 * (f - filtered);
                            return formatted("%.4f,%.4f,%.4f\n", x, f, filtered);
                          }));
    const auto log = readForceLog(file.path());
    if (!log) FAIL(log.failure().sentence());
    checkButton(*log);
  }
}

TEST_CASE("a number of the row is no force, though its title is N") {
  const LayoutFile file("N,x (mm),F (N)\n" + rowsOf([](double x, double f, int row) {
                          return formatted("%d,%.4f,%.5f\n", row + 1, x, f);
                        }));
  const auto log = readForceLog(file.path());
  if (!log) FAIL(log.failure().sentence());
  checkButton(*log);
}

TEST_CASE("a line that says what a volt measures scales the column") {
  const LayoutFile file(
      "Vertical Units,V,V\nNote,CH1 laser 1 V = 2 mm,CH2 load cell 1 V = 0.5 N\nSecond,CH1,CH2\n" +
      rowsOf([](double x, double f, int row) {
        return formatted("%.3f,%.5f,%.5f\n", 0.02 * row, x / 2, f / 0.5);
      }));
  const auto log = readForceLog(file.path());
  if (!log) FAIL(log.failure().sentence());
  checkButton(*log);
}

TEST_CASE("titles stand one cell to the left where rows have names, as R writes them") {
  const auto rows = [](const char* form, bool time) {
    return rowsOf([&](double x, double f, int n) {
      return time ? formatted(form, n + 1, 0.05 * n, x, f, n <= 160 ? "press" : "release")
                  : formatted(form, n + 1, x, f, n <= 160 ? "press" : "release");
    });
  };
  for (const std::string& text : {
           "\"travel.mm\" \"force.N\" \"stroke\"\n" + rows("\"%d\" %.5f %.5f \"%s\"\n", false),
           "\"time.s\" \"travel.mm\" \"force.N\" \"stroke\"\n" + rows("\"%d\" %.2f %.5f %.5f \"%s\"\n", true),
           "\"Travel (mm)\" \"Force (N)\" \"stroke\"\n" + rows("\"%d\" %.5f %.5f \"%s\"\n", false),
           "travel_mm,force_N,stroke\n" + rows("%d,%.5f,%.5f,%s\n", false),
           "row,travel_mm,force_N,stroke\n" + rows("%d,%.5f,%.5f,%s\n", false),
           "Reading,travel_mm,force_N\n" + rows("%d,%.5f,%.5f,%s\n", false),
           "No,travel_mm,force_N\n" + rows("%d,%.5f,%.5f,%s\n", false),
       }) {
    CAPTURE(text.substr(0, 70));
    const LayoutFile file(text);
    const auto log = readForceLog(file.path());
    if (!log) FAIL(log.failure().sentence());
    CHECK(log->confidence > 0.9);
    checkButton(*log);
  }
}

TEST_CASE("titles stand one cell to the right behind a comment sign, as NumPy writes them") {
  for (const char* header : {"# displacement_mm force_N\n", "# displacement force\n"}) {
    CAPTURE(header);
    const LayoutFile file(header +
                          rowsOf([](double x, double f, int) { return formatted("%.4f %.4f\n", x, f); }));
    const auto log = readForceLog(file.path());
    REQUIRE(log);
    checkButton(*log);
  }
}

TEST_CASE("a release that stands above its press, both named, is the release") {
  const auto row = [](double x, double f, int) { return formatted("%.4f;%.4f\n", x, f); };
  const std::string press = rowsOf(row, false);
  std::string release;
  for (int i = 0; i <= 160; ++i)
    release += row(travel_mm * i / 160, buttonForce_N(travel_mm * i / 160, i == 160), i);
  const LayoutFile file("Release\nTravel (mm);Force (N)\n" + release + "\nPress\nTravel (mm);Force (N)\n" +
                        press);
  const auto log = readForceLog(file.path());
  REQUIRE(log);
  checkButton(*log);
}

TEST_CASE("a unit given by hand settles a column whose title and unit contradict each other") {
  const LayoutFile file("Travel (mm),Force (s)\n" +
                        rowsOf([](double x, double f, int) { return formatted("%.4f,%.4f\n", x, f); }));
  CHECK_FALSE(readForceLog(file.path()));
  LogHints newton;
  newton.yUnit = ForceUnit::newton;
  const auto log = readForceLog(file.path(), newton);
  REQUIRE(log);
  checkButton(*log);
  CHECK(
      std::ranges::any_of(log->remarks, [](const Remark& each) { return each.code == RemarkCode::doubted; }));
}

TEST_CASE("the more a table says, the surer its reading is") {
  const auto rows = rowsOf([](double x, double f, int) { return formatted("%.4f,%.4f\n", x, f); });
  double before = 0;
  for (const char* header :
       {"", "Position,Value\n", "Travel,Force\n", "Travel (mm),Force\n", "Travel (mm),Force (N)\n"}) {
    CAPTURE(header);
    const LayoutFile file(header + rows);
    const auto log = readForceLog(file.path());
    REQUIRE(log);
    CHECK(log->confidence > before);
    CHECK(log->confidence < 1);
    before = log->confidence;
  }
  CHECK(before > 0.99);
}

TEST_CASE("files that differ in the word of a stroke are pairs") {
  const auto pairs =
      pairedFiles({"a/Red.downstroke.csv", "a/Red.upstroke.csv", "a/Blue press.csv", "a/Blue release.csv",
                   "b/Red.upstroke.csv", "a/Green.csv", "a/Gold.downstroke.csv"});
  CHECK(pairs == std::map<std::string, std::string>{{"a/Red.downstroke.csv", "a/Red.upstroke.csv"},
                                                    {"a/Blue press.csv", "a/Blue release.csv"}});
  CHECK(withoutStrokeWord("a/Red.upstroke.csv") == "a/Red.csv");
  CHECK(withoutStrokeWord("a/Green.csv") == "a/Green.csv");
}

TEST_CASE("an approach through air is cut off and said, and the offset of the gauge with it") {
  std::string text = "Travel (mm),Force (N)\n";
  for (int i = 0; i < 60; ++i) text += formatted("%.4f,%.4f\n", 0.02 * i, 0.02 + (i % 2 ? 0.001 : -0.001));
  text += rowsOf([](double x, double f, int) { return formatted("%.4f,%.4f\n", 1.2 + x, 0.02 + f); });
  const LayoutFile file(text);
  const auto log = readForceLog(file.path());
  REQUIRE(log);
  CHECK(log->preload_N == Approx(0.02).margin(0.002));
  checkButton(*log, true, 0.05);  // contact is certain to a few hundredths of a millimetre
}

TEST_CASE("a press that was taken back half way and resumed begins where it began") {
  std::string text = "Travel (mm),Force (N)\n";
  const auto move = [&](double from, double to, bool press) {
    for (int i = 0; i < 60; ++i) {
      const double x = from + (to - from) * i / 60;
      text += formatted("%.4f,%.4f\n", x, buttonForce_N(x, press));
    }
  };
  move(0, 1.5, true), move(1.5, 0.6, false), move(0.6, 4, true), move(4, -0.0, false);
  text += "0.0000,0.0000\n";
  const LayoutFile file(text);
  const auto log = readForceLog(file.path());
  REQUIRE(log);
  CHECK(log->strokes.press.points.front().displacement_mm == 0);
  CHECK(log->strokes.press.points.back().displacement_mm == Approx(4).margin(0.08));
}

TEST_CASE("presses one after the other are records: the way back between them is no release") {
  std::string text = "Travel (mm),Force (N)\n";
  for (const double scale : {1.0, 1.2, 1.4})
    text += rowsOf([&](double x, double f, int) { return formatted("%.4f,%.4f\n", x, scale * f); }, false);
  const LayoutFile file(text);
  const LogReading open = readLog(file.path());
  REQUIRE_FALSE(open.log);
  CHECK(open.records.size() == 3);
  LogHints second;
  second.curve = "2";
  const auto log = readForceLog(file.path(), second);
  REQUIRE(log);
  CHECK_FALSE(log->strokes.release);
  CHECK(log->strokes.press.points.back().force_N == Approx(1.2 * buttonForce_N(4, true)).margin(0.001));
}

TEST_CASE("columns titled by conditions or specimens are records, never the first in silence") {
  struct Titles {
    const char* header;
    const char* first;
    const char* second;
    double newton = 1;  // in one unit of the table
  };
  for (const Titles& each : {Titles{"Weg (mm);-40 °C (N);85 °C (N)", "-40 °C", "85 °C"},
                             Titles{"Travel (mm);0 cycles (N);1M cycles (N)", "0 cycles", "1M cycles"},
                             Titles{"Travel (mm);after 10 cycles (N);after 5000 cycles (N)",
                                    "after 10 cycles", "after 5000 cycles"},
                             Titles{"Travel (mm);Switch A;Switch B", "Switch A", "Switch B", 0.00980665},
                             Titles{"Travel (mm);0.1 mm/s [N];10 mm/s [N]", "0.1 mm/s", "10 mm/s"},
                             Titles{"Weg (mm);Probe 1 (N);Probe 2 (N)", "Probe 1", "Probe 2"},
                             Titles{"Travel;-40 °C;85 °C\nmm;N;N", "-40 °C", "85 °C"}}) {
    CAPTURE(each.header);
    const LayoutFile file(
        std::string(each.header) + "\n" +
        rowsOf([&](double x, double f,
                   int) { return formatted("%.4f;%.5f;%.5f\n", x, f / each.newton, 1.4 * f / each.newton); },
               false));
    const LogReading open = readLog(file.path());
    REQUIRE_FALSE(open.log);
    CHECK(open.log.failure().code == FailureCode::notCertain);
    REQUIRE(open.records.size() == 2);
    CHECK(open.records[0].name == each.first);
    CHECK(open.records[1].name == each.second);
    REQUIRE(open.question);
    LogHints second;
    second.curve = each.second;
    const auto log = readForceLog(file.path(), second);
    REQUIRE(log);
    CHECK_FALSE(log->strokes.release);
    CHECK(log->strokes.press.points.back().force_N == Approx(1.4 * buttonForce_N(4, true)).margin(0.001));
    if (each.newton == 1) CHECK(log->confidence > 0.9);  // which of the columns is meant was answered
  }
}

TEST_CASE("a name that several records have chooses none of them") {
  const LayoutFile file(
      "Travel (mm);Probe 1 (N);Probe 1 (N)\n" +
      rowsOf([](double x, double f, int) { return formatted("%.4f;%.5f;%.5f\n", x, f, 1.4 * f); }, false));
  LogHints hints;
  hints.curve = "Probe 1";
  const auto log = readForceLog(file.path(), hints);
  REQUIRE_FALSE(log);
  CHECK(log.failure().code == FailureCode::wrongUsage);
}

TEST_CASE("a word that is a force in one language and another quantity in the next counts with its unit") {
  const auto rows = rowsOf([](double x, double f, int) { return formatted("%.4f,%.4f\n", x, f); });
  for (const char* word : {"Charge", "压力", "압력"}) {
    CAPTURE(word);
    const LayoutFile bare("Travel (mm)," + std::string(word) + "\n" + rows);
    const LogReading open = readLog(bare.path());
    REQUIRE_FALSE(open.log);
    CHECK(open.log.failure().code == FailureCode::notCertain);
    REQUIRE(open.question);
    REQUIRE(open.question->choices.size() == 1);
    CHECK(open.question->choices.front().option == "--force-column 2");
    LogHints answered;
    answered.columns.force = "2";
    CHECK(readForceLog(bare.path(), answered));
    const LayoutFile whole("Travel (mm)," + std::string(word) + " (N)\n" + rows);
    const auto log = readForceLog(whole.path());
    REQUIRE(log);
    CHECK(log->confidence > 0.9);
    checkButton(*log);
  }
}

TEST_CASE("conditions above pairs of columns name records") {
  const LayoutFile file(
      "-40 °C;;85 °C;\nWeg (mm);Kraft (N);Weg (mm);Kraft (N)\n" +
      rowsOf([](double x, double f, int) { return formatted("%.4f;%.5f;%.4f;%.5f\n", x, f, x, 1.4 * f); }));
  const LogReading open = readLog(file.path());
  REQUIRE_FALSE(open.log);
  REQUIRE(open.records.size() == 2);
  CHECK(open.records[0].name == "-40 °C");
  CHECK(open.records[1].name == "85 °C");
}

TEST_CASE("a loop sorted by displacement is refused with what to do") {
  std::string text = "Travel (mm),Force (N)\n";
  for (int i = 0; i <= 100; ++i)
    text += formatted("%.4f,%.4f\n%.4f,%.4f\n", 0.04 * i, buttonForce_N(0.04 * i, true) + 0.1,
                      0.04 * i + 0.01, buttonForce_N(0.04 * i + 0.01, false));
  const LayoutFile file(text);
  const auto log = readForceLog(file.path());
  REQUIRE_FALSE(log);
  CHECK(log.failure().sentence().find("sorted") != std::string::npos);
}

TEST_CASE("a pair of files is one button") {
  const LayoutFile press(
      "Travel (mm),Force (N)\n" +
          rowsOf([](double x, double f, int) { return formatted("%.4f,%.4f\n", x, f); }, false),
      "a.csv");
  std::string rows = "Travel (mm),Force (N)\n";
  const bool rises = GENERATE(true, false);
  for (int i = 0; i <= 160; ++i) {
    const double x = rises ? travel_mm * i / 160 : travel_mm * (160 - i) / 160;
    rows += formatted("%.4f,%.4f\n", x, buttonForce_N(x, false));
  }
  const LayoutFile release(rows, "b.csv");
  LogHints pair;
  pair.releasePath = release.path();
  const auto log = readForceLog(press.path(), pair);
  if (!log) FAIL(log.failure().sentence());
  checkButton(*log);
}

TEST_CASE("results of formulas that no program has calculated are no numbers") {
  enum class Results { right, zero, none };
  // Force as a formula, as XlsxWriter (0) and openpyxl (none) save it; beside it a load in grams, or nothing.
  const auto sheet = [](Results results, bool withLoad) {
    std::string xml =
        "<worksheet><sheetData><row><c t=\"inlineStr\"><is><t>Travel (mm)</t></is></c>"
        "<c t=\"inlineStr\"><is><t>Force (N)</t></is></c>";
    if (withLoad) xml += "<c t=\"inlineStr\"><is><t>Load (gf)</t></is></c>";
    xml += "</row>";
    for (int i = 0; i <= 320; ++i) {
      const bool press = i <= 160;
      const double x = travel_mm * (press ? i : 320 - i) / 160, force_N = buttonForce_N(x, press);
      const auto value = [](double v) { return "<v>" + std::to_string(v) + "</v>"; };
      xml += "<row><c>" + value(x) + "</c><c><f>C2*0.00980665</f>" +
             (results == Results::right  ? value(force_N)
              : results == Results::zero ? "<v>0</v>"
                                         : "") +
             "</c>" + (withLoad ? "<c>" + value(force_N / 0.00980665) + "</c>" : "") + "</row>";
    }
    return test::zipOf("xl/worksheets/sheet1.xml", xml + "</sheetData></worksheet>");
  };
  for (const Results results : {Results::right, Results::zero, Results::none}) {
    CAPTURE(static_cast<int>(results));
    if (results != Results::right) {  // calculated ones are a second record
      const LayoutFile beside(sheet(results, true), "beside.xlsx");
      const auto log = readForceLog(beside.path());
      if (!log) FAIL(log.failure().sentence());
      checkButton(*log);
    }
    const LayoutFile alone(sheet(results, false), "alone.xlsx");
    const auto read = readForceLog(alone.path());
    CHECK(read.ok() == (results == Results::right));
    if (!read) CHECK_THAT(read.failure().sentence(), Catch::Contains("321 formulas have no results"));
  }
}

TEST_CASE("sheets named as strokes are one button") {
  const auto table = [](const std::string& name, const char* titles, bool press, bool rises, double newton,
                        double scale) {
    std::string xml = "<table:table table:name=\"" + name + "\">" + titles;
    for (int i = 0; i <= 160; ++i) {
      const double x = travel_mm * (rises ? i : 160 - i) / 160;
      xml += "<table:table-row>" + test::cellOf(x) + test::cellOf(scale * buttonForce_N(x, press) / newton) +
             "</table:table-row>";
    }
    return xml + "</table:table>";
  };
  const auto titles = [](const char* displacement, const char* force) {
    return "<table:table-row>" + test::cellOf(std::string(displacement)) + test::cellOf(std::string(force)) +
           "</table:table-row>";
  };
  const auto book = [](const std::string& sheets) {
    return test::zipOf("content.xml",
                       "<?xml version=\"1.0\"?><office:spreadsheet>" + sheets + "</office:spreadsheet>");
  };
  const std::string plain = titles("Travel (mm)", "Force (N)"), grams = titles("Travel (mm)", "Force (gf)"),
                    bare = titles("Travel", "Force");
  struct Names {
    const char* press;
    const char* release;
  };
  for (const Names& names :
       {Names{"Press", "Release"}, Names{"Belastung", "Entlastung"}, Names{"Aller", "Retour"},
        Names{"加载", "卸载"}, Names{"K1 downstroke", "K1 upstroke"}})
    for (const bool rises : {false, true}) {
      CAPTURE(names.press, rises);
      const std::string press = table(names.press, plain.c_str(), true, true, 1, 1);
      const std::string release = table(names.release, grams.c_str(), false, rises, 0.00980665, 1);
      for (const std::string& sheets : {press + release, release + press}) {
        const LayoutFile file(book(sheets), "a.ods");
        const auto log = readForceLog(file.path());
        if (!log) FAIL(log.failure().sentence());
        CHECK(log->confidence > 0.9);
        checkButton(*log);
      }
    }
  // A unit that only one of the sheets says is that of both.
  const LayoutFile half(book(table("Press", bare.c_str(), true, true, 0.00980665, 1) +
                             table("Release", grams.c_str(), false, false, 0.00980665, 1)),
                        "b.ods");
  const auto log = readForceLog(half.path());
  if (!log) FAIL(log.failure().sentence());
  CHECK(log->yUnit == "gf");
  checkButton(*log);
  // Two buttons of two sheets each; a release without its press does not count.
  const LayoutFile two(book(table("A press", plain.c_str(), true, true, 1, 1) +
                            table("A release", plain.c_str(), false, false, 1, 1) +
                            table("B press", plain.c_str(), true, true, 1, 1.5) +
                            table("B release", plain.c_str(), false, false, 1, 1.5) +
                            table("C release", plain.c_str(), false, false, 1, 2)),
                       "c.ods");
  const LogReading bothStrokes = readLog(two.path());
  REQUIRE(bothStrokes.records.size() == 2);
  CHECK(bothStrokes.records[0].name == "A");
  CHECK(bothStrokes.records[1].name == "B");
  CHECK(bothStrokes.records[1].release);
}

TEST_CASE("a column of contact gives the operating and the reset point") {
  const LayoutFile file("Travel (mm),Force (N),Voltage (V)\n" + rowsOf([](double x, double f, int n) {
                          const bool closed = n <= 160 ? x >= 2 : x > 1.7;
                          return formatted("%.4f,%.4f,%.2f\n", x, f, closed ? 0.1 : 4.9);
                        }));
  const auto log = readForceLog(file.path());
  REQUIRE(log);
  REQUIRE(log->operatingPoint_mm);
  REQUIRE(log->resetPoint_mm);
  CHECK(*log->operatingPoint_mm == Approx(2).margin(0.026));
  CHECK(*log->resetPoint_mm == Approx(1.7).margin(0.026));
}
