// SPDX-License-Identifier: GPL-3.0-or-later
// Force meters' files of any text, unit, sign and length.

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include <catch2/catch.hpp>

#include "importer/log/force_log.h"
#include "importer/log/split_strokes.h"
#include "importer/log/table.h"
#include "tests/extremes/extreme_values.h"

using namespace detent;
using namespace detent::importer;
using namespace detent::tests;

namespace {

/// Writes the text to one file again for each case, because readers read files.
Result<ForceLog> readText(const std::string& text) {
  static const std::string path = (std::filesystem::temp_directory_path() /
                                   ("detent_log_extremes_" + std::to_string(std::random_device{}()) + ".csv"))
                                      .string();
  std::ofstream(path, std::ios::binary | std::ios::trunc) << text;
  Result<ForceLog> log = readForceLog(path);
  std::filesystem::remove(path);
  return log;
}

struct Form {
  std::string header = "displacement_mm,force_N";
  char delimiter = ',', decimal = '.';
  double perMm = 1, perN = 1;
};

std::string written(double value, char decimal) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value);
  for (char* c = text; *c; ++c)
    if (*c == '.') *c = decimal;
  return text;
}

std::string tableOf(const std::vector<CurvePoint>& points, const Form& table) {
  std::string header = table.header;
  for (char& c : header)
    if (c == ',') c = table.delimiter;
  std::string text = header + "\n";
  for (const CurvePoint& p : points)
    text += written(p.displacement_mm * table.perMm, table.decimal) + table.delimiter +
            written(p.force_N * table.perN, table.decimal) + "\n";
  return text;
}

/// There along a press and back along a release, evenly.
std::vector<CurvePoint> anyRun(Size size, int least = 20, int most = 60) {
  const double start = within(0.1, 0.4), end = within(0.6, 1), bump = within(0, 0.3), loss = within(0, 0.1);
  const int n = count(least, most);
  std::vector<CurvePoint> run;
  const auto force = [&](double s) {
    return start + (end - start) * s + bump * std::exp(-std::pow((s - 0.4) / 0.1, 2));
  };
  for (int i = 0; i <= n; ++i) run.push_back({size.travel_mm * i / n, size.force_N * force(double(i) / n)});
  for (int i = n - 1; i >= 0; --i)
    run.push_back({size.travel_mm * i / n, size.force_N * (force(double(i) / n) - loss * (n - i) / n)});
  return run;
}

}  // namespace

TEST_CASE("a log of any size is read as it stands", "[finite]") {
  holdsAlways("readForceLog, 1 µm to 100 m, 1 nN to 1 MN", [] {
    const Size size = anySize();
    const auto log = readText(tableOf(anyRun(size), {}));
    if (!log) RC_FAIL(log.failure().sentence());
    RC_ASSERT(std::isfinite(log->noise_mm) && log->noise_mm > 0);
    RC_ASSERT(std::isfinite(log->noise_N) && log->noise_N > 0);
    RC_ASSERT(log->strokes.release.has_value());
    RC_ASSERT(alike(log->strokes.press.points.back().displacement_mm, size.travel_mm, 1e-15));
  });
  holdsAlways("the same in any unit", [] {
    const std::vector<CurvePoint> run = anyRun({4, 1});
    const auto one = readText(tableOf(run, {}));
    RC_ASSERT(one.ok());
    struct Form {
      const char* header;
      double perMm, perN;
    };
    constexpr Form forms[] = {{"displacement_m,force_kN", 1e-3, 1e-3}, {"Weg in m,Kraft in mN", 1e-3, 1e3},
                              {"displacement_um,force_cN", 1e3, 1e2},  {"Travel (cm),Load (N)", 0.1, 1},
                              {"displacement_nm,force_uN", 1e6, 1e6},  {"travel_mm,force_MN", 1, 1e-6}};
    const Form& form = forms[static_cast<std::size_t>(count(0, 5))];
    const auto other = readText(tableOf(run, {form.header, ',', '.', form.perMm, form.perN}));
    RC_ASSERT(other.ok());
    const auto &a = one->strokes.press.points, &b = other->strokes.press.points;
    RC_ASSERT(a.size() == b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      RC_ASSERT(alike(a[i].displacement_mm, b[i].displacement_mm, 1e-14, 4));
      RC_ASSERT(alike(a[i].force_N, b[i].force_N, 1e-14, 1));
    }
    RC_ASSERT(alike(one->noise_N, other->noise_N, 1e-6));
  });
  holdsAlways("the same with any separator and decimal sign", [] {
    const std::vector<CurvePoint> run = anyRun({4, 1});
    const auto one = readText(tableOf(run, {}));
    constexpr std::pair<char, char> forms[] = {{';', ','}, {';', '.'}, {'\t', ','}, {'\t', '.'}, {'|', '.'}};
    const auto [delimiter, decimal] = forms[static_cast<std::size_t>(count(0, 4))];
    const auto other = readText(tableOf(run, {"displacement_mm,force_N", delimiter, decimal, 1, 1}));
    RC_ASSERT(one.ok() && other.ok());
    RC_ASSERT(one->strokes.press.points == other->strokes.press.points);
    RC_ASSERT(one->strokes.release->points == other->strokes.release->points);
  });
  holdsAlways("the same whatever the instrument's signs", [] {
    const std::vector<CurvePoint> run = anyRun({4, 1});
    const auto one = readText(tableOf(run, {}));
    const auto other =
        readText(tableOf(run, {"displacement_mm,force_N", ',', '.', oneIn(2) ? -1.0 : 1.0, -1.0}));
    RC_ASSERT(one.ok() && other.ok());
    const auto &a = one->strokes.press.points, &b = other->strokes.press.points;
    RC_ASSERT(a.size() == b.size());
    for (std::size_t i = 0; i < a.size(); ++i) RC_ASSERT(alike(a[i].force_N, b[i].force_N, 1e-14));
  });
  holdsAlways("rows that are no numbers do not matter", [] {
    const std::vector<CurvePoint> run = anyRun({4, 1});
    std::string text = tableOf(run, {});
    const auto one = readText(text);
    for (int i = count(1, 5); i > 0; --i) {
      std::size_t at = text.find('\n', anyOf<std::size_t>(30, text.size() - 3));
      text.insert(at + 1, oneIn(2) ? "nan,nan\n" : oneIn(2) ? "inf,1\n" : "--,--\n");
    }
    const auto other = readText(text);
    RC_ASSERT(one.ok() && other.ok());
    RC_ASSERT(one->strokes.press.points == other->strokes.press.points);
    RC_ASSERT(other->rowsSkipped > 0);
  });
}

