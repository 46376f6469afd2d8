#include "registry/configuration_files.h"

#include "base/error.h"
#include "base/files.h"
#include "json/layers.h"
#include "json/object_reader.h"
#include "registry/placeholders.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

namespace orbs::registry {

namespace {

namespace fs = std::filesystem;
using json::ObjectReader;

struct Layer {
  json::Document document;
  fs::path file;  // absolute
  bool is_included = false;
};

fs::path normal_path(const fs::path& file) { return fs::absolute(file).lexically_normal(); }

std::string text_now_of(const fs::path& file, const std::optional<EditedFile>& edited) {
  if (edited && normal_path(edited->file) == normal_path(file)) return edited->text;
  return read_file(file);
}

void refuse_doubles(std::vector<ObjectReader> entries) {
  std::set<std::string> names;
  for (auto& entry : entries)
    if (entry.has("name") && entry.holds_text("name") && !names.insert(entry.text("name")).second)
      entry.fail("name", fmt::format("'{}' is the name of an earlier entry", entry.text("name")));
}

// The uppermost file that stands alone, or the lowest of all. What lies below is not looked at, and may be
// broken.
std::vector<fs::path>::const_iterator uppermost_alone(const std::vector<fs::path>& files,
                                                      const std::optional<EditedFile>& edited) {
  for (auto file = files.end() - 1; file != files.begin(); --file) {
    const auto document = json::parse(file->string(), text_now_of(*file, edited));
    if (ObjectReader in(document); in.boolean_or("stands_alone", false)) return file;
  }
  return files.begin();
}

// A path that may begin with {root} or {data}. Other braces are its own.
fs::path path_of(const std::string& text, const fs::path& root, const fs::path& data) {
  constexpr std::string_view kRoot = "{root}";
  constexpr std::string_view kData = "{data}";
  if (text.starts_with(kRoot)) return (root.string() + text.substr(kRoot.size()));
  if (text.starts_with(kData)) return (data.string() + text.substr(kData.size()));
  return resolve_path(root, text);
}

class Reading {
 public:
  Reading(fs::path data, const std::optional<EditedFile>& edited) : data_(std::move(data)), edited_(edited) {}

  void add(const fs::path& file, bool is_included) {
    const auto path = normal_path(file);
    Layer layer{json::parse(file.string(), text_now_of(file, edited_)), path, is_included};
    ObjectReader in(layer.document);
    in.one_of("format", {"orbs-configuration/1"});
    refuse_doubles(in.objects_or_none("suites"));
    refuse_doubles(in.objects_or_none("renderers"));
    open_.push_back(path);
    add_included(in, path);
    open_.pop_back();
    layers_.push_back(std::move(layer));
  }

  std::vector<Layer> take() { return std::move(layers_); }

 private:
  void add_included(ObjectReader& in, const fs::path& file) {
    if (!in.has("include")) return;
    const auto names = in.system_texts("include");
    for (std::size_t i = 0; i < names.size(); ++i) {
      const auto included = normal_path(path_of(names[i], file.parent_path(), data_));
      if (const auto problem = no_file_problem(included); !problem.empty()) in.fail_at("include", i, problem);
      if (std::find(open_.begin(), open_.end(), included) != open_.end())
        in.fail_at("include", i, "a file cannot include itself, nor one that includes it");
      const auto same = [&](const Layer& layer) { return layer.file == included; };
      if (std::none_of(layers_.begin(), layers_.end(), same)) add(included, true);
    }
  }

