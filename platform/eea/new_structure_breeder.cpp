#include "eea/new_structure_breeder.h"

#include <lacuna/error.h>

namespace lacuna {
namespace {

constexpr int kMostTries = 100;

}  // namespace

bool NewStructureBreeder::can_breed(const std::vector<std::uint64_t>& key) const {
  if (taken_.empty()) return true;
  RandomStream stream(key);
  return !is_taken(random(stream));
}

Genome NewStructureBreeder::random(RandomStream& random) const {
  Genome genome = breeder_.random(random);
  for (int again = 1; again < kMostTries && is_taken(genome); ++again) genome = breeder_.random(random);
  return genome;
}

Genome NewStructureBreeder::child(std::span<const Genome> parents, RandomStream& random,
                                  std::vector<std::size_t>& used) const {
  Genome genome = breeder_.child(parents, random, used);
  for (int again = 1; again < kMostTries && is_taken(genome); ++again) {
    used.clear();
    genome = breeder_.child(parents, random, used);
  }
  return genome;
}

bool NewStructureBreeder::is_taken(const Genome& genome) const {
  if (taken_.empty()) return false;
  try {
    return is_taken(definition_.decode_model(genome));
  } catch (const Error&) {
    return false;
  }
}

}  // namespace lacuna
