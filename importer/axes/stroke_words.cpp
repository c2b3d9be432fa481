// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/axes/stroke_words.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "importer/axes/word_match.h"

namespace detent::importer {
namespace {

// As `folded` writes them; a line or two to a language. No std::array: clang 14 deduces none of over 256.
constexpr std::string_view kPressWords[] = {
    // English
    "press", "pressing", "pressed", "downstroke", "down", "downward", "downwards", "push", "pushing",
    "pushed", "forward", "forwards", "loading", "load", "depress", "depressing", "actuate", "actuation",
    "actuating", "in", "make", "compress", "compressing", "advance", "insertion", "outbound", "fwd",
    "approach", "engage", "increasing", "operate", "operating", "lowering", "lowered", "adding", "descending",
    "descent", "ingoing", "inward", "inwards", "applying", "squeeze", "squeezing",
    // German
    "hinweg", "hin", "vorlauf", "hinlauf", "drucken", "gedruckt", "eindrucken", "niederdrucken",
    "herunterdrucken", "betatigen", "betatigung", "belasten", "belastung", "hinhub", "vorhub", "abwarts",
    "vorwarts", "runter", "einfahren", "herunter", "hinunter", "hinab", "rein", "absenken", "senken",
    "auflegen",
    // French
    "appui", "appuyer", "appuye", "enfoncer", "enfonce", "enfoncement", "aller", "descente", "charge",
    "compression", "pression", "presser", "actionnement", "activation", "poussee", "pousser", "descendant",
    "descendre", "abaissement", "abaisser", "baisser",
    // Spanish, Portuguese, Catalan
    "ida", "pulsar", "pulsado", "pulsacion", "pulsando", "bajada", "descenso", "carga", "presion",
    "presionar", "presionando", "presionado", "apretar", "avance", "accionamiento", "abajo", "pressao",
    "acionamento", "pressionar", "pressionando", "pressionamento", "premir", "apertar", "aperto", "avanco",
    "descida", "carregamento", "compressao", "baixo", "pulsacio", "premer", "anada", "bajando", "empuje",
    "adelante", "bajar", "hundir", "hundimiento", "descer", "descendo",
    // Italian, Romanian
    "andata", "pressione", "premuto", "premendo", "discesa", "carico", "azionamento", "compressione",
    "schiacciamento", "apasare", "apasat", "presare", "incarcare", "coborare", "actionare", "comprimare",
    "premere", "spinta", "dus", "scendere", "scendendo", "abbassamento", "giu",
    // Dutch
    "indrukken", "ingedrukt", "drukken", "heen", "heenweg", "heengaand", "belasting", "neergaand", "omlaag",
    "neerwaarts", "heenreis", "neer", "beneden", "neergang", "neerdrukken", "duwen", "induwen", "inveren",
    // Swedish, Norwegian, Danish, Icelandic
    "tryck", "trycka", "tryckning", "nedtryck", "nedtryckning", "intryckning", "intryck", "nedat",
    "belastning", "tryk", "trykk", "trykke", "trykning", "nedtrykning", "nedtrykking", "nedtrykk", "nedtryk",
    "inntrykking", "indtrykning", "trykking", "nedover", "nedad", "ned", "fram", "framat", "frem", "fremad",
    "dit", "inn", "ind", "ner",
    // Finnish, Estonian, Latvian, Lithuanian
    "painallus", "painaminen", "painettaessa", "painaessa", "alas", "alaspain", "kuormitus", "puristus",
    "vajutus", "vajutamine", "nospiesana", "nospiezot", "paspaudimas", "spaudimas", "nuspaudimas", "meno",
    "menosuunta", "sisaan", "eteenpain", "edasi", "turp", "pirmyn",
    // Polish
    "nacisk", "naciskanie", "nacisniecie", "nacisniety", "wciskanie", "wcisniecie", "wcisk", "docisk",
    "dociskanie", "sciskanie", "obciazanie", "obciazenie", "tam", "dol", "opuszczanie",
    // Czech, Slovak
    "stisk", "stisknuti", "stisknuto", "stlaceni", "stlacovani", "zatizeni", "zatezovani", "zmacknuti",
    "stlacenie", "stlacanie", "stlacovanie", "zatazenie", "zatazovanie", "dolu", "nadol", "vpred",
    // Hungarian, Turkish
    "nyomas", "lenyomas", "lenyomaskor", "benyomas", "megnyomas", "terheles", "basma", "basis", "basarken",
    "bastirma", "basilma", "basildi", "yukleme", "asagi", "sikistirma", "oda", "lefele", "gidis", "ileri",
    "itme",
    // Slovene, Croatian, Serbian
    "pritisk", "pritisak", "pritiskanje", "stiskanje", "opterecenje", "naprej", "naprijed", "napred", "tja",
    "tamo", "navzdol", "dolje",
    // Indonesian, Vietnamese
    "tekan", "menekan", "ditekan", "penekanan", "maju", "turun", "pergi", "nhan", "xuong",
    // Russian, Ukrainian, Bulgarian, Serbian
    "нажатие", "нажим", "нажато", "нагрузка", "нагружение", "прямой", "надавливание", "сжатие", "вниз",
    "натискання", "натиснення", "натиск", "навантаження", "стискання", "натискане", "натоварване", "притисак",
    "притискање", "туда", "вперед", "туди", "напред", "тамо", "опускание",
    // Greek
    "πιεση", "πατημα", "συμπιεση", "φορτιση", "πιεζω", "κατω", "μεταβαση", "εμπρος"};
constexpr std::string_view kReleaseWords[] = {
    // English
    "release", "releasing", "released", "upstroke", "up", "upward", "upwards", "return", "returning", "back",
    "backward", "backwards", "reverse", "unloading", "unload", "reset", "out", "break", "decompress",
    "retract", "retraction", "inbound", "bwd", "bkwd", "withdraw", "withdrawal", "disengage", "decreasing",
    "raising", "raised", "removing", "ascending", "ascent", "outgoing", "outward", "outwards", "lifting",
    "lifted", "relieving",
    // German
    "ruckweg", "zuruck", "her", "losen", "ruckzug", "rucklauf", "ruckhub", "ruckgang", "loslassen",
    "losgelassen", "entlasten", "entlastung", "ruckstellung", "ruckkehr", "freigabe", "freigeben", "aufwarts",
    "ruckwarts", "ausfahren", "herauf", "hinauf", "raus", "anheben", "heben", "abnehmen",
    // French
    "relachement", "relacher", "relache", "remontee", "decharge", "retour", "decompression", "detente",
    "liberation", "montee", "arriere", "retrait", "ascendant", "monter", "remonter", "relevage", "relever",
    "lacher", "enlever",
    // Spanish, Portuguese, Catalan
    "vuelta", "soltar", "soltando", "soltado", "suelta", "liberacion", "liberar", "subida", "descarga",
    "retorno", "retroceso", "regreso", "arriba", "descompresion", "liberacao", "soltura", "alivio",
    "libertacao", "libertar", "volta", "regresso", "descarregamento", "descompressao", "cima", "alliberament",
    "recuo", "tornada", "subiendo", "atras", "subir", "levantar", "levantando", "subindo",
    // Italian, Romanian
    "ritorno", "rilascio", "rilasciato", "rilasciando", "risalita", "scarico", "salita", "decompressione",
    "eliberare", "eliberat", "revenire", "descarcare", "ridicare", "retragere", "intoarcere", "intors",
    "inapoi", "rilasciare", "indietro", "salire", "salendo", "sollevamento",
    // Dutch
    "loslaten", "losgelaten", "terug", "terugweg", "teruggaand", "terugkeer", "ontlasten", "ontlasting",
    "opgaand", "omhoog", "vrijgeven", "opwaarts", "terugreis", "uit", "opgang", "optillen", "uitveren",
    "terugveren",
    // Swedish, Norwegian, Danish, Icelandic
    "slapp", "slappa", "slappning", "uppslapp", "frislappning", "frigoring", "frigivning", "aterfjadring",
    "aterstallning", "atergang", "uppat", "avlastning", "tillbaka", "retur", "slipp", "slippe", "slipping",
    "slip", "oppslipp", "oppover", "opad", "tilbake", "tilbage", "aflastning", "frigivelse", "opp", "upp",
    "bakat", "ut", "ud",
    // Finnish, Estonian, Latvian, Lithuanian
    "vapautus", "vapauttaminen", "vapautettaessa", "palautus", "palautuminen", "paluu", "ylos", "ylospain",
    "vabastus", "vabastamine", "atlaisana", "atbrivosana", "atleidimas", "paleidimas", "paluusuunta", "ulos",
    "taaksepain", "purku", "tagasi", "atpakal", "atgal",
    // Polish
    "zwolnienie", "zwalnianie", "zwolniony", "puszczanie", "puszczenie", "odpuszczanie", "odpuszczenie",
    "powrot", "powrotny", "powrotem", "odciazanie", "odciazenie", "gora", "gore", "podnoszenie",
    // Czech, Slovak
    "uvolneni", "uvolnovani", "uvolneno", "pusteni", "povoleni", "navrat", "odlehceni", "odlehcovani",
    "uvolnenie", "uvolnovanie", "pustenie", "odlahcenie", "zpet", "zpatky", "nahoru", "spat", "nahor", "vzad",
    // Hungarian, Turkish
    "vissza", "felfele", "felengedes", "elengedes", "elengedeskor", "kiengedes", "visszateres",
    "visszaengedes", "tehermentesites", "birakma", "birakis", "birakirken", "birakildi", "salma", "geri",
    "donus", "bosaltma", "yukari", "serbest",
    // Slovene, Croatian, Serbian
    "sprostitev", "spuscanje", "popuscanje", "otpustanje", "pustanje", "povratak", "rasterecenje", "nazaj",
    "natrag", "nazad", "navzgor",
    // Indonesian, Vietnamese
    "lepas", "melepas", "dilepas", "pelepasan", "mundur", "naik", "pulang", "nha", "tha", "len",
    // Russian, Ukrainian, Bulgarian, Serbian
    "отпускание", "отпущено", "возврат", "разгрузка", "разгружение", "обратный", "отжатие", "вверх",
    "відпускання", "відпущення", "відпуск", "повернення", "розвантаження", "звільнення", "зворотний", "вгору",
    "отпускане", "освобождаване", "връщане", "разтоварване", "отпуштање", "обратно", "назад", "подъем",
    // Greek
    "απελευθερωση", "αφεση", "επιστροφη", "αποφορτιση", "αποσυμπιεση", "επαναφορα", "πανω", "πισω"};

constexpr std::array kPressSigns = {
    "按压", "按下", "按动", "下压",     "压下",   "压入", "按入", "去程", "往程", "加载",  "正程",
    "下行", "下降", "压缩", "施压",     "向下",   "按壓", "按動", "下壓", "壓下", "壓入",  "加載",
    "壓縮", "施壓", "押下", "押し込み", "押込み", "押す", "押し", "押込", "押圧", "加圧",  "往路",
    "圧縮", "行き", "下り", "プレス",   "누름",   "누르", "눌림", "누를", "가압", "하강",  "압축",
    "กด",   "前进", "进程", "正行程",   "正向",   "前進", "往動", "전진", "ضغط",  "לחיצה", "दबा"};
constexpr std::array kReleaseSigns = {
    "释放",   "松开", "放开", "松手", "放手", "抬起",  "回弹",  "弹回",  "回程",     "返程",     "弹起",
    "复位",   "卸载", "反程", "上行", "上升", "返回",  "向上",  "釋放",  "鬆開",     "放開",     "鬆手",
    "回彈",   "彈回", "彈起", "復位", "卸載", "解放",  "開放",  "戻り",  "リリース", "リターン", "戻し",
    "戻る",   "離す", "離し", "復路", "復帰", "除荷",  "除圧",  "上り",  "帰り",     "복귀",     "해제",
    "놓기",   "놓음", "떼기", "뗌",   "이완", "감압",  "상승",  "복원",  "ปล่อย",     "后退",     "退程",
    "反行程", "反向", "後退", "復動", "후진", "تحرير", "إفلات", "שחרור", "छोड़"};

/// Words that say so alone: beside others they are "on" or an article.
constexpr std::array<std::string_view, 1> kLonePressWords = {"le"};
constexpr std::array<std::string_view, 3> kLoneReleaseWords = {"op", "su", "fel"};

/// Ways that arrows point: the key goes down or on, and up or back. At a name's beginning or end; between words they lead from one to
/// the next.
constexpr std::array kPressArrows = {"↓", "⇓", "⬇", "▼", "→"};
constexpr std::array kReleaseArrows = {"↑", "⇑", "⬆", "▲", "←"};

/// A text with one of these names a point on a curve, not the curve.
constexpr std::array kPointWords = {
    "point",   "points",  "position", "pos",   "punkt",   "punto", "ponto",    "punt",     "bod",
    "piste",   "nokta",   "noktasi",  "punct", "punctul", "pont",  "pkt",      "posicion", "posizione",
    "posicao", "positie", "poloha",   "konum", "tocka",   "точка", "положение"};

// What every legend names: a curve, or what it is a curve of.
constexpr std::array kCurveWords = {
    "stroke",   "curve",     "key",       "switch",  "going",    "coming",   "run",     "the",
    "of",       "on",        "hub",       "csv",     "txt",      "dat",      "ход",     "phase",
    "hod",      "kurve",     "kurva",     "curva",   "courbe",   "krzywa",   "krivka",  "kayra",
    "egri",     "corsa",     "skok",      "slag",    "fase",     "faza",     "carrera", "curso",
    "кривая",   "крива",     "хід",       "de",      "da",       "do",       "del",     "la",
    "le",       "der",       "des",       "beim",    "hacia",    "para",     "vers",    "cursa",
    "course",   "trajet",    "pohyb",     "smer",    "ruch",     "kierunek", "yonu",    "direction",
    "richtung", "direccion", "direzione", "direcao", "riktning", "retning",  "sens",    "movement",
    "motion",   "isku",      "zdvih"};
constexpr std::array kCurveSigns = {"曲线", "曲線", "过程", "過程", "行程", "阶段", "곡선"};

/// German names of curves by what they are of: "Rückstellkurve", "Entlastungsvorgang".
constexpr std::array kPressFirsts = {"betatigungs", "belastungs", "hin", "vor", "druck", "abwarts"};
constexpr std::array kReleaseFirsts = {"ruckstell", "entlastungs", "loslass", "ruck", "aufwarts", "freigabe"};
constexpr std::array kCurveLasts = {"kurve",    "hub",      "lauf",  "vorgang", "gang",
                                    "bewegung", "richtung", "phase", "ast",     "linie"};

bool isContinuation(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

std::size_t lettersIn(std::string_view word) {
  return static_cast<std::size_t>(std::ranges::count_if(word, [](char c) { return !isContinuation(c); }));
}

/// What readers of pixels take for each other written alike: "rn" and "m", "ii", "ti" and "u", "vv" and "w", "i", "j" and "l",
/// "y" and "v".
std::string looked(std::string_view word) {
  std::string look;
  for (std::size_t i = 0; i < word.size(); ++i) {
    const std::string_view two = word.substr(i, 2);
    if (two == "rn" || two == "ii" || two == "ti" || two == "vv") {
      look += two == "rn" ? 'm' : two == "vv" ? 'w' : 'u';
      ++i;
    } else {
      look += word[i] == 'i' || word[i] == 'j' ? 'l' : word[i] == 'y' ? 'v' : word[i];
    }
  }
  return look;
}

/// Letters that may be wrong in a word of so many.
std::size_t forgiven(std::size_t letters) { return letters >= 9 ? 2 : letters >= 6 ? 1 : 0; }

constexpr std::size_t kFar = 100;  // letters wrong: another word

/// How many letters of a word are wrong if it is one of the list's; `kFar` if more than are forgiven.
template <class List>
std::size_t wrongLetters(std::string_view word, const List& list) {
  constexpr std::size_t fewest = 4;  // letters of a word that may be spelled by its look
  const std::string look = looked(word);
  std::size_t least = kFar;
  for (const std::string_view known : list) {
    if (word == known) return 0;
    const std::size_t letters = std::min(lettersIn(word), lettersIn(known));
    if (letters < fewest) continue;
    const std::size_t most = forgiven(letters), wrong = editsBetween(look, looked(known), most);
    if (wrong <= most) least = std::min(least, wrong + 1);  // a word as it is spelled is nearer
  }
  return least;
}

template <class List>
bool isCompound(std::string_view word, const List& firsts) {
  return std::ranges::any_of(firsts, [&](std::string_view first) {
    return word.starts_with(first) &&
           std::ranges::find(kCurveLasts, word.substr(first.size())) != kCurveLasts.end();
  });
}

std::optional<Stroke> onlyOne(bool press, bool release) {
  if (press == release) return {};
  return press ? Stroke::press : Stroke::release;
}

/// Greek, Cyrillic or Latin: what stands for a letter and its accents; 0 for an accent by itself.
char32_t foldedLetter(char32_t c) {
  constexpr std::u32string_view latin =  // U+00C0 to U+017F; a sign that is no letter stays itself
      U"aaaaaaaceeeeiiiidnooooo ouuuuypsaaaaaaaceeeeiiiidnooooo "
      U"ouuuuypyaaaaaaccccccccddddeeeeeeeeeegggggggghhhh"
      U"iiiiiiiiiiiijjkkklllllll"
      U"lllnnnnnnnnnoooooooorrrrrrssssssssttttttuuuuuuuuuuuuwwyyyzzzzzzs";
  struct Range {
    char32_t first, last, letter;
  };
  constexpr std::array<Range, 14> ranges{{{0x1A0, 0x1A1, U'o'},
                                          {0x1AF, 0x1B0, U'u'},
                                          {0x218, 0x219, U's'},
                                          {0x21A, 0x21B, U't'},
                                          {0x300, 0x36F, 0},
                                          {0x1EA0, 0x1EB7, U'a'},
                                          {0x1EB8, 0x1EC7, U'e'},
                                          {0x1EC8, 0x1ECB, U'i'},
                                          {0x1ECC, 0x1EE3, U'o'},
                                          {0x1EE4, 0x1EF1, U'u'},
                                          {0x1EF2, 0x1EF9, U'y'},
                                          {0x3C2, 0x3C2, U'σ'},
                                          {0x451, 0x451, U'е'},
                                          {0x401, 0x401, U'е'}}};
  constexpr std::u32string_view accented = U"άέήίόύώΆΈΉΊΌΎΏ", plain = U"αεηιουωαεηιουω";
  if (c >= U'A' && c <= U'Z') return c + 0x20;
  if (c >= 0xC0 && c <= 0x17F) return latin[c - 0xC0] == U' ' ? c : latin[c - 0xC0];
  for (const Range& range : ranges)
    if (c >= range.first && c <= range.last) return range.letter;
  if (const auto at = accented.find(c); at != std::u32string_view::npos) return plain[at];
  if (c >= 0x391 && c <= 0x3A9) return c + 0x20;  // Greek capitals
  if (c >= 0x410 && c <= 0x42F) return c + 0x20;  // Cyrillic capitals, and those that stand before А
  if (c >= 0x400 && c <= 0x40F) return c + 0x50;
  if (c >= 0xFF21 && c <= 0xFF5A) return foldedLetter(c - 0xFF21 + U'A');  // as wide as ideographs
  return c;
}

/// Of two or three bytes; what is not well formed comes back byte by byte.
struct Decoded {
  char32_t letter;
  std::size_t bytes;
};
Decoded decodedAt(std::string_view utf8, std::size_t at) {
  const auto byte = [&](std::size_t k) {
    return at + k < utf8.size() ? static_cast<unsigned char>(utf8[at + k]) : 0U;
  };
  const auto more = [&](std::size_t k) { return (byte(k) & 0xC0U) == 0x80U; };
  if (byte(0) >= 0xC2 && byte(0) <= 0xDF && more(1)) return {(byte(0) & 0x1FU) << 6 | (byte(1) & 0x3FU), 2};
  if (byte(0) >= 0xE0 && byte(0) <= 0xEF && more(1) && more(2))
    return {(byte(0) & 0x0FU) << 12 | (byte(1) & 0x3FU) << 6 | (byte(2) & 0x3FU), 3};
  return {byte(0), 1};
}

void appendLetter(std::string& text, char32_t letter) {
  const auto put = [&](char32_t byte) { text += static_cast<char>(static_cast<unsigned char>(byte)); };
  if (letter < 0x80) {
    put(letter);
  } else {
    put(0xC0U | letter >> 6);  // all that are folded lie below U+0800
    put(0x80U | (letter & 0x3FU));
  }
}

/// A small Cyrillic letter in the Latin ones it looks like; capitals look as small ones do.
std::string_view latinLook(char32_t letter) {
  constexpr std::u32string_view letters = U"абвгдежзийклмнопрстуфхцчшщъыьэюяіїєґ";
  constexpr std::array<std::string_view, 36> looks{
      "a", "6", "b", "r", "a", "e", "x", "3", "u", "u",  "k", "n", "m",  "h", "o", "n", "p", "c",
      "t", "y", "o", "x", "u", "y", "w", "w", "b", "bi", "b", "3", "10", "a", "i", "i", "e", "r"};
  const auto at = letters.find(letter);
  return at == std::u32string_view::npos ? std::string_view() : looks[at];
}

/// Empty if a letter of it is not Cyrillic.
std::string latinLookOf(std::string_view word) {
  std::string look;
  for (std::size_t at = 0; at < word.size();) {
    const Decoded is = decodedAt(word, at);
    const std::string_view letter = latinLook(is.letter);
    if (letter.empty()) return {};
    look += letter;
    at += is.bytes;
  }
  return look;
}

struct Look {
  std::string_view word;
  std::string latin;
};

/// Of the words with so many letters that a Latin one is not like them by chance.
std::vector<Look> cyrillicLooks() {
  constexpr std::size_t fewest = 6;  // letters
  std::vector<Look> looks;
  const auto add = [&](const auto& list) {
    for (const std::string_view word : list)
      if (std::string latin = latinLookOf(word); latin.size() >= fewest)
        looks.push_back({word, std::move(latin)});
  };
  add(kPressWords);
  add(kReleaseWords);
  return looks;
}

}  // namespace

std::string folded(std::string_view utf8) {
  std::string out;
  for (std::size_t at = 0; at < utf8.size();) {
    const Decoded is = decodedAt(utf8, at);
    const char32_t letter = foldedLetter(is.letter);
    const bool single = is.bytes == 1 && is.letter >= 0x80;
    if (letter == is.letter || single)
      out += utf8.substr(at, is.bytes);
    else if (letter != 0)
      appendLetter(out, letter);
    at += is.bytes;
  }
  return out;
}

std::optional<Stroke> strokeOfWord(std::string_view word) {
  const std::size_t press = wrongLetters(word, kPressWords), release = wrongLetters(word, kReleaseWords);
  if (press != release) return press < release ? Stroke::press : Stroke::release;
  return onlyOne(isCompound(word, kPressFirsts), isCompound(word, kReleaseFirsts));
}

std::optional<Stroke> strokeOfLoneWord(std::string_view word) {
  const auto isIn = [&](const auto& list) { return std::ranges::find(list, word) != list.end(); };
  return onlyOne(isIn(kLonePressWords), isIn(kLoneReleaseWords));
}

std::optional<Stroke> strokeOfPart(std::string_view word) {
  constexpr std::size_t fewest = 5;
  constexpr double most = 0.6;  // of a word whose end is hidden
  if (lettersIn(word) < fewest) return {};
  const auto isPart = [&](std::string_view known) {
    return known.ends_with(word) || (known.starts_with(word) && static_cast<double>(word.size()) >=
                                                                    most * static_cast<double>(known.size()));
  };
  return onlyOne(std::ranges::any_of(kPressWords, isPart), std::ranges::any_of(kReleaseWords, isPart));
}

bool isPointWord(std::string_view word) {
  const auto isOne = [&](std::string_view known) { return word == known; };
  return word.ends_with("punkt") || word.ends_with("punkten") || std::ranges::any_of(kPointWords, isOne) ||
         wrongLetters(word, kPointWords) < kFar;
}

SignedStrokes strokesSignedIn(std::string_view utf8) {
  const auto holds = [&](std::string_view sign) { return utf8.find(sign) != std::string_view::npos; };
  const auto isAtEnd = [&](std::string_view arrow) {
    return utf8.starts_with(arrow) || utf8.ends_with(arrow);
  };
  return {std::ranges::any_of(kPressSigns, holds) || std::ranges::any_of(kPressArrows, isAtEnd),
          std::ranges::any_of(kReleaseSigns, holds) || std::ranges::any_of(kReleaseArrows, isAtEnd)};
}

std::string withoutStrokeSigns(std::string_view word) {
  std::string rest(word);
  const auto take = [&](const auto& signs) {
    for (const std::string_view sign : signs)
      if (const auto at = rest.find(sign); at != std::string::npos) rest.erase(at, sign.size());
  };
  const auto takeFromEnds = [&](const auto& arrows) {
    for (const std::string_view arrow : arrows)
      if (rest.starts_with(arrow))
        rest.erase(0, arrow.size());
      else if (rest.ends_with(arrow))
        rest.resize(rest.size() - arrow.size());
  };
  take(kPressSigns);
  take(kReleaseSigns);
  takeFromEnds(kPressArrows);
  takeFromEnds(kReleaseArrows);
  if (rest.size() != word.size()) take(kCurveSigns);
  return rest;
}

std::string_view cyrillicWordLike(std::string_view read) {
  static const std::vector<Look> looks = cyrillicLooks();
  std::size_t least = kFar;
  std::string_view likest;
  for (const Look& look : looks) {
    const std::size_t most = forgiven(std::min(read.size(), look.latin.size())),
                      wrong = editsBetween(read, look.latin, most);
    if (wrong <= most && wrong < least) least = wrong, likest = look.word;
  }
  return likest;
}

bool isCurveWord(std::string_view word) { return wrongLetters(word, kCurveWords) < kFar; }

}  // namespace detent::importer
