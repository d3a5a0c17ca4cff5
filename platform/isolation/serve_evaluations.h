#pragma once

#include "eea/definition/eea_definition.h"
#include "isolation/channel.h"
#include "isolation/messages.h"

namespace lacuna {

/// Runs in a worker process: reads the first message of its host. Throws `Error` where there is none.
WorkerTask receive_task(const MessageChannel& channel);

/// Reports that the worker is ready, then answers its host until the host closes the channel. `CallPage::task` holds
/// the index of the current candidate or test of a request.
void serve_evaluations(const MessageChannel& channel, const EeaDefinition& definition);

/// Tells the host why the worker cannot start.
void send_failure(const MessageChannel& channel, const std::string& sentence);
/// Tells the host that the process which did the work has ended.
void send_lost(const MessageChannel& channel, const LostWork& lost);

}  // namespace lacuna
