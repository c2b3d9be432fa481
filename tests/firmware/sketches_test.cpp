// SPDX-License-Identifier: GPL-3.0-or-later
// The sketches of samples/firmware, compiled with Arduino's AVR core, on simulated boards:
// docs/reference/force-protocol.md and docs/reference/serial-protocol.md line by line.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/firmware/simulated_board.h"

using namespace detent::firmware;
using Catch::Matchers::StartsWith;

namespace {

std::string sketch(const char* name, const BoardKind& kind) {
  return std::string(DETENT_SKETCHES) + "/" + name + "-" + kind.name + ".elf";
}

std::vector<std::string> fieldsOf(const std::string& body) {
  std::vector<std::string> fields;
  std::istringstream text(body);
  for (std::string field; std::getline(text, field, ',');) fields.push_back(field);
  return fields;
}

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

constexpr double newtonsAtFullDuty = 5.1;  // force1d's fullDuty_uN
constexpr const char* limits3N = "L,3000000,5000000,2000000,200,15";

/// force1d after its start, with the switch closed.
struct ForceBoard : SimulatedBoard {
  explicit ForceBoard(const BoardKind& which) : SimulatedBoard(which, sketch("force1d", which)), kind(which) {
    run_us(100000);
    take();
  }
  double force_N() const { return duty() * newtonsAtFullDuty * (pinIsHigh(kind.direction) ? -1 : 1); }
  /// Time until the PWM pin gives nothing, or `most_us`.
  double untilNoForce_us(double most_us) {
    const double began_us = time_us();
    while (duty() > 0 && time_us() < began_us + most_us) run_us(50);
    return time_us() - began_us;
  }
  /// Sends `F` or `H` the given number of times, `every_us` apart; returns the last answer.
  std::string keepAsking(const std::string& letterAndForce, int times, double every_us = 4000) {
    std::string answer;
    for (int i = 0; i < times; ++i) {
      const double next_us = time_us() + every_us;
      std::string body = letterAndForce;
      body.insert(1, "," + std::to_string(i));
      answer = ask(body);
      run_us(std::max(0.0, next_us - time_us()));
    }
    return answer;
  }
  /// The encoder's two lines through so many quarter turns of the pattern, half of which force1d counts.
  void turn(int counts, double every_us) {
    for (int i = 0; i < std::abs(counts); ++i) {
      const bool forwards = counts > 0;
      // B leads by a quarter on the way in, A on the way out: A and B are equal after an edge of A when
      // pressing.
      if (forwards) setPin(kind.encoderB, !a_);
      run_us(every_us / 2);
      a_ = !a_;
      setPin(kind.encoderA, a_);
      run_us(every_us / 2);
      if (!forwards) setPin(kind.encoderB, a_);
    }
  }
  const BoardKind& kind;

 private:
  bool a_ = false;
};

std::string stateOf(const std::string& answer) {
  const auto fields = fieldsOf(answer);
  return fields.size() == 5 && fields[0] == "P" ? fields[4] : "no answer: " + answer;
}

double positionOf_mm(const std::string& answer) {
  const auto fields = fieldsOf(answer);
  REQUIRE(fields.size() == 5);
  return 1e-6 * std::stod(fields[3]);
}

}  // namespace

TEST_CASE("fsr400: a thousand readings a second with checksums, through the wrap of the clock") {
  for (const BoardKind* kind : {&uno, &mega}) {
    INFO(kind->name);
    SimulatedBoard board(*kind, sketch("fsr400", *kind));
    board.setAnalog_mV(0, 2500);
    board.run_us(100000);
    CHECK_THAT(board.take(), StartsWith("# detent-force 1 fsr400 divider 1023\r\n"));
    board.wrapClockIn(300000);
    board.take();
    board.run_us(1000000);
    const auto lines = linesOf(board.take());
    CHECK(std::abs(static_cast<int>(lines.size()) - 1000) <= 1);
    std::vector<std::uint32_t> times_us;
    for (std::size_t i = 1; i + 1 < lines.size(); ++i) {
      const std::string body = lines[i].substr(0, lines[i].find('*'));
      REQUIRE(lineOf(body) == lines[i] + "\n");
      const auto fields = fieldsOf(body);
      REQUIRE(fields.size() == 2);
      times_us.push_back(static_cast<std::uint32_t>(std::stoul(fields[0])));
      CHECK(std::abs(std::stoi(fields[1]) - 511) <= 1);  // 2.5 of 5 V
    }
    CHECK(times_us.front() > times_us.back());  // it wrapped
    for (std::size_t i = 1; i < times_us.size(); ++i) {
      const std::uint32_t step_us = times_us[i] - times_us[i - 1];
      REQUIRE(step_us > 900);
      REQUIRE(step_us < 1100);
    }
    CHECK(board.stackUsed() < 200);
    CHECK(board.stackUsed() + 256 < board.stackAvailable());
  }
}

