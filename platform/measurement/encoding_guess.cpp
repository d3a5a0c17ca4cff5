#include "measurement/encoding_guess.h"

#include "measurement/decode.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace lacuna {
namespace {

constexpr double kSmall = 4.0;              ///< a decoded change over the usual ones that still counts as small
constexpr double kUsual = 0.99;             ///< quantile of the changes that are no jumps
constexpr double kMostJumps = 0.1;          ///< of all changes
constexpr std::size_t kFewestDecoded = 20;  ///< of what a moving robot reads; a switched command has fewer
constexpr std::size_t kFewestOfASide = 5;   ///< on either side of what parts the values
constexpr int kBits[] = {10, 12, 14, 15, 16, 20, 24, 31, 32};

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

/// The largest change that is usual: a quantile of those that are below half the modulus; 1 at least where counts are
/// whole.
double usual_change(const std::vector<Change>& changes, double modulus, bool whole) {
  std::vector<double> usual;
  for (const Change& change : changes)
    if (change.size < 0.5 * modulus) usual.push_back(change.size);
  if (usual.empty()) return 0.0;
  const auto at = usual.begin() + static_cast<std::ptrdiff_t>(kUsual * static_cast<double>(usual.size() - 1));
  std::nth_element(usual.begin(), at, usual.end());
  return whole ? std::max(*at, 1.0) : *at;
}

/// Whether the column takes several values on either side of what parts them: a single zero before the first reading,
/// or a signal that only reaches the boundary, shows no encoding.
bool moves_on_both_sides(Files files, double half, const Encoding& encoding) {
  const bool from_zero = all_values(files, [](double value) { return value >= 0.0; });
  const double between = encoding.kind == EncodingKind::sign_bit ? 2.0 * half : from_zero ? half : 0.0;
  std::set<double> below, above;
  for (const std::vector<double>& file : files)
    for (const double value : file)
      if (!std::isnan(value)) (value < between ? below : above).insert(value);
  return below.size() >= kFewestOfASide && above.size() >= kFewestOfASide;
}

std::optional<FoundEncoding> test(const Encoding& encoding, double jump, Files files, bool whole) {
  const std::vector<Change> before = changes_of(files);
  FoundEncoding found{encoding};
  for (const Change& change : before) {
    if (change.size < 0.5 * jump) continue;
    if (found.jumps++ == 0) found.first = change.place;
  }
  if (found.jumps == 0 || static_cast<double>(found.jumps) > kMostJumps * static_cast<double>(before.size()))
    return std::nullopt;
  std::vector<std::vector<double>> decoded(files.begin(), files.end());
  if (!moves_on_both_sides(files, 0.5 * jump, encoding)) return std::nullopt;
  std::set<double> levels;
  for (std::vector<double>& file : decoded) {
    decode(encoding, file);
    for (auto value = file.begin(); value != file.end() && levels.size() < kFewestDecoded; ++value)
      if (!std::isnan(*value)) levels.insert(*value);
  }
  if (levels.size() < kFewestDecoded) return std::nullopt;
  const double most = kSmall * usual_change(before, jump, whole);
  const std::vector<Change> after = changes_of(decoded);
  const bool smooth =
      std::all_of(after.begin(), after.end(), [&](const Change& change) { return change.size <= most; });
  return smooth && most < 0.25 * jump ? std::optional(found) : std::nullopt;
}

/// Sizes below the sign's bit use no more of the range than those above it.
bool fits_sign_bit(Files files, double bit) {
  return all_values(files, [&](double value) { return value >= 0.0 && value < 2.0 * bit; });
}

bool fits_complement(Files files, double modulus) {
  return all_values(files, [&](double value) {
    return value >= 0.0 && value < modulus && (value < 0.25 * modulus || value >= 0.75 * modulus);
  });
}

bool fits_wrap(Files files, double modulus) {
  return all_values(files, [&](double value) { return value >= 0.0 && value <= modulus; }) ||
         all_values(files, [&](double value) { return std::abs(value) <= 0.5 * modulus * (1.0 + 1e-9); });
}

/// Full turns in the unit of the column.
std::vector<double> turns_of(const std::string& unit) {
  if (unit == "rad") return {2.0 * M_PI};
  if (unit == "deg") return {360.0};
  if (unit == "rev") return {1.0};
  if (unit == "mrad") return {2000.0 * M_PI};
  return {};
}

}  // namespace

std::optional<FoundEncoding> guess_encoding(Files files, const std::string& unit) {
  for (const double turn : turns_of(unit)) {
    const Encoding encoding{EncodingKind::wraps, turn};
    if (!fits_wrap(files, turn)) continue;
    if (const auto found = test(encoding, turn, files, false)) return found;
  }
  if (!all_values(files, [](double value) { return value == std::round(value); })) return std::nullopt;
  for (const int bits : kBits) {
    const double modulus = std::ldexp(1.0, bits), bit = 0.5 * modulus;
    std::optional<FoundEncoding> found;
    if (fits_complement(files, modulus)) found = test({EncodingKind::twos_complement, modulus}, modulus, files, true);
    if (!found && fits_sign_bit(files, bit)) found = test({EncodingKind::sign_bit, bit}, bit, files, true);
    if (!found && fits_wrap(files, modulus)) found = test({EncodingKind::wraps, modulus}, modulus, files, true);
    if (found) return found;
  }
  return std::nullopt;
}

}  // namespace lacuna
