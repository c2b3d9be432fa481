// SPDX-License-Identifier: GPL-3.0-or-later
// detent-import as a program: exit code, what it prints, what it leaves behind.

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sys/stat.h>

#include "tests/cli/run_program.h"
#include "tests/samples/two_switches.h"

using detent::tests::ProgramFolder;
using detent::tests::ProgramResult;
using nlohmann::json;
using Names = std::set<std::string>;

namespace {

const std::string plots = std::string(DETENT_SOURCE_DIR) + "/samples/plots/";
const std::string plot = plots + "two-level-legend.png";

std::string bytesOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

ProgramResult import(const ProgramFolder& folder, const std::vector<std::string>& arguments) {
  return folder.run(DETENT_IMPORT, arguments);
}

/// A failing import of a file with these bytes: its code, one sentence that names the file, and no output.
void refused(const std::string& name, const std::string& bytes, int exitCode, const std::string& words) {
  const ProgramFolder folder("import_refused");
  folder.write(name, bytes);
  INFO(name);
  const ProgramResult run =
      import(folder, {name, "-o", "b.button.json", "--csv", "b.csv", "--overlay", "b.png", "--json"});
  CHECK(run.exitCode == exitCode);
  CHECK_THAT(run.err, Catch::Contains(words, Catch::CaseSensitive::No));
  CHECK_THAT(run.err, Catch::Contains(name));
  const json report = json::parse(run.out);
  CHECK(report["exit_code"] == exitCode);
  CHECK_FALSE(report["remedy"].get<std::string>().empty());
  CHECK(folder.files() == Names{name});
}

/// A white 24-bit BMP: the smallest picture anyone can write by hand.
std::string whiteBmp(unsigned width, unsigned height) {
  const std::size_t row = (3 * width + 3) / 4 * 4;
  std::string bytes(54 + row * height, '\xff');
  const auto put = [&](std::size_t at, std::size_t value) {
    for (std::size_t i = 0; i < 4; ++i) bytes[at + i] = static_cast<char>(value >> (8 * i) & 255);
  };
  bytes[0] = 'B', bytes[1] = 'M';
  put(2, bytes.size()), put(6, 0), put(10, 54), put(14, 40), put(18, width), put(22, height);
  put(26, 1u | 24u << 16), put(30, 0), put(34, 0), put(38, 2835), put(42, 2835), put(46, 0), put(50, 0);
  return bytes;
}

/// A PDF of these objects, the catalogue first; readers rebuild the table that is missing.
std::string pdfOf(const std::vector<std::string>& objects, const std::string& trailerEntries = "") {
  std::string bytes = "%PDF-1.4\n";
  int number = 0;
  for (const std::string& object : objects) {
    ++number;
    bytes += std::to_string(number) + " 0 obj\n" + object + "\nendobj\n";
  }
  return bytes + "trailer\n<</Root 1 0 R" + trailerEntries + ">>\n%%EOF\n";
}

std::string pdfStream(const std::string& entries, const std::string& content) {
  return "<<" + entries + "/Length " + std::to_string(content.size()) + ">>\nstream\n" + content +
         "\nendstream";
}

/// `count` times the same page with this content; further objects from number 5.
std::string pdfPages(int count, const std::string& content, const std::string& resources = "",
                     const std::vector<std::string>& further = {}) {
  std::string kids;
  for (int i = 0; i < count; ++i) kids += "3 0 R ";
  std::vector<std::string> objects{
      "<</Type/Catalog/Pages 2 0 R>>",
      "<</Type/Pages/Kids[" + kids + "]/Count " + std::to_string(count) + ">>",
      "<</Type/Page/Parent 2 0 R/MediaBox[0 0 600 800]/Contents 4 0 R/Resources<<" + resources + ">>>>",
      pdfStream("", content)};
  objects.insert(objects.end(), further.begin(), further.end());
  return pdfOf(objects);
}

/// Forms that draw the next one 20 times, ten deep: 20^10 lines.
std::string formBomb() {
  const auto form = [](int next) {
    std::string content;
    for (int i = 0; i < 20; ++i) content += "/X Do ";
    return pdfStream("/Type/XObject/Subtype/Form/BBox[0 0 9 9]/Resources<</XObject<</X " +
                         std::to_string(next) + " 0 R>>>>",
                     content);
  };
  std::vector<std::string> forms;
  for (int next = 6; next < 16; ++next) forms.push_back(form(next));
  forms.push_back(pdfStream("/Type/XObject/Subtype/Form/BBox[0 0 9 9]", "0 0 m 9 9 l S"));
  return pdfPages(1, "/X Do", "/XObject<</X 5 0 R>>", forms);
}

/// Each reference draws the one before it eight times.
std::string svgBomb() {
  std::string svg =
      "<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink' width='9' "
      "height='9'>"
      "<g id='a0'><path d='M0 0L9 9' stroke='red'/></g>";
  for (int i = 1; i < 12; ++i) {
    svg += "<g id='a" + std::to_string(i) + "'>";
    for (int k = 0; k < 8; ++k) svg += "<use xlink:href='#a" + std::to_string(i - 1) + "'/>";
    svg += "</g>";
  }
  return svg + "</svg>";
}

/// The head of a BMP that promises far more pixels than it has.
std::string claimingBmp() {
  std::string bytes = whiteBmp(4, 4);
  const std::string huge("\xa0\x86\x01\x00", 4);  // 100000
  bytes.replace(18, 4, huge).replace(22, 4, huge);
  return bytes;
}

}  // namespace

