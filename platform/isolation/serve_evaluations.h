#pragma once

#include "eea/definition/eea_definition.h"
#include "isolation/channel.h"
#include "isolation/messages.h"

namespace lacuna {

/// In a worker process: the first message of its host. Throws `Error` where there is none.
WorkerTask receive_task(const MessageChannel& channel);

/// Says that the worker is ready, then answers its host until that closes the channel. `CallPage::task` tells which of
/// a request's candidates or tests it is at.
void serve_evaluations(const MessageChannel& channel, const EeaDefinition& definition);

/// Tells the host why there is no worker.
void send_failure(const MessageChannel& channel, const std::string& sentence);
/// Tells the host that the process which did the work has ended.
void send_lost(const MessageChannel& channel, const LostWork& lost);

}  // namespace lacuna
