#include "json/writer.h"
#include "studies/probe.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::studies {

namespace {

constexpr std::size_t kMostNamed = 3;

std::string thing_name(const ProbeRecord& record, int thing) {
  return thing == kNoThing ? "the background" : record.thing_names[static_cast<std::size_t>(thing)];
}

std::string mismatch_text(const ProbeRecord& record, const Mismatch& mismatch) {
  return fmt::format("{} ({} pixel{}, first at ({}, {}), which show {})", thing_name(record, mismatch.thing),
                     mismatch.pixels, mismatch.pixels == 1 ? "" : "s", mismatch.x, mismatch.y,
                     mismatch.instead);
}

std::string differs(const char* what, const ProbeRecord& record, const ProbeFindings& findings) {
  std::vector<std::string> named;
  for (const auto& mismatch : findings.mismatches)
    if (named.size() < kMostNamed) named.push_back(mismatch_text(record, mismatch));
  const auto rest = findings.mismatches.size() - named.size();
  return fmt::format("{}: {}{}", what, fmt::join(named, "; "),
                     rest == 0 ? "" : fmt::format("; and {} more", rest));
}

// Empty when the image says nothing against the renderer.
std::string fault(const char* what, const ProbeRecord& record, const ProbeImage& image) {
  if (!image.no_image.empty()) return image.no_image;
  return image.findings.mismatches.empty() ? "" : differs(what, record, image.findings);
}

void put_image(json::Writer& out, const char* name, const ProbeRecord& record, const ProbeImage& image) {
  out.key(name).begin_object();
  if (!image.unsupported.empty()) out.member("unsupported", image.unsupported);
  if (!image.no_image.empty()) out.member("no_image", image.no_image);
  out.member("compared_pixels", image.findings.compared).key("mismatches").begin_array();
  for (const auto& mismatch : image.findings.mismatches)
    out.begin_object()
        .member("thing", thing_name(record, mismatch.thing))
        .member("pixels", mismatch.pixels)
        .member("x", mismatch.x)
        .member("y", mismatch.y)
        .member("instead", mismatch.instead)
        .end_object();
  out.end_array().end_object();
}

}  // namespace

bool is_mapped_right(const ProbeRecord& record) {
  return fault("", record, record.things).empty() && fault("", record, record.coordinates).empty();
}

std::string probe_message(const ProbeRecord& record) {
  if (!record.things.unsupported.empty()) return "unsupported: " + record.things.unsupported;
  const auto things = fault("scene mapping differs", record, record.things);
  if (!things.empty()) return things;
  const auto coordinates = fault("texture coordinates differ", record, record.coordinates);
  if (!coordinates.empty()) return coordinates;
  return fmt::format("ok, {} pixels, {}", record.things.findings.compared,
                     record.coordinates.unsupported.empty()
                         ? fmt::format("texture coordinates in {}", record.coordinates.findings.compared)
                         : "texture coordinates unsupported: " + record.coordinates.unsupported);
}

std::string probe_json(const std::vector<ProbeRecord>& records) {
  json::Writer out;
  out.begin_array();
  for (const auto& record : records) {
    out.begin_object()
        .member("scene", record.scene)
        .member("renderer", record.renderer)
        .member("ok", is_mapped_right(record))
        .member("reason", probe_message(record));
    put_image(out, "things", record, record.things);
    put_image(out, "coordinates", record, record.coordinates);
    out.end_object();
  }
  out.end_array();
  return out.text();
}

}  // namespace orbs::studies
