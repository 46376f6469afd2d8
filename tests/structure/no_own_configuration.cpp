// Part of every test program: what it starts must not read the configuration of whoever runs the tests.
#include <cstdlib>

namespace {

[[maybe_unused]] const bool kIsSet = [] {
  constexpr const char* kNowhere = ORBS_BINARY_DIR "/tests/no-configuration";
  ::setenv("XDG_CONFIG_HOME", kNowhere, 1);
  ::setenv("ORBS_SYSTEM_FOLDER", kNowhere, 1);
  return true;
}();

}  // namespace
