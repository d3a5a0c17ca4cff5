#include "storage/results/revision_change.h"

#include "foundation/address.h"
#include "storage/core/canonical_text.h"

#include <algorithm>

namespace lacuna {
namespace {

bool contains(const EffectList& effects, const EffectEntry& entry) {
  return std::any_of(effects.begin(), effects.end(), [&](const EffectEntry& other) {
    return other.effect == entry.effect && other.where == entry.where && other.id == entry.id;
  });
}

EffectList only_in(const EffectList& effects, const EffectList& others) {
  EffectList only;
  std::copy_if(effects.begin(), effects.end(), std::back_inserter(only),
               [&](const EffectEntry& entry) { return !contains(others, entry); });
  return only;
}

std::string names(const EffectList& effects) {
  std::string text;
  for (const EffectEntry& entry : effects) text += (text.empty() ? "" : ", ") + entry.effect;
  return text;
}

void append(std::string& sentence, const std::string& part) {
  if (part.empty()) return;
  sentence += (sentence.empty() ? "" : ", ") + part;
}

/// The free values of effects, which come and go with them, or the robot's own.
std::vector<FreeValueRecord> free_values(const RevisionRecord& revision, bool of_effects) {
  std::vector<FreeValueRecord> free;
  std::copy_if(revision.free.begin(), revision.free.end(), std::back_inserter(free),
               [&](const FreeValueRecord& value) { return is_of_effect(value.address) == of_effects; });
  return free;
}

std::vector<FreeValueRecord> free_of_robot(const RevisionRecord& revision) { return free_values(revision, false); }

/// Addresses of the robot that are free in `after` alone; nothing where anything else of its free values differs.
std::vector<std::string> newly_free(const RevisionRecord& before, const RevisionRecord& after) {
  std::vector<FreeValueRecord> rest = free_of_robot(after);
  std::vector<std::string> addresses;
  std::erase_if(rest, [&](const FreeValueRecord& value) {
    const bool is_known = std::any_of(before.free.begin(), before.free.end(),
                                      [&](const FreeValueRecord& old) { return old.address == value.address; });
    if (!is_known) addresses.push_back(value.address);
    return !is_known;
  });
  return canonical_text(rest) == canonical_text(free_of_robot(before)) ? addresses : std::vector<std::string>{};
}

bool same_effect_values(const RevisionRecord& parent, const RevisionRecord& revision) {
  return canonical_text(parent.effects) == canonical_text(revision.effects) &&
         canonical_text(free_values(parent, true)) == canonical_text(free_values(revision, true));
}

/// How many substeps a model takes follows from it, where a file leaves that open: no difference worth a word beside
/// one of the model.
bool same_engine(EngineSettings a, const EngineSettings& b) {
  a.substeps = b.substeps;
  return canonical_text(a) == canonical_text(b);
}

std::string other_differences(const RevisionRecord& parent, const RevisionRecord& revision, bool same_effects) {
  const bool same_free = canonical_text(free_of_robot(parent)) == canonical_text(free_of_robot(revision)) ||
                         !newly_free(parent, revision).empty() || !newly_free(revision, parent).empty();
  std::string parts;
  if (parent.robot_text != revision.robot_text) append(parts, "robot");
  if (!same_free) append(parts, "free values");
  if (same_effects && same_free && !same_effect_values(parent, revision)) append(parts, "values of effects");
  if (!same_engine(parent.engine, revision.engine)) append(parts, "engine");
  if (parts.empty() && same_effects && parent.engine.substeps != revision.engine.substeps) append(parts, "substeps");
  if (parent.fit_data_digest != revision.fit_data_digest) append(parts, "fit data");
  return parts.empty() ? "" : "other " + parts;
}

}  // namespace

RevisionChange change_of_first(const RevisionRecord& revision) {
  return {.added = revision.effects,
          .removed = {},
          .sentence = revision.effects.empty() ? "rigid" : names(revision.effects)};
}

RevisionChange change_between(const RevisionRecord& parent, const RevisionRecord& revision) {
  // By way of the canonical text, so that the order of effects and places does not count.
  const EffectList before = effects_from_text(canonical_text(parent.effects));
  const EffectList after = effects_from_text(canonical_text(revision.effects));
  RevisionChange change{.added = only_in(after, before), .removed = only_in(before, after), .sentence = {}};
  append(change.sentence, names(change.added));
  if (!change.removed.empty()) append(change.sentence, "without " + names(change.removed));
  for (const std::string& address : newly_free(parent, revision)) append(change.sentence, address + " fitted");
  for (const std::string& address : newly_free(revision, parent)) append(change.sentence, address + " fixed");
  append(change.sentence, other_differences(parent, revision, change.added.empty() && change.removed.empty()));
  return change;
}

}  // namespace lacuna
