// Every file of tests/corpus through the reader that the fuzzer steers: read, or refused with a complaint.
#include "base/files.h"
#include "fuzz/feed.h"
#include "structure/source_files.h"

#include <functional>
#include <map>

namespace {

using Feed = std::string (*)(std::string_view);

const std::map<std::string, Feed> kFeeds{{"scene", orbs::fuzz::feed_scene},
                                         {"configuration", orbs::fuzz::feed_configuration},
                                         {"case", orbs::fuzz::feed_case},
                                         {"obj", orbs::fuzz::feed_obj},
                                         {"ply", orbs::fuzz::feed_ply},
                                         {"ies", orbs::fuzz::feed_ies},
                                         {"exr", orbs::fuzz::feed_exr},
                                         {"image", orbs::fuzz::feed_image},
                                         {"expression", orbs::fuzz::feed_expression},
                                         {"table", orbs::fuzz::feed_table},
                                         {"record", orbs::fuzz::feed_record},
                                         {"request", orbs::fuzz::feed_request}};

const std::filesystem::path kCorpus = ORBS_SOURCE_DIR "/tests/corpus";

std::string complaint_about(const std::string& input, const std::string& file) {
  return kFeeds.at(input)(orbs::read_file(kCorpus / input / file));
}

class HostileInput : public testing::TestWithParam<std::string> {};

struct Refused {
  const char* input;
  const char* file;
  const char* complaint;  // a part of it
};

// What was found by fuzzing or by reading with it in mind, one small file each.
const std::vector<Refused> kRefused{
    {"scene", "many_triangles.json", ":1:211: /meshes/0/generator: asks for 16777216 triangles"},
    {"scene", "many_instances.json",
     "/instances/0/scatter: asks for 1000000 instances; the scene may hold 500"},
    {"scene", "odd_sphere.json", "/meshes/0/generator: a sphere needs an even number of segments"},
    {"scene", "spread_beyond_numbers.json", "/instances/0/scatter: copy 0 0: the matrix holds "},
    {"scene", "moved_beyond_numbers.json", "/instances/0/matrix: the matrix holds inf; entries must lie in"},
    {"scene", "no_way_back.json", "/instances/0/matrix: the matrix holds 1e+308; entries"},
    {"scene", "camera_beyond_numbers.json",
     "/camera/position/0: must lie in [-1000000000000, 1000000000000], is 1e+308"},
    {"scene", "sphere_without_size.json", "/lights/0/radius: times the matrix is too small a sphere"},
    {"scene", "mesh_beyond_floats.json", "/meshes/0: position 0 lies farther out than 1000000000000 m"},
    {"scene", "motion_without_way_back.json", "/instances/0/end_matrix: the matrices between start and end"},
    {"scene", "zero_in_file.json", "/textures/0/file: must not hold a zero byte"},
    {"configuration", "zero_in_name.json", "/renderers/0/name: must not hold a zero byte"},
    {"configuration", "zero_in_command.json", "/renderers/0/command/3: must not hold a zero byte"},
    {"configuration", "zero_in_program.json", "/renderers/0/executable: must not hold a zero byte"},
    {"configuration", "deep.json", ":1:76: nested deeper than 64 levels"},
    {"configuration", "twice.json", ":1:43: key 'format' appears twice"},
    {"configuration", "number_overflow.json", ":1:17: not usable JSON"},
    {"case", "zero_in_name.json", "/scenes/0/name: 'a"},
    {"case", "zero_in_file.json", "/scenes/0/file: must not hold a zero byte"},
    {"case", "empty_region.json", "/pixel_checks/0/region: [x0,y0,x1,y1] = [3,3,3,4] holds no pixel"},
    {"obj", "largest_index.obj", "mesh.obj:3: position index -9223372036854775808 is out of range"},
    {"obj", "zero_normal.obj", "mesh.obj:8: normal 2 is (0, 0, 0), must be finite and not zero"},
    {"obj", "weight.obj", "mesh.obj:1: the weight w is 2; only 1 is read"},
    {"ply", "face_of_nothing.ply", "mesh.ply:17: face 1: a face needs at least three corners, has 0"},
    {"ply", "corner_uvs_too_few.ply", "mesh.ply:17: face 0: the list 'texcoord' has 4 numbers"},
    {"ply", "strips.ply", "Triangle strips (tristrips) are not read"},
    {"ply", "material_list.ply", "a face has 0 materials, expected one"},
    {"ply", "material_huge.ply", "material 1e+30 is no place in a list"},
    {"ply", "material_nan.ply", "material nan is no place in a list"},
    {"ply", "no_properties.ply", "element 'a' has no property"},
    {"ies", "planes_to_60.ies", "horizontal angles of type C run from 0 to 0, 90, 180 or 360"},
    {"ies", "peak_infinite.ies", "beyond what a number can hold"},
    {"exr", "text.exr", "is no readable .exr image: it does not start as one"},
    {"exr", "other_version.exr", "is an EXR file of an unknown version, 0x63"},
    {"exr", "torn_in_header.exr", "the file ends inside its EXR header"},
    {"exr", "attribute_too_long.exr", "the file ends inside its EXR header"},
    {"exr", "attribute_of_other_size.exr", "'pixelAspectRatio' of type float has 3 bytes, expected 4"},
    {"exr", "window_of_other_type.exr", "'dataWindow' is of type box2f, expected box2i"},
    {"exr", "too_wide.exr", "2000000001 x 3 px with 3 channels, which is more than 535 bytes can hold"},
    {"exr", "too_high.exr", "the file is too short for the blocks that the EXR header speaks of"},
    {"exr", "backwards.exr", "the EXR header says -6 x 5 px"},
    {"exr", "tiles_of_nothing.exr", "20 x 18 px in blocks of 0 x 16"},
    {"exr", "tiles_too_large.exr", "which is more than 1876 bytes can hold"},
    {"exr", "second_channel_list.exr", "the list of EXR channels does not hold together"},
    {"exr", "half_the_rows.exr", "not a multiple of the y subsampling factor of the \"B\" channel"},
    {"exr", "unknown_compression.exr", "the EXR compression 99 is not known"},
    {"exr", "cube_map.exr", "is a cube map by its attribute envmap"},
    {"exr", "uint_zips.exr", "the EXR channel 'Y' holds integers, expected half or float"},
};

}  // namespace

