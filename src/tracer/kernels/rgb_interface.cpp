#include "tracer/kernels/kernels.h"
#include "tracer/render_with.h"
#include "tracer/rgb_transport.h"

namespace orbs::tracer {

void rgb_interface_pass(const World& world,
                        const RenderSettings& settings,
                        const NumberedPass& pass,
                        Film& film,
                        Rendering& out,
                        const std::function<void()>& tile_done) {
  render_pass<RgbInterfaceTransport>(world, settings, pass, film, out, tile_done);
}

}  // namespace orbs::tracer
