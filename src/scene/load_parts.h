#pragma once

#include "json/object_reader.h"
#include "scene/load_scene.h"
#include "scene/scene.h"
#include "spectra/table_file.h"

#include <filesystem>
#include <limits>
#include <map>
#include <string>

/// The pieces of load_scene, one per kind of thing in the file. All throw InputError at the key that is
/// wrong.
namespace orbs::scene {

/// Places and lengths in metres, and the entries of matrices. Renderers compute in floats, and beyond these
/// the product of three lengths is nothing that a float holds (3.4e38, 1.2e-38).
constexpr double kFarthest_m = 1e12;
constexpr json::Range kPlace{-kFarthest_m, kFarthest_m};
constexpr json::Range kLength{1e-12, kFarthest_m};
/// What a channel of an image holds.
constexpr json::Range kRadiance{0, std::numeric_limits<float>::max()};

/// Names given to one kind of thing, in file order: name -> index, with complaints about doubles and dangling
/// names.
class Names {
 public:
  explicit Names(std::string kind) : kind_(std::move(kind)) {}
  void add(json::ObjectReader& in, const std::string& key);
  /// Index of the name that the text under `key` holds.
  int find(json::ObjectReader& in, const std::string& key) const;
  /// Index of `name`, which stands at element `index` of the array under `key`.
  int find_at(const json::ObjectReader& in,
              const std::string& key,
              std::size_t index,
              const std::string& name) const;
  /// Index of `name`, -1 when there is none; `hint` for the complaint.
  int lookup(const std::string& name) const;
  std::string unknown(const std::string& name) const;

 private:
  std::string kind_;
  std::map<std::string, int> index_;
};

/// The file under `key`, resolved against `folder`; it must exist and be a regular file.
std::filesystem::path existing_file(json::ObjectReader& in,
                                    const std::string& key,
                                    const std::filesystem::path& folder);

/// "matrix": 16 numbers row-major, or steps {"translate"|"rotate_x"|"rotate_y"|"rotate_z"|"scale": ...}
/// multiplied in written order. Identity when absent. Must be affine and invertible.
Mat4 load_matrix(json::ObjectReader& in, const std::string& key);

/// The complaint about a matrix that cannot move things there and back; "" when it can.
std::string matrix_problem(const Mat4& matrix);

/// What the scene file says wavelength by wavelength.
struct SpectralData {
  std::filesystem::path folder;  // what files are relative to
  Names names = Names("spectrum");
  std::vector<NamedSpectrum> spectra = {};
  std::vector<std::filesystem::path> files = {};  // that have been read
  std::vector<std::string> warnings = {};
};

/// Adds one entry of "spectra": a constant, an illuminant by name, a column of a file, or samples.
void load_spectrum(json::ObjectReader in, SpectralData& data);
/// "wavelengths" and "values", with "beyond": "hold" or "zero".
spectra::Spectrum load_samples(json::ObjectReader& in);
/// The spectrum of the scene that "spectrum" names.
const spectra::Spectrum& find_spectrum(json::ObjectReader& in, const SpectralData& data);
/// The table that "file" names.
spectra::TableFile load_table(json::ObjectReader& in, SpectralData& data);

/// What stands in the place of a colour: [r, g, b] or {"spectrum": name, "scale": number}.
struct Colour {
  RgbColour rgb;
  std::optional<SpectrumUse> spectrum;
};
/// Shares of light, in [0, 1] at every wavelength.
Colour load_reflectance(json::ObjectReader& in, const std::string& key, const SpectralData& data);
/// Radiance, not negative. A spectrum must be constant or zero beyond its samples.
Colour load_radiance(json::ObjectReader& in, const std::string& key, const SpectralData& data);

/// A number, or an object with "spectrum", "wavelengths", "sellmeier", "cauchy" or "file". Above 0
/// everywhere.
spectra::RefractiveIndex load_index(json::ObjectReader& in, const std::string& key, SpectralData& data);

MaterialModel load_conductor(json::ObjectReader& in, SpectralData& data);
MaterialModel load_dielectric(json::ObjectReader& in, SpectralData& data);
MaterialModel load_fluorescent(json::ObjectReader& in, SpectralData& data);
MaterialModel load_polariser(json::ObjectReader& in);
MaterialModel load_retarder(json::ObjectReader& in);

Material load_material(json::ObjectReader in, const Names& textures, SpectralData& data);
/// Takes `wanted` things off what is `left`; the complaint at `key` when there are not so many.
void take(const json::ObjectReader& in,
          const std::string& key,
          const char* things,
          std::size_t wanted,
          std::size_t& left);
Mesh load_mesh(json::ObjectReader in,
               const std::filesystem::path& folder,
               const Names& materials,
               SceneBudget& left);
/// The mesh of the entry's "generator", without name and materials.
Mesh load_generated(json::ObjectReader& in, SceneBudget& left);
/// Appends one instance to the scene, or many when the entry has "scatter".
void load_instances(json::ObjectReader in,
                    const Names& meshes,
                    const Names& materials,
                    SceneBudget& left,
                    std::vector<Instance>& out);
/// Why the scene shows a material in a way that its model has no meaning for; "" when it does not: a sheet's
/// axis must not stand perpendicular to a triangle of it, and nothing solid is a sheet.
std::string sheet_problem(const Scene& scene, int material);

Sphere load_shape(json::ObjectReader in, const Names& materials);
Light load_light(json::ObjectReader in, const std::filesystem::path& folder, const SpectralData& data);

}  // namespace orbs::scene
