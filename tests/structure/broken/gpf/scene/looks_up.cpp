// A fault for the layering test: a lower layer includes a higher one.
#  include "gpf/event/loop.hpp"  // the spaces are allowed by the language
#include "gpf/base/vec2.hpp"
