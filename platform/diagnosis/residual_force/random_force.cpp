#include "diagnosis/residual_force/random_force.h"

namespace lacuna {

double correlation_time(const RandomForce& force) { return force.slow ? force.duration : 0.5 * force.duration; }

double power(const RandomForce& force) { return force.deviation * force.deviation * correlation_time(force); }

}  // namespace lacuna
