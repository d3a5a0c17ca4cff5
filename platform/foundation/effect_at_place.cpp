#include "foundation/effect_at_place.h"

#include <string_view>

namespace lacuna {
namespace {

constexpr std::string_view kBetween = " @ ";

}  // namespace

std::string to_string(const EffectAtPlace& effect) { return effect.effect + std::string(kBetween) + effect.place; }

EffectAtPlace effect_at_place_from(const std::string& text) {
  const std::size_t end = text.rfind(kBetween);
  if (end == std::string::npos) return {text, ""};
  return {text.substr(0, end), text.substr(end + kBetween.size())};
}

}  // namespace lacuna
