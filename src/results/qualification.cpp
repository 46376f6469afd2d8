#include "results/qualification.h"

#include "json/document.h"
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
  write_texts(out, "control", gate.control);
  out.member("accepts_control", gate.accepts_control).member("control_reason", gate.control_reason);
  out.key("mutants").begin_array();
  for (const auto& mutant : gate.mutants) {
    out.begin_object().member("fault", mutant.fault);
    if (mutant.no_fault.empty()) {
      out.member("rejected", mutant.rejected).member("reason", mutant.reason);
    } else {
      out.member("no_fault", mutant.no_fault);
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
  gate.control = read_texts(in.object("control"));
  gate.accepts_control = in.boolean_or("accepts_control", false);
  gate.control_reason = in.text("control_reason");
  for (auto& mutant : in.objects("mutants"))
    gate.mutants.push_back({mutant.text("fault"), mutant.text_or("no_fault", ""),
                            mutant.boolean_or("rejected", false), mutant.text_or("reason", "")});
  gate.global = read_smallest(in.object("smallest_global"));
  gate.local = read_smallest(in.object("smallest_local"));
  constexpr json::Range kPixel{0, 1e9};
  for (const double pixel : in.numbers("local_where", 0, kPixel))
    gate.local_where.push_back(static_cast<int>(pixel));
  gate.provenance = read_texts(in.object("provenance"));
  return gate;
}

}  // namespace

bool is_qualified(const GateRecord& gate) {
  return gate.accepts_control &&
         std::all_of(gate.mutants.begin(), gate.mutants.end(),
                     [](const auto& mutant) { return mutant.rejected || !mutant.no_fault.empty(); });
}

std::vector<GateRecord> read_qualification(const std::filesystem::path& file) {
  std::vector<GateRecord> gates;
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return gates;
  const auto document = json::parse_file(file);
  ObjectReader in(document);
  in.one_of("format", {"orbs-qualification/2"});
  for (auto& gate : in.objects("gates")) gates.push_back(read_gate(gate));
  return gates;
}

std::string qualification_file(const std::string& size) {
  if (size == "1") return "qualification.json";
  auto name = "qualification-" + size + ".json";
  std::replace(name.begin(), name.end(), '/', '-');
  return name;
}

std::string qualification_json(const std::vector<GateRecord>& gates) {
  Writer out;
  out.begin_object().member("format", "orbs-qualification/2").key("gates").begin_array();
  for (const auto& gate : gates) write_gate(out, gate);
  out.end_array().end_object();
  return out.text();
}

}  // namespace orbs::results
