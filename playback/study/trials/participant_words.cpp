// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/trials/participant_words.h"

namespace detent::playback {

namespace {

constexpr ParticipantWords english{
    .agree = "y = I agree: begin     n = no, thank you",
    .goodbye = "Thank you for coming. Nothing about you was kept.",
    .trial = "Trial %1 of %2",
    .practice = "Practice %1 of %2",
    .rehearsal = "[REHEARSAL: nothing is felt]",
    .keys = "p pauses, q stops for good",
    .press = "press: ",
    .andX = "and x for X",
    .realSwitch = "X is the real switch number %1",
    .answer = "answer:",
    .spaceBar = "the space bar",
    .thenEnter = "%1, then Enter",
    .magnitude = "a number as great as it feels strong (twice as strong: twice the number)",
    .preference = "how much you like it, 1 (not at all) to 7 (very much)",
    .takenBack = "taken back",
    .typeMagnitude = "type a number above 0, then Enter",
    .typePreference = "type 1, 2, 3, 4, 5, 6 or 7, then Enter",
    .isX = "X is %1",
    .better = "%1 is better",
    .force = "%1 needs more force",
    .click = "%1 has the stronger click",
    .deeper = "%1 goes deeper",
    .snaps = "%1 snaps more",
    .rougher = "%1 feels rougher on the way",
    .pressThem = "press them first, each to the end and back:",
    .pressIt = "press it first, to the end and back:",
    .notYet = "(not yet to the end)",
    .rest = "Time for a rest, as long as you like. Any key goes on.",
    .stop = "Stop for good? y stops, any other key goes on.",
    .paused = "Paused. The same command goes on at this trial.",
    .last = "That was the last one. Thank you.",
    .interrupted = "Interrupted: %1. This trial begins anew.",
    .notKept = "%1. Your answer is not kept yet: answer again.",
    .stopForce = "Esc takes the force away at once",
    .rearm = "There is no force. a brings it back.",
    .rain = "Rain plays %1; turn it up until the vibration cannot be heard.",
    .behindTheSignal = "on the outputs behind the vibration's",
    .cueTask = "Four beats come, evenly. Press with the fourth.",
    .windowTask = "A ball runs to the right. Press while it is between the brackets.",
    .tappingTask =
        "Press again and again, as fast as you can keep up, until it says stop: %1 s from your first press.",
    .begin = "Any key begins.",
    .hit = "hit",
    .missed = "missed",
    .enough = "Stop.",
    .noPress = "No press came at a time that counts. Once more.",
    .held = "The presses came too close: let the key go each time. Once more.",
    .notFelt = "The button was not pressed far enough. Once more.",
    .yes = 'y'};

constexpr ParticipantWords german{
    .agree = "j = Ich bin einverstanden: beginnen     n = nein, danke",
    .goodbye = "Danke, dass Sie gekommen sind. Über Sie wurde nichts aufgehoben.",
    .trial = "Frage %1 von %2",
    .practice = "Übung %1 von %2",
    .rehearsal = "[PROBE: man fühlt nichts]",
    .keys = "p macht Pause, q hört endgültig auf",
    .press = "drücken: ",
    .andX = "und x für X",
    .realSwitch = "X ist der echte Taster Nummer %1",
    .answer = "antworten:",
    .spaceBar = "die Leertaste",
    .thenEnter = "%1, dann Eingabe",
    .magnitude = "eine Zahl, so groß, wie es sich stark anfühlt (doppelt so stark: die doppelte Zahl)",
    .preference = "wie gut es Ihnen gefällt, 1 (gar nicht) bis 7 (sehr)",
    .takenBack = "zurückgenommen",
    .typeMagnitude = "eine Zahl über 0 tippen, dann Eingabe",
    .typePreference = "1, 2, 3, 4, 5, 6 oder 7 tippen, dann Eingabe",
    .isX = "X ist %1",
    .better = "%1 ist besser",
    .force = "%1 braucht mehr Kraft",
    .click = "%1 hat den stärkeren Klick",
    .deeper = "%1 geht tiefer",
    .snaps = "%1 schnappt mehr",
    .rougher = "%1 fühlt sich unterwegs rauer an",
    .pressThem = "erst drücken, jeden bis zum Ende und zurück:",
    .pressIt = "erst drücken, bis zum Ende und zurück:",
    .notYet = "(noch nicht bis zum Ende)",
    .rest = "Zeit für eine Pause, so lange Sie mögen. Jede Taste geht weiter.",
    .stop = "Endgültig aufhören? j hört auf, jede andere Taste geht weiter.",
    .paused = "Pause. Derselbe Befehl geht an dieser Frage weiter.",
    .last = "Das war die letzte. Vielen Dank.",
    .interrupted = "Unterbrochen: %1. Diese Frage beginnt von vorn.",
    .notKept = "%1. Ihre Antwort ist noch nicht aufgehoben: antworten Sie noch einmal.",
    .stopForce = "Esc nimmt sofort die Kraft weg",
    .rearm = "Es ist keine Kraft da. a bringt sie zurück.",
    .rain = "Regen rauscht %1; drehen Sie ihn auf, bis die Vibration nicht zu hören ist.",
    .behindTheSignal = "auf den Ausgängen hinter dem der Vibration",
    .cueTask = "Es kommen vier gleichmäßige Schläge. Drücken Sie mit dem vierten.",
    .windowTask = "Ein Ball läuft nach rechts. Drücken Sie, während er zwischen den Klammern ist.",
    .tappingTask =
        "Drücken Sie immer wieder, so schnell Sie es durchhalten, bis Halt kommt: %1 s ab dem ersten Druck.",
    .begin = "Jede Taste beginnt.",
    .hit = "getroffen",
    .missed = "daneben",
    .enough = "Halt.",
    .noPress = "Zu der Zeit, die zählt, kam kein Druck. Noch einmal.",
    .held = "Die Drücke kamen zu dicht: lassen Sie die Taste jedes Mal los. Noch einmal.",
    .notFelt = "Der Taster wurde nicht weit genug gedrückt. Noch einmal.",
    .yes = 'j'};

}  // namespace

const ParticipantWords& participantWords(const std::string& language) {
  return language == "de" ? german : english;
}

const char* comparisonWords(const ParticipantWords& words, const StudyDesign& design) {
  if (asksForX(design.kind)) return words.isX;
  if (design.kind == StudyKind::rating) return words.better;
  switch (design.quantity) {
    case LevelQuantity::peakForce:
      return words.force;
    case LevelQuantity::eventSize:
      return words.click;
    case LevelQuantity::travel:
      return words.deeper;
    case LevelQuantity::snap:
      return words.snaps;
    case LevelQuantity::grainStrength:
      break;
  }
  return words.rougher;
}

}  // namespace detent::playback
