// SPDX-License-Identifier: GPL-3.0-or-later
// detent-graph as a program.
#include <algorithm>
#include <tuple>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/cli/run_program.h"

using detent::tests::ProgramFolder;
using detent::tests::ProgramResult;
using nlohmann::json;

namespace {

const std::string samples = std::string(DETENT_SOURCE_DIR) + "/samples/buttons/";

class Graph : public ProgramFolder {
 public:
  Graph() : ProgramFolder("graph_cli_test") {
    for (const char* name : {"A", "B", "EF"})
      std::filesystem::copy_file(samples + name + ".button.json",
                                 path() / (std::string(name) + ".button.json"));
  }
  ProgramResult operator()(const std::vector<std::string>& arguments) const {
    return run(DETENT_GRAPH, arguments);
  }
};

const char* const pressOnlyCsv = "stroke,displacement_mm,force_N\npress,0,0.25\npress,2,0.5\n";

}  // namespace

TEST_CASE("check: whole output of a valid file") {
  const Graph graph;
  const ProgramResult r = graph({"check", "A.button.json"});
  CHECK(r.exitCode == 0);
  CHECK(r.out == "A.button.json: valid, 1 state, nothing odd\n");
  CHECK(r.err.empty());
}

TEST_CASE("check: warnings are printed and exit 0; --json moves the text to stderr") {
  const Graph graph;
  graph.write("p.csv", pressOnlyCsv);
  const ProgramResult text = graph({"check", "p.csv"});
  CHECK(text.exitCode == 0);
  CHECK(text.out ==
        "p.csv: valid, 1 state, 1 warning\n"
        "  warning [no-release] release curve: is not known; the press curve stands in for it.\n");
  const ProgramResult r = graph({"check", "p.csv", "--json"});
  CHECK(r.exitCode == 0);
  CHECK(r.err == text.out);
  const json object = json::parse(r.out);
  CHECK(object.at("status") == "ok");
  CHECK(object.at("warnings").at(0).at("rule") == "no-release");
  CHECK(std::count(r.out.begin(), r.out.end(), '\n') == 1);
}

TEST_CASE("show: whole output for a linear button") {
  const Graph graph;
  const ProgramResult r = graph({"show", "A.button.json"});
  CHECK(r.exitCode == 0);
  CHECK(r.err.empty());
  CHECK(r.out ==
        "Button \"A: CHERRY MX black, linear\"\n"
        "Travel: 4 mm\n"
        "Operating point: 2 mm, 0.6 N\n"
        "Reset point: 2 mm, 0.54 N\n"
        "Press: 3 knots, 0.38 to 1.1 N, work 2.4 mJ\n"
        "  slope             0 ->        4 mm      0.38 ->     0.82 N\n"
        "  bottom-out        4 ->        4 mm      0.82 ->      1.1 N\n"
        "Release: 3 knots, 0.32 to 1.1 N, work 2.16 mJ\n"
        "  bottom-out        4 ->        4 mm       1.1 ->     0.76 N\n"
        "  slope             4 ->        0 mm      0.76 ->     0.32 N\n"
        "Hysteresis: 0.24 mJ\n");
}

TEST_CASE("show --json carries the figures") {
  const Graph graph;
  const ProgramResult r = graph({"show", "B.button.json", "--json"});
  CHECK(r.exitCode == 0);
  const json state = json::parse(r.out).at("states").at(0);
  CHECK(state.at("travel_mm") == 4);
  CHECK(state.at("press").at("tactile_points").at(0).at("force_N") == 0.55);
  CHECK(state.at("press").at("tactile_points").at(0).at("snap_ratio").get<double>() == Approx(0.13 / 0.55));
  CHECK(state.at("press").at("bottom_out").at("wall") == true);
  CHECK(state.at("release").at("tactile_points").size() == 1);
  CHECK(json::parse(graph({"show", "EF.button.json", "--json"}).out).at("self_locking") == true);
}

TEST_CASE("convert: button to CSV and back lies on itself") {
  const Graph graph;
  const ProgramResult r = graph({"convert", "B.button.json", "b.csv"});
  CHECK(r.exitCode == 0);
  CHECK(r.out == "B.button.json -> b.csv (1 state, 13 knots)\n");
  CHECK(graph.read("b.csv").rfind("stroke,displacement_mm,force_N\npress,0,0.32\n", 0) == 0);
  CHECK(graph({"convert", "b.csv", "again.button.json"}).exitCode == 0);
  const ProgramResult compared = graph({"compare", "B.button.json", "again.button.json", "--json"});
  CHECK(compared.exitCode == 0);
  CHECK(json::parse(compared.out).at("max_of_span").get<double>() < 5e-4);
  CHECK(graph.files() == std::set<std::string>{"A.button.json", "B.button.json", "EF.button.json",
                                               "again.button.json", "b.csv"});
}

