// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/strokes/legend.h"

#include <utility>

#include <catch2/catch.hpp>

using detent::Stroke;
using detent::importer::isDefaultName;
using detent::importer::mayBeOnePair;
using detent::importer::mayNameAPoint;
using detent::importer::namesBothStrokes;
using detent::importer::namesNothingButRelease;
using detent::importer::namesOnePair;
using detent::importer::strokeNamedBy;
using detent::importer::switchNamedBy;
using detent::importer::TextSource;

TEST_CASE("Legend words in the languages of datasheets", "[legend]") {
  for (const char* text : {"Press",       "downstroke",
                           "DOWNSTROKE",  "Downstroke (press)",
                           "down stroke", "Loading",
                           "Hinweg",      "Betätigung",
                           "BETÄTIGUNG",  "按压",
                           "下压力曲线",  "押し込み",
                           "Нажатие",     "Harimau housing downstroke",
                           "going down",  "mesure aller",
                           "Compression", "Ida",
                           "Andata",      "Avance",
                           "Premuto",     "abwärts"})
    CHECK(strokeNamedBy(text) == Stroke::press);
  for (const char* text : {"Release",    "upstroke",      "Upstroke (release)",
                           "Unloading",  "Rückhub",       "RÜCKLAUF",
                           "return",     "释放",          "回弹",
                           "戻り",       "Отпускание",    "T1 housing upstroke",
                           "coming up",  "mesure retour", "Decompression",
                           "Vuelta",     "Ritorno",       "Retroceso",
                           "Rilasciato", "aufwärts"})
    CHECK(strokeNamedBy(text) == Stroke::release);
}

TEST_CASE("Legend words of many languages, press and release", "[legend]") {
  const std::pair<const char*, const char*> named[] = {{"Naciskanie", "Zwalnianie"},
                                                       {"Tryck ned", "Släpp"},
                                                       {"Nedtryckning", "Återfjädring"},
                                                       {"Trykk", "Slipp"},
                                                       {"Tryk", "Slip"},
                                                       {"Indrukken", "Loslaten"},
                                                       {"Stisk", "Uvolnění"},
                                                       {"Stlačenie", "Uvoľnenie"},
                                                       {"Lenyomás", "Felengedés"},
                                                       {"Painallus", "Vapautus"},
                                                       {"Basma", "Serbest bırakma"},
                                                       {"Basış", "Geri dönüş"},
                                                       {"Pressionar", "Soltar"},
                                                       {"Apăsare", "Eliberare"},
                                                       {"Apăsare", "Revenire"},
                                                       {"Πίεση", "Απελευθέρωση"},
                                                       {"ΠΑΤΗΜΑ", "ΕΠΙΣΤΡΟΦΗ"},
                                                       {"Натискання", "Відпускання"},
                                                       {"Натискане", "Отпускане"},
                                                       {"Nhấn", "Nhả"},
                                                       {"Pritisak", "Otpuštanje"},
                                                       {"Vajutus", "Vabastus"},
                                                       {"Tekan", "Lepas"},
                                                       {"Obciążenie", "Odciążenie"},
                                                       {"Betätigungskurve", "Rückstellkurve"},
                                                       {"Hinrichtung", "Rückrichtung"},
                                                       {"下壓", "釋放"},
                                                       {"押し込み", "リターン"},
                                                       {"누르기", "놓기"},
                                                       {"กด", "ปล่อย"},
                                                       {"Belastungskurve", "Entlastungskurve"},
                                                       {"Вниз", "Вверх"},
                                                       {"Abajo", "Arriba"},
                                                       {"Dus", "Întors"},
                                                       {"Cursă dus", "Cursă întors"},
                                                       {"Tam", "Zpět"},
                                                       {"Tam", "Späť"},
                                                       {"Tam", "Z powrotem"},
                                                       {"Gidiş", "Dönüş"},
                                                       {"Oda", "Vissza"},
                                                       {"Meno", "Paluu"},
                                                       {"Fram", "Tillbaka"},
                                                       {"Туда", "Обратно"},
                                                       {"Вперёд", "Назад"},
                                                       {"Naprijed", "Natrag"},
                                                       {"Descente", "Montée"},
                                                       {"正行程", "反行程"},
                                                       {"↓", "↑"},
                                                       {"Force ▼", "Force ▲"},
                                                       {"→ hin", "← zurück"}};
  for (const auto& [press, release] : named) {
    CAPTURE(press, release);
    CHECK(strokeNamedBy(press) == Stroke::press);
    CHECK(strokeNamedBy(release) == Stroke::release);
    CHECK(mayBeOnePair(press, release));
  }
}

