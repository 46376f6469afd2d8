#include "tracer/kernels/kernels.h"
#include "tracer/transport/polarised_transport.h"
#include "tracer/render/render_pass.h"

namespace orbs::tracer {

void polarised_pass(const World& world,
                    const RenderSettings& settings,
                    const NumberedPass& pass,
                    Film& film,
                    Rendering& out,
                    const std::function<void()>& tile_done) {
  render_pass<PolarisedTransport<SpectralTransport, 1>>(world, settings, pass, film, out, tile_done);
}

}  // namespace orbs::tracer
