// Which method finds a flow, and how finely: as a value and as one line of text.
#pragma once

#include <string>
#include <string_view>

#include "gpf/methods/channel_flow.hpp"
#include "gpf/methods/enskog_monte_carlo.hpp"

namespace gpf {

enum class Method {
  event_driven,  ///< the engine
  all_pairs,     ///< the oracle: the same physics, all pairs examined
  soft_disks,    ///< contacts that last, time steps
  monte_carlo,   ///< Enskog's equation, uniform along the channel or in cells along it
  hydrodynamics  ///< steady profiles of the theory, uniform along the channel
};

std::string_view name_of(Method method);

/// Of each method only its own numbers count.
struct MethodSetting {
  Method method = Method::event_driven;
  double contact = 0.05;               ///< soft_disks: duration of a contact in mean free times of the start
  int steps = 50;                      ///< soft_disks: time steps in a contact
  MonteCarloSetting monte_carlo{};     ///< keys cells, particles, step, along
  ChannelFlowSetting hydrodynamics{};  ///< keys cells, closure
};

/// "event_driven", "soft_disks contact=0.05 steps=50", "monte_carlo cells=40 particles=200 step=0.1",
/// "hydrodynamics cells=100 closure=jenkins_richman" (or garzo_dufty): every number of the method, so that equal texts
/// mean equal settings; but " along=62", cells along the channel, only if there are more than one.
std::string text_of(const MethodSetting& setting);

/// Reads such a text; numbers that are left out are the defaults. Throws InputError with the known names.
MethodSetting parse_method(std::string_view text);

}  // namespace gpf
