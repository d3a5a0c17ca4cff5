#pragma once

namespace lacuna::ode {

/// Prepares ODE for the calling thread: initialises the library once per process, installs handlers that throw instead
/// of ending the process, and gives the thread its own data, which is released when the thread ends.
void join_session();

/// Clears ODE's messages in this thread.
void clear_complaint();
/// ODE reports some failures by a message only (two motors on one coordinate without
/// regularisation: all forces zero). The first since `clear_complaint`, or empty.
const char* complaint();

}  // namespace lacuna::ode
