#pragma once

#include <map>
#include <set>
#include <string>

/// Which words of its format an exported file uses, in the form of tests/data/pbrt_words.txt and
/// its like: facts from the sources of the programs, so that a file that they would refuse fails
/// here.
namespace orbs::tests {

/// "Film spectral", "Film spectral integer nbuckets", "Option disabletexturefiltering", ... of a pbrt scene.
std::set<std::string> pbrt_words(const std::string& text);

/// "bsdf diffuse", "bsdf diffuse rgb reflectance", "attributes rgb name value", ... of a Mitsuba scene.
std::set<std::string> mitsuba_words(const std::string& text);

/// "material diffuse/bsdf", "bsdf oren-nayar", "instance@matrix", ... of a scene for HydraCore3: each node in
/// its parent, with its type behind its name, and each attribute. Ids are left out: they are positions.
std::set<std::string> hydra_words(const std::string& text);

/// The words of a table and where each stands in the program's sources. Throws std::runtime_error for a line
/// without a source.
std::map<std::string, std::string> known_words(const std::string& text);

}  // namespace orbs::tests
