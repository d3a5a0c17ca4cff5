#pragma once

#include "foundation/processes/stop.h"
#include "storage/traces/named_trace.h"

#include <ostream>

namespace lacuna {

/// Writes a trace as an MCAP file: a topic a channel, "/angle", whose messages are JSON, {"time":0.5,"measured":0.1,
/// "predicted":0.2}; what is not known at a time is not in the message. The schema of a topic has the units. Messages
/// have the trial's time, ns, from 1970 on; a trial that begins before 0 s is moved by whole seconds.
void write_mcap_trace(const NamedTrace& trace, std::ostream& stream, const Stop& stop = {});

}  // namespace lacuna