TEST_CASE("fsr400: answers a request for its name, and ignores everything else") {
  struct Row {
    const char* sent;
    int greetings;
  };
  for (const Row& row : {Row{"?", 1}, Row{"????", 4}, Row{"garbage\n", 0}, Row{"\xff\x80\r\n", 0}}) {
    INFO(row.sent);
    SimulatedBoard board(uno, sketch("fsr400", uno));
    board.run_us(50000);
    board.take();
    board.send(row.sent);
    board.run_us(100000);
    const auto lines = linesOf(board.take());
    CHECK(std::count(lines.begin(), lines.end(), "# detent-force 1 fsr400 divider 1023\r") == row.greetings);
    CHECK(static_cast<int>(lines.size()) > 100 - 3 * row.greetings);
  }
}

TEST_CASE("force1d: gives no force after a reset, before a limit, and after a refused one") {
  for (const BoardKind* kind : {&uno, &mega}) {
    INFO(kind->name);
    ForceBoard board(*kind);
    CHECK(board.duty() == 0);
    CHECK_FALSE(board.pinIsHigh(kind->direction));
    struct Row {
      const char* line;
      const char* answer;
    };
    const Row rows[] = {
        {"T,2,0,1000000,20000,100,1000000", "N,limit"},
        {"G", "N,no table"},
        {"L,0,0,0,0,0", "N,limit"},
        {"L,-3000000,5000000,2000000,200,15", "N,limit"},
        {"L,3000000,5000000,2000000,200", "N,limit"},
        {"L,3000000,5000000,2000000,200,15,1", "N,limit"},
        {"L,3000000,5000000,2000000,200,99999999999", "N,limit"},
        {"L,3000000,5000000,2000000,200,x", "N,limit"},
    };
    for (const Row& row : rows) {
      INFO(row.line);
      CHECK(board.ask(row.line) == row.answer);
      CHECK(stateOf(board.ask("F,1,2000000")) == "2");
      CHECK(board.duty() == 0);
    }
    const auto who = fieldsOf(board.ask("?"));
    REQUIRE(who.size() == 7);
    CHECK(who[1] == "force1d");
    CHECK(who[5] == std::to_string(kind->tableRows));
    CHECK(who[6] == "2");
  }
}

TEST_CASE("force1d: holds to its limit, at 20 kHz") {
  ForceBoard board(mega);
  // More force or silence than the device allows: it answers with its own limits.
  CHECK(board.ask("L,9000000,5000000,2000000,200,400") == "L,5000000,5000000,2000000,200,50");
  REQUIRE(board.ask(limits3N) == limits3N);
  struct Row {
    const char* force;
    double given_N;
  };
  for (const Row& row :
       {Row{"0", 0}, Row{"1000000", 1}, Row{"-1000000", -1}, Row{"6400", 0.0064}, Row{"3000001", 3},
        Row{"2147483647", 3}, Row{"-9000000", -3}, Row{"-2147483647", -3}, Row{"3000", 0}}) {
    INFO(row.force);
    CHECK(stateOf(board.ask(std::string("F,7,") + row.force)) == "0");
    CHECK(board.force_N() == Approx(row.given_N).margin(newtonsAtFullDuty / 800));
    CHECK(std::abs(board.force_N()) <= 3);
    const auto measured = board.measurePwm();
    CHECK(measured.duty == Approx(board.duty()).margin(0.002));
    if (std::abs(row.given_N) > 0.01) CHECK(measured.frequency_Hz >= 20000);
  }
}