TEST_CASE("Inputs that cannot be read are refused with one helpful sentence and nothing written") {
  refused("empty.png", "", 3, "empty");
  refused("text.png", "These are words, not pixels.\n", 3, "text.png");
  refused("lies.pdf", whiteBmp(40, 30).substr(0, 60), 3, "lies.pdf");
  refused("truncated.pdf", bytesOf(plots + "white-vector.pdf").substr(0, 300), 3, "truncated.pdf");
  refused("truncated.png", bytesOf(plot).substr(0, 2000), 3, "truncated.png");
}

TEST_CASE("Hostile inputs are refused with a sentence, in bounded time and memory") {
  refused("claims.bmp", claimingBmp(), 3, "100000 x 100000");
  // A fast machine reaches the limit of references, a slow one the limit of time: both say that it is not
  // drawn.
  refused("bomb.svg", svgBomb(), 3, "draw");
  refused("forms.pdf", formBomb(), 3, "too many objects");
  refused("pages.pdf", pdfPages(10000, "0 0 m 9 9 l S"), 3, "10000 pages");
  refused("circle.pdf", pdfOf({"<</Type/Catalog/Pages 2 0 R>>", "<</Type/Pages/Kids[2 0 R]/Count 1>>"}), 3,
          "damaged");
  const std::string id(32, '3'), key(64, '1');
  refused("locked.pdf",
          pdfOf({"<</Type/Catalog/Pages 2 0 R>>", "<</Type/Pages/Kids[3 0 R]/Count 1>>",
                 "<</Type/Page/Parent 2 0 R/MediaBox[0 0 9 9]>>",
                 "<</Filter/Standard/V 1/R 2/O<" + key + ">/U<" + key + ">/P -4>>"},
                "/Encrypt 4 0 R/ID[<" + id + "><" + id + ">]"),
          3, "password");
}

TEST_CASE("A missing file and a folder are no inputs") {
  const ProgramFolder folder("import_missing");
  for (const std::string input : {"missing.png", "."}) {
    const ProgramResult run = import(folder, {input, "-o", "b.button.json"});
    CHECK(run.exitCode == 3);
    CHECK_FALSE(run.err.empty());
    CHECK(folder.files().empty());
  }
}

TEST_CASE("A named pipe is refused at once, because nobody may ever write to it") {
  const ProgramFolder folder("import_pipe");
  for (const char* name : {"pipe", "pipe.csv", "pipe.png"})
    REQUIRE(mkfifo((folder.path() / name).c_str(), 0600) == 0);
  const std::string log = plots + "force-meter-log.csv";
  const std::vector<std::vector<std::string>> cases = {{"pipe", "-o", "b.button.json"},
                                                       {"pipe.csv"},
                                                       {"pipe.png"},
                                                       {"--list", "pipe"},
                                                       {"--pair", log, "pipe.csv"},
                                                       {"--family", log, "pipe"},
                                                       {"--all", "pipe"}};
  for (std::vector<std::string> words : cases) {
    INFO(words.front() << " " << words.back());
    words.insert(words.begin(), {"20", DETENT_IMPORT});
    const ProgramResult run = folder.run("timeout", words);
    CHECK(run.exitCode == 3);
    CHECK_THAT(run.err, Catch::Contains("pipe") && Catch::Contains("this is not an ordinary file"));
  }
  const std::vector<std::string> batch{"20",       DETENT_IMPORT, "--batch", "pipe",
                                       "pipe.csv", "--out-dir",   "out",     "--resume"};
  for (int run = 0; run < 2; ++run) CHECK(folder.run("timeout", batch).exitCode == 0);
  const std::string report = folder.read("out/report.jsonl");
  CHECK(std::count(report.begin(), report.end(), '\n') == 2);
  CHECK_THAT(report, Catch::Contains("\"exit_code\":3"));
}

