// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>

#include <catch2/catch.hpp>

#include "importer/log/force_log.h"

using namespace detent;
using namespace detent::importer;

namespace {

constexpr double newtonPerGf = 0.00980665;

/// A file that goes when the test does.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& content, const std::string& name = "log.csv")
      : path_(std::filesystem::temp_directory_path() /
              ("detent_log_test_" + std::to_string(++count_) + "_" + name)) {
    std::ofstream(path_, std::ios::binary) << content;
  }
  ~TemporaryFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  std::string path() const { return path_.string(); }

 private:
  static inline int count_ = 0;
  std::filesystem::path path_;
};

double pressForce_gf(double x) { return 40 + 8 * x + 15 * std::exp(-std::pow((x - 1.2) / 0.3, 2)); }
double releaseForce_gf(double x) { return 30 + 8 * x + 10 * std::exp(-std::pow((x - 1.0) / 0.3, 2)); }

struct Style {
  const char* header = "Displacement (mm),Force (gf)\n";
  char delimiter = ',';
  char decimal = '.';
  const char* end = "\n";
  int cycles = 1;
  double sign = 1, forceSign = 1;
};

std::string number(double value, char decimal) {
  char text[40];
  std::snprintf(text, sizeof text, "%.5f", value);
  std::string s(text);
  if (decimal == ',') s[s.find('.')] = ',';
  return s;
}

std::string run(const Style& style) {
  std::string text = style.header;
  const auto row = [&](double x, double f) {
    text += number(style.sign * x, style.decimal) + style.delimiter +
            number(style.forceSign * f, style.decimal) + style.end;
  };
  for (int c = 0; c < style.cycles; ++c) {
    for (int i = 0; i <= 400; ++i) row(0.01 * i, pressForce_gf(0.01 * i) + c);
    for (int i = 399; i >= 0; --i) row(0.01 * i, releaseForce_gf(0.01 * i) + c);
  }
  return text;
}

void checkStrokes(const ForceLog& log) {
  const auto& press = log.strokes.press.points;
  REQUIRE(press.size() > 390);
  CHECK(press.front().displacement_mm < press.back().displacement_mm);
  REQUIRE(log.strokes.release);
  const auto& release = log.strokes.release->points;
  CHECK(release.front().displacement_mm > release.back().displacement_mm);
  for (const CurvePoint& p : press)
    REQUIRE(p.force_N == Approx(pressForce_gf(p.displacement_mm) * newtonPerGf).margin(1e-6));
  for (std::size_t i = 1; i < release.size(); ++i)
    REQUIRE(release[i].force_N ==
            Approx(releaseForce_gf(release[i].displacement_mm) * newtonPerGf).margin(1e-6));
}

ForceLog readOk(const std::string& content) {
  TemporaryFile file(content);
  auto log = readForceLog(file.path());
  if (!log) FAIL(log.failure().sentence());
  return std::move(log).value();
}

Failure readFailing(const std::string& content) {
  TemporaryFile file(content);
  const auto log = readForceLog(file.path());
  REQUIRE_FALSE(log);
  CHECK(english(log.failure().subject.name).find("log.csv") != std::string::npos);
  CHECK_FALSE(log.failure().problem.empty());
  CHECK_FALSE(log.failure().remedies.empty());
  return log.failure();
}

std::string utf16(const std::string& ascii, bool littleEndian) {
  std::string out = littleEndian ? "\xFF\xFE" : "\xFE\xFF";
  for (char c : ascii) {
    if (littleEndian)
      out += c, out += '\0';
    else
      out += '\0', out += c;
  }
  return out;
}

}  // namespace

TEST_CASE("one run in common forms gives press and release") {
  checkStrokes(readOk(run({})));
  checkStrokes(readOk(run({"Weg in mm;Kraft in gf\n", ';', ','})));
  checkStrokes(readOk(run({"行程(mm)\t力(gf)\r\n", '\t', '.', "\r\n"})));
  checkStrokes(readOk(run({"変位 (mm),荷重 (gf)\r", ',', '.', "\r"})));
  checkStrokes(readOk("\xEF\xBB\xBF" + run({})));
  checkStrokes(readOk(utf16(run({}), true)));
  checkStrokes(readOk(utf16(run({}), false)));
  checkStrokes(readOk("Force gauge M5-05\nSerial,123456\nDate,2024-05-01\n\n" + run({})));
  checkStrokes(readOk(run({"Position,Load\nmm,gf\n"})));
}