TEST_CASE("force1d: ignores every line that the protocol does not have") {
  const std::string zeros(95 - std::strlen("F,1,2000000*00"), '0');
  const auto withChecksum = [](std::string body) {
    body = lineOf(body);
    body.pop_back();
    return body;
  };
  struct Row {
    std::string name, line;
    bool obeyed = false;
  };
  const Row rows[] = {
      {"as the protocol has it", withChecksum("F,1,2000000"), true},
      {"95 characters", withChecksum("F,1," + zeros + "2000000"), true},
      {"96 characters", withChecksum("F,1," + zeros + "02000000")},
      {"text behind the checksum", withChecksum("F,1,2000000") + std::string(120, 'x')},
      {"one character behind the checksum", withChecksum("F,1,2000000") + "0"},
      {"a carriage return", withChecksum("F,1,2000000") + "\r"},
      {"checksum of one digit", "F,1,2000000*4"},
      {"wrong checksum", "F,1,2000000*00"},
      {"no checksum", "F,1,2000000"},
      {"a second star", withChecksum("F,1,2000000*") + "*"},
      {"garbage before", "\x80\xff" + withChecksum("F,1,2000000")},
      {"a zero byte", withChecksum("F,1,2000000") + std::string(1, '\0') + "x"},
      {"force too large for 32 bit", withChecksum("F,1,999999999999")},
      {"no force", withChecksum("F,1,")},
      {"letters for a force", withChecksum("F,1,abc")},
      {"digits and letters", withChecksum("F,1,2000000N")},
      {"a fraction", withChecksum("F,1,2000000.5")},
      {"a number too many", withChecksum("F,1,2000000,0")},
      {"no sequence", withChecksum("F,,2000000")},
      {"negative sequence", withChecksum("F,-1,2000000")},
      {"a space", withChecksum("F,1, 2000000")},
      {"two signs", withChecksum("F,1,--2000000")},
      {"lower case", withChecksum("f,1,2000000")},
      {"a question with more", withChecksum("?,1")},
      {"nothing", ""},
      {"a star alone", "*00"},
  };
  ForceBoard board(uno);
  REQUIRE(board.ask(limits3N) == limits3N);
  for (const Row& row : rows) {
    INFO(row.name);
    REQUIRE(stateOf(board.ask("F,3,0")) == "0");
    board.take();
    board.send(row.line + "\n");
    board.run_us(8000);
    CHECK(board.take().empty() == !row.obeyed);
    CHECK((board.duty() > 0) == row.obeyed);
  }
  // Lines run into each other: the cut-off line is lost, and no other.
  board.ask("F,3,0");
  board.take();
  board.send(std::string(300, 'F') + "\n" + lineOf("F,4,1000000"));
  board.run_us(12000);
  CHECK_THAT(board.take(), StartsWith("P,4,"));
  CHECK(board.force_N() == Approx(1).margin(0.01));
}

TEST_CASE("force1d: takes its force away by itself when no good line comes") {
  struct Row {
    const char* limits;
    double silence_ms;
    std::string meanwhile;  // sent every 5 ms
  };
  for (const BoardKind* kind : {&uno, &mega})
    for (const Row& row : {Row{limits3N, 15, ""}, Row{"L,3000000,5000000,2000000,200,40", 40, ""},
                           Row{"L,3000000,5000000,2000000,200,400", 50, ""}, Row{limits3N, 15, "H,5*00\n"},
                           Row{limits3N, 15, lineOf("Q,5")}, Row{limits3N, 15, std::string(300, 'x')}}) {
      INFO(kind->name << " " << row.limits << " " << row.meanwhile);
      ForceBoard board(*kind);
      board.ask(row.limits);
      board.ask("F,1,2000000");
      REQUIRE(board.duty() > 0);
      const double began_us = board.time_us();
      while (board.duty() > 0 && board.time_us() < began_us + 100000) {
        board.send(row.meanwhile);
        board.run_us(100);
        for (int i = 0; i < 49 && board.duty() > 0; ++i) board.run_us(100);
      }
      // The answer came 1 ms or so after the line was taken.
      const double silence_ms = (board.time_us() - began_us) / 1000;
      CHECK(silence_ms <= row.silence_ms + 2);
      CHECK(silence_ms >= row.silence_ms - 3);
      board.ask("H,3");
      CHECK(board.duty() == 0);  // only `F` brings the force back
    }
}

TEST_CASE("force1d: stops at once for the host and for its own switch, until U") {
  const auto stops = [](ForceBoard& board) {
    board.run_us(1000);
    const bool gone = board.duty() == 0;
    return gone && stateOf(board.ask("F,2,2000000")) == "1" && board.duty() == 0;
  };
  for (const BoardKind* kind : {&uno, &mega}) {
    INFO(kind->name);
    ForceBoard board(*kind);
    board.ask(limits3N);
    board.ask("F,1,2000000");
    REQUIRE(board.duty() > 0);
    board.send(lineOf("S"));
    CHECK(stops(board));
    board.ask("X", 1000);
    CHECK(stateOf(board.ask("F,3,2000000")) == "1");
    board.ask("U", 1000);
    CHECK(board.duty() == 0);
    CHECK(stateOf(board.ask("F,4,2000000")) == "0");
    CHECK(board.duty() > 0);
    // Open for 2 ms is enough, though it is closed again.
    board.setPin(kind->stopSwitch, true);
    board.run_us(2000);
    board.setPin(kind->stopSwitch, false);
    CHECK(stops(board));
    board.setPin(kind->stopSwitch, true);
    board.ask("U", 1000);
    CHECK(stops(board));
    board.setPin(kind->stopSwitch, false);
    board.ask("U", 1000);
    CHECK(stateOf(board.ask("F,5,2000000")) == "0");
    CHECK(board.duty() > 0);
  }
}

