#include "verify/stop_signals.hpp"

#include <initializer_list>

namespace gpf {
namespace {

volatile std::sig_atomic_t stop_requested = 0;
extern "C" void request_stop_of_command(int) { stop_requested = 1; }

}  // namespace

const volatile std::sig_atomic_t* stop_on_signals() {
  for (const int signal : {SIGTERM, SIGINT, SIGUSR1}) std::signal(signal, request_stop_of_command);
  if (std::signal(SIGHUP, request_stop_of_command) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
  return &stop_requested;
}

}  // namespace gpf
