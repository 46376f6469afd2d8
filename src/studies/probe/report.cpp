#include "studies/probe/report.h"

#include "base/nth.h"
#include "base/two_digits.h"
#include "json/writer.h"
#include "metrics/seeds.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::studies {

namespace {

constexpr std::size_t kMostNamed = 3;

std::string object_name(const ProbeRecord& record, int object) {
  return object == kNoObject ? "the background" : nth(record.object_names, object);
}

std::string mismatch_text(const ProbeRecord& record, const Mismatch& mismatch) {
  return fmt::format("{} ({} pixel{}, first at ({}, {}), which show {})",
                     object_name(record, mismatch.object), mismatch.pixels, mismatch.pixels == 1 ? "" : "s",
                     mismatch.x, mismatch.y, mismatch.instead);
}

std::string differs(const char* what, const ProbeRecord& record, const ProbeFindings& findings) {
  std::vector<std::string> named;
  for (const auto& mismatch : findings.mismatches)
    if (named.size() < kMostNamed) named.push_back(mismatch_text(record, mismatch));
  const auto rest = findings.mismatches.size() - named.size();
  return fmt::format("{}: {}{}", what, fmt::join(named, "; "),
                     rest == 0 ? "" : fmt::format("; and {} more", rest));
}

std::string undecided(const ProbeImage& image) {
  return image.findings.needed_samples
             ? fmt::format("noise hides what is compared: needs about {} times the samples (--spp)",
                           two_digits(*image.findings.needed_samples))
             : "";
}

// The fault that the image shows; "" if it shows none.
std::string fault(const char* what, const ProbeRecord& record, const ProbeImage& image) {
  if (!image.no_image.empty()) return image.no_image;
  return image.findings.mismatches.empty() ? "" : differs(what, record, image.findings);
}

// A texture can be what it cannot read: then its mapping of the scene is known all the same.
std::string uv_fault_of(const ProbeRecord& record) {
  const auto text = fault("texture coordinates differ", record, record.uv_pass);
  if (record.uv_pass.no_image.empty()) return text;
  return fmt::format("scene mapping is right in {} pixels, but with a texture, as EXR or PNG, {}",
                     record.id_pass.findings.compared, text);
}

std::string layers_fault(const ProbeLayers& layers) {
  if (!layers.no_image.empty()) return layers.no_image;
  return layers.findings.fault.empty() ? "" : "layers differ: " + layers.findings.fault;
}

// ", frames of normal maps in 412"; nothing where none were compared.
std::string compared_text(const char* what, const ProbeImage& image) {
  return image.findings.compared == 0 ? "" : fmt::format(", {} in {}", what, image.findings.compared);
}

// ", layers depth and normal in 412"; nothing for a renderer that has none, as most.
std::string layers_text(const ProbeLayers& layers) {
  if (layers.layers.empty()) return "";
  return fmt::format(", layers {} in {}", fmt::join(layers.layers, ", "), layers.findings.compared);
}

void put_layers(json::Writer& out, const ProbeLayers& layers) {
  out.key("layers").begin_object();
  if (!layers.unsupported.empty()) out.member("unsupported", layers.unsupported);
  if (!layers.no_image.empty()) out.member("no_image", layers.no_image);
  out.key("compared").begin_array();
  for (const auto& layer : layers.layers) out.value(layer);
  out.end_array().member("compared_pixels", layers.findings.compared);
  out.member("fault", layers.findings.fault).end_object();
}

void put_image(json::Writer& out, const char* name, const ProbeRecord& record, const ProbeImage& image) {
  out.key(name).begin_object();
  if (!image.unsupported.empty()) out.member("unsupported", image.unsupported);
  if (!image.no_image.empty()) out.member("no_image", image.no_image);
  if (!image.note.empty()) out.member("note", image.note);
  if (image.has_equal_seeds) out.member("equal_seeds", true);
  out.member("compared_pixels", image.findings.compared).member("crack_pixels", image.findings.cracks);
  if (image.findings.needed_samples) out.member("times_the_samples_needed", *image.findings.needed_samples);
  out.key("mismatches").begin_array();
  for (const auto& mismatch : image.findings.mismatches)
    out.begin_object()
        .member("object", object_name(record, mismatch.object))
        .member("pixels", mismatch.pixels)
        .member("x", mismatch.x)
        .member("y", mismatch.y)
        .member("instead", mismatch.instead)
        .end_object();
  out.end_array().end_object();
}

}  // namespace

ProbeVerdict probe_verdict(const ProbeRecord& record) {
  if (!record.id_pass.unsupported.empty()) return ProbeVerdict::NotChecked;
  for (const auto* image : {&record.id_pass, &record.uv_pass, &record.second_uv_pass, &record.frames})
    if (!fault("", record, *image).empty()) return ProbeVerdict::Wrong;
  if (!layers_fault(record.layers).empty()) return ProbeVerdict::Wrong;
  return undecided(record.id_pass).empty() && undecided(record.uv_pass).empty() ? ProbeVerdict::Right
                                                                                : ProbeVerdict::NotChecked;
}

std::string probe_message(const ProbeRecord& record) {
  if (!record.id_pass.unsupported.empty()) return "not checked: " + record.id_pass.unsupported;
  const auto id_fault = fault("scene mapping differs", record, record.id_pass);
  if (!id_fault.empty()) return id_fault;
  const auto uv_fault = uv_fault_of(record);
  if (!uv_fault.empty()) return uv_fault;
  const auto second_fault = fault("second texture coordinates differ", record, record.second_uv_pass);
  if (!second_fault.empty()) return second_fault;
  const auto frames_fault = fault("frames of normal maps differ", record, record.frames);
  if (!frames_fault.empty()) return frames_fault;
  if (const auto fault = layers_fault(record.layers); !fault.empty()) return fault;
  for (const auto* image : {&record.id_pass, &record.uv_pass})
    if (const auto reason = undecided(*image); !reason.empty()) return "not checked: " + reason;
  const int cracks = record.id_pass.findings.cracks;
  const bool ignores_seed = record.id_pass.has_equal_seeds;
  return fmt::format("{}ok, {} pixels{}, {}{}{}{}{}",
                     ignores_seed ? fmt::format("{}; ", metrics::kEqualSeeds) : "",
                     record.id_pass.findings.compared,
                     cracks == 0 ? "" : fmt::format(" ({} of them at cracks between triangles)", cracks),
                     record.uv_pass.unsupported.empty()
                         ? fmt::format("texture coordinates in {}", record.uv_pass.findings.compared)
                         : "texture coordinates not checked: " + record.uv_pass.unsupported,
                     record.uv_pass.note.empty() ? "" : fmt::format(" ({})", record.uv_pass.note),
                     compared_text("second ones", record.second_uv_pass),
                     compared_text("frames of normal maps", record.frames), layers_text(record.layers));
}

std::string probe_json(const std::vector<ProbeRecord>& records) {
  json::Writer out;
  out.begin_array();
  for (const auto& record : records) {
    out.begin_object()
        .member("scene", record.scene)
        .member("renderer", record.renderer)
        .member("checked", probe_verdict(record) != ProbeVerdict::NotChecked)
        .member("ok", probe_verdict(record) == ProbeVerdict::Right)
        .member("reason", probe_message(record));
    put_image(out, "id_pass", record, record.id_pass);
    put_image(out, "uv_pass", record, record.uv_pass);
    put_image(out, "second_uv_pass", record, record.second_uv_pass);
    put_image(out, "frames_pass", record, record.frames);
    put_layers(out, record.layers);
    out.end_object();
  }
  out.end_array();
  return out.text();
}

}  // namespace orbs::studies
