// Compiled for the first x86-64, as src/CMakeLists.txt says. It calls no template and no inline function: the
// linker keeps one copy of each, which may be one with newer instructions.
#include "base/processor.h"

#if defined(__x86_64__)

#  include <cerrno>
#  include <cstring>

#  include <cpuid.h>
#  include <unistd.h>

namespace orbs {

namespace {

struct Needed {
  const char* name;
  unsigned int ProcessorFeatures::*word;
  unsigned int bits;
};

// Bits by the Intel 64 manual, volume 2, CPUID. That the system saves the wide registers is OSXSAVE and
// XCR0.
constexpr Needed kNeeded[] = {
    {"SSE3", &ProcessorFeatures::leaf_1_ecx, 1U << 0},
    {"SSSE3", &ProcessorFeatures::leaf_1_ecx, 1U << 9},
    {"SSE4.1", &ProcessorFeatures::leaf_1_ecx, 1U << 19},
    {"SSE4.2", &ProcessorFeatures::leaf_1_ecx, 1U << 20},
    {"POPCNT", &ProcessorFeatures::leaf_1_ecx, 1U << 23},
    {"AVX", &ProcessorFeatures::leaf_1_ecx, 1U << 28},
    {"AVX (the system does not save its registers)", &ProcessorFeatures::leaf_1_ecx, 1U << 27},
    {"AVX (the system does not save its registers)", &ProcessorFeatures::saved, 6},
    {"AVX2", &ProcessorFeatures::leaf_7_ebx, 1U << 5},
    {"FMA", &ProcessorFeatures::leaf_1_ecx, 1U << 12},
    {"F16C", &ProcessorFeatures::leaf_1_ecx, 1U << 29},
    {"MOVBE", &ProcessorFeatures::leaf_1_ecx, 1U << 22},
    {"BMI1", &ProcessorFeatures::leaf_7_ebx, 1U << 3},
    {"BMI2", &ProcessorFeatures::leaf_7_ebx, 1U << 8},
    {"LZCNT", &ProcessorFeatures::extended_1_ecx, 1U << 5},
};

void say(const char* text) {
  // Nothing can be done where standard error cannot be written.
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text, std::strlen(text));
}

// Before the initialisers of C++, which have the priority 65535.
[[gnu::constructor(101)]] void check_processor() {
  const char* missing = missing_instructions(features_of_this_processor());
  if (missing == nullptr) return;
  say(program_invocation_short_name);
  say(": this processor has no ");
  say(missing);
  say("; expected x86-64-v3, which Intel's have since Haswell (2013) and AMD's since Excavator (2015). "
      "Run it on a newer machine.\n");
  ::_exit(2);
}

}  // namespace

ProcessorFeatures features_of_this_processor() {
  ProcessorFeatures features;
  unsigned int a = 0;
  unsigned int b = 0;
  unsigned int c = 0;
  unsigned int d = 0;
  if (__get_cpuid(1, &a, &b, &c, &d) != 0) features.leaf_1_ecx = c;
  if (__get_cpuid_count(7, 0, &a, &b, &c, &d) != 0) features.leaf_7_ebx = b;
  if (__get_cpuid(0x80000001, &a, &b, &c, &d) != 0) features.extended_1_ecx = c;
  constexpr unsigned int kOsxsave = 1U << 27;
  if ((features.leaf_1_ecx & kOsxsave) != 0) asm("xgetbv" : "=a"(features.saved), "=d"(d) : "c"(0));
  return features;
}

const char* missing_instructions(const ProcessorFeatures& features) {
  for (const Needed& needed : kNeeded)
    if ((features.*needed.word & needed.bits) != needed.bits) return needed.name;
  return nullptr;
}

}  // namespace orbs

#endif
