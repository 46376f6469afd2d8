#include "tracer/kernels/kernels.h"

namespace orbs::tracer {

PassRenderer* kernel_for(const World& world) {
  switch (world.transport) {
    case scene::LightTransport::Rgb:
      return world.has_appearance_materials ? rgb_boundary_pass : rgb_pass;
    case scene::LightTransport::Spectral:
      return spectral_pass;
    case scene::LightTransport::Bispectral:
      return bispectral_pass;
    case scene::LightTransport::Polarised:
      return world.wants_stokes ? stokes_pass : polarised_pass;
    case scene::LightTransport::PolarisedBispectral:
      return world.wants_stokes ? stokes_bispectral_pass : polarised_bispectral_pass;
  }
  return rgb_pass;
}

}  // namespace orbs::tracer
