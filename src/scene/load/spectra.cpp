#include "scene/load/spectra.h"

#include "base/nth.h"
#include "spectra/observer.h"
#include "spectra/rgb.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace orbs::scene {

namespace {

using spectra::Beyond;
using spectra::Spectrum;

constexpr const char* kColour = R"(three numbers or {"spectrum": name})";

Beyond load_beyond(json::ObjectReader& in) {
  return in.one_of_or("beyond", "hold", {"hold", "zero"}) == "zero" ? Beyond::IsZero : Beyond::HoldsEnds;
}

Spectrum load_column(json::ObjectReader& in, SpectralData& data) {
  const auto table = load_table(in, data);
  const auto column = in.text("column");
  const Beyond beyond = load_beyond(in);
  return with_note("reading the column that " + in.place("column") + " names",
                   [&] { return spectra::spectrum_of(table, column, beyond); });
}

Spectrum load_values(json::ObjectReader& in, SpectralData& data) {
  if (in.has("constant")) return spectra::constant(in.number("constant", json::kNotNegative));
  if (in.has("illuminant")) return spectra::illuminant(in.one_of("illuminant", {"A", "D50", "D65", "E"}));
  if (in.has("file")) return load_column(in, data);
  if (in.has("wavelengths")) return load_samples(in);
  in.fail("", "needs \"constant\", \"illuminant\", \"file\" or \"wavelengths\" and \"values\"");
}

const Spectrum& used(const SpectralData& data, const SpectrumUse& use) {
  return spectrum_at(data.spectra, use).spectrum;
}

SpectrumUse load_use(json::ObjectReader& in, const SpectralData& data) {
  const SpectrumUse use{data.names.find(in, "spectrum"), in.number_or("scale", 1, json::kNotNegative)};
  in.finish();
  const auto& values = used(data, use).values;
  const auto smallest = *std::min_element(values.begin(), values.end());
  if (smallest < 0) in.fail("spectrum", fmt::format("holds {}: neither light nor a share of it", smallest));
  return use;
}

// A plain index outside of this range is taken for a typing error.
constexpr json::Range kPlainIndex{0.1, 10.0};

void check_plain_index(json::ObjectReader& in, const std::string& key, double index) {
  if (!(index >= kPlainIndex.min && index <= kPlainIndex.max))
    in.fail(key, fmt::format("must lie in [{}, {}], is {}", kPlainIndex.min, kPlainIndex.max, index));
}

// Checks the real part of an index that is given by a formula or by samples.
spectra::RefractiveIndex checked_index(json::ObjectReader& in,
                                       const std::string& key,
                                       spectra::RefractiveIndex index) {
  if (const auto* table = std::get_if<spectra::Spectrum>(&index); table && is_constant(*table))
    check_plain_index(in, key, table->values.front());
  const double smallest = spectra::smallest_index(index);
  if (smallest > 0) return index;
  in.fail(key,
          std::isnan(smallest)
              ? std::string("the formula has no real value somewhere from 300 to 830 nm")
              : fmt::format("must be above 0 from 300 to 830 nm, falls to {}; vacuum is 1, glass about 1.5",
                            smallest));
}

std::array<double, 4> four(std::vector<double> numbers) {
  numbers.resize(4, 0);
  return {numbers[0], numbers[1], numbers[2], numbers[3]};
}

spectra::RefractiveIndex load_sellmeier(json::ObjectReader in) {
  const auto b = in.numbers("b");
  const auto c_um2 = in.numbers("c_um2");
  in.finish();
  if (b.empty() || b.size() > 4 || b.size() != c_um2.size())
    in.fail("c_um2", fmt::format("\"b\" and \"c_um2\" must hold 1 to 4 numbers each, hold {} and {}",
                                 b.size(), c_um2.size()));
  return spectra::Sellmeier{four(b), four(c_um2)};
}

spectra::RefractiveIndex load_cauchy(json::ObjectReader& in) {
  const auto terms = in.numbers("cauchy");
  if (terms.empty() || terms.size() > 4)
    in.fail("cauchy", fmt::format("must hold 1 to 4 numbers (a, b, c, d), holds {}", terms.size()));
  const auto [a, b, c, d] = four(terms);
  return spectra::Cauchy{a, b, c, d};
}

spectra::RefractiveIndex load_glass(json::ObjectReader& in, SpectralData& data) {
  const auto table = load_table(in, data);
  const auto material = in.text("material");
  return with_note("reading the glass that " + in.place("material") + " names",
                   [&] { return spectra::glass_of(table, material); });
}

spectra::RefractiveIndex load_index_object(json::ObjectReader in, SpectralData& data) {
  spectra::RefractiveIndex index;
  if (in.has("spectrum"))
    index = find_spectrum(in, data);
  else if (in.has("wavelengths"))
    index = load_samples(in);
  else if (in.has("sellmeier"))
    index = load_sellmeier(in.object("sellmeier"));
  else if (in.has("cauchy"))
    index = load_cauchy(in);
  else if (in.has("file"))
    index = load_glass(in, data);
  else
    in.fail("",
            "needs \"spectrum\", \"wavelengths\" and \"values\", \"sellmeier\", \"cauchy\", or \"file\" "
            "and \"material\"");
  in.finish();
  return index;
}

}  // namespace

