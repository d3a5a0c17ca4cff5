#include "evaluation/model/recorded_setups.h"

#include "evaluation/model/possible_values.h"
#include "foundation/address.h"
#include "foundation/unit.h"

#include <fmt/format.h>

#include <algorithm>

namespace lacuna {
namespace {

/// The role of a value in one recording.
enum class Told { as_in_all, set, own };

class SetupBuilder {
 public:
  SetupBuilder(ModelDefinition& definition, const RecordingSource& source, Complaints& complaints)
      : definition_(definition), source_(source), complaints_(complaints), places_(possible_values(definition)) {
    for (const FreeValue& free : definition.free) {
      PossibleValue& place = *std::find_if(places_.begin(), places_.end(),
                                           [&](const PossibleValue& one) { return one.value.address == free.address; });
      place.value = free;
      place.is_bounded = true;
    }
    told_.assign(places_.size(), std::vector<Told>(source.files.size(), Told::as_in_all));
  }

  void build() {
    for (std::size_t f = 0; f < source_.files.size(); ++f) {
      const MeasuredFile& file = source_.files[f];
      if (file.setup.name.empty()) continue;
      Setup setup{file.setup.name};
      for (const Setup::Value& value : file.setup.values) set(file, f, value, setup);
      definition_.structure.setups.push_back(std::move(setup));
      for (std::size_t i = 0; i < file.own.size(); ++i) own(file, f, i);
    }
    for (std::size_t p = 0; p < places_.size(); ++p) settle(p);
    definition_.free.insert(definition_.free.end(), owned_.begin(), owned_.end());
  }

 private:
  /// Indices of the places that the pattern matches; complains where it matches none.
  std::vector<std::size_t> find(const std::string& pattern, const std::string& key) {
    std::vector<std::size_t> found;
    std::vector<std::string> known;
    for (std::size_t p = 0; p < places_.size(); ++p) {
      known.push_back(places_[p].value.address);
      if (matches(pattern, places_[p].value.address)) found.push_back(p);
    }
    if (found.empty())
      complaints_.add(
          key, "\"" + pattern + "\" matches no value of the robot or of its effects" + did_you_mean(pattern, known));
    return found;
  }

  void set(const MeasuredFile& file, std::size_t f, const Setup::Value& given, Setup& setup) {
    const std::string key = file.key + ".set." + given.address;
    for (const std::size_t p : find(given.address, key)) {
      const PossibleValue& place = places_[p];
      complaints_.check_unit(key, place.value.unit);
      if (told_[p][f] == Told::set)
        complaints_.add(key, "another key of this recording also sets " + place.value.address + "; keep one of them");
      if (!(given.value >= place.lower && given.value <= place.upper))
        complaints_.add(key, fmt::format("{} is not a possible value of {} ({} to {})",
                                         format_quantity(given.value, place.value.unit), place.value.address,
                                         format_quantity(place.lower, place.value.unit),
                                         format_quantity(place.upper, place.value.unit)));
      told_[p][f] = Told::set;
      setup.values.push_back({place.value.address, given.value});
    }
  }

  void own(const MeasuredFile& file, std::size_t f, std::size_t i) {
    const std::string key = fmt::format("{}.own[{}]", file.key, i);
    if (file.held_out)
      complaints_.add(key,
                      "the recording is held out, so no fit can find its value; set the value, or hold out only "
                      "stretches of the recording: holdout = [[from, to]]");
    for (const std::size_t p : find(file.own[i], key)) {
      const PossibleValue& place = places_[p];
      if (told_[p][f] != Told::as_in_all) {
        complaints_.add(key, fmt::format("{} is already {} by this recording; keep one of the two", place.value.address,
                                         told_[p][f] == Told::set ? "set" : "named as unknown"));
        continue;
      }
      if (!place.is_bounded)
        complaints_.add(
            key, fmt::format("{0} has no bounds for the fit; give them in [model.free]: \"{0}\" = [lower, upper]",
                             place.value.address));
      told_[p][f] = Told::own;
      owned_.push_back(place.value);
      owned_.back().address = address_in_setup(place.value.address, file.setup.name);
      owned_.back().setup = file.setup.name;
    }
  }

  /// A free value that every fit recording replaces is determined by none of them.
  void settle(std::size_t p) {
    const auto free = std::find_if(definition_.free.begin(), definition_.free.end(),
                                   [&](const FreeValue& value) { return value.address == places_[p].value.address; });
    if (free == definition_.free.end()) return;
    bool is_owned = false;
    const MeasuredFile* without = nullptr;
    for (std::size_t f = 0; f < source_.files.size(); ++f) {
      const bool shares = told_[p][f] == Told::as_in_all;
      if (shares && !source_.files[f].held_out) return;
      if (shares) without = &source_.files[f];
      is_owned = is_owned || told_[p][f] == Told::own;
    }
    if (source_.files.empty()) return;
    if (!is_owned)
      complaints_.add(
          "model.free." + free->address,
          free->address + " is set by every fit recording, so no data determine it; leave it out of [model.free]");
    else if (without)
      complaints_.add_at(without->location,
                         fmt::format("every fit recording has its own value of {}, so the value of this held-out "
                                     "recording is unknown; set it here, under [[target.recording]]",
                                     free->address));
    definition_.free.erase(free);
  }

  ModelDefinition& definition_;
  const RecordingSource& source_;
  Complaints& complaints_;
  std::vector<PossibleValue> places_;
  std::vector<std::vector<Told>> told_;  ///< by place and file
  std::vector<FreeValue> owned_;
};

}  // namespace

void add_setups(ModelDefinition& definition, const RecordingSource& source, Complaints& complaints) {
  const bool has_some = std::any_of(source.files.begin(), source.files.end(),
                                    [](const MeasuredFile& file) { return !file.setup.name.empty(); });
  if (has_some) SetupBuilder(definition, source, complaints).build();
}

}  // namespace lacuna
