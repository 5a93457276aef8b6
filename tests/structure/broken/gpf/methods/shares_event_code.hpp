// A fault for the layering test: the oracle must not use the engine's rules.
#include "gpf/event/rules.hpp"
#include "gpf/scene/state.hpp"
