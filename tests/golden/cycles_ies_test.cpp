#include "adapters/process/process.h"
#include "base/files.h"
#include "scene/lights/ies.h"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

/// Blender's Python reads luminaire files by itself (adapters/cycles_ies.py). What the harness takes it must
/// take too, and see the same light in it.
namespace {

using namespace orbs;

struct Luminaire {
  std::string name;
  std::string planes;  // numbers of the file from the count of planes on
  std::string header = "IESNA:LM-63-2002\nTILT=NONE\n";
  std::string line_end = "\n";
};

std::string file_of(const Luminaire& luminaire) {
  std::string text;
  for (const char c : luminaire.header + "1 -1 2 2 " + luminaire.planes)
    text += c == '\n' ? luminaire.line_end : std::string(1, c);
  return text;
}

// The ways in which programs write the same file; the last factor of the ballast line counts in old ones.
std::vector<Luminaire> headers() {
  const std::string planes = "1 1 2 0 0 0 0.5 0.5 10\n0 90\n0\n8,4\n";
  const std::string included = "1\n3\n0 45 90\n0.5 0.75 1\n";
  return {{"small letters", planes, "iesna:lm-63-2002\nTilt=none\n"},
          {"blanks", planes, "IESNA:LM-63-2002\n tilt\t= None \n"},
          {"tilt included", planes, "IESNA:LM-63-1995\nTilt=Include\n" + included},
          {"of 1991", planes, "IESNA91\nTILT=NONE\n"},
          {"of 1986", planes, "A luminaire\nTILT=NONE\n"},
          {"byte order mark", planes, "\xEF\xBB\xBFIESNA:LM-63-1995\nTILT=NONE\n"},
          {"bytes beyond ASCII", planes, "IESNA:LM-63-2002\n[LUMINAIRE] f\xFCr \x85 30\xB0\x0C\nTILT=NONE\n"},
          {"line ends of Windows", planes, "IESNA:LM-63-2002\nTILT=NONE\n", "\r\n"},
          {"carriage returns", planes, "IESNA:LM-63-2002\nTILT=NONE\n", "\r"}};
}

std::vector<Luminaire> luminaires() {
  const std::string middle = " 1 2 0 0 0 0.5 1 10\n0 90\n";
  return {{"axial", "1" + middle + "0\n8 4\n"},
          {"quadrants", "3" + middle + "0 30 90\n1 1\n2 2\n4 8\n"},
          {"halves", "3" + middle + "0 45 180\n1 1\n2 2\n4 8\n"},
          {"halves from 90", "3" + middle + "90 180 270\n1 1\n2 2\n5 7\n"},
          {"halves from 90 without 180", "3" + middle + "90 140 270\n1 1\n13 13\n26 28\n"},
          {"all around", "4" + middle + "0 90 200 360\n1 1\n2 2\n5 7\n1 1\n"},
          {"short of 360", "3" + middle + "0 90 345\n1 1\n2 2\n5 7\n"}};
}

class CyclesIes : public testing::TestWithParam<Luminaire> {};

/// The script's answer to: candela on its regular grid, by azimuth and then vertical angle, or its error.
std::string grid_in_python(const std::string& text) {
  const ScratchFolder folder("orbs-cycles-ies");
  write_file(folder.path() / "lamp.ies", text);
  adapters::ProcessRequest request;
  request.argv = {"/usr/bin/python3",
                  "-B",
                  "-c",
                  "import sys; sys.path.insert(0, sys.argv[1]); import cycles_ies as ies\n"
                  "profile = ies.read_ies(sys.argv[2]); grid = ies.regular_grid(profile)\n"
                  "at = lambda c, r: grid.values[r * grid.columns + c] * profile.max_candela\n"
                  "for c in range(grid.columns): print(*(f'{at(c, r):.9f}' for r in (0, grid.rows - "
                  "1)))\n",
                  ORBS_SOURCE_DIR "/adapters",
                  (folder.path() / "lamp.ies").string()};
  request.environment = {"PATH=/usr/bin:/bin"};
  request.limits.wall_seconds = 60;
  return adapters::run_process(request).output;
}

TEST_P(CyclesIes, SeesTheLightThatTheHarnessSees) {
  const std::string text = file_of(GetParam());
  const std::string found = grid_in_python(text);
  const auto columns = std::count(found.begin(), found.end(), '\n');
  ASSERT_GE(columns, 2) << found;
  const auto profile = scene::parse_ies("lamp.ies", text);
  std::string expected;
  for (int c = 0; c < columns; ++c) {
    // 360 is 0: candela_at takes angles modulo a turn.
    const double azimuth_deg = 360.0 * c / static_cast<double>(columns - 1);
    expected += fmt::format("{:.9f} {:.9f}\n", scene::candela_at(profile, 0, azimuth_deg),
                            scene::candela_at(profile, 90, azimuth_deg));
  }
  EXPECT_EQ(found, expected);
}

std::string test_name(const testing::TestParamInfo<Luminaire>& luminaire) {
  std::string name = luminaire.param.name;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Symmetries, CyclesIes, testing::ValuesIn(luminaires()), test_name);
INSTANTIATE_TEST_SUITE_P(Headers, CyclesIes, testing::ValuesIn(headers()), test_name);

}  // namespace
