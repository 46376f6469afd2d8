// A plug-in for tests whose initialiser ends the program, and says that all is well. It is a plug-in of no
// version.
#include <cstdlib>

#include <orbs/shape_plugin.h>

namespace {
const bool kExits = (std::exit(0), true);
}

uint32_t orbs_shape_plugin_version() { return kExits ? 0 : 1; }