TEST_CASE("An output that the disk refuses ends with the documented code and a true sentence") {
  const ProgramFolder folder("import_full");
  const auto inShell = [&](const std::string& before, const std::string& after,
                           std::vector<std::string> words) {
    words.insert(words.begin(), {"-c", before + " \"$0\" \"$@\" " + after, DETENT_IMPORT, plot});
    return folder.run("/bin/sh", words);
  };
  for (const char* option : {"-o", "--csv", "--trace-csv", "--overlay", "--dump-steps"}) {
    INFO(option);
    // the shell's limit on the size of files fails a write as a full disk does
    const ProgramResult run = inShell("trap '' XFSZ; ulimit -f 4;", "", {option, "out"});
    CHECK(run.exitCode == 1);
    CHECK_THAT(run.err, Catch::Contains("out: the file cannot be written: File too large. Check the folder"));
    CHECK(folder.files().empty());
  }
  const ProgramResult coded = inShell("trap '' XFSZ; ulimit -f 4;", "", {"-o", "out", "--json"});
  CHECK(json::parse(coded.out)["reason"] == "not_written");
  for (const char* words : {"--json", "--list"}) {
    INFO(words);
    const ProgramResult run = inShell("", ">/dev/full", {words});
    CHECK(run.exitCode == 1);
    CHECK_THAT(run.err, Catch::Contains("standard output cannot be written"));
  }
}

TEST_CASE("Pictures without a force graph are distinguished from broken ones") {
  refused("dot.bmp", whiteBmp(1, 1), 4, "no force graph");
  refused("blank.bmp", whiteBmp(640, 480), 4, "no force graph");
  refused("line.pdf", pdfPages(2, "0 0 m 600 800 l S"), 4, "no force graph");
  refused("itself.pdf",
          pdfPages(1, "/X Do", "/XObject<</X 5 0 R>>",
                   {pdfStream("/Type/XObject/Subtype/Form/BBox[0 0 9 9]/Resources<</XObject<</X 5 0 R>>>>",
                              "/X Do /X Do")}),
          4, "no force graph");
}

TEST_CASE("Force logs that cannot mean a stroke are refused") {
  refused("words.csv", "displacement_mm,force_N\nabc,def\n", 4, "words.csv");
  refused("one.csv", "displacement_mm,force_N\n1,2\n", 4, "one.csv");
  refused("nan.csv", "displacement_mm,force_N\n0,nan\n1,nan\n2,nan\n", 4, "nan.csv");
}

TEST_CASE("Wrong usage exits 2 and says how it is meant") {
  const ProgramFolder folder("import_usage");
  const auto says = [&](const std::vector<std::string>& arguments, const std::string& words) {
    const ProgramResult run = import(folder, arguments);
    CHECK(run.exitCode == 2);
    CHECK_THAT(run.err, Catch::Contains(words));
  };
  says({}, "INPUT");
  says({"a.png", "b.png"}, "--batch");
  says({"--batch", "a.png"}, "--out-dir");
  says({"a.png", "--no-overlays"}, "--batch");
  says({"a.png", "--x-axis", "4"}, "MIN:MAX");
  says({"a.png", "--x-axis", "4:4"}, "MIN:MAX");
  says({"a.png", "--y-unit", "stone"}, "unit of force");
  says({"a.png", "--press-color", "red"}, "#2a6099");
  says({"a.png", "--frame", "1,2,3"}, "X0,Y0,X1,Y1");
  says({"a.png", "--quality", "best"}, "--quality");
  says({"a.png", "--page", "0"}, "--page");
  says({"a.png", "--time-limit", "0"}, "--time-limit");
}

TEST_CASE("No output takes the place of an input or of another output") {
  const ProgramFolder folder("import_overwriting");
  folder.write("page.csv", "a\n");
  for (const std::vector<std::string>& outputs : {std::vector<std::string>{"-o", "page.csv"},
                                                  {"--csv", "./page.csv"},
                                                  {"--overlay", "sub/../page.csv"},
                                                  {"-o", "b.json", "--csv", "b.json"},
                                                  {"--trace-csv", "t", "--dump-steps", "./t"}}) {
    CAPTURE(outputs);
    std::vector<std::string> arguments = outputs;
    arguments.insert(arguments.begin(), "page.csv");
    const ProgramResult run = import(folder, arguments);
    CHECK(run.exitCode == 2);
    CHECK_THAT(run.err, Catch::Contains("names the file of"));
    CHECK(folder.files() == Names{"page.csv"});
    CHECK(bytesOf((folder.path() / "page.csv").string()) == "a\n");
  }
}