TEST_CASE("Names that are no words for strokes stay names", "[legend]") {
  for (const char* name :
       {"Clown",    "Linear",   "Tactile",    "Clicky",  "Silent",   "Heavy",   "Light",    "Brown",
        "Yellow",   "Orange",   "Retro",      "Button",  "Switch",   "Sample",  "Muster",   "Taster",
        "Taste",    "Touche A", "Bouton",     "Tecla",   "Botão A",  "Knapp",   "Knop",     "Tlačítko",
        "Przycisk", "Modell",   "Exemplar",   "Before",  "After",    "Fresh",   "Worn",     "Aged",
        "Reserve",  "Pressure", "Rubber",     "Dome",    "Membrane", "Optical", "Magnetic", "Buckling",
        "Kailh",    "Gateron",  "Holy Panda", "Zealios", "A → B",    "Rev B",   "vor Test", "avant"}) {
    CAPTURE(name);
    CHECK(strokeNamedBy(name) == std::nullopt);
  }
  CHECK_FALSE(mayBeOnePair("Clown", "Clicky"));
  CHECK_FALSE(mayBeOnePair("A轴下压", "B轴释放"));
  CHECK(namesOnePair("A轴下压", "A轴释放"));
  CHECK(switchNamedBy("Пуск отпускание") == "Пуск");
}

TEST_CASE("Words of strokes that readers of pixels misread or cut", "[legend]") {
  for (const char* text :
       {"Driicken", "Drticken", "Naciskani", "Naclskanle", "Nacisniqcie", "Betatlgung", "Indrukkan", "Trvk"})
    CHECK(strokeNamedBy(text) == Stroke::press);
  for (const char* text : {"Zwalniani", "Uvolnéni", "Felengedés", "Loslass", "Odpuszczani", "Elibarare"})
    CHECK(strokeNamedBy(text) == Stroke::release);
  CHECK(strokeNamedBy("Obciazenie") == Stroke::press);  // nearer by the one letter that distinguishes the two
  CHECK(strokeNamedBy("Oociazenie") == std::nullopt);
}

TEST_CASE("A release and nothing else", "[legend]") {
  for (const char* text : {"Release", "Return stroke", "Rückhub", "Обратный ход", "释放", "Press / Release"})
    CHECK(namesNothingButRelease(text));
  for (const char* text : {"Press", "Release force", "Release point", "Switch B release", "Release 2", ""})
    CHECK_FALSE(namesNothingButRelease(text));
}

TEST_CASE("A letter that resembles another is forgiven, one that does not proves nothing", "[legend]") {
  CHECK(strokeNamedBy("downstr0ke") == std::nullopt);  // a digit splits the word
  CHECK(strokeNamedBy("downstrake") == Stroke::press);
  CHECK(strokeNamedBy("dwnstroke") == std::nullopt);
  CHECK(strokeNamedBy("prass") == std::nullopt);
  CHECK(strokeNamedBy("Retomo") == Stroke::release);  // "Retorno"
  CHECK(strokeNamedBy("Presion") == Stroke::press);
  CHECK(mayBeOnePair("dwnstroke", "upstroke"));  // beside the other stroke's name it does
  CHECK_FALSE(mayBeOnePair("dwnstroke", "upstroke", TextSource::exact));
  CHECK(mayBeOnePair("Pressing", "sing"));   // of "Releasing", its beginning hidden
  CHECK(mayBeOnePair("P", "Return"));        // of "Press"
  CHECK(mayBeOnePair("Down", "rce curve"));  // of "Force curve"
  CHECK_FALSE(mayBeOnePair("Down", "Lotus"));
}

TEST_CASE("Names of other things that hold a stroke's word are no strokes", "[legend]") {
  for (const TextSource source : {TextSource::exact, TextSource::recognised})
    for (const char* text : {"Leading edge", "Trailing edge", "Load cell A", "Load cell B", "Return loss",
                             "Return key", "Pressing plate", "Bottom out", "Back EMF", "Push button",
                             "Advanced", "Classic", "Drucktaste 12"}) {
      CAPTURE(text);
      CHECK(strokeNamedBy(text, source) == std::nullopt);
    }
  CHECK_FALSE(mayBeOnePair("Advanced", "Classic"));
  CHECK_FALSE(mayBeOnePair("Charge", "Classic"));  // "charge" is French for a press
  CHECK_FALSE(mayBeOnePair("Press", "Bare dome"));
  CHECK_FALSE(mayBeOnePair("Return key", "Space bar"));
  CHECK_FALSE(mayBeOnePair("2019", "2024"));
  CHECK(mayBeOnePair("Pushing the key in", "Letting the key go"));
}

TEST_CASE("A name that is a point's in other legends", "[legend]") {
  for (const char* text : {"actuation", "Release", "Reset"}) CHECK(mayNameAPoint(text));
  for (const char* text : {"downstroke", "Upstroke", "Loslassen", "Gateron"})
    CHECK_FALSE(mayNameAPoint(text));
}

TEST_CASE("Accents and capitals that a reader of pixels loses", "[legend]") {
  for (const char* text :
       {"Ruckweg", "RÜCKWEG", "Rickweg", "rueckweg", "décharge", "Zwolnienie", "BIRAKMA", "ОБРАТНЫЙ ход"})
    CHECK(strokeNamedBy(text) == Stroke::release);
  for (const char* text : {"wciśnięcie", "Drücken", "druecken", "Прямой ход", "Make", "Hin"})
    CHECK(strokeNamedBy(text) == Stroke::press);
}

