// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/document/button_document.h"

#include <memory>

#include <catch2/catch.hpp>

#include "editor/document/view_settings.h"
#include "model/edits.h"
#include "model/templates.h"

using namespace detent;
using namespace detent::editor;

namespace {

ForceGraph line(double end_N) {
  return ForceGraph::fromCurves(
             StrokeCurve::fromKnots({{0, 0, end_N / 4, end_N / 4}, {4, end_N, end_N / 4, end_N / 4}}).value(),
             {})
      .value();
}

Button latch() {
  return Button::fromStates("latch", {{"unlocked", line(1), {}, {}, {}}, {"locked", line(2), {}, {}, {}}})
      .value();
}

int countedChanges(ButtonDocument& document, void (ButtonDocument::*signal)(),
                   const std::function<void()>& act) {
  int count = 0;
  const auto connection = QObject::connect(&document, signal, &document, [&] { ++count; });
  act();
  QObject::disconnect(connection);
  return count;
}

}  // namespace

TEST_CASE("A document is called after its file, else after its button") {
  ButtonDocument document(rename(latch(), "Blue").value());
  CHECK(document.title() == "Blue");
  document.setPath("/somewhere/Clicky 3.5.button.json");
  CHECK(document.title() == "Clicky 3.5");
  document.setPath("/somewhere/log.2024.csv");
  CHECK(document.title() == "log.2024");
  CHECK(ButtonDocument(rename(latch(), "").value()).title() == "Untitled");
}

TEST_CASE("Open buttons of one title are distinguished by file, folder or number, in their order") {
  struct Case {
    std::vector<const char*> paths;  // "": not saved; every button is named "Blue"
    QStringList titles;
  };
  const Case cases[] = {
      {{""}, {"Blue"}},
      {{"/a/Blue.button.json", "/a/Red.button.json"}, {"Blue", "Red"}},
      {{"", "/a/Blue.button.json"}, {"Blue (not saved)", "Blue (Blue.button.json)"}},
      {{"/a/Blue.png", "/a/Blue.button.json"}, {"Blue (Blue.png)", "Blue (Blue.button.json)"}},
      {{"/a/Blue.png", "/b/Blue.png"}, {"Blue (a/Blue.png)", "Blue (b/Blue.png)"}},
      {{"/a/Blue.png", "/b/Blue.png", ""}, {"Blue (a/Blue.png)", "Blue (b/Blue.png)", "Blue (not saved)"}},
      {{"", "/x/Red.png", ""}, {"Blue (not saved, 1)", "Red", "Blue (not saved, 2)"}},
      {{"/1/a/Blue.png", "/2/a/Blue.png"}, {"Blue (a/Blue.png, 1)", "Blue (a/Blue.png, 2)"}},
  };
  for (const Case& each : cases) {
    std::vector<std::unique_ptr<ButtonDocument>> owned;
    std::vector<ButtonDocument*> documents;
    for (const char* path : each.paths) {
      owned.push_back(std::make_unique<ButtonDocument>(rename(latch(), "Blue").value()));
      owned.back()->setPath(path);
      documents.push_back(owned.back().get());
    }
    CHECK(distinctTitles(documents).join("; ").toStdString() == each.titles.join("; ").toStdString());
  }
}

TEST_CASE("The shown graph is that of the active state, and follows a drag") {
  ButtonDocument document(latch());
  document.setActiveState(1);
  CHECK(document.graph().press().force_N(4) == 2);
  document.history().beginDrag("Scale");
  document.history().preview(scaleForce(latch(), 3).value());
  CHECK(document.graph().press().force_N(4) == 6);
  document.history().cancelDrag();
  CHECK(document.graph().press().force_N(4) == 2);
}

TEST_CASE("The active state stays one the button has when an undo takes the second away") {
  const Button momentary = Button::fromStates("b", {{"", line(1), {}, {}, {}}}).value();
  ButtonDocument document(momentary);
  document.history().apply(latch(), "Add state");
  document.setActiveState(1);
  document.history().stack().undo();
  CHECK(document.activeState() == 0);
  CHECK(document.graph() == momentary.states()[0].graph);
  document.history().stack().redo();
  CHECK(document.activeState() == 1);
}

TEST_CASE("Views hear of a new value, title marks of saving and edits") {
  ButtonDocument document(latch());
  const Button heavier = scaleForce(latch(), 2).value();
  CHECK(countedChanges(document, &ButtonDocument::changed,
                       [&] { document.history().apply(heavier, "Scale"); }) == 1);
  CHECK(countedChanges(document, &ButtonDocument::changed,
                       [&] { document.history().apply(heavier, "Scale"); }) == 0);
  CHECK(countedChanges(document, &ButtonDocument::titleChanged, [&] { document.history().markSaved(); }) ==
        1);
  CHECK_FALSE(document.history().modified());
}

TEST_CASE("Settings of the view tell of a change once, and only of a change") {
  ViewSettings settings;
  int count = 0;
  QObject::connect(&settings, &ViewSettings::changed, &settings, [&] { ++count; });
  settings.setUnits({LengthUnit::inch, ForceUnit::ounceForce});
  settings.setUnits({LengthUnit::inch, ForceUnit::ounceForce});
  settings.setUnderlayOpacity(0.25);
  settings.setSnap({.toGrid = true});
  settings.setAppearance(Appearance::dark);
  settings.setAppearance(Appearance::dark);
  settings.setResidualsShown(true);
  CHECK(count == 5);
  CHECK(settings.units().length == LengthUnit::inch);
  CHECK(settings.snap().toGrid);
}

TEST_CASE("A document that is closed with unsaved changes emits no change of its title") {
  int titles = 0;
  QObject listener;
  {
    ButtonDocument document(latch());
    document.history().apply(rename(document.button(), "Blue").value(), "Rename");
    QObject::connect(&document, &ButtonDocument::titleChanged, &listener, [&] { ++titles; });
  }
  CHECK(titles == 0);
}
