#include "tracer/trace_light_wave.h"

namespace orbs::tracer {

template void trace_wave<RgbTransport>(Wave<RgbTransport>&, const World&, std::span<const Sample>);
template void trace_light_wave<RgbTransport>(
    LightWave<RgbTransport>&, const World&, SampleBlock, std::uint32_t, std::uint32_t);

}  // namespace orbs::tracer
