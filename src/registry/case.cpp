#include "registry/case.h"

#include "base/files.h"
#include "base/text.h"
#include "json/document.h"
#include "json/object_reader.h"
#include "registry/features.h"
#include "registry/placeholders.h"
#include "registry/plain_name.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::registry {

namespace {

using json::ObjectReader;

constexpr int kMostSpp = 1 << 24;
constexpr int kMostCameraPaths = 1 << 30;
constexpr int kLargestPixel = 1 << 20;

std::string target_name(ObjectReader& in, std::set<std::string>& names) {
  auto name = plain_name(in, "name");
  if (!names.insert(name).second)
    in.fail("name", fmt::format("'{}' is the name of an earlier image of this case", name));
  return name;
}

std::string known_name(ObjectReader& in, const std::string& key, const std::set<std::string>& names) {
  auto name = in.text(key);
  if (!names.contains(name))
    in.fail(key, fmt::format("no image of this case is called '{}'{}; there are: {}", name,
                             closest(name, names), fmt::join(names, ", ")));
  return name;
}

std::vector<AcceptedReference> load_accepted(ObjectReader& in, const CaseScene& scene) {
  std::vector<AcceptedReference> accepted;
  for (auto& entry : in.objects_or_none("accepted")) {
    AcceptedReference other{entry.text("reference"), entry.text("reason")};
    if (other.reference == scene.name || other.reference == scene.reference)
      entry.fail("reference", "is that of the scene already");
    if (other.reason.empty()) entry.fail("reason", "must say why the specification allows this image, too");
    entry.finish();
    accepted.push_back(std::move(other));
  }
  if (!accepted.empty() && !scene.no_reference.empty())
    in.fail("accepted", "needs a reference that the image is compared with first");
  return accepted;
}

std::map<std::string, std::vector<std::string>> load_arguments(ObjectReader in) {
  std::map<std::string, std::vector<std::string>> arguments;
  for (const auto& renderer : in.keys()) {
    auto& words = arguments[renderer];
    words = in.system_texts(renderer);
    for (std::size_t i = 0; i < words.size(); ++i)
      if (const auto problem = placeholder_problem(words[i], argument_placeholders()))
        in.fail_at(renderer, i, *problem);
  }
  in.finish();
  return arguments;
}

CaseScene load_case_scene(ObjectReader in,
                          const std::filesystem::path& folder,
                          std::set<std::string>& names) {
  CaseScene scene;
  scene.name = target_name(in, names);
  scene.file = resolve_path(folder, in.system_text("file"));
  if (const auto problem = no_file_problem(scene.file); !problem.empty()) in.fail("file", problem);
  if (in.has("camera")) {
    scene.camera = in.text("camera");
    if (scene.camera.empty())
      in.fail("camera", "must be the name of a camera; leave it out for \"camera\" of the file");
  }
  scene.spp = in.integer_or("spp", scene.spp, 1, kMostSpp);
  scene.camera_paths = in.integer_or("camera_paths", scene.camera_paths, 1, kMostCameraPaths);
  scene.wall_seconds = in.number_or("wall_seconds", 0, json::kPositive);
  if (in.has("reference")) scene.reference = in.text("reference");
  if (scene.reference == scene.name) in.fail("reference", "is the scene itself; leave it out");
  if (in.has("analytic")) scene.analytic = load_analytic(in.object("analytic"));
  if (in.has("no_reference")) scene.no_reference = in.text("no_reference");
  if (in.has("no_reference") && scene.no_reference.empty())
    in.fail("no_reference", "must say why pixel checks alone judge the scene");
  scene.accepted = load_accepted(in, scene);
  if (in.has("arguments")) scene.arguments = load_arguments(in.object("arguments"));
  if ((scene.reference.empty() ? 0 : 1) + (scene.analytic ? 1 : 0) + (scene.no_reference.empty() ? 0 : 1) > 1)
    in.fail("", "has more than one of 'reference', 'analytic' and 'no_reference'; keep one");
  in.finish();
  return scene;
}

Difference load_difference(ObjectReader in,
                           const std::set<std::string>& scenes,
                           std::set<std::string>& names) {
  Difference difference{target_name(in, names), known_name(in, "of", scenes),
                        known_name(in, "minus", scenes)};
  if (difference.of == difference.minus)
    in.fail("minus", "is the same scene as 'of': the difference would be black");
  in.finish();
  return difference;
}

Rectangle checked_rectangle(const ObjectReader& in, const std::string& key, const std::vector<double>& n) {
  for (const double edge : n)
    if (edge != static_cast<int>(edge))
      in.fail(key, fmt::format("pixels are whole numbers, {} is none", edge));
  const Rectangle r{static_cast<int>(n[0]), static_cast<int>(n[1]), static_cast<int>(n[2]),
                    static_cast<int>(n[3])};
  if (r.x0 >= r.x1 || r.y0 >= r.y1)
    in.fail(key,
            fmt::format("[x0,y0,x1,y1] = {} holds no pixel: x1 and y1 are exclusive", rectangle_text(r)));
  return r;
}

std::vector<Rectangle> load_rectangles(ObjectReader& in) {
  std::vector<Rectangle> out;
  for (const auto& row : in.number_rows("rectangles", 4, {0, kLargestPixel}))
    out.push_back(checked_rectangle(in, "rectangles", row));
  if (out.empty()) in.fail("rectangles", "must hold at least one [x0,y0,x1,y1]");
  return out;
}

Mask load_mask(ObjectReader in, const std::set<std::string>& names) {
  Mask mask{known_name(in, "scene", names), load_rectangles(in), in.text("reason")};
  if (mask.reason.empty()) in.fail("reason", "must say why these pixels are left out");
  in.finish();
  return mask;
}

PixelCheck load_pixel_check(ObjectReader in, const std::set<std::string>& names) {
  PixelCheck check;
  check.target = known_name(in, "scene", names);
  check.region = checked_rectangle(in, "region", in.numbers("region", 4, {0, kLargestPixel}));
  const auto expected = in.numbers("expected", 3);
  std::copy(expected.begin(), expected.end(), check.expected.begin());
  check.tolerance = in.number("tolerance", json::kNotNegative);
  check.standard_errors = in.number_or("standard_errors", 0, json::kNotNegative);
  check.why = in.text("why");
  in.finish();
  return check;
}

// "ESDL", "EDSSL-T": eye, surface events, light, and whether one of them is a transmission.
bool is_path_class(std::string_view name) {
  if (name.ends_with("-T")) name.remove_suffix(2);
  return name.size() >= 3 && name.front() == 'E' && name.back() == 'L' &&
         name.substr(1, name.size() - 2).find_first_not_of("DSG") == std::string_view::npos;
}

PathShare load_path_share(ObjectReader in, const std::set<std::string>& scenes) {
  PathShare share{known_name(in, "scene", scenes), in.text("class"), in.number("min_share", {0, 1})};
  if (!is_path_class(share.path_class))
    in.fail("class",
            fmt::format("'{}' is no path class; expected for example ESDL or EDSSL-T", share.path_class));
  in.finish();
  return share;
}

std::string load_requirement(ObjectReader& in) {
  auto text = in.text("requirement");
  try {
    refuse_unknown(parse_requirement(text));
  } catch (const InputError& e) {
    in.fail("requirement", e.what());
  }
  return text;
}

void load_scenes(ObjectReader& in, Case& one_case) {
  std::set<std::string> names;
  for (auto& entry : in.objects("scenes"))
    one_case.scenes.push_back(load_case_scene(std::move(entry), one_case.file.parent_path(), names));
  if (one_case.scenes.empty()) in.fail("scenes", "must hold at least one scene");
  const auto scenes = names;
  for (auto& entry : in.objects_or_none("differences"))
    one_case.differences.push_back(load_difference(std::move(entry), scenes, names));
  for (auto& entry : in.objects_or_none("masks"))
    one_case.masks.push_back(load_mask(std::move(entry), names));
  for (auto& entry : in.objects_or_none("pixel_checks"))
    one_case.pixel_checks.push_back(load_pixel_check(std::move(entry), names));
  for (auto& entry : in.objects_or_none("path_shares"))
    one_case.path_shares.push_back(load_path_share(std::move(entry), scenes));
}

// A target without reference and checks would pass with any image. A difference has a reference if both of
// its scenes have one.
void refuse_unjudged(const ObjectReader& in, const Case& one_case) {
  for (const auto& difference : one_case.differences) {
    const auto lacks = [&](const std::string& name) { return !no_reference_reason(one_case, name).empty(); };
    if (lacks(difference.of) != lacks(difference.minus))
      in.fail("differences",
              fmt::format("'{}' is of a scene with a reference and one without", difference.name));
  }
  for (const auto& target : target_names(one_case)) {
    if (no_reference_reason(one_case, target).empty()) continue;
    const bool is_checked = std::any_of(one_case.pixel_checks.begin(), one_case.pixel_checks.end(),
                                        [&](const auto& check) { return check.target == target; });
    if (!is_checked)
      in.fail("scenes",
              fmt::format("'{}' has no reference and no pixel check: nothing would judge it", target));
  }
}

ConditionBound load_condition(ObjectReader in) {
  ConditionBound bound{in.number("max", json::kNotNegative), in.text("reason")};
  if (bound.reason.empty()) in.fail("reason", "must say how the limit was found");
  in.finish();
  return bound;
}

}  // namespace