TEST_CASE("signs are turned and said") {
  const ForceLog pulled = readOk(run({"Displacement (mm),Force (gf)\n", ',', '.', "\n", 1, 1, -1}));
  checkStrokes(pulled);
  CHECK_FALSE(pulled.remarks.empty());
  const ForceLog downwards = readOk(run({"Displacement (mm),Force (gf)\n", ',', '.', "\n", 1, -1, 1}));
  checkStrokes(downwards);
}

TEST_CASE("a dome that collapses keeps its direction, though force falls with travel on the whole") {
  // Like the largest record of a dome bench: a hump over the first half, a valley, a short bottom-out.
  const auto dome_gf = [](double x) {
    return 110 * std::sin(std::min(3.0, x) / 3 * 3.14159) + 15 * x / 3 + (x > 3.7 ? 800 * (x - 3.7) : 0);
  };
  std::string down, up;
  for (int i = 0; i <= 790; ++i) {
    const double x = 0.005 * i, back = 0.005 * (790 - i);
    down += number(x, '.') + "," + number(dome_gf(x), '.') + "\n";
    up += number(back, '.') + "," + number(dome_gf(back) - 5, '.') + "\n";
  }
  const ForceLog log = readOk("Travel (mm),Scale (grams)\n" + down + up);
  for (const Remark& remark : log.remarks) CHECK(remark.code != RemarkCode::displacementTurned);
  CHECK(log.strokes.press.points.back().force_N > 1.5);
  CHECK(log.strokes.press.points.front().force_N < 0.1);
}

TEST_CASE("a switch may be called up or down") {
  std::string rows = "force,displacement,judge,name\n";
  for (int i = 0; i <= 400; ++i)
    rows += number(pressForce_gf(0.01 * i), '.') + "," + number(0.01 * i, '.') + ",0,Sunny Side Up Linear\n";
  for (int i = 400; i >= 0; --i)
    rows +=
        number(releaseForce_gf(0.01 * i), '.') + "," + number(0.01 * i, '.') + ",0,Sunny Side Up Linear\n";
  checkStrokes(readOk(rows));
}

TEST_CASE("a meter's preamble says the units of columns without titles") {
  std::string rows = "MAX FORCE = 10.0,3.525\nUNIT = gf,mm\nDATA COUNT = 802,\nTHRESHOLD = ---,\n";
  for (int i = 0; i <= 400; ++i) rows += number(0.02 * i, '.') + "," + number(0.01 * i, '.') + "\n";
  const ForceLog log = readOk(rows);  // forces that alone would pass for newtons
  CHECK(log.yUnit == "gf");
  CHECK(log.xUnit == "mm");
  CHECK(log.strokes.press.points.back().force_N == Approx(8 * newtonPerGf).margin(0.001));
  for (const Remark& remark : log.remarks) {
    CHECK(remark.code != RemarkCode::forceUnitAssumed);
    CHECK(remark.code != RemarkCode::displacementUnitAssumed);
  }
}

TEST_CASE("of several cycles that differ one has to be chosen") {
  const TemporaryFile file(run({"Displacement (mm),Force (gf)\n", ',', '.', "\n", 3}));
  const LogReading open = readLog(file.path());
  REQUIRE_FALSE(open.log);
  CHECK(open.log.failure().code == FailureCode::notCertain);
  CHECK(open.records.size() == 3);
  REQUIRE(open.question);
  REQUIRE(open.question->choices.size() == 4);
  CHECK(open.question->choices[1].option == "--record 2");
  CHECK(open.question->choices[3].option == "--record mean");
  LogHints first, mean;
  first.curve = "1", mean.curve = "mean";
  const auto one = readForceLog(file.path(), first);
  REQUIRE(one);
  checkStrokes(*one);
  const auto all = readForceLog(file.path(), mean);
  REQUIRE(all);
  REQUIRE(all->strokes.release);
  CHECK(all->strokes.press.points.front().force_N ==
        Approx((pressForce_gf(0) + 1) * newtonPerGf).margin(1e-4));
}

TEST_CASE("cycles that differ by less than makes another button are one") {
  std::string text = run({});
  text += text.substr(text.find('\n') + 1);
  const ForceLog log = readOk(text);
  checkStrokes(log);
  CHECK(std::ranges::count(log.remarks, RemarkCode::severalPresses, &Remark::code) == 1);
}

