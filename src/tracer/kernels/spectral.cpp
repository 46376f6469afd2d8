#include "tracer/kernels/kernels.h"
#include "tracer/render/render_pass.h"
#include "tracer/transport/spectral_transport.h"

namespace orbs::tracer {

void spectral_pass(const World& world,
                   const RenderSettings& settings,
                   const NumberedPass& pass,
                   Film& film,
                   Rendering& out,
                   const std::function<void()>& tile_done) {
  render_pass<SpectralTransport>(world, settings, pass, film, out, tile_done);
}

}  // namespace orbs::tracer
