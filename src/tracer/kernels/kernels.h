#pragma once

#include "tracer/render/passes.h"
#include "tracer/render/render.h"

#include <functional>

/// The path loop once per transport, each in a file of its own.
namespace orbs::tracer {

using PassRenderer = void(const World& world,
                          const RenderSettings& settings,
                          const NumberedPass& pass,
                          Film& film,
                          Rendering& out,
                          const std::function<void()>& tile_done);

PassRenderer rgb_pass;
PassRenderer rgb_boundary_pass;  // RGB with materials beyond ORB.S
PassRenderer spectral_pass;
PassRenderer bispectral_pass;
PassRenderer polarised_pass;
PassRenderer polarised_bispectral_pass;
PassRenderer stokes_pass;  // polarised, with S1 to S3 in the image
PassRenderer stokes_bispectral_pass;

/// The one for the world's transport.
PassRenderer* kernel_for(const World& world);

}  // namespace orbs::tracer
