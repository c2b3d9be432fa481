// SPDX-License-Identifier: GPL-3.0-or-later
// The model with renamed letters: a container made by hand goes in and comes out, junk is refused.

#include "importer/axes/light_model.h"

#include <cstring>

#include <catch2/catch.hpp>

using namespace detent::importer;

namespace {

constexpr int parts = 24, letterList = 21, wordList = 19;

/// A .traineddata of a list of letters, a word list and one part more.
std::string container(const std::string& letters) {
  std::string data(4 + 8 * parts, '\0');
  const auto put = [&](int part, const std::string& bytes) {
    const auto at = static_cast<std::int64_t>(data.size());
    std::memcpy(data.data() + 4 + 8 * part, &at, sizeof at);
    data += bytes;
  };
  const std::int32_t count = parts;
  std::memcpy(data.data(), &count, sizeof count);
  const std::int64_t absent = -1;
  for (int part = 0; part < parts; ++part) std::memcpy(data.data() + 4 + 8 * part, &absent, sizeof absent);
  put(17, "NETWORK");
  put(wordList, std::string(5000, 'w'));
  put(letterList, letters);
  return data;
}

const std::string letters =
    "5\nNULL 0 Common 0\nJoined 7 0,255 Latin 1 0 1 Joined\t# Joined\n|Broken|0|1 f 0,255 Common 2 10 2 "
    "|Broken|0|1\n"
    "8 8 0,255 Common 14 2 14 8\t# 8 [38 ]0\n\xC2\xB0 0 0,255 Common 15 2 15 \xC2\xB0\t# degree\n";

}  // namespace

TEST_CASE("letters are renamed, and answers come back as written") {
  const auto model = LightModel::from(container(letters));
  REQUIRE(model);
  CHECK(model->bytes().find("NETWORK") != std::string::npos);
  CHECK(model->bytes().find("wwww") == std::string::npos);  // never loaded
  CHECK(model->bytes().find("\n8 8 ") == std::string::npos);
  CHECK(model->bytes().find("Joined 7 0,255") != std::string::npos);  // known to the engine by name
  CHECK(model->bytes().find("\xEE\x84\x83 8 0,255 Common 14 2 14 \xEE\x84\x83\n") != std::string::npos);
  CHECK(model->renamed("8x") == "\xEE\x84\x83");
  CHECK(model->original("\xEE\x84\x83 \xEE\x84\x84\n") == "8 \xC2\xB0\n");
  CHECK(model->original("\xEE\xBF\xBF") == "\xEE\xBF\xBF");  // none of ours
}

TEST_CASE("what is no model is refused") {
  const std::string whole = container(letters);
  CHECK_FALSE(LightModel::from(""));
  CHECK_FALSE(LightModel::from("junk that is longer than a count"));
  CHECK_FALSE(LightModel::from(std::string_view(whole).substr(0, 100)));
  CHECK_FALSE(LightModel::from(container("3\nnothing\n")));
  for (std::size_t cut = 4; cut < whole.size(); cut += 97)
    LightModel::from(std::string_view(whole).substr(0, cut));
}
