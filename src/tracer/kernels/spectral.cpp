#include "tracer/kernels/kernels.h"
#include "tracer/render/render_pass.h"
#include "tracer/transport/spectral_transport.h"

namespace orbs::tracer {

template PassRenderer render_pass<SpectralTransport>;

}  // namespace orbs::tracer
