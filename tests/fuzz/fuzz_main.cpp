// What libFuzzer calls: https://llvm.org/docs/LibFuzzer.html. ORBS_FEED is one function of feed.h.
#include "fuzz/feed.h"

#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // The bytes as char: any object may be looked at as char.
  orbs::fuzz::ORBS_FEED({reinterpret_cast<const char*>(data), size});
  return 0;
}