TEST_CASE("Help states units, defaults and exit codes") {
  const ProgramFolder folder("import_help");
  const ProgramResult help = import(folder, {"--help"});
  CHECK(help.exitCode == 0);
  for (const char* words : {"--x-axis", "points (1/72 in)", "Exit codes", "mm", "default"}) {
    CHECK_THAT(help.out, Catch::Contains(words));
  }
}

TEST_CASE("A plot becomes a button, a CSV, a trace and an overlay, with the JSON of the contract") {
  const ProgramFolder folder("import_plot");
  const ProgramResult run = import(folder, {plot, "-o", "b.button.json", "--csv", "b.csv", "--trace-csv",
                                            "t.csv", "--overlay", "o.png", "--json"});
  INFO(run.err);
  REQUIRE(run.exitCode == 0);
  const json report = json::parse(run.out);
  CHECK(report["status"] == "ok");
  for (const char* key : {"page", "graph", "x_axis", "y_axis", "press", "release", "travel_mm", "quality",
                          "seconds", "confidence", "warnings"}) {
    INFO(key);
    CHECK(report.contains(key));
  }
  for (const char* key : {"unit", "min", "max", "residual_px"}) CHECK(report["x_axis"].contains(key));

  // samples/plots/MANIFEST.md: button D, tactile points at 0.90 mm 0.800 N and 2.10 mm 1.600 N.
  const json tactile = report["press"]["tactile_points"];
  REQUIRE(tactile.size() == 2);
  CHECK(tactile[0]["displacement_mm"].get<double>() == Approx(0.90).margin(0.03));
  CHECK(tactile[0]["force_N"].get<double>() == Approx(0.80).margin(0.01));
  CHECK(tactile[1]["displacement_mm"].get<double>() == Approx(2.10).margin(0.03));
  CHECK(tactile[1]["force_N"].get<double>() == Approx(1.60).margin(0.01));
  CHECK(tactile[0]["sigma_mm"].get<double>() > 0);
  CHECK(tactile[0]["sigma_N"].get<double>() > 0);

  CHECK(folder.read("b.csv").rfind("stroke,displacement_mm,force_N\npress,", 0) == 0);
  CHECK(folder.read("t.csv").rfind("stroke,displacement_mm,force_N\npress,", 0) == 0);
  CHECK(folder.read("o.png").substr(1, 3) == "PNG");
  const json button = json::parse(folder.read("b.button.json"));
  CHECK(button["format"] == "detent-button");
  CHECK(folder.files() == Names{"b.button.json", "b.csv", "o.png", "t.csv"});
}

TEST_CASE("An import that is not certain enough writes its overlay, complete, and nothing else") {
  const ProgramFolder folder("import_refused_overlay");
  const ProgramResult run = import(
      folder, {plot, "--sure", "1", "-o", "b.button.json", "--csv", "b.csv", "--overlay", "o.png", "--json"});
  CHECK(run.exitCode == 5);
  CHECK_THAT(run.err, Catch::Contains("wrote o.png"));
  CHECK(folder.files() == Names{"o.png"});
  CHECK(folder.read("o.png").substr(1, 3) == "PNG");
}

TEST_CASE("A limit on time leaves what was read until then, marked, or nothing and a sentence") {
  const ProgramFolder folder("import_time_limit");
  const std::vector<std::string> precisely{plot, "--quality", "precise", "-o", "b.button.json", "--json"};
  const auto limited = [&](const char* seconds) {
    auto arguments = precisely;
    arguments.insert(arguments.end(), {"--time-limit", seconds});
    return import(folder, arguments);
  };
  const ProgramResult none = limited("0.01");
  CHECK(none.exitCode == 3);
  CHECK_THAT(none.err, Catch::Contains("two-level-legend.png") && Catch::Contains("0.01 s") &&
                           Catch::Contains("raise the limit"));
  CHECK(folder.files().empty());

  const ProgramResult enough = limited("3600");
  REQUIRE(enough.exitCode == 0);
  const json report = json::parse(enough.out);
  CHECK_FALSE(report.contains("ended_by_time_limit"));
  REQUIRE(report["looks"].size() == 2);
  CHECK(report["looks"][0]["taken"] == true);
  CHECK(report["looks"][1]["travel_mm"].get<double>() ==
        Approx(report["travel_mm"].get<double>()).epsilon(0.01));
}