TEST_CASE("our own CSV and two pairs of columns") {
  std::string own = "stroke,displacement_mm,force_gf\n", pairs = "Press mm,Press gf,Release mm,Release gf\n";
  std::string shared = "Position (mm);Downstroke (gf);Upstroke (gf)\n";
  for (int i = 0; i <= 400; ++i) {
    const double x = 0.01 * i, y = 0.01 * (400 - i);
    own += "press," + number(x, '.') + "," + number(pressForce_gf(x), '.') + "\n";
    pairs += number(x, '.') + "," + number(pressForce_gf(x), '.') + "," + number(y, '.') + "," +
             number(releaseForce_gf(y), '.') + "\n";
    shared +=
        number(x, '.') + ";" + number(pressForce_gf(x), '.') + ";" + number(releaseForce_gf(x), '.') + "\n";
  }
  for (int i = 400; i >= 0; --i)
    own += "release," + number(0.01 * i, '.') + "," + number(releaseForce_gf(0.01 * i), '.') + "\n";
  checkStrokes(readOk(own));
  checkStrokes(readOk(pairs));
  checkStrokes(readOk(shared));
}

TEST_CASE("two forces beside one displacement, without a word about strokes, are a question") {
  std::string twoChannels = "Travel (mm),Force A (gf),Force B (gf)\n";
  const auto add = [&](double x, double force_gf) {
    twoChannels += number(x, '.') + "," + number(force_gf, '.') + "," + number(3 * force_gf + 20, '.') + "\n";
  };
  for (int i = 0; i <= 400; ++i) add(0.01 * i, pressForce_gf(0.01 * i));
  for (int i = 399; i >= 0; --i) add(0.01 * i, releaseForce_gf(0.01 * i));
  CHECK(readFailing(twoChannels).code == FailureCode::notCertain);
  const TemporaryFile file(twoChannels);
  LogHints given;
  given.columns.force = "Force A";
  const auto log = readForceLog(file.path(), given);
  REQUIRE(log);
  checkStrokes(*log);
}

TEST_CASE("without units the sizes decide, with a warning, and hints overrule") {
  const ForceLog guessed = readOk(run({""}));
  checkStrokes(guessed);
  CHECK(guessed.yUnit == "gf");
  CHECK(guessed.remarks.size() >= 2);
  TemporaryFile file(run({""}));
  const auto given = readForceLog(file.path(), {LengthUnit::millimetre, ForceUnit::centinewton, false});
  REQUIRE(given);
  CHECK(given->yUnit == "cN");
  CHECK(given->strokes.press.points.front().force_N == Approx(pressForce_gf(0) * 0.01).margin(1e-6));
}

TEST_CASE("one press in any unit of length and force is the same press") {
  const auto written = [](const char* header, double perMm, double perN) {
    std::string text = std::string(header) + "\n";
    char line[80];
    for (int i = 0; i <= 400; ++i) {
      std::snprintf(line, sizeof line, "%.17g,%.17g\n", 0.01 * i * perMm,
                    pressForce_gf(0.01 * i) * newtonPerGf * perN);
      text += line;
    }
    return text;
  };
  const std::vector<CurvePoint> expected =
      readOk(written("displacement_mm,force_N", 1, 1)).strokes.press.points;
  struct Form {
    const char* header;
    double perMm, perN;
  };
  for (const Form& form :
       {Form{"displacement_m,force_kN", 1e-3, 1e-3}, Form{"Displacement (m),Force (N)", 1e-3, 1},
        Form{"Weg in m,Kraft in kN", 1e-3, 1e-3}, Form{"Weg in \xC2\xB5m,Kraft in mN", 1e3, 1e3},
        Form{"displacement_nm,force_uN", 1e6, 1e6}, Form{"Travel [cm],Load [MN]", 0.1, 1e-6},
        Form{"Travel (in),Load (gf)", 1 / 25.4, 1 / newtonPerGf},
        Form{"Weg in Zoll,Kraft in N", 1 / 25.4, 1}}) {
    CAPTURE(form.header);
    const ForceLog log = readOk(written(form.header, form.perMm, form.perN));
    CHECK(log.remarks.size() == 1);  // no release; no unit had to be assumed
    REQUIRE(log.strokes.press.points.size() == expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      REQUIRE(log.strokes.press.points[i].displacement_mm ==
              Approx(expected[i].displacement_mm).epsilon(1e-13));
      REQUIRE(log.strokes.press.points[i].force_N == Approx(expected[i].force_N).epsilon(1e-13));
    }
  }
}

TEST_CASE("a preposition is no inch: the unit is assumed, and said") {
  const ForceLog log = readOk("Weg in Schritten,Kraft in N\n0,0.1\n1,0.2\n2,0.4\n3,0.5\n");
  CHECK(log.xUnit == "mm");
  CHECK(log.strokes.press.points.back().displacement_mm == 3);
  CHECK(std::ranges::count(log.remarks, RemarkCode::displacementUnitAssumed, &Remark::code) == 1);
}

