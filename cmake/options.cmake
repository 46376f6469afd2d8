# By the compiler, which may be one for another machine than this.
include(CheckCXXSymbolExists)
check_cxx_symbol_exists(__x86_64__ "" ORBS_IS_X86_64)

# What every target of ours is compiled with.
add_library(orbs_options INTERFACE)
target_compile_options(orbs_options INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wnon-virtual-dtor -Wold-style-cast
  # Where sources are compiled together, a local name may well be one of another source's.
  $<$<NOT:$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>>:-Wshadow>
  # FMA contraction breaks the antisymmetry that watertight edge tests and bit-equal images rest on; and NaN must stay NaN.
  -ffp-contract=off -fno-fast-math
  # These two only say that nobody reads errno or traps; every value, NaN and infinities included, stays the same.
  -fno-math-errno -fno-trapping-math
  # As on x86-64 without saying: comparisons of characters mean the same on ARM64.
  $<$<NOT:$<BOOL:${ORBS_IS_X86_64}>>:-fsigned-char>
  # AVX2 machines are the oldest that Cycles and Embree are still tuned for; every x86-64 since 2013 has it, and
  # base/processor.cpp says so to the others. ARM64 has all that is used from its first version on.
  $<$<BOOL:${ORBS_IS_X86_64}>:-march=x86-64-v3>
  $<$<BOOL:${ORBS_WERROR}>:-Werror>
  $<$<BOOL:${ORBS_SANITIZE}>:-fsanitize=address,undefined,float-cast-overflow;-fno-sanitize-recover=all>
  $<$<BOOL:${ORBS_SANITIZE}>:-fno-omit-frame-pointer;-D_GLIBCXX_ASSERTIONS>
  $<$<BOOL:${ORBS_FUZZ}>:-fsanitize=fuzzer-no-link>
  $<$<BOOL:${ORBS_COVERAGE}>:--coverage;-O0>)
target_link_options(orbs_options INTERFACE
  $<$<BOOL:${ORBS_SANITIZE}>:-fsanitize=address,undefined>
  $<$<BOOL:${ORBS_COVERAGE}>:--coverage>)
