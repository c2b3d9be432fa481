// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "importer/library/find_switches.h"
#include "importer/library/index_folders.h"
#include "importer/library/origin.h"
#include "importer/library/read_switches.h"
#include "importer/library/report_page.h"
#include "importer/library/store.h"
#include "importer/library/switch_name.h"
#include "importer/library/wanted_button.h"
#include "model/units.h"

using namespace detent;
using namespace detent::importer;

namespace {

namespace fs = std::filesystem;

/// A folder of the test's own.
class Folder {
 public:
  Folder() {
    static int count = 0;
    path_ = fs::temp_directory_path() /
            ("detent-library-" + std::to_string(std::hash<std::string>{}(fs::current_path().string())) + "-" +
             std::to_string(++count));
    fs::remove_all(path_);
    fs::create_directories(path_);
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  fs::path operator/(const std::string& name) const { return path_ / name; }
  std::string path() const { return path_.string(); }
  void write(const std::string& name, const std::string& text) const {
    fs::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name, std::ios::binary) << text;
    // An hour ago: a file as fresh as its index is read again.
    fs::last_write_time(path_ / name, fs::file_time_type::clock::now() - std::chrono::hours(1));
  }

 private:
  fs::path path_;
};

/// A switch by a bump on a spring: peak at 1.2 mm, bottom-out at 3.6 mm; the release 6 gf below.
double force_gf(double x_mm, double start_gf, double bump_gf) {
  const double bump = bump_gf * std::exp(-(x_mm - 1.2) * (x_mm - 1.2) / 0.08);
  const double bottomOut_N = x_mm > 3.6 ? 400 * (x_mm - 3.6) : 0;
  return std::min(start_gf, 300 * x_mm) + 8 * x_mm + bump + bottomOut_N;
}

/// In the layout of force-curves-tidy: force, displacement in gf and mm, way down, then up.
std::string tidyCsv(double start_gf, double bump_gf) {
  std::string text = "force,displacement,judge,name\n";
  const auto row = [&](double f, double x) {
    char line[80];
    std::snprintf(line, sizeof line, "%.2f,%.4f,0,switch\n", f, x);
    text += line;
  };
  for (int i = 0; i <= 380; ++i) row(force_gf(0.01 * i, start_gf, bump_gf), 0.01 * i);
  for (int i = 380; i >= 0; --i) row(std::max(0.0, force_gf(0.01 * i, start_gf, bump_gf) - 6), 0.01 * i);
  return text;
}

IndexSummary indexed(const Folder& folder, const std::string& database) {
  const auto summary = indexFolders({{folder.path()}, database, "", "", 2});
  if (!summary) FAIL(summary.failure().sentence());
  return *summary;
}

std::vector<FoundSwitch> found(const FindRequest& request) {
  const auto result = findSwitches(request);
  if (!result) FAIL(result.failure().sentence());
  return result->found;
}

}  // namespace

TEST_CASE("a switch is called what its file calls it, without what the file is") {
  CHECK(switchNameFrom("d/Leobog Nimbus__Leobog Nimbus Raw Data CSV.csv") ==
        SwitchName{"Leobog Nimbus", "", ""});
  CHECK(switchNameFrom("d/JWK-Bouquet-Sample-2-Measurement-1.ods") == SwitchName{"JWK Bouquet", "2", "1"});
  CHECK(switchNameFrom("Topre_R1_45g/DataLog_4.csv") == SwitchName{"Topre R1 45g", "", "4"});
  // Forms of unit names of laboratories: a number behind the folder's name, or a leading zero.
  CHECK(switchNameFrom("d/Clickiez 40g__Clickiez 40g 2 Raw Data CSV.csv") ==
        SwitchName{"Clickiez 40g", "2", ""});
  CHECK(switchNameFrom("AEBoards Naevy EC/AEBoards Naevy EC 3 Raw Data CSV.csv") ==
        SwitchName{"AEBoards Naevy EC", "3", ""});
  CHECK(switchNameFrom("Sony_BKE_Gray_02/DataLog_3.csv") == SwitchName{"Sony BKE Gray", "02", "3"});
  CHECK(switchNameFrom("d/Boba U4T 62.csv") == SwitchName{"Boba U4T 62", "", ""});
  CHECK(switchNameFrom("gateron-aliaz/truth.csv") == SwitchName{"gateron aliaz", "", ""});
  CHECK(switchNameFrom("B.button.json").name == "B");
  CHECK(switchNameFrom("d/茶轴.csv").name == "茶轴");
}

