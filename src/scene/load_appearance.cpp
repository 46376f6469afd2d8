#include "scene/load_parts.h"
#include "spectra/rgb.h"

#include <algorithm>

#include <fmt/format.h>

/// The materials that go beyond ORB.S.
namespace orbs::scene {

namespace {

using spectra::Spectrum;

std::optional<Roughness> load_roughness(json::ObjectReader& in) {
  if (!in.has("alpha")) return std::nullopt;
  Roughness roughness;
  roughness.alpha = in.number("alpha", {1e-4, 1.0});  // as for the other microfacet models
  if (in.one_of_or("distribution", "ggx", {"ggx", "beckmann"}) == "beckmann")
    roughness.distribution = Distribution::Beckmann;
  if (in.one_of_or("masking", "separable", {"separable", "correlated"}) == "correlated")
    roughness.masking = Masking::Correlated;
  return roughness;
}

std::optional<Film> load_film(json::ObjectReader& in, SpectralData& data) {
  if (!in.has("film")) return std::nullopt;
  auto entry = in.object("film");
  Film film{load_index(entry, "index", data), entry.number("height_nm", {0.0, 1e6})};
  entry.finish();
  return film;
}

spectra::RefractiveIndex load_outside(json::ObjectReader& in, SpectralData& data) {
  return in.has("outside") ? load_index(in, "outside", data) : spectra::constant(1);
}

// One of n and k: a number, or a spectrum of the scene, or samples.
Spectrum load_part(json::ObjectReader& in, const std::string& key, double least, const SpectralData& data) {
  if (in.holds_number(key)) return spectra::constant(in.number(key, {least, 100.0}));
  auto entry = in.object(key);
  Spectrum part = entry.has("spectrum") ? find_spectrum(entry, data) : load_samples(entry);
  entry.finish();
  const double smallest = *std::min_element(part.values.begin(), part.values.end());
  if (!(smallest >= least)) in.fail(key, fmt::format("must be at least {}, falls to {}", least, smallest));
  return part;
}

spectra::MetalIndex load_metal(json::ObjectReader in, SpectralData& data) {
  // Without any real part Fresnel's formulas still hold; what measures below this is a misprint.
  constexpr double kLeastN = 1e-3;
  spectra::MetalIndex metal;
  if (in.has("file")) {
    const auto table = load_table(in, data);
    metal = with_note("reading the metal that " + in.place("file") + " names",
                      [&] { return spectra::metal_of(table); });
  } else {
    metal = {load_part(in, "n", kLeastN, data), load_part(in, "k", 0, data)};
  }
  in.finish();
  return metal;
}

Vec3d load_axis(json::ObjectReader& in) {
  const Vec3d axis = in.vec3("axis");
  if (length(axis) == 0) in.fail("axis", "must have a length: it is a direction in the world");
  return axis;
}

// Light of other wavelengths is neither ultraviolet nor visible nor near infrared, and no kernel is as wide.
constexpr json::Range kLight_nm{100.0, 2000.0};
constexpr json::Range kWidth_nm{1e-3, 2000.0};

snippets::TentKernel<double> load_tents(json::ObjectReader& in) {
  return {.peak_per_nm = in.number("peak_per_nm", json::kNotNegative),
          .absorbed_nm = in.number("absorbed_nm", kLight_nm),
          .absorbed_reach_nm = in.number("absorbed_reach_nm", kWidth_nm),
          .emitted_nm = in.number("emitted_nm", kLight_nm),
          .emitted_reach_nm = in.number("emitted_reach_nm", kWidth_nm)};
}

// Rows are emitted bins, columns absorbed ones.
snippets::ReradiationMatrix<double> load_reradiation_matrix(json::ObjectReader& in) {
  constexpr std::size_t kMostBins = 1000;
  snippets::ReradiationMatrix<double> matrix;
  matrix.first_nm = in.number("first_nm", json::kPositive);
  matrix.width_nm = in.number("width_nm", kWidth_nm);
  matrix.bins = static_cast<std::size_t>(in.integer("bins", 2, kMostBins));
  const auto rows = in.number_rows("shares", matrix.bins, {0.0, 1.0});
  if (rows.size() != matrix.bins)
    in.fail("shares",
            fmt::format("must hold {0} rows of {0} numbers, holds {1} rows", matrix.bins, rows.size()));
  for (std::size_t out = 0; out < matrix.bins; ++out)
    for (std::size_t absorbed = 0; absorbed < matrix.bins; ++absorbed) {
      if (absorbed >= out && rows[out][absorbed] > 0)
        in.fail_at(
            "shares", out,
            fmt::format("column {} is {}: light goes to bins of longer wavelengths only, what keeps its "
                        "wavelength is the reflectance",
                        absorbed, rows[out][absorbed]));
      matrix.share.push_back(rows[out][absorbed]);
    }
  return matrix;
}

using Gain = snippets::LargestGain<double>;

template <typename Reflectance>
Gain largest_gain(const snippets::ReradiationMatrix<double>& matrix, const Reflectance& reflectance) {
  Gain largest;
  for (std::size_t in = 0; in < matrix.bins; ++in) {
    const double share = emitted_share(matrix, in);
    // Measured reflectances bend at whole nanometres at most.
    for (double at = 0; share > 0 && at <= matrix.width_nm; at += 1)
      if (const double nm = matrix.first_nm + static_cast<double>(in) * matrix.width_nm + at;
          share + reflectance(nm) > largest.gain)
        largest = {share + reflectance(nm), nm};
  }
  return largest;
}

void check_energy(json::ObjectReader& in, const Fluorescent& model, SpectralData& data) {
  constexpr double kRounding = 1e-9;
  const Spectrum reflectance =
      model.spectrum ? scaled(data.spectra[static_cast<std::size_t>(model.spectrum->spectrum)].spectrum,
                              model.spectrum->scale)
                     : spectra::reflectance_of_rgb(model.reflectance);
  const Gain largest = std::visit(
      [&](const auto& kernel) {
        return largest_gain(kernel, [&](double nm) { return value_at(reflectance, nm); });
      },
      model.reradiation);
  if (!support_of(model.reradiation) || largest.gain <= 1 + kRounding) return;
  const auto problem = fmt::format("of the light at {} nm {:.4f} leaves again, reflected or re-radiated",
                                   largest.absorbed_nm, largest.gain);
  if (!model.gains_energy)
    in.fail("reradiation", problem + "; lower it, or write \"gains_energy\": true if that is meant");
  data.warnings.push_back(fmt::format("{}: {}", in.place("reradiation"), problem));
}

}  // namespace

MaterialModel load_conductor(json::ObjectReader& in, SpectralData& data) {
  return Conductor{load_metal(in.object("index"), data), load_outside(in, data), load_roughness(in),
                   load_film(in, data)};
}

MaterialModel load_dielectric(json::ObjectReader& in, SpectralData& data) {
  return Dielectric{load_index(in, "index", data), load_outside(in, data), load_roughness(in),
                    load_film(in, data)};
}

MaterialModel load_polariser(json::ObjectReader& in) { return Polariser{load_axis(in)}; }

MaterialModel load_retarder(json::ObjectReader& in) {
  return Retarder{load_axis(in), in.number("retardance_deg", {-3600.0, 3600.0})};
}

MaterialModel load_fluorescent(json::ObjectReader& in, SpectralData& data) {
  const auto colour = load_reflectance(in, "reflectance", data);
  auto entry = in.object("reradiation");
  Fluorescent model{colour.rgb, colour.spectrum, {}, in.boolean_or("gains_energy", false)};
  if (entry.has("shares"))
    model.reradiation = load_reradiation_matrix(entry);
  else
    model.reradiation = load_tents(entry);
  entry.finish();
  check_energy(in, model, data);
  return model;
}

}  // namespace orbs::scene
