#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lacuna {

/// The meaning of a word in a column's name, in the languages of measurement programs.
enum class WordKind {
  trial,    ///< numbers trials: run, versuch
  counter,  ///< occurs beside such a word: number, nr, id
  wanted,   ///< setpoint of a quantity: ref, setpoint, soll, consigne
  ordered,  ///< a command; beside a coordinate its setpoint: cmd, commande
  input,    ///< input of the rig; beside a coordinate only an adjective: u, input, drive
  current,  ///< electric current; beside a coordinate "at this moment": current
  voltage,  ///< of a drive
  effort,   ///< torque, force
  velocity,
  position,
  time,
  measured,  ///< measured, actual, ist: no information on the quantity
  filler,    ///< no information
  supply,    ///< a voltage or current that is not a motor's: main, bus
  bystander  ///< not a motion, whatever the quantity: error, acceleration, battery
};

/// For a word in lower case without accents; nothing if it is not known.
std::optional<WordKind> kind_of_word(std::string_view word);

/// `sollwinkel` → soll, winkel; `motorstrom` → motor, strom; `pendelwinkel` → pendel, winkel; `thetadot` → theta, dot.
/// A word that is not a compound is left whole.
std::vector<std::string> parts_of_compound(const std::string& word);

/// Lower case, Greek letters by their names, Latin ones without accents (ä as ae), other characters as they are.
std::string plain_letters(std::string_view text);

}  // namespace lacuna