TEST_CASE("a folder says its licence and its makers") {
  CHECK(licenceNamed("MIT License\n\nCopyright") == "MIT");
  CHECK(licenceNamed("Creative Commons\nAttribution 4.0 International") == "CC BY 4.0");
  CHECK(licenceNamed(" Ask me first. \nThen go on") == "Ask me first.");
  CHECK(creditFrom("[remote \"origin\"]\n\turl = https://me:secret@host.example/owner/name.git\n") ==
        "owner/name");
  CHECK(creditFrom("[core]\n").empty());

  const Folder folder;
  folder.write("own/a.csv", tidyCsv(30, 0));
  folder.write("own/LICENSE", "MIT License\n");
  folder.write("b.csv", tidyCsv(50, 0));
  indexed(folder, (folder / "l.db").string());
  for (const FoundSwitch& each : found({(folder / "l.db").string(), {}, {}, 10}))
    CHECK(each.entry.licence == (each.entry.name == "a" ? "MIT" : noLicenceStated));
}

TEST_CASE("a second run reads what changed and nothing else") {
  const Folder folder;
  const std::string database = (folder / "l.db").string();
  folder.write("x/red.csv", tidyCsv(35, 0));
  folder.write("x/clear.csv", tidyCsv(40, 25));
  folder.write("x/broken.csv", "force,displacement\nnone,none\n");
  folder.write("x/.hidden/red.csv", tidyCsv(35, 0));
  const IndexSummary first = indexed(folder, database);
  CHECK(first.imported == 2);
  CHECK(first.refused == 1);
  REQUIRE(first.refusals.size() == 1);
  CHECK(first.refusals[0].file == (folder / "x/broken.csv").string());
  CHECK(!first.refusals[0].reason.empty());

  const IndexSummary second = indexed(folder, database);
  CHECK(second.imported == 0);
  CHECK(second.unchanged == 2);
  CHECK(second.refused == 1);

  folder.write("x/red.csv", tidyCsv(55, 0));
  const auto anHourAgo = fs::file_time_type::clock::now() - std::chrono::hours(2);
  fs::last_write_time(folder / "x/clear.csv", anHourAgo);  // touched: the content is what counts
  fs::remove(folder / "x/broken.csv");
  const IndexSummary third = indexed(folder, database);
  CHECK(third.imported == 1);
  CHECK(third.unchanged == 1);
  CHECK(third.refused == 0);
  CHECK(third.gone == 1);
  CHECK(found({database, {}, {}, 10}).size() == 2);

  fs::remove(folder / "x/red.csv");
  indexed(folder, database);
  CHECK(found({database, {}, {}, 10}).size() == 1);
}

TEST_CASE("the nearest stands first, in units of lab noise") {
  const Folder folder;
  const std::string database = (folder / "l.db").string();
  for (int i = 0; i < 5; ++i)
    folder.write("s/spring " + std::to_string(30 + 10 * i) + ".csv", tidyCsv(30 + 10 * i, 0));
  folder.write("s/tactile.csv", tidyCsv(50, 25));
  indexed(folder, database);

  const auto like = readSwitches((folder / "s/spring 50.csv").string());
  REQUIRE(like);
  const auto nearest = found({database, like->front().shape, {}, 6});
  REQUIRE(nearest.size() == 6);
  CHECK(nearest[0].entry.name == "spring 50");
  CHECK(*nearest[0].distance_labNoise < 1e-3);
  // 10 gf on both strokes, times the weight of the level, less the part that a shift of the contact
  // explains.
  const auto softer =
      std::ranges::find_if(nearest, [](const FoundSwitch& each) { return each.entry.name == "spring 40"; });
  REQUIRE(softer != nearest.end());
  CHECK(*softer->distance_labNoise > 2.5);
  CHECK(*softer->distance_labNoise < 10 * FeelWeights{}.level / labNoise_gf);
  for (std::size_t i = 1; i < nearest.size(); ++i)
    CHECK(*nearest[i - 1].distance_labNoise <= *nearest[i].distance_labNoise);

  const auto tactile = found({database, {}, {{KeyFigure::drop, 0.1, 1}}, 10});
  REQUIRE(tactile.size() == 1);
  CHECK(tactile[0].entry.name == "tactile");
  CHECK(kindOf(tactile[0].entry.figures) == SwitchKind::tactile);
  CHECK(!tactile[0].distance_labNoise);
}

