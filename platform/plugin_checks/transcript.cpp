#include "plugin_checks/transcript.h"

#include "foundation/digest.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lacuna {

void Transcript::add(const char* call, std::span<const double> numbers, May may) {
  entries_.push_back({call, std::string(reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes())});
  count_ += numbers.size();
  if (!not_finite_.empty() || may == May::be_anything) return;
  for (const double number : numbers)
    if (std::isnan(number) || (std::isinf(number) && may == May::be_finite)) {
      not_finite_ = fmt::format("{} returned {}", call, std::isnan(number) ? "NaN" : "infinity");
      return;
    }
}

void Transcript::add_text(const char* call, std::string_view text) { entries_.push_back({call, std::string(text)}); }

std::string Transcript::digest() const {
  Sha256 digest;
  for (const Entry& entry : entries_) digest.add(fmt::format("{} {}\n", entry.call, entry.bytes.size()) + entry.bytes);
  return digest.hex();
}

std::string Transcript::first_difference(const Transcript& a, const Transcript& b) {
  const std::size_t both = std::min(a.entries_.size(), b.entries_.size());
  for (std::size_t i = 0; i < both; ++i)
    if (a.entries_[i].bytes != b.entries_[i].bytes) return a.entries_[i].call;
  if (a.entries_.size() == b.entries_.size()) return {};
  return (a.entries_.size() > both ? a : b).entries_[both].call;
}

}  // namespace lacuna
