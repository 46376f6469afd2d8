#include "tracer/kernels/kernels.h"
#include "tracer/render/render_pass.h"
#include "tracer/transport/rgb_transport.h"

namespace orbs::tracer {

void rgb_boundary_pass(const World& world,
                        const RenderSettings& settings,
                        const NumberedPass& pass,
                        Film& film,
                        Rendering& out,
                        const std::function<void()>& tile_done) {
  render_pass<RgbBoundaryTransport>(world, settings, pass, film, out, tile_done);
}

}  // namespace orbs::tracer
