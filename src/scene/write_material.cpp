#include "scene/write_material.h"

#include <array>
#include <span>

namespace orbs::scene {

namespace {

using json::Writer;
using spectra::Spectrum;

void write_samples(Writer& out, const Spectrum& spectrum) {
  out.key("wavelengths").numbers(spectrum.wavelengths_nm).key("values").numbers(spectrum.values);
  if (spectrum.beyond == spectra::Beyond::IsZero) out.member("beyond", "zero");
}

// A number, or its samples in an object.
void write_curve(Writer& out, const Spectrum& spectrum) {
  if (spectrum.wavelengths_nm.empty()) {
    out.value(spectrum.values.front());
    return;
  }
  out.begin_object();
  write_samples(out, spectrum);
  out.end_object();
}

struct IndexWriter {
  Writer& out;

  void operator()(const Spectrum& spectrum) const { write_curve(out, spectrum); }
  void operator()(const spectra::Sellmeier& glass) const {
    out.begin_object().key("sellmeier").begin_object();
    out.key("b").numbers(glass.b).key("c_um2").numbers(glass.c_um2);
    out.end_object().end_object();
  }
  void operator()(const spectra::Cauchy& glass) const {
    const std::array terms{glass.a, glass.b, glass.c, glass.d};
    out.begin_object().key("cauchy").numbers(terms).end_object();
  }
};

void write_index(Writer& out, const char* key, const spectra::RefractiveIndex& index) {
  out.key(key);
  std::visit(IndexWriter{out}, index);
}

void write_kernel(Writer& out, const snippets::TentKernel<double>& k) {
  out.member("peak_per_nm", k.peak_per_nm);
  out.member("absorbed_nm", k.absorbed_nm).member("absorbed_reach_nm", k.absorbed_reach_nm);
  out.member("emitted_nm", k.emitted_nm).member("emitted_reach_nm", k.emitted_reach_nm);
}

void write_kernel(Writer& out, const snippets::ReradiationMatrix<double>& k) {
  out.member("first_nm", k.first_nm).member("width_nm", k.width_nm);
  out.member("bins", static_cast<int>(k.bins)).key("shares").begin_array();
  for (std::size_t row = 0; row < k.bins; ++row)
    out.numbers(std::span(k.share).subspan(row * k.bins, k.bins));
  out.end_array();
}

struct ModelWriter {
  Writer& out;
  const Scene& scene;

  void operator()(const Lambert& m) const {
    out.member("type", "lambert");
    write_colour(out, scene, "reflectance", m.reflectance, m.spectrum);
  }
  void operator()(const OrenNayar& m) const {
    out.member("type", "oren_nayar");
    write_colour(out, scene, "reflectance", m.reflectance, m.spectrum);
    out.member("roughness", m.roughness);
  }
  void operator()(const Mirror& m) const {
    out.member("type", "mirror");
    write_colour(out, scene, "reflectance", m.reflectance, m.spectrum);
  }
  void operator()(const Glass& m) const {
    out.member("type", "glass").member("colour", m.colour).member("ior", m.ior);
  }
  void operator()(const Ggx& m) const {
    out.member("type", "ggx");
    write_colour(out, scene, "colour", m.colour, m.spectrum);
    out.member("alpha", m.alpha);
  }
  void operator()(const RoughGlass& m) const {
    out.member("type", "rough_glass")
        .member("colour", m.colour)
        .member("ior", m.ior)
        .member("alpha", m.alpha);
  }
  void operator()(const Emission& m) const {
    out.member("type", "emission");
    write_colour(out, scene, "radiance", m.radiance, m.spectrum);
  }
  void operator()(const Conductor& m) const {
    out.member("type", "conductor").key("index").begin_object().key("n");
    write_curve(out, m.index.n);
    out.key("k");
    write_curve(out, m.index.k);
    out.end_object();
    interface(m);
  }
  void operator()(const Dielectric& m) const {
    out.member("type", "dielectric");
    write_index(out, "index", m.index);
    interface(m);
  }
  void operator()(const Polariser& m) const { out.member("type", "polariser").member("axis", m.axis); }
  void operator()(const Retarder& m) const {
    out.member("type", "retarder").member("axis", m.axis).member("retardance_deg", m.retardance_deg);
  }
  void operator()(const Fluorescent& m) const {
    out.member("type", "fluorescent");
    write_colour(out, scene, "reflectance", m.reflectance, m.spectrum);
    out.key("reradiation").begin_object();
    std::visit([&](const auto& kernel) { write_kernel(out, kernel); }, m.reradiation);
    out.end_object();
    if (m.gains_energy) out.member("gains_energy", true);
  }

  template <typename Interface>
  void interface(const Interface& m) const {
    write_index(out, "outside", m.outside);
    if (m.roughness) {
      const auto& r = *m.roughness;
      out.member("alpha", r.alpha);
      out.member("distribution", r.distribution == Distribution::Ggx ? "ggx" : "beckmann");
      out.member("masking", r.masking == Masking::Separable ? "separable" : "correlated");
    }
    if (!m.film) return;
    out.key("film").begin_object();
    write_index(out, "index", m.film->index);
    out.member("height_nm", m.film->height_nm).end_object();
  }
};

}  // namespace

void write_model(Writer& out, const Scene& scene, const MaterialModel& model) {
  std::visit(ModelWriter{out, scene}, model);
}

void write_spectra(Writer& out, const Scene& scene) {
  if (scene.spectra.empty()) return;
  out.key("spectra").begin_array();
  for (const auto& [name, spectrum] : scene.spectra) {
    out.begin_object().member("name", name);
    if (spectrum.wavelengths_nm.empty())
      out.member("constant", spectrum.values.front());
    else
      write_samples(out, spectrum);
    out.end_object();
  }
  out.end_array();
}

void write_colour(Writer& out,
                  const Scene& scene,
                  const char* key,
                  RgbColour rgb,
                  const std::optional<SpectrumUse>& spectrum) {
  if (!spectrum) {
    out.member(key, rgb);
    return;
  }
  const auto& name = scene.spectra[static_cast<std::size_t>(spectrum->spectrum)].name;
  out.key(key).begin_object().member("spectrum", name).member("scale", spectrum->scale).end_object();
}

}  // namespace orbs::scene