  fs::path data_;
  const std::optional<EditedFile>& edited_;
  std::vector<Layer> layers_;
  std::vector<fs::path> open_;  // files that are being read
};

// "/renderers/3/command/0" as its parts.
std::vector<std::string> keys_of(const std::string& pointer) {
  std::vector<std::string> parts;
  for (std::size_t begin = 1; begin <= pointer.size();) {
    const auto end = std::min(pointer.find('/', begin), pointer.size());
    parts.push_back(pointer.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

bool is_path_of_suite(const std::vector<std::string>& parts) {
  static const std::set<std::string> kKeys{"cases", "references", "data"};
  return parts.size() > 2 && parts[0] == "suites" && kKeys.contains(parts[2]);
}

bool has_placeholders(const std::vector<std::string>& parts) {
  static const std::set<std::string> kKeys{"executable",      "command",          "plugins",
                                           "version_command", "double_precision", "variants"};
  return parts.size() > 2 && parts[0] == "renderers" && kKeys.contains(parts[2]);
}

// What `text` of a file in the folder `root` stands for where {root} is `whole_root`.
std::string value_of(const std::string& pointer,
                     const std::string& text,
                     const fs::path& root,
                     const fs::path& whole_root,
                     const fs::path& data) {
  const auto parts = keys_of(pointer);
  const bool is_elsewhere = root != whole_root;
  if (is_path_of_suite(parts)) {
    const bool is_as_it_stands = !is_elsewhere && !text.starts_with("{root}") && !text.starts_with("{data}");
    return is_as_it_stands ? text : path_of(text, root, data).lexically_normal().string();
  }
  if (!has_placeholders(parts)) return text;
  // A folder beside the data has one spelling, or a path with ".." would outdate the renders of one without.
  const auto shipped =
      data == whole_root / "data" ? "{root}" : with_doubled_braces(data.parent_path().string());
  auto filled = with_some_placeholders(
      text,
      {{"root", is_elsewhere ? with_doubled_braces(root.string()) : "{root}"}, {"data", shipped + "/data"}});
  if (const auto up = shipped + "/data/../"; filled.starts_with(up))
    filled.replace(0, up.size(), shipped + "/");
  const bool is_relative = parts[2] == "plugins" && !filled.starts_with('/') && !filled.starts_with('{');
  return is_elsewhere && is_relative ? with_doubled_braces(root.string()) + "/" + filled : filled;
}

}  // namespace

LayeredFiles read_layers(const ConfigurationFiles& files, const std::optional<EditedFile>& edited) {
  const auto lowest = normal_path(files.layers.front()).parent_path();
  const auto data = files.data.empty() ? lowest / "data" : normal_path(files.data);
  Reading reading(data, edited);
  for (auto file = uppermost_alone(files.layers, edited); file != files.layers.end(); ++file)
    reading.add(*file, false);
  auto layers = reading.take();
  LayeredFiles read;
  std::vector<json::Document> documents;
  for (auto& layer : layers) {
    if (read.root.empty() && !layer.is_included) read.root = layer.file.parent_path();
    read.files.push_back(layer.file);
    documents.push_back(std::move(layer.document));
  }
  read.document =
      json::layered(std::move(documents), {.by_name = {"suites", "renderers"}, .appended = {"expected"}},
                    [&](std::size_t layer, const std::string& pointer, const std::string& text) {
                      return value_of(pointer, text, read.files[layer].parent_path(), read.root, data);
                    });
  return read;
}

std::vector<ValuePlace> value_places(const ConfigurationFiles& files) {
  const auto read = read_layers(files, {});
  ObjectReader in(read.document);
  std::vector<ValuePlace> places;
  for (const char* key : {"defaults", "limits", "slurm"}) {
    if (!in.has(key)) continue;
    const auto object = in.object(key);
    for (const auto& name : object.keys())
      places.push_back({fmt::format("{}/{}", key, name), object.place(name)});
  }
  for (const char* key : {"suites", "renderers"})
    for (auto& entry : in.objects_or_none(key))
      for (const auto& member : entry.keys())
        if (member != "name")
          places.push_back({fmt::format("{}/{}/{}", key, entry.text("name"), member), entry.place(member)});
  return places;
}

std::string own_text(const fs::path& file) {
  if (file.empty())
    throw InputError(
        "there is no file of your own to write to: HOME is not set; name one with --configuration");
  std::error_code ignored;
  return fs::exists(fs::symlink_status(file, ignored)) ? read_file(file) : kEmptyConfiguration;
}

void write_own(const fs::path& file, const std::string& text) {
  make_folder(file.parent_path());
  write_file(fs::weakly_canonical(file), text);
}

ConfigurationFiles with_own(ConfigurationFiles files, const fs::path& file) {
  const auto same = [&](const fs::path& other) { return normal_path(other) == normal_path(file); };
  if (std::none_of(files.layers.begin(), files.layers.end(), same)) files.layers.push_back(file);
  return files;
}

}  // namespace orbs::registry
