#include "tracer/kernels/kernels.h"
#include "tracer/render/render_pass.h"
#include "tracer/transport/polarised_transport.h"

namespace orbs::tracer {

template PassRenderer render_pass<PolarisedTransport<SpectralTransport, 1>>;

}  // namespace orbs::tracer