TEST_CASE("a force that relaxes while the handle dwells at the bottom is no tactile point") {
  std::string text = "displacement_mm,force_N\n";
  for (int i = 0; i <= 400; ++i) text += number(0.01 * i, '.') + "," + number(0.3 + 0.001 * i, '.') + "\n";
  for (int i = 1; i <= 200; ++i) text += "4.00000," + number(0.7 - 0.0005 * i, '.') + "\n";
  for (int i = 400; i >= 0; --i) text += number(0.01 * i, '.') + "," + number(0.2 + 0.001 * i, '.') + "\n";
  const ForceLog log = readOk(text);
  CHECK(log.strokes.press.points.back() == CurvePoint{4, 0.7});
  REQUIRE(log.strokes.release);
  CHECK(log.strokes.release->points.back().displacement_mm == 0);
}

TEST_CASE("single outliers do not turn the signs") {
  std::string text = "displacement_mm,force_N\n";
  for (int i = 0; i <= 400; ++i)
    text += number(0.01 * i, '.') + "," + (i % 37 == 5 ? "-500" : number(0.3 + 0.001 * i, '.')) + "\n";
  const ForceLog log = readOk(text);
  for (const Remark& remark : log.remarks) {
    CHECK(remark.code != RemarkCode::forcesTurned);
    CHECK(remark.code != RemarkCode::displacementTurned);
  }
}

TEST_CASE("an offset before contact is taken off and reported") {
  std::string text = "mm,N\n";
  for (int i = 0; i <= 100; ++i) text += number(0.01 * i, '.') + ",0.03\n";
  for (int i = 1; i <= 300; ++i)
    text += number(1 + 0.01 * i, '.') + "," + number(0.03 + 0.005 * i, '.') + "\n";
  const ForceLog log = readOk(text);
  CHECK(log.preload_N == Approx(0.03).margin(1e-4));
  CHECK(log.strokes.press.points.front().force_N == Approx(0).margin(1e-4));
  CHECK_FALSE(log.strokes.release);
}

TEST_CASE("noise is estimated from the samples") {
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0, 0.01);
  std::string text = "mm,N\n";
  for (int i = 0; i <= 4000; ++i)
    text += number(0.001 * i, '.') + "," + number(0.5 + 1e-4 * i + noise(random), '.') + "\n";
  const ForceLog log = readOk(text);
  CHECK(log.noise_N == Approx(0.01).epsilon(0.15));
  CHECK(log.noise_mm > 0);
  CHECK(log.noise_mm < 1e-3);
}

TEST_CASE("what is no force log is refused with a sentence") {
  CHECK(readFailing("").code == FailureCode::unreadableInput);
  CHECK(readFailing(std::string("\x89PNG\r\n\x1A\n\0\0\0\rIHDR", 16)).code == FailureCode::unreadableInput);
  CHECK(readFailing("This is a letter.\nIt holds no numbers, only words.\n").code ==
        FailureCode::noForceGraph);
  CHECK(readFailing("mm,N\nnan,nan\nnan,nan\nnan,nan\n").code == FailureCode::noForceGraph);
  const Failure oneRow = readFailing("mm,N\n0.5,0.2\n");
  CHECK(oneRow.code == FailureCode::noForceGraph);
  CHECK(english(oneRow.problem).find("one sample") != std::string::npos);
  CHECK(readFailing("mm,N\n0.5,0.2\n0.5,0.3\n0.5,0.4\n").code == FailureCode::noForceGraph);
  CHECK(readFailing("stroke,displacement_mm,force_N\npress,0,0.1\nrelease,0,0.1\n").code ==
        FailureCode::noForceGraph);
  const auto missing = readForceLog("no such folder/log.csv");
  REQUIRE_FALSE(missing);
  CHECK(missing.failure().code == FailureCode::unreadableInput);
  const auto folder = readForceLog(std::filesystem::temp_directory_path().string());
  REQUIRE_FALSE(folder);
  CHECK(folder.failure().code == FailureCode::unreadableInput);
}

TEST_CASE("a row without numbers among the first takes no row of numbers with it") {
  const ForceLog log = readOk("mm,N\n0,0.1\n1,0.2\n--,--\n2,0.4\n3,0.5\n4,0.6\n");
  CHECK(log.strokes.press.points.size() == 5);
  CHECK(log.rowsSkipped == 1);
}

