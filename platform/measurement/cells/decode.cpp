#include "measurement/cells/decode.h"

#include <cmath>

namespace lacuna {
namespace {

void unwrap(double modulus, std::vector<double>& column) {
  double turns = 0.0, before = std::nan("");
  for (double& value : column) {
    if (std::isnan(value)) continue;
    if (!std::isnan(before)) turns -= std::round((value - before) / modulus);
    before = value;
    value += turns * modulus;
  }
}

}  // namespace

void decode(const Encoding& encoding, std::vector<double>& column) {
  const double modulus = encoding.modulus;
  switch (encoding.kind) {
    case EncodingKind::automatic:
    case EncodingKind::plain: return;
    case EncodingKind::wraps: return unwrap(modulus, column);
    case EncodingKind::sign_bit:
      for (double& value : column)
        if (value >= modulus) value = modulus - value;
      return;
    case EncodingKind::twos_complement:
      for (double& value : column)
        if (value >= 0.5 * modulus) value -= modulus;
      return;
  }
}

}  // namespace lacuna