TEST_CASE("a short answer is the beginning of the long one, of equals the first by name") {
  const Folder folder;
  const std::string database = (folder / "l.db").string();
  for (const char* const name : {"e", "c", "a", "d", "b"})
    folder.write(std::string("s/") + name + ".csv", tidyCsv(45, 0));
  folder.write("s/nearer.csv", tidyCsv(50, 0));
  folder.write("s/tactile.csv", tidyCsv(50, 25));
  indexed(folder, database);
  const auto like = readSwitches((folder / "s/nearer.csv").string(), false);
  REQUIRE(like);
  CHECK_FALSE(like->front().sigmas[KeyFigure::totalTravel]);
  const auto names = [&](const std::optional<FeltShape>& query, std::size_t limit) {
    std::string all;
    for (const FoundSwitch& each : found({database, query, {}, limit})) all += each.entry.name + " ";
    return all;
  };
  CHECK(names(like->front().shape, 9) == "nearer a b c d e tactile ");
  CHECK(names(like->front().shape, 3) == "nearer a b ");
  CHECK(names({}, 9) == "a b c d e nearer tactile ");
  CHECK(names({}, 2) == "a b ");
  CHECK(names({}, 0).empty());
  const std::vector<FigureRange> none{{KeyFigure::totalTravel, 5, 6}};
  const auto missing = findSwitches({database, {}, none, 2});
  REQUIRE(missing);
  CHECK(missing->fitting == 0);
  REQUIRE(missing->nearest.size() == 2);
  CHECK(missing->nearest[0].miss_labNoise <= missing->nearest[1].miss_labNoise);
}

TEST_CASE("the nearest are those that all distances say, though few curves are read") {
  const Folder folder;
  const std::string database = (folder / "l.db").string();
  std::mt19937 draw(29);
  std::vector<LibraryFile> files;
  for (int i = 0; i < 240; ++i) {
    LibraryFile file;
    file.path = (folder / std::to_string(i)).string();
    LibrarySwitch each;
    each.name = "s" + std::to_string(i / 2);  // every other one is the one before once more: equals
    each.source = file.path;
    each.figures[KeyFigure::totalTravel] = 3 + 0.01 * (i % 50);
    if (i % 2 == 1) {
      each.shape = files.back().switches.front().shape;
    } else {
      const auto number = [&](double from, double to) {
        return std::uniform_real_distribution(from, to)(draw);
      };
      const double start_gf = number(30, 60), bump_gf = number(0, 30), travel_mm = number(3, 3.6);
      const double gf = newtonsPer(ForceUnit::gramForce);
      each.shape.travel_mm = travel_mm;
      for (std::size_t k = 0; k < FeltShape::samples; ++k) {
        const double f_gf =
            force_gf(0.2 + travel_mm * double(k) / double(FeltShape::samples), start_gf, bump_gf);
        each.shape.press_N.push_back(static_cast<float>(gf * f_gf));
        if (i % 3 != 0) each.shape.release_N.push_back(static_cast<float>(gf * (f_gf - 6)));
      }
    }
    file.switches.push_back(each);
    files.push_back(file);
  }
  {
    auto store = LibraryStore::openToWrite(database);
    REQUIRE(store);
    REQUIRE(store->put(files));
  }
  for (const std::vector<FigureRange>& ranges :
       {std::vector<FigureRange>{}, std::vector<FigureRange>{{KeyFigure::totalTravel, 3.1, 3.3}}})
    for (const std::size_t like : {0U, 17U, 100U, 239U})
      for (const std::size_t limit : {1U, 2U, 7U, 50U, 1000U}) {
        const FeltShape& query = files[like].switches.front().shape;
        const FeelDistance distance(query);
        std::vector<std::pair<double, std::string>> all;
        for (const LibraryFile& file : files) {
          const LibrarySwitch& each = file.switches.front();
          const double travel_mm = *each.figures[KeyFigure::totalTravel];
          if (!ranges.empty() && (travel_mm < 3.1 || travel_mm > 3.3)) continue;
          all.emplace_back(distance.to(each.shape), each.name);
        }
        std::ranges::sort(all);
        const auto result = findSwitches({database, query, ranges, limit});
        REQUIRE(result);
        CHECK(result->fitting == all.size());
        REQUIRE(result->found.size() == std::min(limit, all.size()));
        for (std::size_t i = 0; i < result->found.size(); ++i) {
          CHECK(result->found[i].distance_labNoise == all[i].first);
          CHECK(result->found[i].entry.name == all[i].second);
        }
      }
}

