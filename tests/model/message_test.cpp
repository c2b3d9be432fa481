// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/message.h"

#include <catch2/catch.hpp>

#include "model/result.h"

using namespace detent;

TEST_CASE("values go where the pattern wants them, in the command line's units") {
  CHECK(english(Message("%2 before %1", "a", 7)) == "7 before a");
  CHECK(english(Message("%1 and %2", millimetres(1.25), newtons(0.5))) == "1.25 mm and 0.5 N");
  CHECK(english(Message("%1 of it", MessageValue(0.946, Measure::share))) == "95 % of it");
  CHECK(english(Message("unsure (%1)", std::vector<Message>{"one", Message("curve point %1", 2)})) ==
        "unsure (one; curve point 2)");
  CHECK(english(Message("5 % of %1", "a")) == "5 % of a");
  CHECK(english(Message("100 %9 %1", "a")) == "100 %9 a");  // no ninth value
}

TEST_CASE("what is made while running is kept as it is, and survives its maker") {
  char buffer[] = "%1 from the system";
  const Message fromBuffer = buffer;
  buffer[0] = 'x';
  CHECK(english(fromBuffer) == "%1 from the system");
  CHECK(english(Message(std::string("50 %1"))) == "50 %1");
  CHECK(Message(std::string()).empty());
  CHECK(Message("").empty());
}

TEST_CASE("the command line names what to pass, and what helps besides") {
  const Remedies axes{
      {RemedyKind::giveXAxis, {}}, {RemedyKind::giveYAxis, "(here)"}, {RemedyKind::giveFrame, "if missed"}};
  CHECK(commandLineWords(axes) ==
        "Pass --x-axis MIN:MAX and --y-axis MIN:MAX (here), or --frame X0,Y0,X1,Y1 if missed");
  CHECK(axes.include(RemedyKind::giveFrame));
  CHECK_FALSE(axes.include(RemedyKind::addMask));
  CHECK(commandLineWords({{RemedyKind::advice, "Crop it"}, {RemedyKind::raiseLimit, {}}}) ==
        "Crop it, or raise the limit");
  CHECK(commandLineWords(RemedyKind::raiseLimit) == "Raise the limit");
  CHECK(commandLineWords("Mend it") == "Mend it");
  CHECK(commandLineWords({}).empty());
}

TEST_CASE("a Failure has a code, a subject of a kind, and one sentence at the command line") {
  const Failure failure{FailureCode::unreadableInput, std::string("a.csv"), Message("line %1", 7), "is empty",
                        "Fill it"};
  CHECK(failure.sentence() == "a.csv, line 7: is empty. Fill it.");
  CHECK(failure.subject.kind == Subject::Kind::named);
  CHECK(Failure{FailureCode::wrongUsage, "press curve", "", "", ""}.subject.kind == Subject::Kind::part);
  CHECK(Subject(std::string()).empty());
  CHECK(Subject::option("--frame").kind == Subject::Kind::option);

  const Failure stopped = Failure::cancelled("render");
  CHECK(stopped.exitCode() == 130);
  CHECK(nameOf(stopped.code) == "cancelled");
  CHECK(stopped.remedies.empty());
}