TEST_CASE("any text is a log or a failure that says what is missing") {
  holdsAlways("readForceLog, damaged", [] {
    std::string text = tableOf(anyRun({4, 1}, 4, 20), {});
    for (int i = count(1, 12); i > 0; --i) {
      const auto at = anyOf<std::size_t>(0, text.size() - 1);
      if (oneIn(2))
        text[at] = "0123456789eE+-.,;\t|\"nai \n\r"[static_cast<std::size_t>(count(0, 25))];
      else
        text.erase(at, static_cast<std::size_t>(count(1, 8)));
    }
    const auto log = readText(text);
    if (!log) return assertNamed(log.failure());
    for (const CurvePoint& p : log->strokes.press.points)
      RC_ASSERT(std::isfinite(p.displacement_mm) && std::isfinite(p.force_N));
  });
  holdsAlways("readForceLog, any numbers", [] {
    std::string text = "displacement_mm,force_N\n";
    for (int i = count(0, 12); i > 0; --i)
      text += written(anyDouble(), '.') + "," + written(anyDouble(), '.') + "\n";
    const auto log = readText(text);
    if (!log) return assertNamed(log.failure());
    RC_ASSERT(log->noise_mm > 0 && log->noise_N > 0);
  });
  holdsAlways("numberIn reads what was printed", [] {
    const double value = anyFinite();
    const std::string text = written(value, ',');
    const auto cell = numberIn(text, NumberStyle{',', 0});
    RC_ASSERT(cell.has_value() && cell->value == value && cell->rest.empty());
  });
  holdsAlways("a table keeps every cell of a line", [] {
    std::string line = "a";
    for (int i = count(0, 40); i > 0; --i) line += "ab1.;,\t| x"[static_cast<std::size_t>(count(0, 9))];
    const auto table = tableOfText("0;1\n1;2\n2;3\n3;4\n4;5\n5;6\n" + line + "\n", "table", {});
    RC_ASSERT(table.ok());
    RC_ASSERT(table->cells(6) == 1 + static_cast<std::size_t>(std::count(line.begin(), line.end(), ';')));
  });
}

TEST_CASE("a log whose travel is a denormal number has a yardstick, or is refused") {
  const auto log = readText("displacement_mm,force_N\n0,0\n5e-324,0\n0,0\n");
  if (log) CHECK(log->noise_mm > 0);
  const auto longer = readText("displacement_mm,force_N\n0,0\n5e-324,1\n1e-323,2\n1.5e-323,3\n");
  if (longer) CHECK(longer->noise_mm > 0);
  CHECK((log.ok() || longer.ok()));  // else nothing was looked at
}

TEST_CASE("runs and their noise", "[finite]") {
  holdsAlways("spansOf: in order, the next begins where the one before ends", [] {
    std::vector<CurvePoint> run;
    for (int k = count(1, 5); k > 0; --k)
      for (const CurvePoint& p : anyRun({within(1, 4), 1}, 5, 20)) run.push_back(p);
    const auto spans = spansOf(run, 0.2);
    for (std::size_t i = 0; i < spans.size(); ++i) {
      RC_ASSERT(spans[i].from <= spans[i].to && spans[i].to < run.size());
      if (i > 0) RC_ASSERT(spans[i].from == spans[i - 1].to && spans[i].stroke != spans[i - 1].stroke);
    }
  });
  holdsAlways("noiseOf: unit and offset do not matter", [] {
    std::vector<double> values, scaled;
    for (int i = count(16, 200); i > 0; --i) values.push_back(within(-1, 1));
    const double factor = std::ldexp(1.0, count(-300, 300));
    for (const double v : values) scaled.push_back(v * factor);
    RC_ASSERT(noiseOf(scaled) == noiseOf(values) * factor);
  });
  holdsAlways("endBeforeDwell never takes the strongest sample, nor all", [] {
    std::vector<CurvePoint> press = anyRun({4, 1});
    const auto strongest =
        *std::max_element(press.begin(), press.end(), [](auto& a, auto& b) { return a.force_N < b.force_N; });
    const auto whole = press;
    endBeforeDwell(press, magnitude(1e-6, 1), magnitude(1e-6, 1));
    RC_ASSERT(press.size() >= 2u && press.size() <= whole.size());
    if (press.size() < whole.size() && strongest.displacement_mm == 4)
      RC_ASSERT(press.back().force_N == strongest.force_N);
  });
  holdsAlways("beforeContact gives finite numbers", [] {
    const auto run = anyRun(anySize());
    const std::vector<CurvePoint> press(run.begin(),
                                        run.begin() + static_cast<std::ptrdiff_t>(run.size() / 2 + 1));
    const auto before = beforeContact(press, magnitude(1e-9, 1));
    if (before) RC_ASSERT(std::isfinite(before->force_N) && std::isfinite(before->contact_mm));
  });
}
