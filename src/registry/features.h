#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

namespace orbs::registry {

/// Requirement numbers by group letter: {'M': {1, 2, 3}} are M1 to M3. A group with no numbers is one of
/// which nothing is fulfilled, which differs from a group that is not mentioned. It is its own type, and
/// no alias, so that the visitors of fields() find its to_text().
struct FeatureSet : std::map<char, std::set<int>> {
  using map::map;
};

/// Highest requirement number that the notation takes; keeps a typo like L70000000 from filling the memory.
constexpr int kHighestLevel = 99;

/// ORB.S section 1: "G1/M3/L7-(2,3)" leaves 2 and 3 out of L1 to L7, "L7+(11-13,15-18)" adds to them. "M0" is
/// a group of which nothing is fulfilled. InputError saying what is wrong, without a place.
FeatureSet parse_features(std::string_view text);

/// The shortest text that parse_features reads back to the same set; G, M, L, A first, other groups after
/// them. Between texts of equal length the one with the higher level, which says more: L3-(2) rather than
/// L1+(3). Numbers that are undecided follow their group, "L3?(2)", and are neither left out of it nor part
/// of it; a group that only `undecided` has is "L?". parse_features does not take these.
std::string format_features(const FeatureSet& features, const FeatureSet& undecided = {});

/// A requirement as cases name it: "M7".
struct RequirementCode {
  char group = 'G';
  int level = 1;
  friend bool operator==(const RequirementCode&, const RequirementCode&) = default;
};

/// "M7" in its parts; InputError when it is none.
RequirementCode parse_requirement(std::string_view text);
std::string format_requirement(RequirementCode code);

/// What the requirements of a group are about: "geometry" of G; "" for a letter that is none.
std::string_view what_of_group(char letter);

/// InputError, with those that there are, when a requirement is none of G1 to G5, M1 to M8, L1 to L4, A1 to
/// A4 of ORB.S, B1 to B9, appearance, C1 to C5, cameras, D1 to D4, lights without an area, E1 to E6, effects
/// of light, N1 to N6, textures and surface detail, V1, layers of surfaces, S1 to S7, shapes by their
/// formula, T1 to T3, motion, and I1 and I2, integrators.
void refuse_unknown(RequirementCode code);
void refuse_unknown(const FeatureSet& features);

/// As fields() write and read what a renderer declares. InputError as of parse_features and refuse_unknown.
std::string to_text(const FeatureSet& features);
void from_text(std::string_view text, FeatureSet& features);

/// Order of the specification: groups G, M, L, A, then the others by letter; numbers within a group.
bool comes_before(RequirementCode a, RequirementCode b);

bool has_feature(const FeatureSet& features, RequirementCode code);

/// The set as codes ("G1", "G2", ...), the form that lowering asks for.
std::set<std::string> feature_codes(const FeatureSet& features);

}  // namespace orbs::registry