TEST_CASE("every figure of a record has an error, and several records of a switch a spread") {
  const Folder folder;
  const std::string database = (folder / "l.db").string();
  folder.write("dome/dome 1.csv", tidyCsv(40, 25));
  folder.write("dome/dome 2.csv", tidyCsv(46, 25));
  folder.write("dome/dome 2 run 2.csv", tidyCsv(46.5, 25));
  folder.write("dome/other.csv", tidyCsv(60, 25));
  indexed(folder, database);
  const auto all = found({database, {}, {}, 10});
  REQUIRE(all.size() == 4);
  const double gf = newtonsPer(ForceUnit::gramForce);
  for (const FoundSwitch& each : all) {
    for (const KeyFigureName& name : keyFigureNames()) {
      INFO(name.key);
      const auto &value = each.entry.figures[name.figure], &sigma = each.entry.sigmas[name.figure];
      CHECK(value.has_value() == sigma.has_value());
      if (sigma) CHECK((std::isfinite(*sigma) && *sigma > 0));
    }
    CHECK(*each.entry.sigmas[KeyFigure::peakForce] < 0.5 * gf);
    if (each.entry.name == "other") {
      CHECK(each.spread.records == 1);
      CHECK_FALSE(each.spread.sd[KeyFigure::peakForce]);
      continue;
    }
    CHECK(each.entry.name == "dome");
    CHECK(each.spread.records == 3);
    CHECK(each.spread.units == 2);
    // 40 against the mean of 46 and 46.5: 6.25 apart, of two units.
    CHECK(*each.spread.sd[KeyFigure::peakForce] / gf == Approx(6.25 / std::sqrt(2.0)).margin(0.3));
  }
}

TEST_CASE("figures are the samples' own, where the few pieces of the fit pass beside them") {
  const Folder folder;
  const std::string database = (folder / "l.db").string();
  folder.write("s/switch.csv", tidyCsv(40, 25));
  indexed(folder, database);
  const auto all = found({database, {}, {}, 10});
  REQUIRE(all.size() == 1);
  const KeyFigures& figures = all[0].entry.figures;
  CHECK(*figures[KeyFigure::totalTravel] == Approx(3.8).margin(1e-6));
  CHECK(*figures[KeyFigure::bottomOutTravel] == Approx(3.6).margin(0.002));
  CHECK(*all[0].entry.sigmas[KeyFigure::bottomOutTravel] < 0.008);
  double work_N_mm = 0;
  for (int i = 0; i < 38000; ++i) work_N_mm += force_gf(1e-4 * (i + 0.5), 40, 25) * 1e-4;
  work_N_mm *= newtonsPer(ForceUnit::gramForce);
  CHECK(*figures[KeyFigure::pressWork] == Approx(work_N_mm).margin(3e-4));
  CHECK(*all[0].entry.sigmas[KeyFigure::pressWork] < 0.005);
}