TEST_CASE("Words whose beginning a sample hides are known by their ends", "[legend]") {
  CHECK(strokeNamedBy("ssing") == Stroke::press);
  CHECK(strokeNamedBy("leasing") == Stroke::release);
  CHECK(mayBeOnePair("ssing", "leasing"));
  for (const char* text : {"stroke", "sing", "asten", "leasing Red"})
    CHECK(strokeNamedBy(text) == std::nullopt);
}

TEST_CASE("Names that programs give to what nobody named", "[legend]") {
  for (const char* text : {"data1", "Series 2", "Seriesl", "Datenreihen1", "Série1", "Ряд2", "系列1",
                           "trace 0", "Column B", "'run.txt' using 1:2"})
    CHECK(isDefaultName(text));
  for (const char* text :
       {"", "data", "Series", "Series Red", "Sample 1", "Switch 1", "Run 2", "Series1 new", "Column 55"})
    CHECK_FALSE(isDefaultName(text));
}

TEST_CASE("What names no stroke, both, or a point", "[legend]") {
  for (const char* text :
       {"", "Force (gf)", "pressure", "press and release", "reset point", "Operating position", "Druckpunkt",
        "复位点", "Punto de liberación", "Rückstellpunkt", "55gf", "\xff\xfe", "uptown"})
    CHECK(strokeNamedBy(text) == std::nullopt);
}

TEST_CASE("Two names of one switch's strokes, and of two switches", "[legend]") {
  CHECK(mayBeOnePair("press", "release"));
  CHECK(mayBeOnePair("Gateron Red press", "Gateron Red release"));
  CHECK(mayBeOnePair("Switch A", "Switch A release"));
  CHECK(mayBeOnePair("going down", "coming up"));
  CHECK(mayBeOnePair("Run 1 - compression", "Run 1 - return"));
  CHECK(mayBeOnePair("", "Switch B"));
  CHECK(mayBeOnePair("Operating point", "Reset point"));
  CHECK_FALSE(mayBeOnePair("Switch A", "Switch B"));
  CHECK_FALSE(mayBeOnePair("downstroke_a", "downstroke_b"));
  CHECK_FALSE(mayBeOnePair("Brown press", "Red release"));
  // An empty name is a short name that was not read; a name with wear is another switch's.
  for (const char* worn : {"after 1 million strokes", "500k cycles", "nach 10^6 Schaltspielen", "100万次后"})
    CHECK_FALSE(mayBeOnePair("", worn));
  CHECK(mayBeOnePair("press, 3 cycles", "release, 3 cycles"));
}

TEST_CASE("Among several switches a pair has to name the same one", "[legend]") {
  CHECK(namesOnePair("Switch A", "Switch A release"));
  CHECK(namesOnePair("downstroke_aura", "upstroke_aura"));
  CHECK(namesOnePair("Switch 1 press", "Switch 1 release"));
  CHECK_FALSE(namesOnePair("Switch 1 press", "Switch 2 release"));
  CHECK_FALSE(namesOnePair("Switch A", "Switch B release"));
  CHECK_FALSE(namesOnePair("Switch A", "Switch A"));
  CHECK_FALSE(namesOnePair("", "release"));
}

TEST_CASE("Both tints of a hue bring both names", "[legend]") {
  CHECK(namesBothStrokes("T1 downstroke / T1 upstroke"));
  CHECK_FALSE(namesBothStrokes("T1 downstroke"));
  CHECK_FALSE(namesBothStrokes("T1 / upstroke"));
}

TEST_CASE("A word that says where to alone says nothing beside others", "[legend]") {
  CHECK(strokeNamedBy("Op") == Stroke::release);
  CHECK(strokeNamedBy("Neer") == Stroke::press);
  CHECK(mayBeOnePair("Neer", "Op"));
  CHECK(switchNamedBy("Op").empty());
  CHECK_FALSE(strokeNamedBy("kracht op knop"));
  CHECK(switchNamedBy("model op") == "model op");
}

TEST_CASE("A switch is called what its strokes' names share", "[legend]") {
  CHECK(switchNamedBy("Switch A release") == "Switch A");
  CHECK(switchNamedBy("downstroke_aura") == "aura");
  CHECK(switchNamedBy("T1 (JWK) - downstroke") == "T1 (JWK)");
  CHECK(switchNamedBy("Boba (w/Clear-slotted top)") == "Boba (w/Clear-slotted top)");
  CHECK(switchNamedBy("Switch A (press)") == "Switch A");
  CHECK(switchNamedBy("T1 downstroke / T1 upstroke") == "T1");
  CHECK(switchNamedBy("press") == "");
  CHECK(switchNamedBy("") == "");
}