TEST_CASE("convert: a button file is rewritten byte for byte") {
  const Graph graph;
  CHECK(graph({"convert", "EF.button.json", "copy.button.json"}).exitCode == 0);
  CHECK(graph.read("copy.button.json") == graph.read("EF.button.json"));
  CHECK(graph({"convert", "EF.button.json", "EF.button.json"}).exitCode == 0);
  CHECK(graph.read("copy.button.json") == graph.read("EF.button.json"));
}

TEST_CASE("convert: SVG in the requested units") {
  const Graph graph;
  CHECK(graph({"convert", "B.button.json", "b.svg", "--force-unit", "gf", "--length-unit", "in"}).exitCode ==
        0);
  const std::string svg = graph.read("b.svg");
  CHECK_THAT(svg, Catch::Contains("Force (gf)") && Catch::Contains("Displacement (in)"));
  CHECK(graph({"convert", "B.button.json", "c.svg", "--force-unit", "furlong"}).exitCode == 2);
  CHECK(graph({"convert", "B.button.json", "c.svg", "--width", "nan"}).exitCode == 2);
  CHECK(graph({"convert", "B.button.json", "c.svg", "--height", "-1"}).exitCode == 2);
  CHECK(graph.files().count("c.svg") == 0);
}

TEST_CASE("a self-locking button's CSV needs its state named") {
  const Graph graph;
  const ProgramResult r = graph({"convert", "EF.button.json", "e.csv"});
  CHECK(r.exitCode == 5);
  CHECK(r.out.empty());
  CHECK(r.err ==
        "EF.button.json: the button has two states (unlocked, locked), but one was expected. Name one with "
        "--state.\n");
  CHECK(graph.files().count("e.csv") == 0);
  CHECK(graph({"convert", "EF.button.json", "e.csv", "--state", "locked"}).exitCode == 0);
  CHECK(graph.read("e.csv").find("press,2.5,0.05\n") != std::string::npos);
  CHECK(graph({"convert", "EF.button.json", "x.csv", "--state", "ajar"}).exitCode == 2);
  CHECK(graph({"compare", "EF.button.json", "A.button.json"}).exitCode == 5);
  CHECK(graph({"compare", "EF.button.json", "EF.button.json", "--state-a", "locked", "--state-b", "locked"})
            .out.find("mean 0.0000 %") != std::string::npos);
}

TEST_CASE("compare: mm, N and share of the span") {
  const Graph graph;
  graph.write("a.csv", "stroke,displacement_mm,force_N\npress,0,0\npress,4,0\npress,4,2\n");
  graph.write("b.csv", "stroke,displacement_mm,force_N\npress,0,0.2\npress,4,0.2\npress,4,2\n");
  const ProgramResult r = graph({"compare", "a.csv", "b.csv", "--json"});
  CHECK(r.exitCode == 0);
  const json object = json::parse(r.out);
  CHECK(object.at("span_mm") == 4);
  CHECK(object.at("span_N") == 2);
  CHECK(object.at("press").at("max_of_span").get<double>() == Approx(0.1));
  CHECK(object.at("press").at("max_N").get<double>() == Approx(0.2));
  CHECK_FALSE(object.contains("release"));
  CHECK_THAT(r.err, Catch::Contains("a.csv against b.csv: mean "));
}

