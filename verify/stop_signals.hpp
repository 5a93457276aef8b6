// Signals that ask a long command to stop.
#pragma once

#include <csignal>

namespace gpf {

/// From now on SIGTERM, SIGINT, SIGUSR1 and (unless it is ignored: nohup) SIGHUP set the flag instead of ending the
/// program.
const volatile std::sig_atomic_t* stop_on_signals();

}  // namespace gpf
