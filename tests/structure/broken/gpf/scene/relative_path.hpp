// A fault for the layering test: a path that does not name the layer.
#include "../base/vec2.hpp"