TEST_CASE("force1d: counts 20,000 steps a second on an 8 bit board") {
  for (const BoardKind* kind : {&uno, &mega}) {
    INFO(kind->name);
    ForceBoard board(*kind);
    CHECK(positionOf_mm(board.ask("H,1")) == 0);
    board.turn(2000, 50);
    CHECK(positionOf_mm(board.ask("H,2")) == Approx(20));
    board.turn(-2500, 50);
    CHECK(positionOf_mm(board.ask("H,3")) == Approx(-5));
  }
}

namespace {

/// A spring of 0.1 N/mm with 0.05 N between press and release and 0.002 N·s/mm of damping, over 10 mm.
void uploadSpring(ForceBoard& board) {
  REQUIRE(board.ask("L,3000000,5000000,2000000,200,50") == "L,3000000,5000000,2000000,200,50");
  REQUIRE(board.ask("T,11,0,1000000,20000,100000,2000000") == "A");
  for (int i = 0; i <= 10; ++i)
    REQUIRE(board.ask("R," + std::to_string(i) + "," + std::to_string(100000 * i + 50000) + "," +
                      std::to_string(100000 * i) + ",2000") == "A");
}

}  // namespace

TEST_CASE("force1d: runs its table at the rate it says, with the time between two steps as it was") {
  for (const BoardKind* kind : {&uno, &mega}) {
    INFO(kind->name);
    ForceBoard board(*kind);
    uploadSpring(board);
    board.turn(200, 100);  // 2 mm
    REQUIRE(board.ask("G") == "A");
    // The force rises from nothing over 200 ms: never above limit times time.
    const double began_us = board.time_us();
    for (int i = 0; i < 30; ++i) {
      const double share = (board.time_us() - began_us + 5000) / 200000;
      CHECK(board.force_N() <= 2 * share + 0.01);
      board.keepAsking("H", 1, 8000);
    }
    CHECK(board.force_N() ==
          Approx(0.2).margin(0.015));  // released: at G the operator stands at its release end
    // steps of the law, counted from outside, to compare with its own count
    int steps = 0;
    std::uint32_t last = board.variable("lastLaw_us", 4);
    for (int i = 0; i < 100; ++i) {
      board.send(lineOf("H,9"));
      for (int k = 0; k < 100; ++k) {
        board.run_us(100);
        const std::uint32_t now = board.variable("lastLaw_us", 4);
        if (now != last) ++steps;
        last = now;
      }
    }
    board.take();
    const double said_Hz = std::stod(fieldsOf(board.ask("?")).at(4));
    CHECK(said_Hz == Approx(steps).epsilon(0.05));  // of one second
    CHECK(steps > 200);
    // Pressed at 20 mm/s for 2 mm: spring, press curve and damping of 0.04 N.
    double sum_N = 0, sumWanted_N = 0;
    for (int i = 0; i < 200; ++i) {
      if (i % 20 == 0) board.send(lineOf("H,9"));
      board.turn(1, 500);
      if (i < 100) continue;
      sum_N += board.force_N();
      sumWanted_N += 0.1 * (2 + 0.01 * (i + 1)) + 0.05 + 0.04;
    }
    CHECK(sum_N / 100 == Approx(sumWanted_N / 100).margin(0.012));
    board.keepAsking("H", 10);
    CHECK(board.force_N() == Approx(0.45).margin(0.012));
    // Above the speed limit it goes within 10 ms, and silence ends the table.
    board.ask("S", 1000);
    CHECK(board.duty() == 0);
    board.ask("U", 1000);
    board.keepAsking("H", 60);
    CHECK(board.force_N() == Approx(0.45).margin(0.012));
    CHECK(board.untilNoForce_us(100000) < 52000);
    board.keepAsking("H", 60);
    CHECK(board.duty() == 0);
  }
}

