#pragma once

#if defined(__x86_64__)

/// Whether the processor has the instructions that our code is compiled for: x86-64-v3 of the ABI of x86-64
/// (System V psABI, 3.1.1), which the machines since 2013 have. Every program asks before anything else,
/// since on an older one the first such instruction ends it with a signal that says nothing.
namespace orbs {

/// What the instruction CPUID answers, by leaf and register, and what the system saves of the registers.
struct ProcessorFeatures {
  unsigned int leaf_1_ecx = 0;
  unsigned int leaf_7_ebx = 0;
  unsigned int extended_1_ecx = 0;
  unsigned int saved = 0;  // XCR0
};

ProcessorFeatures features_of_this_processor();

/// The name of an instruction set that is missing; nullptr if there is all that is needed.
const char* missing_instructions(const ProcessorFeatures& features);

}  // namespace orbs

#endif