TEST_P(HostileInput, IsReadOrRefusedByNameAndNothingElseHappens) {
  const auto folder = kCorpus / GetParam();
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    EXPECT_NO_THROW(complaint_about(GetParam(), entry.path().filename())) << entry.path();
    ++files;
  }
  EXPECT_GT(files, 0) << folder;
}

INSTANTIATE_TEST_SUITE_P(Corpus,
                         HostileInput,
                         testing::ValuesIn([] {
                           std::vector<std::string> inputs;
                           for (const auto& [input, feed] : kFeeds) inputs.push_back(input);
                           return inputs;
                         }()),
                         [](const auto& one) { return one.param; });

TEST(HostileInputCorpus, WhatWasFoundOnceIsRefusedAtItsPlace) {
  for (const auto& [input, file, complaint] : kRefused)
    EXPECT_NE(complaint_about(input, file).find(complaint), std::string::npos)
        << input << "/" << file << ": " << complaint_about(input, file);
}

TEST(HostileInputCorpus, SeedsThatAreRightAreRead) {
  const std::vector<std::pair<const char*, const char*>> right{{"scene", "whole.json"},
                                                               {"scene", "motion.json"},
                                                               {"scene", "generators.json"},
                                                               {"configuration", "whole.json"},
                                                               {"case", "whole.json"},
                                                               {"obj", "square.obj"},
                                                               {"ply", "ascii.ply"},
                                                               {"ply", "binary.ply"},
                                                               {"ies", "round.ies"},
                                                               {"ies", "quadrant.ies"},
                                                               {"ies", "sides.ies"},
                                                               {"ies", "half.ies"},
                                                               {"ies", "tilt.ies"},
                                                               {"ies", "no_plane_at_180.ies"},
                                                               {"exr", "zip_float.exr"},
                                                               {"exr", "half_layers.exr"},
                                                               {"exr", "none_tiled.exr"},
                                                               {"exr", "rle.exr"},
                                                               {"exr", "piz.exr"},
                                                               {"exr", "pxr24.exr"},
                                                               {"exr", "b44.exr"},
                                                               {"exr", "dwaa.exr"},
                                                               {"obj", "concave_quad.obj"},
                                                               {"obj", "crossing_face.obj"},
                                                               {"obj", "hole_on_an_edge.obj"},
                                                               {"obj", "loose_ends.obj"},
                                                               {"obj", "material_spaces.obj"},
                                                               {"ply", "texture_uv.ply"},
                                                               {"ply", "corner_uvs.ply"},
                                                               {"ply", "cr_lines.ply"},
                                                               {"ies", "small_letters.ies"},
                                                               {"ies", "cr_lines.ies"}};
  for (const auto& [input, file] : right) EXPECT_EQ(complaint_about(input, file), "") << input << "/" << file;
}
