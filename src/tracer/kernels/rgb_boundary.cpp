#include "tracer/kernels/kernels.h"
#include "tracer/render/render_pass.h"
#include "tracer/transport/rgb_transport.h"

namespace orbs::tracer {

template PassRenderer render_pass<RgbBoundaryTransport>;

}  // namespace orbs::tracer