TEST_CASE("The same import twice writes the same bytes") {
  const ProgramFolder folder("import_twice");
  REQUIRE(import(folder, {plot, "-o", "1.button.json", "--csv", "1.csv"}).exitCode == 0);
  REQUIRE(import(folder, {plot, "-o", "2.button.json", "--csv", "2.csv"}).exitCode == 0);
  CHECK(folder.read("1.button.json") == folder.read("2.button.json"));
  CHECK(folder.read("1.csv") == folder.read("2.csv"));
}

TEST_CASE("What is given by hand is kept, changes what depends on it, and is recorded") {
  const ProgramFolder folder("import_hints");
  const ProgramResult found = import(folder, {plot, "--json"});
  const ProgramResult given =
      import(folder, {plot, "--y-axis", "0:5.6", "--y-unit", "N", "-o", "b.button.json", "--json"});
  INFO(given.err);
  REQUIRE(found.exitCode == 0);
  REQUIRE(given.exitCode == 0);
  const auto tactileForce = [](const ProgramResult& run) {
    return json::parse(run.out)["press"]["tactile_points"][0]["force_N"].get<double>();
  };
  CHECK(tactileForce(given) == Approx(2 * tactileForce(found)).epsilon(0.01));  // the axis ends at 2.8 N
  CHECK_THAT(given.out + given.err, Catch::Contains("contradict the numbers printed there"));
  CHECK_THAT(folder.read("b.button.json"), Catch::Contains("--y-axis"));

  const ProgramResult swapped = import(folder, {plot, "--swap-strokes", "--csv", "s.csv"});
  CHECK(swapped.exitCode == 0);
}

TEST_CASE("--list shows where the graph is and how its axes read") {
  const ProgramFolder folder("import_list");
  const ProgramResult run = import(folder, {"--list", plots + "white-vector.pdf", "--json"});
  INFO(run.err);
  REQUIRE(run.exitCode == 0);
  const json graphs = json::parse(run.out)["graphs"];
  REQUIRE(graphs.size() == 1);
  CHECK(graphs[0]["page"] == 1);
  CHECK(graphs[0]["graph"] == 1);
  CHECK(graphs[0]["frame_pt"].size() == 4);
  CHECK(graphs[0]["x_axis"]["unit"] == "mm");
  CHECK(graphs[0]["y_axis"]["unit"] == "cN");
  CHECK(graphs[0]["y_axis"]["max"].get<double>() == Approx(100).margin(0.5));
}

TEST_CASE("curves that make no pair beside a second scale of forces are refused for that scale") {
  const ProgramFolder folder("import_two_scales");
  std::string svg = detent::tests::twoSwitchesSvg();
  svg.erase(svg.find("<line x1='620'"));  // the legend
  const auto text = [](double y, const std::string& words) {
    return "<text font-family='sans-serif' font-size='14' x='590' y='" + std::to_string(y) + "'>" + words +
           "</text>";
  };
  for (int i = 0; i <= 6; ++i)
    svg += text(405 - 60 * i, std::to_string(i * 4 / 10) + "." + std::to_string(i * 4 % 10));
  svg +=
      "<text font-family='sans-serif' font-size='14' transform='translate(640,220) rotate(-90)' "
      "text-anchor='middle'>Force (N)</text></svg>";
  folder.write("two.svg", svg);
  const ProgramResult refused = import(folder, {"two.svg"});
  CHECK(refused.exitCode == 5);
  CHECK_THAT(refused.err, Catch::Contains("and it also measures forces. Import a graph"));
}

TEST_CASE("--list and the import name what a plot measures in place of a force") {
  const ProgramFolder folder("import_list_other");
  std::string svg = detent::tests::twoSwitchesSvg();
  const std::string title = "Force (N)";
  REQUIRE(svg.find(title) != std::string::npos);
  svg.replace(svg.find(title), title.size(), "Inductance (H)");
  folder.write("other.svg", svg);
  const char* const said = "the y axis cannot be used: it measures \"inductance (H)\"";
  const ProgramResult listed = import(folder, {"--list", "other.svg", "--json"});
  CHECK(listed.exitCode == 4);
  CHECK(json::parse(listed.out)["graphs"].empty());
  CHECK_THAT(listed.err, Catch::Contains(said));
  CHECK_THAT(import(folder, {"other.svg"}).err, Catch::Contains(said));

  folder.write("none.svg", "<svg xmlns='http://www.w3.org/2000/svg' width='90' height='90'/>");
  CHECK_THAT(import(folder, {"--list", "none.svg", "--json"}).err, Catch::Contains("no force graph found"));
}

