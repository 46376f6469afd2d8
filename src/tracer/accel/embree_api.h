#pragma once

// Embree 3 and 4 under one set of names. Between them a query's context and flags moved into arguments of the
// call; geometries, packets of rays and the callbacks of user geometry are the same.

#if ORBS_EMBREE_MAJOR >= 4
#  include <embree4/rtcore.h>
#else
#  include <embree3/rtcore.h>
#endif

namespace orbs::tracer {

/// What a device is made with. Embree takes the widest kernels of the processor and, for some processors,
/// narrower trees (Device::Device in its kernels/common/device.cpp asks for simd128 on a Skylake Xeon). Each
/// of them rounds hits in its own way, so every x86-64 is asked for the same: AVX2 is what all our code is
/// compiled for. What is left between Intel and AMD is the approximate reciprocal, rcpps, which rounds hits.
/// Other processors have one set of kernels each, and are asked for nothing.
#if defined(__x86_64__)
inline constexpr const char* kDeviceSettings = "isa=avx2,frequency_level=simd256";
#else
inline constexpr const char* kDeviceSettings = "";
#endif

#if ORBS_EMBREE_MAJOR >= 4

using RayContext = RTCRayQueryContext;

inline void init(RayContext& context) { rtcInitRayQueryContext(&context); }

inline void intersect_packet(
    const int* valid, RTCScene scene, RayContext& context, RTCRayHit16& packet, bool is_coherent) {
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = &context;
  arguments.flags = is_coherent ? RTC_RAY_QUERY_FLAG_COHERENT : RTC_RAY_QUERY_FLAG_INCOHERENT;
  rtcIntersect16(valid, scene, &packet, &arguments);
}

inline void occluded_packet(const int* valid, RTCScene scene, RayContext& context, RTCRay16& packet) {
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.context = &context;
  rtcOccluded16(valid, scene, &packet, &arguments);
}

#else

using RayContext = RTCIntersectContext;

inline void init(RayContext& context) { rtcInitIntersectContext(&context); }

inline void intersect_packet(
    const int* valid, RTCScene scene, RayContext& context, RTCRayHit16& packet, bool is_coherent) {
  context.flags = is_coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
  rtcIntersect16(valid, scene, &context, &packet);
}

inline void occluded_packet(const int* valid, RTCScene scene, RayContext& context, RTCRay16& packet) {
  rtcOccluded16(valid, scene, &context, &packet);
}

#endif

}  // namespace orbs::tracer
