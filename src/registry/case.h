#pragma once

#include "base/rectangle.h"
#include "registry/analytic.h"
#include "registry/gates.h"

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// case.json (format "orbs-case/2") as plain data: what a requirement needs tested, and what counts as right.
namespace orbs::registry {

/// Another right image of a scene, where a specification allows more than one answer.
struct AcceptedReference {
  std::string reference;  // the scene of the suite whose reference it is
  std::string reason;
  friend bool operator==(const AcceptedReference&, const AcceptedReference&) = default;
};

struct CaseScene {
  std::string name;  // unique in the suite
  std::filesystem::path file;
  int spp = 64;
  int camera_paths = 0;  // that the mean of the image needs, over all pixels; a reduced run makes up for them
  double wall_seconds = 0;     // that a render may take; 0: as long as its renderer may
  std::string reference = {};  // the scene of the suite whose image this one is by definition; "": its own
  std::optional<AnalyticReference> analytic = {};  // the formula of its reference, where there is one
  std::map<std::string, std::vector<std::string>> arguments = {};  // by the name of a renderer's entry
  std::vector<AcceptedReference> accepted = {};  // tried in turn where the image fails by its reference
  std::string no_reference = {};  // why it has no reference and pixel checks alone judge it; "": it has one
  std::string camera = {};        // one of the file's "cameras"; "": its "camera"
};

/// An image made by subtraction, judged like a scene: of - minus.
struct Difference {
  std::string name;
  std::string of;
  std::string minus;
};

struct Mask {
  std::string target;  // a scene or a difference of the case
  std::vector<Rectangle> rectangles;
  std::string reason;
};

/// What the mean linear value of a region of the renderer's image must be, per channel.
struct PixelCheck {
  std::string target;
  Rectangle region{};
  std::array<double, 3> expected{};
  double tolerance = 0;
  std::string why;
  std::string not_measured = {};  // why it cannot be measured at a reduced size; "" if it can
  /// 0: the mean itself must lie within the tolerance. Else the mean with so many standard errors on either
  /// side: all of it within is right, all of it beyond is wrong, and anything between is inconclusive.
  double standard_errors = 0;
};

/// The least share of a light-path class in the mean radiance of the reference, or the case proves nothing
/// about it.
struct PathShare {
  std::string scene;
  std::string path_class;  // "ESDL"
  double min_share = 0;
};

/// How much rounding may decide in the images of a case, where its renderer can be asked.
struct ConditionBound {
  /// Of the mean of the absolute differences of single pixels between a render in single and one in double
  /// precision with the same random numbers, over the mean of the image.
  double most = 0;
  std::string reason;
};

struct Case {
  std::string name;  // its folder
  std::filesystem::path file;
  std::string requirement;  // "M2"
  std::string title;
  std::string tests;
  std::string typical_mistake;
  std::vector<CaseScene> scenes;
  std::vector<Difference> differences;
  std::vector<Gate> gates;  // all must be met; in the order in which verdicts name them
  std::vector<Mask> masks;
  std::vector<PixelCheck> pixel_checks;
  std::vector<PathShare> path_shares;
  std::optional<ConditionBound> condition;  // of each of its scenes
  std::string negative_values;              // why images may hold negative values; "" when they may not
};

/// Reads and checks one case.json. InputError with file, line and key.
Case load_case(const std::filesystem::path& file);

/// As load_case, for a text that is not in the file yet.
Case parse_case(const std::filesystem::path& file, const std::string& text);

/// Names of the images that a case judges: its scenes, then its differences.
std::vector<std::string> target_names(const Case& one_case);

/// The scene whose reference a scene is judged by: mostly its own.
const std::string& reference_name(const CaseScene& scene);

/// Why pixel checks alone judge the target, a scene or a difference of scenes; "" where a reference does.
std::string no_reference_reason(const Case& one_case, const std::string& target);

}  // namespace orbs::registry