TEST_CASE("Of several switches in one plot --curve takes one, by name or number") {
  const ProgramFolder folder("import_curve");
  folder.write("two.svg", detent::tests::twoSwitchesSvg());
  const ProgramResult listed = import(folder, {"--list", "two.svg", "--json"});
  INFO(listed.err);
  REQUIRE(listed.exitCode == 0);
  const json curves = json::parse(listed.out)["graphs"][0]["curves"];
  REQUIRE(curves.size() == 2);
  CHECK(curves[0] ==
        json{{"curve", 1}, {"name", "Brown"}, {"press_color", "#c8102e"}, {"release_color", "#0b5cad"}});
  CHECK(curves[1] == json{{"curve", 2}, {"name", "Red"}, {"press_color", "#2e8b37"}});
  CHECK_THAT(import(folder, {"--list", "two.svg"}).out,
             Catch::Contains("curve 1 \"Brown\"  press #c8102e  release #0b5cad"));

  const ProgramResult unasked = import(folder, {"two.svg", "-o", "b.button.json", "--json"});
  CHECK(unasked.exitCode == 5);
  CHECK_THAT(unasked.err, Catch::Contains("1 \"Brown\"") && Catch::Contains("2 \"Red\" (#2e8b37)") &&
                              Catch::Contains("--curve"));
  CHECK(json::parse(unasked.out)["reason"] == "several-switches");
  CHECK(json::parse(unasked.out)["curves"] == curves);
  const json question = json::parse(unasked.out)["question"];
  CHECK(question["what"] == "which switch should be read");
  REQUIRE(question["choices"].size() == 2);
  CHECK(question["choices"][0] == json{{"text", "Brown (#c8102e)"}, {"option", "--curve 1"}});
  CHECK(question["choices"][1] == json{{"text", "Red (#2e8b37)"}, {"option", "--curve 2"}});
  CHECK(folder.files() == Names{"two.svg"});

  const auto imported = [&](const std::string& curve) {
    const ProgramResult run = import(folder, {"two.svg", "--curve", curve, "-o", "b.button.json", "--json"});
    INFO(run.err);
    REQUIRE(run.exitCode == 0);
    return json::parse(run.out);
  };
  const json brown = imported("Brown"), red = imported("red");
  CHECK(brown["curve"] == json{{"number", 1}, {"name", "Brown"}, {"of", 2}});
  CHECK(brown.contains("release"));
  CHECK_FALSE(red.contains("release"));
  CHECK(brown["press"]["tactile_points"][0]["force_N"].get<double>() == Approx(0.8).margin(0.01));
  CHECK(red["press"]["tactile_points"][0]["force_N"].get<double>() == Approx(0.6).margin(0.01));
  CHECK_THAT(folder.read("b.button.json"), Catch::Contains("--curve red") && Catch::Contains("two Red"));
  CHECK(imported("2")["curve"]["name"] == "Red");

  for (const char* wrong : {"Blue", "3", "0"}) {
    const ProgramResult run = import(folder, {"two.svg", "--curve", wrong, "-o", "c.button.json"});
    CHECK(run.exitCode == 2);
    CHECK_THAT(run.err, Catch::Contains("\"Brown\"") && Catch::Contains(std::string("\"") + wrong + "\""));
  }
  CHECK(folder.files() == Names{"two.svg", "b.button.json"});
  const ProgramResult only = import(folder, {plot, "--curve", "1", "--json"});
  CHECK(only.exitCode == 0);  // a plot of one switch has a first one
  CHECK_FALSE(json::parse(only.out).contains("curve"));
}

TEST_CASE("A force meter's log becomes the same button as its plot") {
  const ProgramFolder folder("import_log");
  const ProgramResult run = import(folder, {plots + "force-meter-log.csv", "-o", "b.button.json", "--json"});
  INFO(run.err);
  REQUIRE(run.exitCode == 0);
  const json tactile = json::parse(run.out)["press"]["tactile_points"];
  REQUIRE(tactile.size() == 1);  // button C
  CHECK(tactile[0]["displacement_mm"].get<double>() == Approx(1.60).margin(0.05));
  CHECK(tactile[0]["force_N"].get<double>() == Approx(0.65).margin(0.01));

  const ProgramResult drawn = import(folder, {plots + "force-meter-log.csv", "--overlay", "o.png"});
  CHECK(drawn.exitCode == 0);
  CHECK_THAT(drawn.out, Catch::Contains("warning: o.png is not written, because a table has no page"));
}

