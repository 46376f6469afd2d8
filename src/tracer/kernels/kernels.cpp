#include "tracer/kernels/kernels.h"

#include "base/error.h"
#include "tracer/integrator/ambient_occlusion.h"
#include "tracer/irradiance_cache/render_irradiance_cache.h"
#include "tracer/render/render_pass.h"
#include "tracer/transport/polarised_transport.h"
#include "tracer/transport/rgb_transport.h"
#include "tracer/transport/spectral_transport.h"

namespace orbs::tracer {

extern template PassRenderer render_pass<RgbTransport>;

#ifdef ORBS_FAULTS

// The program of the tests that makes numeric faults is built without the kernels of richer transports: no
// hard case has effects that call for them.
PassRenderer* kernel_for(const World& world) {
  if (std::holds_alternative<scene::AmbientOcclusion>(world.integrator)) return render_ambient_occlusion;
  if (std::holds_alternative<scene::IrradianceCache>(world.integrator)) return render_irradiance_cache;
  if (world.transport != scene::LightTransport::Rgb || world.has_appearance_materials)
    throw InputError("orbs-faulty-tracer renders in three colours alone");
  return render_pass<RgbTransport>;
}

#else

extern template PassRenderer render_pass<RgbBoundaryTransport>;
extern template PassRenderer render_pass<SpectralTransport>;
extern template PassRenderer render_pass<BispectralTransport>;
extern template PassRenderer render_pass<PolarisedTransport<SpectralTransport, 1>>;
extern template PassRenderer render_pass<PolarisedTransport<SpectralTransport, 4>>;
extern template PassRenderer render_pass<PolarisedTransport<BispectralTransport, 1>>;
extern template PassRenderer render_pass<PolarisedTransport<BispectralTransport, 4>>;

PassRenderer* kernel_for(const World& world) {
  if (std::holds_alternative<scene::AmbientOcclusion>(world.integrator)) return render_ambient_occlusion;
  if (std::holds_alternative<scene::IrradianceCache>(world.integrator)) return render_irradiance_cache;
  switch (world.transport) {
    case scene::LightTransport::Rgb:
      return world.has_appearance_materials ? render_pass<RgbBoundaryTransport> : render_pass<RgbTransport>;
    case scene::LightTransport::Spectral:
      return render_pass<SpectralTransport>;
    case scene::LightTransport::Bispectral:
      return render_pass<BispectralTransport>;
    case scene::LightTransport::Polarised:
      return world.wants_stokes ? render_pass<PolarisedTransport<SpectralTransport, 4>>
                                : render_pass<PolarisedTransport<SpectralTransport, 1>>;
    case scene::LightTransport::PolarisedBispectral:
      return world.wants_stokes ? render_pass<PolarisedTransport<BispectralTransport, 4>>
                                : render_pass<PolarisedTransport<BispectralTransport, 1>>;
  }
  return render_pass<RgbTransport>;
}

#endif

}  // namespace orbs::tracer