TEST_CASE("what a person said of a switch stands beside it, credited, and moves nothing") {
  const Folder folder;
  const std::string database = (folder / "l.db").string();
  folder.write("s/Maker Alpaca V2.csv", tidyCsv(45, 0));
  folder.write("s/Cherry MX 'Old' (62g).csv", tidyCsv(50, 20));
  folder.write("s/Yellow.csv", tidyCsv(50, 0));
  const std::string head =
      "\xef\xbb\xbf,\"Somebody's, sheet\",,,,,,,\n,,\n"
      "Rank,Switch Name,Date,Manufacturer,Type,Push Feel,Wobble,\"Timeless\nTotal\",,Rank,Switches Tested\n";
  folder.write("somebody/.git/config",
               "[remote \"origin\"]\n\turl = https://host.example/somebody/scores.git\n");
  folder.write("somebody/hard.csv",
               head +
                   "1,Alpaca V2,1/2/2020,Other/Maker,Linear,31,22.5,64,,1,17\n"
                   "2,\"Old \"\"MX\"\" Cherry (62g)\",1/2/2020,Cherry,Tactile,12,8,,,1,17\n"
                   "3,KTT Yellow,1/2/2020,KTT,Linear,1,2,3,,1,17\n,,,,,,,,\n");
  folder.write("somebody/none.csv", "Rank,Switch Name,Wobble\n1,Yellow,3\n");
  const IndexSummary summary = indexed(folder, database);
  CHECK(summary.imported == 4);
  CHECK(summary.switches == 3);
  CHECK(summary.ratings == 3);
  REQUIRE(summary.refusals.size() == 1);
  CHECK(summary.refusals[0].file == (folder / "somebody/none.csv").string());
  const auto like = readSwitches((folder / "s/Yellow.csv").string(), false);
  REQUIRE(like);
  const auto all = found({database, like->front().shape, {}, 9});
  REQUIRE(all.size() == 3);  // a sheet is no switch
  for (const FoundSwitch& each : all) {
    INFO(each.entry.name);
    if (each.entry.name == "Yellow") {  // another maker's may be meant
      CHECK(each.ratings.empty());
      continue;
    }
    REQUIRE(each.ratings.size() == 1);
    CHECK(each.ratings[0].credit == "somebody/scores");
    CHECK(each.ratings[0].licence == noLicenceStated);
    if (each.entry.name == "Maker Alpaca V2")
      CHECK(ratingWords(each.ratings[0]) ==
            "somebody/scores of \"Alpaca V2\": Push Feel 31, Wobble 22.5, Timeless Total 64");
    else
      CHECK(each.ratings[0].scores.size() == 2);
  }
  CHECK(reportPage(like->front(), all, 3)
            .find("rated by somebody/scores of &quot;Alpaca V2&quot;: Push Feel 31") != std::string::npos);
  const IndexSummary again = indexed(folder, database);
  CHECK(again.unchanged == 4);
  CHECK(found({database, {}, {}, 1})[0].ratings.size() == 1);
  fs::remove_all(folder / "somebody");
  indexed(folder, database);
  for (const FoundSwitch& each : found({database, {}, {}, 9})) CHECK(each.ratings.empty());
}

TEST_CASE("a bump where a linear switch is first touched is no tactile point; name and kind find it") {
  const Folder folder;
  const std::string database = (folder / "l.db").string();
  const auto touched = [](double at_mm, double drop_gf) {
    std::string text = "force,displacement,judge,name\n";
    for (int i = 0; i <= 380; ++i) {
      const double x_mm = 0.01 * i;
      const double bump = drop_gf * std::exp(-(x_mm - at_mm) * (x_mm - at_mm) / 0.002);
      text += std::to_string(force_gf(x_mm, 30, 0) + bump) + "," + std::to_string(x_mm) + ",0,switch\n";
    }
    return text;
  };
  folder.write("s/Jelly Black.csv", touched(0.15, 4));
  folder.write("s/Jelly Brown.csv", tidyCsv(30, 25));
  folder.write("s/Early Clear.csv", touched(0.15, 12));
  indexed(folder, database);
  const auto named = [&](const std::string& name, std::optional<SwitchKind> kind) {
    FindRequest request{database, {}, {}, 9};
    request.name = name;
    request.kind = kind;
    std::vector<std::string> names;
    for (const FoundSwitch& each : found(request)) names.push_back(each.entry.name);
    return names;
  };
  CHECK(named("jelly", {}) == std::vector<std::string>{"Jelly Black", "Jelly Brown"});
  CHECK(named("", SwitchKind::linear) == std::vector<std::string>{"Jelly Black"});
  CHECK(named("JELLY", SwitchKind::tactile) == std::vector<std::string>{"Jelly Brown"});
  CHECK(named("nobody", {}).empty());
  CHECK(found({database, {}, {FigureRange{KeyFigure::peakForce, 0, 10}}, 9}).size() == 2);
  for (const FoundSwitch& each : found({database, {}, {}, 9}))
    CHECK(each.entry.figures[KeyFigure::peakForce].has_value() == (each.entry.name != "Jelly Black"));
}