TEST_CASE("A batch handles every input, whatever happens to one, and resumes") {
  const ProgramFolder folder("import_batch");
  folder.write("broken.png", "not a picture");
  const ProgramResult run =
      import(folder, {"--batch", plot, "broken.png", "--out-dir", "out", "--jobs", "2"});
  INFO(run.err);
  REQUIRE(run.exitCode == 0);
  std::istringstream report(folder.read("out/report.jsonl"));
  std::string first, second, none;
  REQUIRE(std::getline(report, first));
  REQUIRE(std::getline(report, second));
  CHECK_FALSE(std::getline(report, none));
  CHECK(json::parse(first)["status"] == "ok");
  CHECK(json::parse(second)["exit_code"] == 3);
  CHECK(folder.read("out/two-level-legend.button.json").size() > 100);
  CHECK_THAT(run.out, Catch::Contains("accepted: 1 at --sure 0.5, 1 at --sure 0.8"));
  const double sure = json::parse(first)["confidence"];
  CHECK_THAT(run.out, Catch::Contains(sure < 0.99 ? "0 at --sure 0.99" : "1 at --sure 0.99"));
  CHECK(json::parse(first)["page_class"] == "picture");

  const ProgramResult again = import(folder, {"--batch", plot, "broken.png", "--out-dir", "out", "--resume"});
  CHECK(again.exitCode == 0);
  CHECK_THAT(again.out, Catch::Contains("0 inputs handled, 0 failed, 2 already done"));

  CHECK(std::filesystem::exists(folder.path() / "out/two-level-legend.overlay.png"));
  REQUIRE(import(folder, {"--batch", plot, "--out-dir", "bare", "--no-overlays"}).exitCode == 0);
  CHECK_FALSE(std::filesystem::exists(folder.path() / "bare/two-level-legend.overlay.png"));
  CHECK(folder.read("bare/two-level-legend.button.json") == folder.read("out/two-level-legend.button.json"));
}

TEST_CASE("A batch takes its inputs from a list and repeats what is no longer the same") {
  const ProgramFolder folder("import_list");
  folder.write("first.txt", "not a picture");
  folder.write("second.txt", "nor this");
  folder.write("list", "first.txt\r\n\nsecond.txt\n");
  const auto again = [&](std::vector<std::string> more) {
    std::vector<std::string> words{"--batch", "@list", "--out-dir", "out", "--resume"};
    words.insert(words.end(), more.begin(), more.end());
    const ProgramResult run = import(folder, words);
    REQUIRE(run.exitCode == 0);
    return run.out.substr(0, run.out.find(';'));
  };
  CHECK(again({}) == "2 inputs handled, 2 failed, 0 already done");
  const std::string report = folder.read("out/report.jsonl");
  CHECK(std::count(report.begin(), report.end(), '\n') == 2);
  CHECK(again({"--jobs", "1"}) == "0 inputs handled, 0 failed, 2 already done");
  folder.write("second.txt", "changed");
  CHECK(again({}) == "1 inputs handled, 1 failed, 1 already done");
  CHECK(again({"--quality", "draft"}) == "2 inputs handled, 2 failed, 0 already done");

  SECTION("half a line of a batch that was killed is made anew") {
    folder.write("out/report.jsonl", report.substr(0, report.size() - 7));
    const std::string journal = folder.read("out/report.done");
    folder.write("out/report.done", journal.substr(0, journal.size() - 7));
    CHECK(again({"--quality", "draft"}) == "1 inputs handled, 1 failed, 1 already done");
    CHECK(folder.read("out/report.jsonl") == report);
  }
  SECTION("lines that a power cut took from the report alone are made anew") {
    folder.write("out/report.jsonl", report.substr(0, report.find('\n') + 1));
    CHECK(again({"--quality", "draft"}) == "1 inputs handled, 1 failed, 1 already done");
    CHECK(folder.read("out/report.jsonl") == report);
    folder.write("out/report.jsonl", "");
    CHECK(again({"--quality", "draft"}) == "2 inputs handled, 2 failed, 0 already done");
    CHECK(folder.read("out/report.jsonl") == report);
  }
  SECTION("a disk that takes no more ends the batch by name") {
    std::filesystem::create_directories(folder.path() / "full");
    std::filesystem::create_symlink("/dev/full", folder.path() / "full/report.jsonl");
    const ProgramResult full = import(folder, {"--batch", "@list", "--out-dir", "full"});
    CHECK(full.exitCode == 1);
    CHECK_THAT(full.err, Catch::Contains("full/report.jsonl"));
    CHECK(folder.read("full/report.done").empty());
  }
  SECTION("a list that is not there is wrong usage") {
    const ProgramResult none = import(folder, {"--batch", "@absent", "--out-dir", "out"});
    CHECK(none.exitCode == 2);
    CHECK_THAT(none.err, Catch::Contains("absent"));
  }
}

