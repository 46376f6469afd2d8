// A plug-in for tests whose initialiser makes the processor flush small numbers to zero, as that of every
// library that was linked with -ffast-math. It is a plug-in of no version.
#include <orbs/shape_plugin.h>
#include <xmmintrin.h>

namespace {
const bool kFlushes = (_MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON), true);
}

uint32_t orbs_shape_plugin_version() { return kFlushes ? 0 : 1; }