TEST_CASE("a tester whose forces lie well off others' is named with each switch") {
  const Folder folder;
  const std::string database = (folder / "l.db").string();
  std::string x, down, up;
  for (int i = 1; i <= 150; ++i) {
    const char* const comma = i > 1 ? "," : "";
    x += comma + std::to_string(0.025 * i);
    down += comma + std::to_string(force_gf(0.025 * i, 40, 25));
    up += comma + std::to_string(force_gf(0.025 * (151 - i), 40, 25) - 6);
  }
  folder.write("s/red.json", "{\"down_x\":[" + x + "],\"down_y\":[" + down + "],\"up_y\":[" + up + "]}");
  folder.write("s/blue.csv", tidyCsv(40, 25));
  indexed(folder, database);
  for (const FoundSwitch& each : found({database, {}, {}, 10}))
    CHECK(each.entry.scaleDoubtful == (each.entry.name == "red"));
  const auto all = found({database, {}, {}, 10});
  CHECK(reportPage(all.front().entry, all, 2).find("well off other laboratories") != std::string::npos);
}

TEST_CASE("another meter's zero of travel and preload do not make another switch, a longer travel does") {
  const auto shapeOf = [](double from_mm, double preload_gf, double travel_mm) {
    FeltShape shape{travel_mm, std::vector<float>(FeltShape::samples),
                    std::vector<float>(FeltShape::samples)};
    for (std::size_t i = 0; i < FeltShape::samples; ++i) {
      const double x_mm = from_mm + travel_mm * double(i) / double(FeltShape::samples - 1);
      const double gf = newtonsPer(ForceUnit::gramForce);
      shape.press_N[i] = static_cast<float>(gf * (force_gf(std::min(x_mm, 3.6), 30, 25) + preload_gf));
      shape.release_N[i] = static_cast<float>(gf * (force_gf(std::min(x_mm, 3.6), 30, 25) + preload_gf - 6));
    }
    return shape;
  };
  const FeelDistance distance(shapeOf(0.1, 0, 3.4));
  CHECK(distance.to(shapeOf(0.1, 0, 3.4)) < 1e-6);
  CHECK(distance.to(shapeOf(0.24, 2, 3.3)) <
        1.2);  // the rest is the distance of a shift, a level and a travel
  CHECK(distance.to(shapeOf(0.1, 0, 3.0)) > 1.5);
  CHECK(distance.to(shapeOf(0.1, 10, 3.4)) > 3);
  FeltShape pressOnly = shapeOf(0.1, 0, 3.4), tiny = shapeOf(0.1, 0, 1e-6);
  pressOnly.release_N.clear();
  CHECK(distance.to(pressOnly) < 1e-6);
  CHECK(std::isfinite(distance.to(tiny)));
  CHECK(std::isfinite(FeelDistance(tiny).to(pressOnly)));
  CHECK(groupOf(0.99) == 1);
  CHECK(groupOf(1.0) == 2);
}

TEST_CASE(
    "a report is one page with every switch, its credit and its licence, and nothing of a file is markup") {
  const Folder folder;
  const std::string database = (folder / "l.db").string();
  folder.write("s/spring <script>.csv", tidyCsv(50, 0));
  folder.write("s/other.csv", tidyCsv(60, 0));
  folder.write("s/LICENSE", "Ask \"me\" & <b>first</b>\n");
  indexed(folder, database);
  auto like = readSwitches((folder / "s/other.csv").string());
  REQUIRE(like);
  like->front().sigmas[KeyFigure::bottomOutForce] = 0.2 * newtonsPer(ForceUnit::gramForce);
  like->front().sigmas[KeyFigure::totalTravel] = 0.004;  // below the last place shown
  const std::vector<FoundSwitch> all = found({database, like->front().shape, {}, 9});
  REQUIRE(all.size() == 2);
  const std::string page = reportPage(like->front(), all, 2);
  CHECK(page == reportPage(like->front(), all, 2));
  CHECK(page.find("<script") == std::string::npos);
  CHECK(page.find("<b>") == std::string::npos);
  CHECK(page.find("spring &lt;script&gt;") != std::string::npos);
  CHECK(page.find("Ask &quot;me&quot; &amp; &lt;b&gt;first") != std::string::npos);
  CHECK(page.find("http") == std::string::npos);  // nothing is loaded
  std::size_t plots = 0;
  for (std::size_t at = page.find("<svg"); at != std::string::npos; at = page.find("<svg", at + 1)) ++plots;
  CHECK(plots == 2);
  CHECK(page.find("nan") == std::string::npos);
  CHECK(page.find("± 0.2</small>") != std::string::npos);
  for (const char* const none : {"± 0.0<", "± 0.00<"}) CHECK(page.find(none) == std::string::npos);
}