TEST_CASE("force1d: a new table, or F, ends the force of the table before") {
  for (const char* line : {"T,11,0,1000000,20000,100000,2000000", "L,3000000,5000000,2000000,200,50", "X"}) {
    INFO(line);
    ForceBoard board(mega);
    uploadSpring(board);
    board.turn(500, 100);
    REQUIRE(board.ask("G") == "A");
    board.keepAsking("H", 60);
    REQUIRE(board.force_N() > 0.4);
    board.ask(line, 3000);
    CHECK(board.duty() == 0);
    board.keepAsking("H", 60);
    CHECK(board.duty() == 0);
  }
  ForceBoard board(mega);
  uploadSpring(board);
  board.turn(500, 100);
  REQUIRE(board.ask("R,11,0,0,0") == "N,row");
  REQUIRE(board.ask("T,257,0,1000000,20000,100000,2000000") == "N,table");
  REQUIRE(board.ask("T,11,0,0,20000,100000,2000000") == "N,table");
  REQUIRE(board.ask("T,11,0,1000000,20000,100000,3000001") == "N,limit");
  uploadSpring(board);
  REQUIRE(board.ask("G") == "A");
  board.keepAsking("H", 60);
  board.keepAsking("F,-1000000", 1);
  CHECK(board.force_N() == Approx(-1).margin(0.01));
}

namespace {

/// The table's whole force at this depth, moved there right before.
void holdAt(ForceBoard& board, int counts) {
  uploadSpring(board);
  board.turn(counts, 100);
  REQUIRE(board.ask("G") == "A");
  for (int i = 0; i < 56; ++i) {  // 224 ms: the ramp
    board.turn(i % 2 ? -1 : 1, 100);
    board.keepAsking("H", 1);
  }
}

}  // namespace

TEST_CASE("force1d: a table whose encoder counts no more loses its force, and says why until U") {
  for (const BoardKind* kind : {&uno, &mega}) {
    INFO(kind->name);
    ForceBoard board(*kind);
    holdAt(board, 500);
    REQUIRE(board.force_N() == Approx(0.5).margin(0.02));
    board.keepAsking("H", 45);  // 180 ms
    CHECK(board.force_N() == Approx(0.5).margin(0.02));
    board.keepAsking("H", 35);  // 320 ms
    CHECK(board.force_N() < 0.01);
    CHECK(stateOf(board.keepAsking("H", 10)) == "0");
    CHECK(stateOf(board.keepAsking("H", 20)) == "3");  // 440 ms
    board.turn(1, 100);
    CHECK(stateOf(board.keepAsking("H", 10)) == "3");
    CHECK(board.duty() == 0);
    board.ask("U", 1000);
    board.turn(1, 100);
    CHECK(stateOf(board.keepAsking("H", 56)) == "0");
    CHECK(board.force_N() > 0.4);
  }
}

TEST_CASE("force1d: an encoder that dies out of a movement has its force taken away at once") {
  for (const BoardKind* kind : {&uno, &mega}) {
    INFO(kind->name);
    ForceBoard board(*kind);
    holdAt(board, 500);
    board.turn(50, 200);  // 50 mm/s, to the press curve
    board.keepAsking("H", 1);
    CHECK(board.force_N() == Approx(0.6).margin(0.03));
    CHECK(board.untilNoForce_us(100000) < 18000);
    CHECK(stateOf(board.keepAsking("H", 5)) == "0");
    board.turn(1, 100);
    board.keepAsking("H", 7);
    CHECK(board.force_N() == Approx(0.6).margin(0.03));
    board.turn(20, 1000);  // 10 mm/s: a hand may stop like that
    board.keepAsking("H", 30);
    CHECK(board.force_N() == Approx(0.62).margin(0.03));
  }
}

TEST_CASE("force1d: a resting finger whose encoder counts one step has its force back within 30 ms") {
  for (const BoardKind* kind : {&uno, &mega}) {
    INFO(kind->name);
    ForceBoard board(*kind);
    holdAt(board, 500);
    for (int i = 0; i < 3; ++i) {
      board.keepAsking("H", 60);  // 240 ms
      CHECK(board.force_N() < 0.4);
      board.turn(i % 2 ? -1 : 1, 100);
      board.keepAsking("H", 7);
      CHECK(board.force_N() == Approx(0.5).margin(0.03));
    }
  }
}

