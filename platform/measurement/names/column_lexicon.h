#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lacuna {

/// What a word in a column's name says of the column, in the languages that programs for measurements speak.
enum class WordKind {
  trial,    ///< numbers trials: run, versuch
  counter,  ///< stands beside such a word: number, nr, id
  wanted,   ///< what a quantity should be: ref, setpoint, soll, consigne
  ordered,  ///< what was sent, alone a command, beside a coordinate what it should be: cmd, commande
  input,    ///< what goes into the rig, beside a coordinate only an adjective: u, input, drive
  current,  ///< electric, beside a coordinate "at this moment": current
  voltage,  ///< of a drive
  effort,   ///< torque, force
  velocity,
  position,
  time,
  measured,  ///< measured, actual, ist: tells nothing of the quantity
  filler,    ///< tells nothing at all
  supply,    ///< of a voltage or a current that it is not a motor's: main, bus
  bystander  ///< makes of any quantity something that is none of the motion: error, acceleration, battery
};

/// Of a word in lower case without accents; nothing if it is not known.
std::optional<WordKind> kind_of_word(std::string_view word);

/// `sollwinkel` → soll, winkel; `motorstrom` → motor, strom; `pendelwinkel` → pendel, winkel; `thetadot` → theta, dot.
/// A word that is not made of others is left whole.
std::vector<std::string> parts_of_compound(const std::string& word);

/// Lower case, Greek letters by their names, Latin ones without accents (ä as ae), other characters as they are.
std::string plain_letters(std::string_view text);

}  // namespace lacuna