TEST_CASE("figures that no switch has: the nearest is reported, and bent it has them") {
  const Folder folder;
  const std::string database = (folder / "l.db").string();
  folder.write("s/weak.csv", tidyCsv(30, 25));
  folder.write("s/strong.csv", tidyCsv(50, 25));
  folder.write("s/linear.csv", tidyCsv(50, 0));
  indexed(folder, database);
  const double gf = newtonsPer(ForceUnit::gramForce);
  const std::vector<FigureRange> wanted{{KeyFigure::peakForce, 95 * gf, 97 * gf},
                                        {KeyFigure::drop, 20 * gf, 21 * gf}};
  const auto result = findSwitches({database, {}, wanted, 10});
  REQUIRE(result);
  CHECK(result->found.empty());
  REQUIRE(result->nearest.size() == 2);  // the linear one has no peak
  CHECK(result->nearest[0].entry.name == "strong");
  CHECK(result->nearest[0].miss_labNoise > 1);
  CHECK(result->nearest[0].miss_labNoise < result->nearest[1].miss_labNoise);

  const auto button = buttonOf(result->nearest[0].entry, Quality::draft);
  REQUIRE(button);
  const auto bent = buttonWithin(*button, wanted);
  REQUIRE(bent);
  const KeyFigures figures = keyFiguresOf(bent->states().front());
  CHECK(*missOf(figures, wanted) < 0.01);
  const std::vector<FigureRange> already{{KeyFigure::peakForce, 0, 9}};
  CHECK(*buttonWithin(*button, already) == *button);
  const auto impossible = buttonWithin(*button, {{KeyFigure::drop, 3, 3.1}, {KeyFigure::peakForce, 1, 1.1}});
  REQUIRE_FALSE(impossible);
  CHECK(impossible.failure().code == FailureCode::notCertain);
  const auto all = findSwitches({database, {}, {}, 10});
  REQUIRE(all);
  for (const FoundSwitch& one : all->found) {
    const LibrarySwitch& each = one.entry;
    if (each.name != "linear") continue;
    const auto linear = buttonOf(each, Quality::draft);
    REQUIRE(linear);
    CHECK_FALSE(buttonWithin(*linear, wanted));
  }
}

TEST_CASE("a damaged library is kept aside and made anew, another program's is left alone") {
  const Folder folder;
  const std::string database = (folder / "l.db").string();
  folder.write("s/red.csv", tidyCsv(35, 0));
  CHECK(indexed(folder, database).rebuilt.empty());
  {
    std::fstream file(database, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(100);
    file << std::string(8000, 'x');
  }
  CHECK(!findSwitches({database, {}, {}, 10}));
  const IndexSummary again = indexed(folder, database);
  CHECK(!again.rebuilt.empty());
  CHECK(again.imported == 1);
  CHECK(fs::exists(database + ".damaged"));
  CHECK(found({database, {}, {}, 10}).size() == 1);

  folder.write("notes.txt", "mine");
  const auto refused = indexFolders({{folder.path()}, (folder / "notes.txt").string(), "", "", 1});
  REQUIRE(!refused);
  CHECK(refused.failure().code == FailureCode::wrongUsage);
  CHECK(fs::file_size(folder / "notes.txt") == 4);
}

TEST_CASE("what is not there is said") {
  const Folder folder;
  const auto noFolder = indexFolders({{(folder / "none").string()}, (folder / "l.db").string(), "", "", 1});
  REQUIRE(!noFolder);
  CHECK(noFolder.failure().code == FailureCode::unreadableInput);
  CHECK(!fs::exists(folder / "l.db"));
  const auto noLibrary = findSwitches({(folder / "l.db").string(), {}, {}, 10});
  REQUIRE(!noLibrary);
  CHECK(noLibrary.failure().code == FailureCode::unreadableInput);
  CHECK(!fs::exists(folder / "l.db"));
}