TEST_CASE("failures: code, one sentence, nothing written, no old file lost") {
  const Graph graph;
  graph.write("broken.button.json", "{\n  \"format\": \"detent-button\",\n  oops");
  graph.write("newer.button.json", "{\"format\": \"detent-button\", \"version\": 99, \"states\": []}");
  graph.write("rows.csv", "stroke,displacement_mm,force_N\npress,0,nan\n");
  graph.write("empty.csv", "stroke,displacement_mm,force_N\n");
  graph.write("notes.txt", "hello");
  graph.write("old.csv", "kept");
  const auto before = graph.files();
  const std::vector<std::tuple<std::string, int, std::string>> cases = {
      {"missing.button.json", 3, "missing.button.json: the file does not exist."},
      {"broken.button.json", 3,
       "broken.button.json, line 3, column 3: the file is not valid JSON: \"oops\" cannot be read. Correct"},
      {"newer.button.json", 3,
       "newer.button.json, version: the file has version 99; this program reads versions up to "},
      {"rows.csv", 3, "rows.csv, line 2: force \"nan\" is not a usable number."},
      {"empty.csv", 4, "empty.csv: the file has a header but no rows."},
      {"notes.txt", 2, "notes.txt: the name does not end in .button.json, .csv or .svg."},
      {"plot.svg", 2, "plot.svg: this is a picture"}};
  for (const auto& [file, code, sentence] : cases) {
    INFO(file);
    for (const char* command : {"show", "check"}) {
      const ProgramResult r = graph({command, file});
      CHECK(r.exitCode == code);
      CHECK(r.out.empty());
      CHECK(r.err.rfind(sentence, 0) == 0);
      CHECK(std::count(r.err.begin(), r.err.end(), '\n') == 1);
    }
    const ProgramResult r = graph({"convert", file, "old.csv", "--json"});
    CHECK(r.exitCode == code);
    const json object = json::parse(r.out);
    CHECK(object.at("status") == "failed");
    CHECK(object.at("exit_code") == code);
    CHECK(object.at("message").get<std::string>() + "\n" == r.err);
    CHECK(graph({"compare", file, "A.button.json"}).exitCode == code);
  }
  CHECK(graph.read("old.csv") == "kept");
  CHECK(graph.files() == before);
}

TEST_CASE("outputs that cannot be written") {
  const Graph graph;
  CHECK(graph({"convert", "A.button.json", "no/folder/a.csv"}).exitCode == 2);
  CHECK(graph({"convert", "A.button.json", "a.txt"}).exitCode == 2);
  std::filesystem::create_directory(graph.path() / "folder.csv");
  CHECK_THAT(graph({"convert", "A.button.json", "folder.csv"}).err,
             Catch::Contains("this is a folder, not a file"));
}

TEST_CASE("wrong usage is exit 2, help is exit 0 and states units and defaults") {
  const Graph graph;
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{},
                                             {"fly"},
                                             {"show"},
                                             {"show", "a", "b"},
                                             {"show", "--what", "A.button.json"},
                                             {"convert", "A.button.json"}}) {
    const ProgramResult r = graph(arguments);
    CHECK(r.exitCode == 2);
    CHECK(r.out.empty());
    CHECK_FALSE(r.err.empty());
  }
  const ProgramResult help = graph({"--help"});
  CHECK(help.exitCode == 0);
  CHECK_THAT(help.out, Catch::Contains("mm") && Catch::Contains("Exit codes"));
  const ProgramResult convert = graph({"convert", "--help"});
  CHECK(convert.exitCode == 0);
  CHECK_THAT(convert.out, Catch::Contains("=N") && Catch::Contains("=640") && Catch::Contains("px"));
}

TEST_CASE("average: units become one button, the odd one is named; one unit is wrong usage") {
  const Graph graph;
  for (int i = 0; i < 5; ++i) {
    const double end_N = i == 3 ? 1.2 : 0.5 + 0.01 * i;
    graph.write("u" + std::to_string(i) + ".csv",
                "stroke,displacement_mm,force_N\npress,0,0.25\npress,2," + std::to_string(end_N) + "\n");
  }
  const ProgramResult r = graph(
      {"average", "u0.csv", "u1.csv", "u2.csv", "u3.csv", "u4.csv", "-o", "mean.button.json", "--json"});
  CHECK(r.exitCode == 0);
  const json object = json::parse(r.out);
  for (int i = 0; i < 5; ++i)
    CHECK(object.at("units").at(static_cast<std::size_t>(i)).at("outlier").get<bool>() == (i == 3));
  CHECK(object.at("states").at(0).at("figures").at("end_force_N").at("mean").get<double>() == Approx(0.654));
  CHECK(object.at("states").at(0).at("press_band").size() == 201);
  CHECK_THAT(r.err, Catch::Contains("u3.csv  OUTLIER"));
  const json mean = json::parse(graph({"show", "mean.button.json", "--json"}).out);
  CHECK(mean.at("states").at(0).at("figures").at("end_force_N").get<double>() == Approx(0.654));

  CHECK(graph({"average", "u0.csv", "-o", "one.button.json"}).exitCode == 2);
  CHECK(graph({"average", "u0.csv", "u1.csv", "-o", "one.csv"}).exitCode == 2);
  CHECK(graph({"average", "u0.csv", "none.csv", "-o", "one.button.json"}).exitCode == 3);
  CHECK_FALSE(std::filesystem::exists(graph.path() / "one.button.json"));
}
