// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/text.h"

#include <catch2/catch.hpp>

#include "model/named_values.h"

using namespace detent;

TEST_CASE("blanks go from both ends, and from there alone") {
  CHECK(trimmed(" \t a b\r\n") == "a b");
  CHECK(trimmed("ab") == "ab");
  CHECK(trimmed(" \f\v ").empty());
  CHECK(trimmed("").empty());
}

TEST_CASE("letters of the alphabet alone become small") {
  CHECK(lowered("AZaz09 \xC3\x84[@") == "azaz09 \xC3\x84[@");
}

TEST_CASE("UTF-8 is distinguished from other bytes") {
  for (const char* text :
       {"", "plain", "\xC3\xA4", "\xE2\x82\xAC", "\xED\x9F\xBF", "\xF4\x8F\xBF\xBF", "a\xF0\x9F\x94\x98z"})
    CHECK(isUtf8(text));
  const std::pair<const char*, const char*> wrong[] = {{"\x80", "a continuation alone"},
                                                       {"\xC3", "cut off"},
                                                       {"\xE2\x82", "cut off"},
                                                       {"\xC0\xAF", "overlong"},
                                                       {"\xE0\x80\xAF", "overlong"},
                                                       {"\xF0\x80\x80\xAF", "overlong"},
                                                       {"\xED\xA0\x80", "half a surrogate"},
                                                       {"\xF4\x90\x80\x80", "beyond Unicode"},
                                                       {"\xFF", "no lead"},
                                                       {"\xC3z", "no continuation"}};
  for (const auto& [text, why] : wrong) {
    INFO(why);
    CHECK_FALSE(isUtf8(text));
  }
}

TEST_CASE("a word stands for its value and back, another one for none") {
  enum class Light { red, green, off };
  constexpr auto lights = named<Light>({{"red", Light::red}, {"green", Light::green}});
  static_assert(lights.value("green") == Light::green);
  CHECK(std::string(lights.word(Light::red)) == "red");
  CHECK(std::string(lights.word(Light::off)).empty());
  CHECK_FALSE(lights.value("Red"));
  CHECK_FALSE(lights.value(""));
}
