// The JSON schema of configuration.json and the tables of docs/use/renderers.md say what the fields() of the
// settings say. With ORBS_WRITE_DOCUMENTATION in the environment both are written.
#include "base/files.h"
#include "base/text.h"
#include "registry/configuration.h"
#include "structure/documentation.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace fs = std::filesystem;

namespace {

using namespace orbs;
using Json = nlohmann::ordered_json;

const fs::path kRoot = ORBS_SOURCE_DIR;
const fs::path kSchema = kRoot / "data/schema/orbs-configuration-1.schema.json";

std::string without(const std::string& text, char letter) {
  auto out = text;
  out.erase(std::remove(out.begin(), out.end(), letter), out.end());
  return out;
}

// What a schema demands beyond the type and the range of a member: texts that stand for something.
const std::map<std::string, const char*> kDemands{
    {"format", R"({"const": "orbs-configuration/1"})"},
    {"name",
     R"({"pattern": "^[A-Za-z0-9][A-Za-z0-9._-]{0,99}$", "not": {"enum": ["junit.xml", "plan.json", "references", "results.csv", "results.json", "run.json", "run.lock"]}})"},
    {"executable", R"({"minLength": 1})"},
    {"command", R"({"minItems": 1})"},
    {"version_command", R"({"minItems": 1})"},
    {"plugins", R"({"minItems": 1, "items": {"type": "string", "minLength": 1}})"},
    {"environment", R"({"items": {"type": "string", "pattern": "^[^=]"}})"},
    {"scene_format",
     R"({"enum": ["orbs-scene", "povray", "mitsuba", "pbrt", "hydra", "gltf", "obj", "ply", "native"]})"},
    {"native_scenes", R"({"pattern": "^[^./\\\\*? \\t\\n][^/\\\\*? \\t\\n]*$"})"},
    {"transports",
     R"({"propertyNames": {"enum": ["rgb", "spectral", "polarised", "bispectral", "polarised-bispectral"]}, "additionalProperties": {"type": "string", "minLength": 1}})"},
    {"requirements",
     R"({"items": {"type": "string", "pattern": "^(G[1-5]|M[1-8]|L[1-4]|A[1-4]|B[1-9]|C[1-5]|D[1-6]|E[1-6]|N[1-6]|V1|S[1-7]|T[1-3]|I[12])$"}})"},
    {"reason", R"({"minLength": 1})"},
    {"key", R"({"minLength": 1})"},
    {"variants", R"({"minItems": 1})"},
    {"render_seconds", R"({"oneOf": [{"required": ["pattern"]}, {"required": ["file", "key"]}]})"},
    {"trial_seconds", R"({"oneOf": [{"required": ["pattern"]}, {"required": ["file", "key"]}]})"},
    {"renderers",
     R"({"items": {"if": {"properties": {"scene_format": {"const": "native"}}, "required": ["scene_format"]}, "then": {"required": ["native_scenes"]}}})"},
    {"options", R"({"items": {"type": "string", "pattern": "^-"}})"},
    {"version", R"({"pattern": "^\\s*(<|<=|=|>=|>)\\d+(\\.\\d+)*(\\s+(<|<=|=|>=|>)\\d+(\\.\\d+)*)*\\s*$"})"},
    {"until", R"({"pattern": "^\\d{4}-\\d{2}-\\d{2}$"})"},
    {"verdict",
     R"({"enum": ["inconclusive", "fail", "constant image", "invalid pixels", "wrong channels", "wrong size", "stale", "unreadable", "no output", "timeout", "out of memory", "crash"]})"}};

// The visitor of fields() that describes an object.
class Schema {
 public:
  template <class T>
  void operator()(const std::string& key, const T& value, const json::Field& field = {}) {
    auto& own = properties_[key];
    if (!field.help.empty()) own["description"] = without(std::string(field.help), '`');
    own.update(type_of(value, field));
    if (const auto initial = initial_of(value); !initial.is_null()) own["default"] = initial;
    if (const auto demand = kDemands.find(key); demand != kDemands.end())
      own.update(Json::parse(demand->second), true);
  }

  template <class T>
  void required(const std::string& key, const T& value, const json::Field& field = {}) {
    // A file over another has only what it changes, and "name" says of which entry.
    static const std::set<std::string> kOfLowestFile{"suites",     "renderers", "cases",   "references",
                                                     "executable", "command",   "declares"};
    (*this)(key, value, field);
    properties_[key].erase("default");
    if (!kOfLowestFile.contains(key)) required_.push_back(key);
  }

  Json object() const {
    Json out{{"type", "object"}};
    if (!required_.empty()) out["required"] = required_;
    out["additionalProperties"] = false;
    out["properties"] = properties_;
    return out;
  }

 private:
  static void add_range(const json::Range& range, Json& out) {
    if (range.min == json::kPositive.min)
      out["exclusiveMinimum"] = 0;
    else if (range.min > json::kAnyNumber.min)
      out["minimum"] =
          range.min == static_cast<int>(range.min) ? Json(static_cast<int>(range.min)) : Json(range.min);
    if (range.max < json::kAnyNumber.max) out["maximum"] = static_cast<int>(range.max);
  }

