#include "base/files.h"
#include "base/text.h"
#include "golden/pbrt_tokens.h"
#include "golden/read_back.h"
#include "scene/geometry/ply.h"
#include "spectra/observer.h"

#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

namespace orbs::tests {

namespace {

struct State {
  Mat4 place;
  std::string material;
  bool is_lamp = false;
  scene::RgbColour radiance;
  ReadSpectrum spectrum;
  bool two_sided = false;
};

using Parameters = std::map<std::string, std::vector<std::string>>;  // "rgb L" -> values

class PbrtReader {
 public:
  explicit PbrtReader(const std::filesystem::path& file) : folder_(file.parent_path()) {
    tokens_ = pbrt_tokens(read_file(file));
    while (at_ < tokens_.size()) directive(next());
    if (!states_.empty()) throw std::runtime_error("AttributeBegin without end");
  }
  ReadScene scene;

 private:
  std::string next() {
    if (at_ == tokens_.size()) throw std::runtime_error("the file ends within a directive");
    return tokens_[at_++];
  }
  std::string text() {
    const std::string token = next();
    if (token[0] != '"') throw std::runtime_error("a string expected: " + token);
    return token.substr(1);
  }
  double number() { return to_number(next()).value(); }
  Vec3d vec3() {
    const double x = number();
    const double y = number();
    return {x, y, number()};
  }
  Parameters parameters() {
    Parameters out;
    while (at_ < tokens_.size() && tokens_[at_][0] == '"') {
      auto& values = out[text()];
      if (tokens_.at(at_) != "[") {
        values.push_back(next());
        continue;
      }
      ++at_;
      while (tokens_.at(at_) != "]") values.push_back(next());
      ++at_;
    }
    return out;
  }
  static double number(const Parameters& given, const std::string& key) {
    return to_number(given.at(key).at(0)).value();
  }
  static Vec3d vec3(const std::vector<std::string>& words, std::size_t first = 0) {
    return {to_number(words.at(first)).value(), to_number(words.at(first + 1)).value(),
            to_number(words.at(first + 2)).value()};
  }

