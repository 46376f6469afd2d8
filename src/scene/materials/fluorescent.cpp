#include "scene/materials/fluorescent.h"

#include "scene/load/spectra.h"
#include "scene/materials/reflectance.h"
#include "spectra/rgb.h"

#include <span>

#include <fmt/format.h>

namespace orbs::scene {

namespace {

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
  const spectra::Spectrum reflectance =
      model.spectrum ? scaled(spectrum_at(data.spectra, *model.spectrum).spectrum, model.spectrum->scale)
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

void write_kernel(json::Writer& out, const snippets::TentKernel<double>& k) {
  out.member("peak_per_nm", k.peak_per_nm);
  out.member("absorbed_nm", k.absorbed_nm).member("absorbed_reach_nm", k.absorbed_reach_nm);
  out.member("emitted_nm", k.emitted_nm).member("emitted_reach_nm", k.emitted_reach_nm);
}

void write_kernel(json::Writer& out, const snippets::ReradiationMatrix<double>& k) {
  out.member("first_nm", k.first_nm).member("width_nm", k.width_nm);
  out.member("bins", static_cast<int>(k.bins)).key("shares").begin_array();
  for (std::size_t row = 0; row < k.bins; ++row)
    out.numbers(std::span(k.share).subspan(row * k.bins, k.bins));
  out.end_array();
}

}  // namespace

void load(const MaterialEntry& entry, Fluorescent& loaded) {
  const auto colour = load_reflectance(entry.in, "reflectance", entry.spectra);
  loaded.reflectance = colour.rgb;
  loaded.spectrum = colour.spectrum;
  auto kernel = entry.in.object("reradiation");
  loaded.gains_energy = entry.in.boolean_or("gains_energy", false);
  if (kernel.has("shares"))
    loaded.reradiation = load_reradiation_matrix(kernel);
  else
    loaded.reradiation = load_tents(kernel);
  kernel.finish();
  check_energy(entry.in, loaded, entry.spectra);
}

void write(json::Writer& out, const SpectrumList& spectra, const Fluorescent& m) {
  write_colour(out, spectra, "reflectance", m.reflectance, m.spectrum);
  out.key("reradiation").begin_object();
  std::visit([&](const auto& kernel) { write_kernel(out, kernel); }, m.reradiation);
  out.end_object();
  if (m.gains_energy) out.member("gains_energy", true);
}

MaterialRequirement requirement(const Fluorescent&) { return {"E4", "fluorescent"}; }

std::vector<EffectVerdict> effects(const SpectrumList& spectra, const Fluorescent& m) {
  auto found = effects_of_reflectance(spectra, m.spectrum);
  EffectVerdict verdict{Effect::Fluorescence, false, "has a kernel that is zero: it re-radiates nothing"};
  if (const auto support = support_of(m.reradiation)) {
    verdict.is_called_for = true;
    verdict.reason = fmt::format("turns light of {:g} to {:g} nm into light of {:g} to {:g} nm{}",
                                 support->in.first_nm, support->in.last_nm, support->out.first_nm,
                                 support->out.last_nm, m.gains_energy ? " and gains energy" : "");
  }
  found.push_back(std::move(verdict));
  return found;
}

bool is_coloured(const SpectrumList& spectra, const Fluorescent& m) {
  return support_of(m.reradiation) || is_coloured(spectra, m.reflectance, m.spectrum);
}

}  // namespace orbs::scene