TEST_CASE("rows that are no numbers are left out, counted and named") {
  std::string text = run({});
  const std::size_t at = text.find('\n', text.size() / 4) + 1;
  text.insert(at, "0.9,NaN\nover range,error\n");
  const ForceLog log = readOk(text);
  CHECK(log.rowsSkipped == 2);
  CHECK(log.rowsRead == 803);
  CHECK(log.remarks.back().code == RemarkCode::rowsLeftOut);
  CHECK(log.remarks.back().values.at(3).text.find("NaN") != std::string::npos);
  checkStrokes(log);
}

TEST_CASE("a failed reading beside the name of its stroke ends no stroke") {
  const bool nameFirst = GENERATE(true, false), onTheWayBack = GENERATE(false, true);
  const std::string failed = GENERATE(std::string("1.5,"), ",0.6", "1.5,-", "1.5,nan", "1.5,0.5*", ",");
  CAPTURE(nameFirst, onTheWayBack, failed);
  std::string text = nameFirst ? "stroke,mm,N\n" : "mm,N,stroke\n";
  const auto add = [&](const char* stroke, const std::string& reading) {
    text += nameFirst ? std::string(stroke) + "," + reading + "\n" : reading + "," + stroke + "\n";
  };
  const auto force = [](double mm, double less) {
    return std::to_string(mm) + "," + std::to_string(mm / 2 - less);
  };
  for (int i = 0; i <= 40; ++i) {
    if (i == 15 && !onTheWayBack) add("down", failed);
    add("down", force(0.1 * i, 0));
  }
  for (int i = 40; i >= 0; --i) {
    if (i == 15 && onTheWayBack) add("up", failed);
    add("up", force(0.1 * i, 0.2 * std::min(1.0, 0.1 * (40 - i))));
  }
  const ForceLog log = readOk(text);
  CHECK(log.rowsSkipped == 1);
  CHECK(log.strokes.press.points.size() == 41);
  REQUIRE(log.strokes.release);
  CHECK(log.strokes.release->points.size() == 41);
}

TEST_CASE("strokes can be swapped, a release alone becomes the press") {
  TemporaryFile file(run({}));
  const auto swapped = readForceLog(file.path(), {{}, {}, true});
  REQUIRE(swapped);
  CHECK(swapped->strokes.press.points.front().displacement_mm <
        swapped->strokes.press.points.back().displacement_mm);
  CHECK(swapped->strokes.press.points.front().force_N ==
        Approx(releaseForce_gf(0) * newtonPerGf).margin(1e-6));

  std::string back = "mm,gf\n";
  for (int i = 400; i >= 0; --i) back += number(0.01 * i, '.') + "," + number(20 + 0.1 * i, '.') + "\n";
  CHECK(readFailing(back).code == FailureCode::noForceGraph);
  TemporaryFile alone(back);
  const auto taken = readForceLog(alone.path(), {{}, {}, true});
  REQUIRE(taken);
  CHECK_FALSE(taken->strokes.release);
}

TEST_CASE("a long log keeps its shape in bounded memory, and can be cancelled") {
  std::string text = "mm,N\n";
  constexpr int half = 600000;
  text.reserve(std::size_t{22} * 2 * half);
  char row[48];
  for (int i = 0; i < 2 * half; ++i) {
    const double x = 4.0 * (i < half ? i : 2 * half - i) / half;
    const int n = std::snprintf(row, sizeof row, "%.6f,%.6f\n", x, (i < half ? 0.5 : 0.4) + 0.1 * x);
    text.append(row, static_cast<std::size_t>(n));
  }
  TemporaryFile file(text);
  const auto log = readForceLog(file.path());
  REQUIRE(log);
  CHECK(log->rowsRead == 2 * half);
  CHECK(log->strokes.press.points.size() <= 1u << 20);
  CHECK(log->strokes.press.points.back().displacement_mm == Approx(4).margin(1e-4));
  REQUIRE(log->strokes.release);
  CHECK(log->strokes.release->points.back().force_N == Approx(0.4).margin(1e-3));

  Progress stop;
  stop.cancelled = [] { return true; };
  const auto cancelled = readForceLog(file.path(), {}, stop);
  REQUIRE_FALSE(cancelled);
  CHECK(cancelled.failure().code == FailureCode::cancelled);
}

TEST_CASE("a line without an end is refused") {
  TemporaryFile endless(std::string(3 << 20, '1'));
  CHECK_FALSE(readForceLog(endless.path()));
}