  void directive(const std::string& word) {
    if (word == "WorldBegin" || word == "ObjectEnd") {
      object_.clear();
    } else if (word == "AttributeBegin") {
      states_.push_back(state_);
    } else if (word == "AttributeEnd") {
      state_ = states_.at(states_.size() - 1);
      states_.pop_back();
    } else if (word == "Scale") {
      scene.mirrored_x = vec3() == Vec3d{-1, 1, 1};
    } else if (word == "LookAt") {
      if (!scene.mirrored_x) throw std::runtime_error("LookAt before the mirror");
      scene.eye = vec3();
      scene.target = vec3();
      scene.up = vec3();
    } else if (word == "Translate") {
      state_.place = state_.place * translation(vec3());
    } else if (word == "Transform") {
      next();
      for (std::size_t column = 0; column < 4; ++column)
        for (std::size_t row = 0; row < 4; ++row) state_.place(row, column) = number();
      if (next() != "]") throw std::runtime_error("16 numbers expected");
    } else {
      with_name(word);
    }
  }
  void with_name(const std::string& word) {
    const bool is_option = word == "Option";
    const std::string name = is_option ? "" : text();
    if (word == "Texture") {
      text();
      text();
    }
    const Parameters given = parameters();
    if (word == "Camera") {
      fov_deg_ = number(given, "float fov");
    } else if (word == "Film") {
      film(name, given);
    } else if (word == "Integrator") {
      scene.trace_depth = static_cast<int>(number(given, "integer maxdepth"));
    } else if (word == "LightSource") {
      radiance(given, scene.environment, scene.environment_spectrum);
    } else if (word == "AreaLightSource") {
      state_.is_lamp = true;
      radiance(given, state_.radiance, state_.spectrum);
      state_.two_sided = given.contains("bool twosided");
    } else if (word == "MakeNamedMaterial") {
      surface(given, scene.surfaces[name]);
    } else if (word == "NamedMaterial") {
      state_.material = name;
    } else if (word == "ObjectBegin") {
      object_ = name;
    } else if (word == "ObjectInstance") {
      const auto& [material, mesh] = objects_.at(name);
      add_mesh(scene.materials[material], mesh, state_.place, false);
    } else if (word == "Shape") {
      shape(name, given);
    } else if (word != "Sampler" && word != "PixelFilter" && word != "Material" && word != "Texture" &&
               !is_option) {
      throw std::runtime_error("unknown directive " + word);
    }
  }
  static ReadSpectrum pairs(const std::vector<std::string>& words) {
    ReadSpectrum out;
    for (std::size_t i = 0; i + 1 < words.size(); i += 2)
      out[to_number(words[i]).value()] = to_number(words[i + 1]).value();
    return out;
  }
  // pbrt divides a light's spectrum by its luminance, then multiplies it by `scale`. Its spectral film
  // multiplies by the luminance of a flat 1, which is 1 for our ybar, and averages over each bucket.
  void radiance(const Parameters& given, scene::RgbColour& colour, ReadSpectrum& spectrum) const {
    spectrum = pairs(given.at("spectrum L"));
    double luminance = 0;
    for (double nm = 360; nm <= 830; nm += 1)
      luminance += value_at(spectra::cie_1931().ybar, nm) * tests::value_at(spectrum, nm);
    for (auto& [nm, value] : spectrum) value *= number(given, "float scale") / luminance;
    if (band_nm_ == 0) return;
    const auto mean = [&](double band) {
      double sum = 0;
      for (double nm = 0.5; nm < band_nm_; nm += 1)
        sum += tests::value_at(spectrum, first_nm_ + band * band_nm_ + nm);
      return sum / band_nm_;
    };
    colour = {mean(2), mean(1), mean(0)};
    spectrum.clear();
  }
  static void surface(const Parameters& given, ReadSurface& out) {
    for (const auto& [key, values] : given) {
      const auto blank = key.find(' ');
      const std::string name = key.substr(blank + 1);
      if (key == "string type")
        out.type = values.at(0).substr(1);
      else if (key.starts_with("spectrum "))
        out.spectra[name] = pairs(values);
      else
        out.words[name] = values.at(0);
    }
  }
  void film(const std::string& type, const Parameters& given) {
    if (type == "spectral") {
      first_nm_ = number(given, "float lambdamin");
      band_nm_ = (number(given, "float lambdamax") - first_nm_) / number(given, "integer nbuckets");
    }
    scene.width_px = static_cast<int>(number(given, "integer xresolution"));
    scene.height_px = static_cast<int>(number(given, "integer yresolution"));
    const double half = std::tan(fov_deg_ * std::numbers::pi / 360);  // of the shorter side
    const double half_y = scene.width_px < scene.height_px ? half * scene.height_px / scene.width_px : half;
    scene.fov_y_deg = 360 / std::numbers::pi * std::atan(half_y);
  }
  void shape(const std::string& type, const Parameters& given) {
    if (type == "plymesh") {
      const std::string file = given.at("string filename").at(0).substr(1);
      const scene::Mesh mesh = scene::read_ply(folder_ / file).mesh;
      if (!object_.empty()) {
        objects_[object_] = {state_.material, mesh};
        return;
      }
      if (state_.is_lamp && !state_.two_sided) throw std::runtime_error("a lamp with one side");
      if (state_.is_lamp) scene.emission[state_.material] = state_.radiance;
      add_mesh(scene.materials[state_.material], mesh, state_.place, false);
      return;
    }
    ReadLight light;
    if (!state_.is_lamp) throw std::runtime_error(type + " without a lamp");
    light.radiance = state_.radiance;
    light.spectrum = state_.spectrum;
    light.centre = transform_point(state_.place, {});
    if (type == "bilinearmesh") {
      const auto& words = given.at("point3 P");
      const Vec3d u = vec3(words, 3) - vec3(words);
      const Vec3d v = vec3(words, 6) - vec3(words);
      light.centre = (vec3(words) + vec3(words, 9)) * 0.5;
      light.area_m2 = length(cross(u, v));
      light.facing = normalised(cross(u, v));
    } else {
      const double r = number(given, "float radius");
      light.area_m2 = (type == "disk" ? 1 : 4) * std::numbers::pi * r * r;
      // pbrt knows the area from the radius alone.
      if (std::abs(determinant3(state_.place) - 1) > 1e-9) throw std::runtime_error(type + " is scaled");
      if (type == "disk") light.facing = transform_direction(state_.place, {0, 0, 1});
    }
    scene.lights.push_back(light);
  }

  std::filesystem::path folder_;
  std::vector<std::string> tokens_;
  std::size_t at_ = 0;
  State state_;
  std::vector<State> states_;
  std::string object_;
  std::map<std::string, std::pair<std::string, scene::Mesh>> objects_;
  double fov_deg_ = 0;
  double first_nm_ = 0;  // of the spectral film's first bucket
  double band_nm_ = 0;   // of each of its buckets; 0 for other films
};

}  // namespace

ReadScene read_pbrt(const std::filesystem::path& file) { return PbrtReader(file).scene; }

}  // namespace orbs::tests
