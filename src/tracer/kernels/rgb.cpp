#include "tracer/trace_wave.h"

namespace orbs::tracer {

template void trace_wave<RgbTransport>(Wave<RgbTransport>&, const World&, std::span<const Sample>);

}  // namespace orbs::tracer
