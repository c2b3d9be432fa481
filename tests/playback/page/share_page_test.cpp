// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/page/share_page.h"

#include <catch2/catch.hpp>

#include "model/file/button_file.h"
#include "model/speed_family.h"
#include "playback/page/button_numbers.h"

using namespace detent;
using namespace detent::playback;

namespace {

Button sample(const std::string& name) {
  return readButtonFile(DETENT_SOURCE_DIR "/samples/buttons/" + name + ".button.json").value();
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

}  // namespace

TEST_CASE("A button comes back from its numbers as it was, bit for bit") {
  for (const char* name : {"A", "B", "C", "D", "E", "EF", "F", "latch", "push"}) {
    INFO(name);
    const Button button = sample(name);
    const Result<Button> back = buttonFrom(numbersOf(button));
    REQUIRE(back.ok());
    REQUIRE(back->states().size() == button.states().size());
    for (std::size_t i = 0; i < button.states().size(); ++i) {
      CHECK(back->states()[i].graph == button.states()[i].graph);
      CHECK(back->states()[i].operatingPoint_mm == button.states()[i].operatingPoint_mm);
      CHECK(back->states()[i].resetPoint_mm == button.states()[i].resetPoint_mm);
    }
  }
}

TEST_CASE("A button with graphs at several speeds comes back from its numbers, or not at all") {
  for (const char* name : {"B", "latch"}) {
    const Button family = familyOf({sample(name), sample(name), sample(name)}, {50, 10, 200}).value();
    const std::vector<double> numbers = numbersOf(family);
    const Result<Button> back = buttonFrom(numbers);
    REQUIRE(back.ok());
    CHECK(speedsOf(*back) == std::vector<double>{10, 50, 200});
    for (std::size_t i = 0; i < family.states().size(); ++i) {
      CHECK(back->states()[i].speed_mm_per_s == family.states()[i].speed_mm_per_s);
      CHECK(back->states()[i].otherSpeeds == family.states()[i].otherSpeeds);
    }
    const std::size_t whole = numbersOf(sample(name)).size();
    for (std::size_t cut = whole + 1; cut < numbers.size(); ++cut)
      CHECK_FALSE(buttonFrom({numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(cut)}).ok());
    for (const double wrong : {-1.0, 0.5, 4.0, std::numeric_limits<double>::quiet_NaN()}) {
      std::vector<double> damaged = numbers;
      damaged[whole] = wrong;  // number of other speeds
      CHECK_FALSE(buttonFrom(damaged).ok());
    }
  }
}

TEST_CASE("Numbers that are no button are refused") {
  std::vector<double> numbers = numbersOf(sample("B"));
  for (std::size_t cut = 0; cut < numbers.size(); ++cut)
    CHECK_FALSE(buttonFrom({numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(cut)}).ok());
  std::vector<double> more = numbers;
  more.push_back(0);
  CHECK_FALSE(buttonFrom(more).ok());
  for (const double wrong : {-1.0, 0.5, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
    std::vector<double> damaged = numbers;
    damaged[3] = wrong;  // number of press knots
    CHECK_FALSE(buttonFrom(damaged).ok());
  }
}

TEST_CASE("A page is complete in itself, and a name is text wherever it stands") {
  if (!hasPageEngine()) {
    WARN("SKIPPED: this build has no engine for browsers");
    return;
  }
  const std::string hostile = "</script><script>alert(1)</script><!-- @DATA@ \xFF";
  const Button button = Button::fromStates(hostile, sample("B").states()).value();
  const Result<std::string> page = sharePage({button, sample("A")});
  REQUIRE(page.ok());
  CHECK(count(*page, "alert(1)</script>") == 0);
  CHECK(count(*page, "<script") == count(*page, "</script>"));
  CHECK(count(*page, "http://") == count(*page, "http://www.w3.org/2000/svg"));
  CHECK(count(*page, "https://") == 0);
  for (const char* part : {"@TITLE@", "@STYLE@", "@VERSION@", "@ENGINE@", "@WORKLET@", "@SCRIPT@"})
    CHECK(count(*page, part) == 0);
}

TEST_CASE("None and ten buttons are refused with what a page holds") {
  const std::vector<Button> ten(10, sample("A"));
  CHECK(sharePage({}).failure().exitCode() == 2);
  CHECK(sharePage(ten).failure().exitCode() == 2);
}
