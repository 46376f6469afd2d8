#pragma once

#include <cfloat>
#include <cstdint>

#if defined(__x86_64__)
#  include <xmmintrin.h>
#endif

/// The processor's flags for numbers too small to be normal, which a test sets and looks at. They are those
/// of the calling thread and of all that it starts from then on.
namespace orbs::tests {

/// Small results become zero, and small operands count as zero.
inline void flush_small_numbers() {
#if defined(__x86_64__)
  // Intel 64 manual, volume 1, 10.2.3: FZ and DAZ of MXCSR.
  constexpr unsigned int kFlushToZero = 0x8000;
  constexpr unsigned int kDenormalsAreZero = 0x0040;
  _mm_setcsr(_mm_getcsr() | kFlushToZero | kDenormalsAreZero);
#elif defined(__aarch64__)
  // Arm architecture reference manual, FPCR: FZ is for both.
  constexpr std::uint64_t kFlushToZero = 1U << 24;
  std::uint64_t flags = 0;
  asm volatile("mrs %0, fpcr" : "=r"(flags));
  flags |= kFlushToZero;
  asm volatile("msr fpcr, %0" : : "r"(flags));
#else
#  error "expected x86-64 or ARM64: say here how this processor flushes small numbers to zero"
#endif
}

inline bool small_numbers_are_flushed() {
  volatile float smallest_normal = FLT_MIN;
  return smallest_normal / 2 == 0;
}

}  // namespace orbs::tests
