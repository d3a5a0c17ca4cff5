#pragma once

#include <lacuna/effect_list.h>

#include <string>

namespace lacuna {

/// Edits of `model.effects` in the text of an experiment file. Everything else stays as it is, byte
/// for byte: comments, layout, line ends, a missing last line end. The list may stand in any form
/// that TOML has: on one line or several, as [[model.effects]], in an inline table, or not at all.
/// Each result is read again and compared: it differs from the text by that effect alone.

/// The text with `effect` at the end of the list. Throws `BadInput` where the text is not TOML, and
/// `Error` where its id is taken, there is no [model], or the list cannot be edited in its layout.
std::string insert_effect(const std::string& text, const EffectEntry& effect);

/// The text without the effect `id`, with what stands on its own lines (a comment behind it too).
/// Throws as above, and `Error` where there is no such effect.
std::string remove_effect(const std::string& text, const std::string& id);

/// An effect as an inline table: `{ id = "friction", effect = "coulomb_friction", where = "joint.hinge" }`.
std::string effect_as_toml(const EffectEntry& effect);

}  // namespace lacuna