TEST_CASE("force1d: the encoder is not watched under little force") {
  ForceBoard board(uno);
  holdAt(board, 220);  // 0.22 N
  board.keepAsking("H", 150);
  CHECK(board.force_N() == Approx(0.22).margin(0.02));
  CHECK(stateOf(board.keepAsking("H", 1)) == "0");
}

TEST_CASE("force1d: goes on through the wrap of the clock") {
  ForceBoard board(mega);
  uploadSpring(board);
  board.turn(500, 100);
  board.wrapClockIn(300000);
  board.ask("H,0");
  REQUIRE(board.ask("G") == "A");
  board.keepAsking("H", 50);
  for (int i = 0; i < 60; ++i) {
    board.turn(i % 2 ? -1 : 1, 100);  // a finger trembles
    board.keepAsking("H", 1);
    REQUIRE(board.force_N() == Approx(0.5).margin(0.02));
  }
  CHECK(std::stoul(fieldsOf(board.ask("H,1")).at(2)) < 1000000);  // it wrapped
  board.run_us(60000);
  CHECK(board.duty() == 0);
}

TEST_CASE("force1d: a processor that hangs is reset by its watchdog, and gives no force after it") {
  for (const BoardKind* kind : {&uno, &mega}) {
    INFO(kind->name);
    ForceBoard board(*kind);
    board.ask(limits3N);
    board.ask("F,1,2000000");
    REQUIRE(board.duty() > 0);
    board.hang();
    CHECK(board.untilNoForce_us(300000) < 80000);
    board.release();
    board.run_us(100000);
    CHECK(stateOf(board.ask("F,2,2000000")) == "2");
    CHECK(board.duty() == 0);
    // And only once: it does not reset itself again while it waits for the host.
    CHECK(board.ask(limits3N) == limits3N);
    board.run_us(300000);
    CHECK(stateOf(board.ask("F,3,1000000")) == "0");
  }
}

TEST_CASE("force1d: its stack and its variables fit the board") {
  for (const BoardKind* kind : {&uno, &mega}) {
    INFO(kind->name);
    ForceBoard board(*kind);
    uploadSpring(board);
    board.ask("?");
    board.ask("G");
    for (int i = 0; i < 100; ++i) {
      board.turn(5, 60);
      board.keepAsking("H", 1);
      board.keepAsking(i % 10 ? "H" : "F,-2000000", 1);
    }
    CHECK(board.stackUsed() < 450);
    CHECK(board.stackUsed() + 256 < board.stackAvailable());
  }
}

TEST_CASE("force1d: a Leonardo starts without force") {
  SimulatedBoard board(leonardo, sketch("force1d", leonardo));
  for (int i = 0; i < 100; ++i) {
    board.run_us(1000);
    REQUIRE(board.duty() == 0);
  }
  CHECK(board.variable("rowCount", 2) == 0);
  CHECK(board.stackUsed() < 450);
}

TEST_CASE("triggered: an exported header plays its clicks on 8 bit boards") {
  struct Row {
    const char* program;
    const BoardKind& kind;
    std::uint16_t dutyRegister;  // data address of OCR2B
  };
  for (const Row& row : {Row{"triggered_minimal", uno, 0xB4}, Row{"triggered", mega, 0xB4}}) {
    INFO(row.program << " " << row.kind.name);
    SimulatedBoard board(row.kind, sketch(row.program, row.kind));
    board.setAnalog_mV(0, 0);
    board.run_us(50000);
    // B's press jump is at about 0.55 N, its bottom-out behind it: 1 V here are 1 N.
    const auto loudest = [&](int from_mV, int to_mV, int ms) {
      int most = 0;
      for (int i = 0; i < ms; ++i) {
        board.setAnalog_mV(0, static_cast<unsigned>(from_mV + (to_mV - from_mV) * i / ms));
        board.run_us(1000);
        most = std::max(most, std::abs(static_cast<int>(board.byteAt(row.dutyRegister)) - 128));
      }
      return most;
    };
    const int before = loudest(0, 450, 50), click = loudest(450, 700, 50),
              rest = (loudest(700, 700, 150), loudest(700, 700, 50)), release = loudest(700, 0, 80);
    if (std::string(row.program) == "triggered_minimal") CHECK(before == 0);
    CHECK(click > 20);
    CHECK(rest <= 1);
    CHECK(release > 10);
    CHECK(board.stackUsed() + 100 < board.stackAvailable());
    std::cout << row.program << " " << row.kind.name << ": longest step "
              << board.variable("longestStep_us", 2) << " us, stack " << board.stackUsed() << " of "
              << board.stackAvailable() << " bytes\n";
  }
}