spectra::Spectrum load_samples(json::ObjectReader& in) {
  const auto wavelengths_nm = in.numbers("wavelengths", 0, json::kPositive);
  const auto values = in.numbers("values");
  const Beyond beyond = load_beyond(in);
  return with_note("reading the samples at " + in.place("values"),
                   [&] { return spectra::tabulated(wavelengths_nm, values, beyond); });
}

const spectra::Spectrum& find_spectrum(json::ObjectReader& in, const SpectralData& data) {
  return nth(data.spectra, data.names.find(in, "spectrum")).spectrum;
}

spectra::TableFile load_table(json::ObjectReader& in, SpectralData& data) {
  const auto file = existing_file(in, "file", data.folders);
  if (std::find(data.files.begin(), data.files.end(), file) == data.files.end()) data.files.push_back(file);
  return with_note("reading the table that " + in.place("file") + " names",
                   [&] { return spectra::read_table_file(file); });
}

void load_spectrum(json::ObjectReader in, SpectralData& data) {
  data.names.add(in, "name");
  data.spectra.push_back({in.text("name"), load_values(in, data)});
  in.finish();
}

Colour load_reflectance(json::ObjectReader& in, const std::string& key, const SpectralData& data) {
  // Above 1 a surface would reflect more than it receives, and the light between two such surfaces has no
  // finite sum.
  if (in.holds_array(key)) return {in.vec3(key, {0.0, 1.0}), std::nullopt};
  auto entry = in.object(key, kColour);
  const auto use = load_use(entry, data);
  const auto& spectrum = used(data, use);
  const double largest = use.scale * *std::max_element(spectrum.values.begin(), spectrum.values.end());
  if (largest > 1)
    entry.fail("spectrum",
               fmt::format("times the scale reaches {}: a surface reflects a share in [0, 1]", largest));
  const auto xyz = spectra::xyz_of_reflectance(spectrum, spectra::illuminant("D65"));
  return {spectra::rgb_of_xyz(xyz) * use.scale, use};
}

Colour load_radiance(json::ObjectReader& in, const std::string& key, const SpectralData& data) {
  if (in.holds_array(key)) return {in.vec3(key, kRadiance), std::nullopt};
  auto entry = in.object(key, kColour);
  const auto use = load_use(entry, data);
  const auto& spectrum = used(data, use);
  if (spectrum.beyond != Beyond::IsZero && !spectrum.wavelengths_nm.empty())
    entry.fail("spectrum",
               "holds its ends beyond its samples, as reflectances do; a light needs \"beyond\": \"zero\"");
  const RgbColour rgb = spectra::rgb_of_xyz(spectra::xyz_of_light(spectrum)) * use.scale;
  if (!(std::max({std::fabs(rgb.x), std::fabs(rgb.y), std::fabs(rgb.z)}) <= kRadiance.max))
    in.fail(key, fmt::format("reaches ({}, {}, {}); an image holds at most {}", rgb.x, rgb.y, rgb.z,
                             kRadiance.max));
  return {rgb, use};
}

spectra::RefractiveIndex load_index(json::ObjectReader& in, const std::string& key, SpectralData& data) {
  if (in.holds_number(key)) return spectra::constant(in.number(key, kPlainIndex));
  return checked_index(in, key, load_index_object(in.object(key), data));
}

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
