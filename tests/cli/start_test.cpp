// What a start of our programs costs: the libraries that the loader brings in before main.
#include "base/files.h"
#include "structure/source_files.h"

#include <array>
#include <cstdio>
#include <filesystem>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

namespace {

namespace fs = std::filesystem;

// What a command prints, errors included.
std::string output_of(const std::string& command) {
  std::FILE* pipe = ::popen((command + " 2>&1").c_str(), "r");
  std::string text;
  std::array<char, 4096> block{};
  while (const auto count = std::fread(block.data(), 1, block.size(), pipe)) text.append(block.data(), count);
  ::pclose(pipe);
  return text;
}

}  // namespace

// OpenImageIO alone brings in 260, which take half a second of each start.
TEST(Start, NoProgramLoadsManyLibraries) {
  constexpr int kMost = 25;
  for (const char* program : {"orbs", "orbs-tracer", "orbs-supervisor"}) {
    // What ldd sets: the loader lists what it would load, one a line.
    std::istringstream libraries(
        output_of(std::string("LD_TRACE_LOADED_OBJECTS=1 " ORBS_BINARY_WORD "/") + program));
    int count = 0;
    std::string all;
    for (std::string line; std::getline(libraries, line); ++count) all += line + '\n';
    // The supervisor has none where it is linked with archives; another test sees to that.
    const int least = std::string(program) == "orbs-supervisor" ? 0 : 3;
    EXPECT_GE(count, least) << program << ": " << all;
    EXPECT_LE(count, kMost) << program << ":\n" << all;
  }
}

TEST(Start, AFormatWhoseModuleIsMissingIsRefusedWithItsPlace) {
  const orbs::structure::TestFolder folder("start-module");
  fs::copy_file(ORBS_BINARY_DIR "/orbs", folder.path() / "orbs");
  orbs::write_file(folder.path() / "a.jpg", "\xff\xd8\xff\xda\xff\xd9");
  const auto image = (folder.path() / "a.jpg").string();
  const auto said = output_of((folder.path() / "orbs").string() + " compare " + image + " " + image);
  const auto expected = image + ": .jpg files are read by liborbs-image-formats.so, expected at " +
                        (folder.path() / "liborbs-image-formats.so").string();
  EXPECT_NE(said.find(expected), std::string::npos) << said;
}
