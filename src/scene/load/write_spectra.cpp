#include "scene/load/write_spectra.h"

#include <array>

namespace orbs::scene {

namespace {

using json::Writer;
using spectra::Spectrum;

void write_samples(Writer& out, const Spectrum& spectrum) {
  out.key("wavelengths").numbers(spectrum.wavelengths_nm).key("values").numbers(spectrum.values);
  if (spectrum.beyond == spectra::Beyond::IsZero) out.member("beyond", "zero");
}

struct IndexWriter {
  Writer& out;
  const char* key;

  void operator()(const Spectrum& spectrum) const { write_curve(out, key, spectrum); }
  void operator()(const spectra::Sellmeier& glass) const {
    out.key(key).begin_object().key("sellmeier").begin_object();
    out.key("b").numbers(glass.b).key("c_um2").numbers(glass.c_um2);
    out.end_object().end_object();
  }
  void operator()(const spectra::Cauchy& glass) const {
    const std::array terms{glass.a, glass.b, glass.c, glass.d};
    out.key(key).begin_object().key("cauchy").numbers(terms).end_object();
  }
};

}  // namespace

void write_spectra(Writer& out, const SpectrumList& spectra) {
  if (spectra.empty()) return;
  out.key("spectra").begin_array();
  for (const auto& [name, spectrum] : spectra) {
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
                  const SpectrumList& spectra,
                  const char* key,
                  RgbColour rgb,
                  const std::optional<SpectrumUse>& spectrum) {
  if (!spectrum) {
    out.member(key, rgb);
    return;
  }
  const auto& name = spectrum_at(spectra, *spectrum).name;
  out.key(key).begin_object().member("spectrum", name).member("scale", spectrum->scale).end_object();
}

void write_curve(Writer& out, const char* key, const Spectrum& spectrum) {
  if (spectrum.wavelengths_nm.empty()) {
    out.member(key, spectrum.values.front());
    return;
  }
  out.key(key).begin_object();
  write_samples(out, spectrum);
  out.end_object();
}

void write_index(Writer& out, const char* key, const spectra::RefractiveIndex& index) {
  std::visit(IndexWriter{out, key}, index);
}

}  // namespace orbs::scene
