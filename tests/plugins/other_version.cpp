// A plug-in for tests that was built with a later header.
#include <orbs/shape_plugin.h>

uint32_t orbs_shape_plugin_version() { return ORBS_SHAPE_PLUGIN_VERSION + 1; }