Case parse_case(const std::filesystem::path& file, const std::string& text) {
  const auto document = json::parse(file.string(), text);
  ObjectReader in(document);
  in.one_of("format", {"orbs-case/2"});
  Case one_case;
  one_case.file = std::filesystem::absolute(file).lexically_normal();
  one_case.name = one_case.file.parent_path().filename().string();
  one_case.requirement = load_requirement(in);
  one_case.title = in.text("title");
  one_case.tests = in.text("tests");
  one_case.typical_mistake = in.text("typical_mistake");
  one_case.gates = load_gates(in);
  load_scenes(in, one_case);
  refuse_unjudged(in, one_case);
  if (in.has("condition_map")) one_case.condition = load_condition(in.object("condition_map"));
  if (in.has("negative_values")) {
    one_case.negative_values = in.text("negative_values");
    if (one_case.negative_values.empty()) in.fail("negative_values", "must say why they are right here");
  }
  in.finish();
  return one_case;
}

Case load_case(const std::filesystem::path& file) { return parse_case(file, read_file(file)); }

std::vector<std::string> target_names(const Case& one_case) {
  std::vector<std::string> names;
  for (const auto& scene : one_case.scenes) names.push_back(scene.name);
  for (const auto& difference : one_case.differences) names.push_back(difference.name);
  return names;
}

const std::string& reference_name(const CaseScene& scene) {
  return scene.reference.empty() ? scene.name : scene.reference;
}

std::string no_reference_reason(const Case& one_case, const std::string& target) {
  for (const auto& scene : one_case.scenes)
    if (scene.name == target) return scene.no_reference;
  for (const auto& difference : one_case.differences)
    if (difference.name == target) return no_reference_reason(one_case, difference.of);
  return "";
}

}  // namespace orbs::registry
