#include "results/qualification.h"

#include "json/object_reader.h"
#include "json/writer.h"

#include <algorithm>

namespace orbs::results {

namespace {

using json::ObjectReader;
using json::Writer;

void write_texts(Writer& out, const char* key, const std::map<std::string, std::string>& texts) {
  out.key(key).begin_object();
  for (const auto& [name, text] : texts) out.member(name, text);
  out.end_object();
}

void write_smallest(Writer& out, const char* key, const SmallestFault& smallest) {
  const auto put = [&](const char* name, const std::optional<double>& value) {
    out.key(name);
    value ? out.value(*value) : out.null();
  };
  out.key(key).begin_object();
  put("seen", smallest.seen);
  put("rejected", smallest.rejected);
  out.end_object();
}

void write_gate(Writer& out, const GateRecord& gate) {
  out.begin_object().member("case", gate.case_name).member("target", gate.target);
  out.member("qualified", is_qualified(gate)).member("judged_by", gate.judged_by);
  write_texts(out, "honest", gate.honest);
  out.member("accepts_honest", gate.accepts_honest).member("honest_reason", gate.honest_reason);
  out.key("twins").begin_array();
  for (const auto& twin : gate.twins) {
    out.begin_object().member("fault", twin.fault);
    if (twin.no_fault.empty()) {
      out.member("rejected", twin.rejected).member("reason", twin.reason);
    } else {
      out.member("no_fault", twin.no_fault);
    }
    out.end_object();
  }
  out.end_array();
  write_smallest(out, "smallest_global", gate.global);
  write_smallest(out, "smallest_local", gate.local);
  const std::vector<double> where(gate.local_where.begin(), gate.local_where.end());
  out.key("local_where").numbers(where);
  write_texts(out, "provenance", gate.provenance);
  out.end_object();
}

std::map<std::string, std::string> read_texts(ObjectReader object) {
  std::map<std::string, std::string> texts;
  for (const auto& name : object.keys()) texts[name] = object.text(name);
  return texts;
}

SmallestFault read_smallest(ObjectReader object) {
  const auto get = [&](const std::string& key) {
    return object.holds_number(key) ? std::optional(object.number(key)) : std::nullopt;
  };
  return {get("seen"), get("rejected")};
}

GateRecord read_gate(ObjectReader& in) {
  GateRecord gate;
  gate.case_name = in.text("case");
  gate.target = in.text("target");
  gate.judged_by = in.text("judged_by");
  gate.honest = read_texts(in.object("honest"));
  gate.accepts_honest = in.boolean_or("accepts_honest", false);
  gate.honest_reason = in.text("honest_reason");
  for (auto& twin : in.objects("twins"))
    gate.twins.push_back({twin.text("fault"), twin.text_or("no_fault", ""),
                          twin.boolean_or("rejected", false), twin.text_or("reason", "")});
  gate.global = read_smallest(in.object("smallest_global"));
  gate.local = read_smallest(in.object("smallest_local"));
  for (const double pixel : in.numbers("local_where")) gate.local_where.push_back(static_cast<int>(pixel));
  gate.provenance = read_texts(in.object("provenance"));
  return gate;
}

}  // namespace

bool is_qualified(const GateRecord& gate) {
  return gate.accepts_honest && std::all_of(gate.twins.begin(), gate.twins.end(), [](const auto& twin) {
           return twin.rejected || !twin.no_fault.empty();
         });
}

std::vector<GateRecord> read_qualification(const std::filesystem::path& file) {
  std::vector<GateRecord> gates;
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return gates;
  const auto document = json::parse_file(file);
  ObjectReader in(document);
  in.one_of("format", {"orbs-qualification/1"});
  for (auto& gate : in.objects("gates")) gates.push_back(read_gate(gate));
  return gates;
}

std::string qualification_json(const std::vector<GateRecord>& gates) {
  Writer out;
  out.begin_object().member("format", "orbs-qualification/1").key("gates").begin_array();
  for (const auto& gate : gates) write_gate(out, gate);
  out.end_array().end_object();
  return out.text();
}

}  // namespace orbs::results
