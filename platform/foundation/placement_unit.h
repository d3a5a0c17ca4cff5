#pragma once

#include <lacuna/physical_effect.h>

#include <string>

namespace lacuna {

/// The unit of an effect's parameter on one element: the placeholders of its declared unit (`{force}` and so on,
/// lacuna/physical_effect.h) replaced by the element's units. A placeholder without a unit on this element stays;
/// `parse_unit` then rejects it.
std::string unit_at(const std::string& declared, const RobotSpec& robot, ElementKind kind, int element);

/// Whether the declared unit, with its placeholders replaced, is a unit on every element of that kind.
bool is_unit_on(ElementKind kind, const std::string& declared);

/// The placeholders that a unit may have there: "{position}, {force}, {inertia}"; empty: none.
std::string unit_words_on(ElementKind kind);

/// The same without a particular robot: "N*m (N on a slider)", "the channel's unit".
std::string unit_in_words(const std::string& declared);

}  // namespace lacuna
