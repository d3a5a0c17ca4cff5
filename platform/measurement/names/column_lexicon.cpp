#include "measurement/names/column_lexicon.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <unordered_map>
#include <utility>

namespace lacuna {
namespace {

using Lexicon = std::unordered_map<std::string_view, WordKind>;

struct WordsOfKind {
  WordKind kind;
  std::vector<std::string_view> words;
};

const std::vector<WordsOfKind>& all_words() {
  static const std::vector<WordsOfKind> kWords = {
      {WordKind::trial,
       {"trial", "run", "episode", "experiment", "segment", "repetition", "rep", "versuch", "lauf", "messung", "essai",
        "prova", "ensayo"}},
      {WordKind::counter, {"number", "nr", "no", "num", "id", "index", "idx", "name", "label"}},
      {WordKind::wanted,
       {"ref",     "reference", "referenz",   "des",         "desired",    "setpoint",         "sp",
        "goal",    "target",    "tgt",        "soll",        "sollwert",   "fuehrungsgroesse", "vorgabe",
        "ziel",    "demand",    "demanded",   "planned",     "wanted",     "consigne",         "consigna",
        "deseado", "deseada",   "referencia", "riferimento", "desiderato", "desiderata"}},
      {WordKind::ordered, {"cmd", "cmnd", "command", "commanded", "commande", "comando", "befehl"}},
      {WordKind::input,
       {"u", "input", "drive", "control", "ctrl", "throttle", "actuation", "stellgroesse", "stellgrad", "vir", "pwm",
        "duty", "dutycycle", "mando"}},
      {WordKind::current,
       {"current", "i", "strom", "curr", "amps", "amperage", "courant", "corriente", "corrente", "stroom"}},
      {WordKind::voltage, {"voltage", "volt", "volts", "spannung", "tension", "tensione", "voltaje", "spanning"}},
      {WordKind::effort,
       {"tau", "torque", "torques", "trq", "effort", "efforts", "force", "frc", "moment", "drehmoment", "kraft",
        "thrust", "couple", "coppia", "par", "fuerza", "forza", "koppel"}},
      {WordKind::velocity,
       {"dot",
        "qd",
        "dq",
        "qdot",
        "vel",
        "velocity",
        "velocities",
        "omega",
        "speed",
        "spd",
        "rate",
        "w",
        "dtheta",
        "dphi",
        "v",
        "rpm",
        "gyro",
        "tacho",
        "geschwindigkeit",
        "winkelgeschwindigkeit",
        "drehgeschwindigkeit",
        "drehzahl",
        "vitesse",
        "velocidad",
        "velocita",
        "snelheid"}},
      {WordKind::position,
       {"q",
        "qm",
        "pos",
        "position",
        "positions",
        "angle",
        "angles",
        "ang",
        "theta",
        "phi",
        "alpha",
        "beta",
        "psi",
        "x",
        "y",
        "z",
        "encoder",
        "enc",
        "displacement",
        "distance",
        "height",
        "altitude",
        "alt",
        "winkel",
        "drehwinkel",
        "weg",
        "lage",
        "stellung",
        "auslenkung",
        "hub",
        "hoehe",
        "abstand",
        "hauteur",
        "deplacement",
        "angolo",
        "posizione",
        "spostamento",
        "altezza",
        "angulo",
        "posicion",
        "desplazamiento",
        "altura",
        "hoek"}},
      {WordKind::time,
       {"t",       "time",     "timestamp", "stamp", "zeit",   "zeitstempel", "uhrzeit", "clock",  "sec",   "secs",
        "seconds", "sekunden", "ms",        "us",    "millis", "micros",      "temps",   "tiempo", "tempo", "tijd"}},
      {WordKind::measured,
       {"meas", "measured", "actual", "act",     "sensor", "ist",    "istwert",  "fb",       "fbk",  "feedback",
        "mess", "gemessen", "mesure", "mesuree", "medido", "medida", "misurato", "misurata", "real", "present"}},
      {WordKind::filler,
       {"motor", "joint", "raw", "value", "val", "wert", "m", "data", "signal", "gelenk", "moteur", "motore", "states",
        "state", "angular", "linear"}},
      {WordKind::bystander,
       {"acc",
        "accel",
        "acceleration",
        "beschleunigung",
        "ddot",
        "ddq",
        "qdd",
        "qddot",
        "error",
        "err",
        "fehler",
        "abweichung",
        "regelabweichung",
        "erreur",
        "errore",
        "supply",
        "battery",
        "batt",
        "vbat",
        "vbus",
        "akku",
        "enabled",
        "enable",
        "status",
        "flag",
        "power",
        "leistung",
        "aceleracion",
        "accelerazione",
        "temperature",
        "temperatures",
        "temp",
        "temperatur",
        "temperatura"}},
      {WordKind::supply, {"main", "mains", "bus", "dclink", "vin", "vcc", "psu", "netz", "versorgung"}}};
  return kWords;
}

const Lexicon& lexicon() {
  static const Lexicon kLexicon = [] {
    Lexicon words;
    for (const WordsOfKind& of_kind : all_words())
      for (const std::string_view word : of_kind.words) words.emplace(word, of_kind.kind);
    return words;
  }();
  return kLexicon;
}

/// German nouns that end compounds with any first word.
constexpr std::array<std::string_view, 10> kHeads = {"winkel", "strom",    "moment",   "spannung",   "geschwindigkeit",
                                                     "kraft",  "stellung", "drehzahl", "auslenkung", "position"};
constexpr std::size_t kShortestPart = 3;

bool is_coordinate(std::string_view word) { return kind_of_word(word) == WordKind::position; }

/// The plain letter for a character in UTF-8, and its size in bytes.
struct Folded {
  std::string_view character, letters;
};
constexpr Folded kFolded[] = {
    {"ä", "ae"},    {"ö", "oe"},    {"ü", "ue"},    {"Ä", "ae"},    {"Ö", "oe"},   {"Ü", "ue"},  {"ß", "ss"},
    {"é", "e"},     {"è", "e"},     {"ê", "e"},     {"É", "e"},     {"È", "e"},    {"á", "a"},   {"à", "a"},
    {"â", "a"},     {"Á", "a"},     {"À", "a"},     {"í", "i"},     {"ì", "i"},    {"î", "i"},   {"ó", "o"},
    {"ò", "o"},     {"ô", "o"},     {"Ó", "o"},     {"ú", "u"},     {"ù", "u"},    {"û", "u"},   {"ñ", "n"},
    {"ç", "c"},     {"θ", "theta"}, {"Θ", "theta"}, {"ϑ", "theta"}, {"φ", "phi"},  {"ϕ", "phi"}, {"Φ", "phi"},
    {"ω", "omega"}, {"Ω", "omega"}, {"τ", "tau"},   {"α", "alpha"}, {"β", "beta"}, {"ψ", "psi"}};

}  // namespace

std::optional<WordKind> kind_of_word(std::string_view word) {
  const auto known = lexicon().find(word);
  return known == lexicon().end() ? std::nullopt : std::optional(known->second);
}

std::vector<std::string> parts_of_compound(const std::string& word) {
  if (kind_of_word(word)) return {word};
  for (std::size_t cut = kShortestPart; cut + kShortestPart <= word.size(); ++cut) {
    const std::string first = word.substr(0, cut), rest = word.substr(cut);
    if (!kind_of_word(first)) continue;
    const std::vector<std::string> others = parts_of_compound(rest);
    if (others.size() == 1 && !kind_of_word(rest)) continue;
    std::vector<std::string> parts{first};
    parts.insert(parts.end(), others.begin(), others.end());
    return parts;
  }
  if (word.ends_with("dot") && is_coordinate(word.substr(0, word.size() - 3)))
    return {word.substr(0, word.size() - 3), "dot"};
  for (const std::string_view head : kHeads)
    if (word.size() >= head.size() + kShortestPart && word.ends_with(head))
      return {word.substr(0, word.size() - head.size()), std::string(head)};
  return {word};
}

std::string plain_letters(std::string_view text) {
  std::string plain;
  while (!text.empty()) {
    const auto folded = std::find_if(std::begin(kFolded), std::end(kFolded),
                                     [&](const Folded& one) { return text.starts_with(one.character); });
    if (folded != std::end(kFolded)) {
      plain += folded->letters;
      text.remove_prefix(folded->character.size());
      continue;
    }
    plain += static_cast<char>(std::tolower(static_cast<unsigned char>(text.front())));
    text.remove_prefix(1);
  }
  return plain;
}

}  // namespace lacuna
