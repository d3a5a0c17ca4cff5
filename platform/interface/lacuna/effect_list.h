#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace lacuna {

/// One effect of a model, as the experiment file states it.
struct EffectEntry {
  std::string id;                  ///< unique within the list; its parameters are `effect.<id>.<parameter>`
  std::string effect;              ///< the plugin's name
  std::vector<std::string> where;  ///< element addresses such as `joint.hinge`, with `*` for all; several share one set
                                   ///< of values; empty: the world
  std::map<std::string, double> start;                          ///< values that differ from the declared defaults, SI
  std::vector<std::string> fixed;                               ///< parameters that are not free
  std::map<std::string, std::pair<double, double>> range = {};  ///< bounds narrower than the declared ones, SI
  bool optional = false;                                        ///< the switches of an encoding may leave it out
};

using EffectList = std::vector<EffectEntry>;

}  // namespace lacuna
