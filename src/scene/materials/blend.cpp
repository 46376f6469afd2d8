#include "scene/materials/blend.h"

#include "json/object_reader.h"
#include "json/writer.h"
#include "scene/load/entry.h"
#include "scene/materials/reflectance.h"

namespace orbs::scene {

namespace {

Blend::Part load_part(const MaterialEntry& entry, const char* key) {
  const int index = entry.names.find(entry.in, key);
  return {entry.in.text(key), index};
}

}  // namespace

void load(const MaterialEntry& entry, Blend& loaded) {
  loaded.parts = {load_part(entry, "first"), load_part(entry, "second")};
  loaded.weight = entry.in.number("weight", {0, 1});
  loaded.texture = load_texture_use(entry);
}

void write(json::Writer& out, const SpectrumList&, const Blend& m) {
  out.member("first", m.parts[0].name).member("second", m.parts[1].name).member("weight", m.weight);
}

}  // namespace orbs::scene
