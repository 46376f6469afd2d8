// A plug-in for tests whose initialiser makes the processor flush small numbers to zero, as that of every
// library that was linked with -ffast-math. It is a plug-in of no version.
#include "plugins/flush_to_zero.h"

#include <orbs/shape_plugin.h>

namespace {
const bool kFlushes = (orbs::tests::flush_small_numbers(), true);
}

uint32_t orbs_shape_plugin_version() { return kFlushes ? 0 : 1; }
