#include "measurement/trials/encoding_guess.h"

#include "foundation/statistics.h"
#include "measurement/cells/decode.h"
#include "measurement/series/wrap_guess.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace lacuna {
namespace {

constexpr double kSmall = 4.0;        ///< largest decoded change over the usual one that still counts as small
constexpr double kUsual = 0.99;       ///< quantile of the changes that are not jumps
constexpr double kMostJumps = 0.5;    ///< of all changes, as for a force near zero
constexpr double kSmallJump = 0.125;  ///< of the jumps' size: with a larger usual change they are not jumps
constexpr std::size_t kFewestDecoded =
    20;  ///< number of distinct values of a moving robot; a switched command has fewer
constexpr std::size_t kFewestOfASide = 5;  ///< on either side of the boundary between the values
constexpr int kFewestBits = 8, kMostBits = 32;

using Files = std::span<const std::vector<double>>;

bool all_values(Files files, const auto& condition) {
  return std::all_of(files.begin(), files.end(), [&](const std::vector<double>& file) {
    return std::all_of(file.begin(), file.end(), [&](double value) { return std::isnan(value) || condition(value); });
  });
}

/// Sizes of the changes from reading to reading, with the place after each.
struct Change {
  double size = 0.0;
  std::size_t place = 0;
};

std::vector<Change> changes_of(Files files) {
  std::vector<Change> changes;
  std::size_t place = 0;
  for (const std::vector<double>& file : files) {
    double before = std::nan("");
    for (const double value : file) {
      if (!std::isnan(value) && !std::isnan(before)) changes.push_back({std::abs(value - before), place});
      if (!std::isnan(value)) before = value;
      ++place;
    }
  }
  return changes;
}

/// The largest usual change: a quantile of those below half the jump; at least one count.
double usual_change(const std::vector<Change>& changes, double jump) {
  std::vector<double> usual;
  for (const Change& change : changes)
    if (change.size < 0.5 * jump) usual.push_back(change.size);
  if (usual.empty()) return 1.0;
  return std::max(quantile_of(usual, kUsual), 1.0);
}

/// Whether the column takes several values on either side of the boundary: a single zero before the first reading, or a
/// signal that only reaches the boundary, shows no encoding.
bool moves_on_both_sides(Files files, double between) {
  std::set<double> below, above;
  for (const std::vector<double>& file : files)
    for (const double value : file)
      if (!std::isnan(value)) (value < between ? below : above).insert(value);
  return below.size() >= kFewestOfASide && above.size() >= kFewestOfASide;
}

bool has_levels(Files files) {
  std::set<double> levels;
  for (const std::vector<double>& file : files)
    for (auto value = file.begin(); value != file.end() && levels.size() < kFewestDecoded; ++value)
      if (!std::isnan(*value)) levels.insert(*value);
  return levels.size() >= kFewestDecoded;
}

/// Whether jumps of at least half of `jump` vanish under an encoding.
std::optional<FoundEncoding> explains_jumps(const Encoding& encoding, double jump, Files files) {
  const std::vector<Change> before = changes_of(files);
  FoundEncoding found{encoding};
  for (const Change& change : before) {
    if (change.size < 0.5 * jump) continue;
    if (found.jumps++ == 0) found.first = change.place;
  }
  if (found.jumps == 0 || static_cast<double>(found.jumps) > kMostJumps * static_cast<double>(before.size()))
    return std::nullopt;
  std::vector<std::vector<double>> decoded(files.begin(), files.end());
  for (std::vector<double>& file : decoded) decode(encoding, file);
  if (!has_levels(decoded)) return std::nullopt;
  const double usual = usual_change(before, jump), most = std::min(kSmall * usual, 0.4 * jump);
  const std::vector<Change> after = changes_of(decoded);
  const bool smooth =
      std::all_of(after.begin(), after.end(), [&](const Change& change) { return change.size <= most; });
  return smooth && usual < kSmallJump * jump ? std::optional(found) : std::nullopt;
}

/// The encoding of negative whole numbers, if the highest bit in use shows their sign.
std::optional<FoundEncoding> guess_sign(Files files, bool is_position) {
  double highest = 0.0;
  for (const std::vector<double>& file : files)
    for (const double value : file)
      if (!std::isnan(value)) highest = std::max(highest, value);
  const int bits = highest >= 1.0 ? std::ilogb(highest) + 1 : 0;
  if (bits < kFewestBits || bits > kMostBits) return std::nullopt;
  if (!all_values(files, [](double value) { return value >= 0.0 && value == std::round(value); })) return std::nullopt;
  const double modulus = std::ldexp(1.0, bits), bit = 0.5 * modulus;
  if (!moves_on_both_sides(files, bit)) return std::nullopt;
  const bool in_outer_quarters =
      all_values(files, [&](double value) { return value < 0.25 * modulus || value >= 0.75 * modulus; });
  if (in_outer_quarters || !is_position)
    if (const auto found = explains_jumps({EncodingKind::twos_complement, modulus}, modulus, files)) return found;
  return explains_jumps({EncodingKind::sign_bit, bit}, bit, files);
}

std::optional<FoundEncoding> guess_wrap(Files files, const std::vector<double>& turns) {
  const std::optional<FoundWrap> wrap = find_wrap(files, turns);
  if (!wrap) return std::nullopt;
  FoundEncoding found{{}, wrap->jumps, wrap->first, wrap->moduli, wrap->estimate, wrap->error};
  if (wrap->is_certain) found.encoding = {EncodingKind::wraps, wrap->moduli.front()};
  return found;
}

}  // namespace

std::optional<FoundEncoding> guess_encoding(Files files, const EncodingHints& hints) {
  std::optional<FoundEncoding> found = guess_sign(files, hints.is_position);
  if (!found && hints.is_position) found = guess_wrap(files, hints.turns);
  return found;
}

}  // namespace lacuna
