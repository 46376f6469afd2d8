// A plug-in for tests that lacks a required function: orbs_shape_intersect.
#include <orbs/shape_plugin.h>

uint32_t orbs_shape_plugin_version() { return ORBS_SHAPE_PLUGIN_VERSION; }
orbs_shape* orbs_shape_create(const orbs_shape_number*, size_t, char*, size_t) { return nullptr; }
void orbs_shape_destroy(orbs_shape*) {}
void orbs_shape_bounds(const orbs_shape*, double[3], double[3]) {}