TEST_CASE("Results that cannot be written end a batch and are made anew") {
  const ProgramFolder folder("import_unwritable");
  const auto inTheWay = folder.path() / "out/two-level-legend.csv";
  std::filesystem::create_directories(inTheWay / "full");
  const std::string log = plots + "force-meter-log.csv";
  const auto batch = [&] {
    return import(folder, {"--batch", plot, log, "--out-dir", "out", "--resume", "--quality", "draft"});
  };
  const ProgramResult run = batch();
  CHECK(run.exitCode == 1);
  CHECK_THAT(run.err, Catch::Contains("two-level-legend.png") && Catch::Contains("--resume"));
  CHECK(folder.read("out/report.jsonl").empty());
  CHECK(folder.read("out/report.done").empty());

  std::filesystem::remove_all(inTheWay);
  const ProgramResult again = batch();
  CHECK(again.exitCode == 0);
  CHECK_THAT(again.out, Catch::Contains("2 inputs handled, 0 failed, 0 already done"));
}

TEST_CASE("Two inputs of one name get results of their own") {
  const ProgramFolder folder("import_names");
  std::filesystem::create_directories(folder.path() / "a");
  std::filesystem::create_directories(folder.path() / "b");
  folder.write("a/p.png", bytesOf(plot));
  folder.write("b/p.png", bytesOf(plot));
  REQUIRE(import(folder, {"--batch", "a/p.png", "b/p.png", "--out-dir", "out"}).exitCode == 0);
  CHECK_FALSE(folder.read("out/a-p.button.json").empty());
  CHECK_FALSE(folder.read("out/b-p.button.json").empty());
}

TEST_CASE("No results are written over those of a page that is kept") {
  const ProgramFolder folder("import_kept_names");
  for (const char* parent : {"v", "w", "x"}) {
    std::filesystem::create_directories(folder.path() / parent / "q");
    folder.write(std::string(parent) + "/q/p.csv", bytesOf(plots + "force-meter-log.csv"));
  }
  const auto batch = [&](std::vector<std::string> words) {
    words.insert(words.begin(), "--batch");
    words.insert(words.end(), {"--out-dir", "out", "--resume", "--quality", "draft"});
    REQUIRE(import(folder, words).exitCode == 0);
  };
  batch({"w/q/p.csv", "x/q/p.csv"});
  batch({"v/q/p.csv", "w/q/p.csv", "x/q/p.csv"});
  std::vector<std::string> buttons;
  std::istringstream report(folder.read("out/report.jsonl"));
  for (std::string line; std::getline(report, line);)
    buttons.push_back(json::parse(line)["input"].get<std::string>() + " " +
                      json::parse(line)["outputs"][0].get<std::string>());
  CHECK(buttons == std::vector<std::string>{"v/q/p.csv out/q-p.button.json",
                                            "w/q/p.csv out/q-p-2.button.json",
                                            "x/q/p.csv out/q-p-3.button.json"});
}

TEST_CASE("A resumed batch keeps the lines of pages whose names are no UTF-8") {
  const ProgramFolder folder("import_bytes_in_names");
  for (const char* name : {"\xff.txt", "\xfe.txt", "z.txt"}) folder.write(name, "not a picture");
  const auto batch = [&] {
    REQUIRE(import(folder, {"--batch", "\xff.txt", "\xfe.txt", "z.txt", "--out-dir", "out", "--resume"})
                .exitCode == 0);
    return folder.read("out/report.jsonl");
  };
  const std::string first = batch();
  CHECK(std::count(first.begin(), first.end(), '\n') == 3);
  CHECK(batch() == first);
  folder.write("z.txt", "changed");
  CHECK(batch() == first);
}

TEST_CASE("an SVG without the program that draws it is refused by that program's name") {
  const ProgramFolder folder("import_without_worker");
  const std::string alone = (folder.path() / "detent-import").string();
  std::filesystem::copy_file(DETENT_IMPORT, alone);
  std::filesystem::copy_file(plots + "black-inch-ounce.svg", folder.path() / "plot.svg");
  const ProgramResult run = folder.run(alone, {"plot.svg", "--json"});
  CHECK(run.exitCode == 3);
  CHECK_THAT(run.err, Catch::Contains("detent-svg-worker"));
  CHECK(import(folder, {"plot.svg", "--json"}).exitCode == 0);
}
