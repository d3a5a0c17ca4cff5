#pragma once

#include <lacuna/physical_effect.h>

#include <string>

namespace lacuna {

/// The unit of an effect's parameter on one element: the words of its declared unit
/// (`{force}` and so on, lacuna/physical_effect.h) replaced by the element's units. A word that the
/// element has no unit for stays as it is; `parse_unit` then rejects it.
std::string unit_at(const std::string& declared, const RobotSpec& robot, ElementKind kind, int element);

/// Whether the declared unit, its words replaced, is a unit on every element of that kind.
bool is_unit_on(ElementKind kind, const std::string& declared);

/// The words that a unit may have there: "{position}, {force}, {inertia}"; empty: none.
std::string unit_words_on(ElementKind kind);

/// The same for a reader who has no robot before him: "N*m (N on a slider)", "the channel's unit".
std::string unit_in_words(const std::string& declared);

}  // namespace lacuna