  static Json type_of(const std::string& /*text*/, const json::Field& /*field*/) {
    return {{"type", "string"}};
  }
  static Json type_of(bool /*flag*/, const json::Field& /*field*/) { return {{"type", "boolean"}}; }
  static Json type_of(int /*number*/, const json::Field& field) {
    Json out{{"type", "integer"}};
    add_range(field.range, out);
    return out;
  }
  static Json type_of(double /*number*/, const json::Field& field) {
    Json out{{"type", "number"}};
    add_range(field.range, out);
    return out;
  }
  static Json type_of(registry::SizeDivisor /*size*/, const json::Field& /*field*/) {
    Json out{{"enum", Json::array()}};
    for (const auto divisor : registry::kSizeDivisors) out["enum"].push_back(to_text(divisor));
    return out;
  }
  // By its key, which is one of the sizes that are reduced.
  template <class T>
  static Json type_of(const std::map<registry::SizeDivisor, T>& /*items*/, const json::Field& field) {
    return {{"type", "object"},
            {"additionalProperties", false},
            {"patternProperties", {{"^1/[248]$", type_of(T{}, field)}}}};
  }
  template <class T>
  static Json type_of(const std::map<std::string, T>& /*items*/, const json::Field& field) {
    return {{"type", "object"}, {"additionalProperties", type_of(T{}, field)}};
  }
  // In a map, null is a value.
  static Json type_of(const std::map<std::string, std::optional<double>>& /*items*/,
                      const json::Field& /*field*/) {
    return {{"type", "object"}, {"additionalProperties", {{"type", {"number", "null"}}}}};
  }
  template <class T>
  static Json type_of(const std::optional<T>& /*value*/, const json::Field& field) {
    return type_of(T{}, field);
  }
  template <class T>
  static Json type_of(const std::vector<T>& /*items*/, const json::Field& field) {
    return {{"type", "array"}, {"items", type_of(T{}, field)}};
  }
  template <class T>
  static Json type_of(const T& value, const json::Field& /*field*/) {
    if constexpr (requires { to_text(value); }) {
      return {{"type", "string"}};
    } else {
      Schema members;
      fields(members, value);
      return members.object();
    }
  }

  static Json initial_of(const std::string& text) { return text.empty() ? Json() : Json(text); }
  static Json initial_of(bool flag) { return flag; }
  static Json initial_of(int number) { return number; }
  static Json initial_of(double number) { return number; }
  static Json initial_of(registry::SizeDivisor size) { return to_text(size); }
  template <class T>
  static Json initial_of(const T& /*value*/) {
    return {};
  }

  Json properties_ = Json::object();
  std::vector<std::string> required_;
};

std::string schema_text() {
  Schema members;
  const registry::ConfigurationFile file;
  fields(members, file);
  Json out{
      {"$schema", "https://json-schema.org/draft/2020-12/schema"},
      {"$id", kSchema.filename().string()},
      {"title",
       "orbs-configuration/1: the suites and the renderers, the only file to edit for a further renderer"}};
  out.update(members.object());
  return out.dump(1) + "\n";
}

// The visitor of fields() that makes the rows of a table: one for each key, and for those of records within.
class Rows {
 public:
  explicit Rows(std::set<std::string> left_out, std::string prefix = "")
      : left_out_(std::move(left_out)), prefix_(std::move(prefix)) {}

  template <class T>
  void operator()(const std::string& key, const T& value, const json::Field& field = {}) {
    if (left_out_.contains(key)) return;
    std::string text(field.help);
    const auto unset = field.unset.empty() ? initial_of(value) : std::string(field.unset);
    if (!unset.empty()) text += fmt::format("{}default: {}", text.empty() ? "" : "; ", unset);
    rows_ += fmt::format("| `{}{}` | {} |\n", prefix_, key, text);
    add_members(key, value);
  }

  template <class T>
  void required(const std::string& key, const T& value, const json::Field& field = {}) {
    if (left_out_.contains(key)) return;
    rows_ +=
        fmt::format("| `{}{}` | {}{}required |\n", prefix_, key, field.help, field.help.empty() ? "" : "; ");
    add_members(key, value);
  }

  const std::string& text() const { return rows_; }

 private:
  static std::string initial_of(const std::string& text) {
    return text.empty() ? "" : fmt::format("`{}`", text);
  }
  static std::string initial_of(bool flag) { return fmt::format("`{}`", flag); }
  static std::string initial_of(int number) { return fmt::format("{}", number); }
  static std::string initial_of(double number) { return fmt::format("{}", number); }
  static std::string initial_of(registry::SizeDivisor size) { return fmt::format("`{}`", to_text(size)); }
  template <class T>
  static std::string initial_of(const T& /*value*/) {
    return "";
  }

  template <class T>
  void add_members(const std::string& key, const std::vector<T>& /*items*/) {
    add_members(key, T{});
  }
  template <class T>
  void add_members(const std::string& key, const T& value) {
    if constexpr (requires(Rows & rows) { fields(rows, value); }) {
      Rows members({}, prefix_ + key + ".");
      fields(members, value);
      rows_ += members.rows_;
    }
  }

  std::set<std::string> left_out_;
  std::string prefix_;
  std::string rows_;
};

template <class Settings>
std::string table_of(const Settings& settings, const std::set<std::string>& left_out = {}) {
  Rows rows(left_out);
  fields(rows, settings);
  return "\n| key | |\n|---|---|\n" + rows.text() + "\n";
}

}  // namespace

TEST(ConfigurationSchema, SaysWhatTheFieldsSay) {
  const auto expected = schema_text();
  if (read_file(kSchema) == expected) return;
  ASSERT_NE(std::getenv("ORBS_WRITE_DOCUMENTATION"), nullptr)
      << kSchema << " is out of date: run this test with ORBS_WRITE_DOCUMENTATION=1";
  write_file(kSchema, expected);
}

TEST(RenderersPage, SaysWhatTheFieldsSay) {
  const auto page = kRoot / "docs/use/renderers.md";
  EXPECT_EQ(structure::check_generated_part(page, "keys of a renderer", table_of(registry::RendererEntry{})),
            "");
  EXPECT_EQ(structure::check_generated_part(page, "keys of the file",
                                            table_of(registry::ConfigurationFile{}, {"renderers", "limits"})),
            "");
}
