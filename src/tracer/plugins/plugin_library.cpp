#include "tracer/plugins/plugin_library.h"

#include "base/error.h"
#include "base/files.h"
#include "tracer/plugins/elf_file.h"

#include <atomic>
#include <cfenv>
#include <set>
#include <string_view>

#include <dlfcn.h>
#include <fmt/format.h>

namespace orbs::tracer {

namespace {

namespace fs = std::filesystem;

constexpr const char* kEnding = ".so";

// dlerror() says what the last call complains about, once.
std::string last_problem() {
  const char* text = ::dlerror();
  return text == nullptr ? "no reason is given" : text;
}

template <typename Function>
Function find_function(void* handle, const char* name) {
  return reinterpret_cast<Function>(::dlsym(handle, name));
}

template <typename Function>
void require(const PluginLibrary& library, const char* name, Function& function) {
  function = find_function<Function>(library.handle.get(), name);
  if (function == nullptr)
    throw InputError(
        fmt::format("plug-in {}: it has no function {}, which orbs/shape_plugin.h requires; define it with "
                    "C linkage, and do not hide it",
                    library.file.string(), name));
}

// No std::string: when the program ends, it would be gone before the last who asks.
std::atomic<const char*> being_opened{nullptr};

std::unique_ptr<void, CloseLibrary> open_library(const fs::path& file) {
  // A library that was linked with -ffast-math has an initialiser that makes the processor flush small
  // numbers to zero from then on, for the thread that opens it and all that it starts: images would depend on
  // it.
  std::fenv_t environment;
  std::fegetenv(&environment);
  // By an absolute path no other folder is searched. RTLD_LOCAL: all plug-ins define the same names.
  const auto path = fs::absolute(file);
  being_opened = path.c_str();
  std::unique_ptr<void, CloseLibrary> handle(::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL));
  being_opened = nullptr;
  std::fesetenv(&environment);
  return handle;
}

void check_version(const PluginLibrary& library) {
  constexpr const char* kVersion = "orbs_shape_plugin_version";
  const auto version = find_function<decltype(&orbs_shape_plugin_version)>(library.handle.get(), kVersion);
  if (version == nullptr)
    throw InputError(
        fmt::format("plug-in {}: it has no function {}, so it is no plug-in for shapes; "
                    "orbs/shape_plugin.h says what one needs",
                    library.file.string(), kVersion));
  if (const auto found = version(); found != ORBS_SHAPE_PLUGIN_VERSION)
    throw InputError(fmt::format(
        "plug-in {}: it is built for version {} of orbs/shape_plugin.h, and this orbs-tracer has version {}; "
        "build it with the header of this version",
        library.file.string(), found, ORBS_SHAPE_PLUGIN_VERSION));
}

fs::path file_of(const std::string& name, const PluginSources& sources) {
  for (const auto& file : sources.files)
    if (plugin_name(file) == name) return file;
  if (sources.folder.empty()) return {};
  std::error_code ignored;
  for (const auto& file : {name + kEnding, "lib" + name + kEnding})
    if (fs::exists(sources.folder / file, ignored)) return sources.folder / file;
  return {};
}

}  // namespace

void CloseLibrary::operator()(void* handle) const { ::dlclose(handle); }

std::string plugin_being_opened() {
  const char* file = being_opened;
  return file == nullptr ? "" : file;
}

std::string plugin_name(const fs::path& file) {
  constexpr std::string_view kPrefix = "lib";
  auto name = file.stem().string();
  if (name.starts_with(kPrefix)) name.erase(0, kPrefix.size());
  return name;
}

void check_plugin_names(const PluginSources& sources) {
  std::set<std::string> names;
  for (const auto& file : sources.files)
    if (const auto name = plugin_name(file); !names.insert(name).second)
      throw InputError(fmt::format(
          "--plugin: two files are the plug-in '{}', the second is {}; scenes could not tell them "
          "apart: rename one",
          name, file.string()));
}

std::shared_ptr<const PluginLibrary> open_plugin(const fs::path& file) {
  if (const auto problem = no_file_problem(file); !problem.empty())
    throw InputError(fmt::format("plug-in {}: {}", file.string(), problem));
  if (const auto missing = missing_part(file); !missing.empty())
    throw InputError(fmt::format("plug-in {}: {}; copy or link it again", file.string(), missing));
  auto library = std::make_shared<PluginLibrary>();
  library->name = plugin_name(file);
  library->file = file;
  library->handle = open_library(file);
  if (library->handle == nullptr)
    throw InputError(fmt::format("plug-in {}: it cannot be opened as a shared library: {}", file.string(),
                                 last_problem()));
  check_version(*library);
  require(*library, "orbs_shape_create", library->create);
  require(*library, "orbs_shape_destroy", library->destroy);
  require(*library, "orbs_shape_bounds", library->bounds);
  require(*library, "orbs_shape_intersect", library->intersect);
  library->occluded =
      find_function<decltype(&orbs_shape_occluded)>(library->handle.get(), "orbs_shape_occluded");
  library->sample = find_function<decltype(&orbs_shape_sample)>(library->handle.get(), "orbs_shape_sample");
  library->pdf = find_function<decltype(&orbs_shape_pdf)>(library->handle.get(), "orbs_shape_pdf");
  return library;
}

PluginLibraries open_plugins(const scene::Scene& scene, const PluginSources& sources) {
  PluginLibraries libraries;
  for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
    const auto* form = std::get_if<scene::PluginForm>(&scene.shapes[i].form);
    if (form == nullptr || libraries.contains(form->plugin)) continue;
    const auto file = file_of(form->plugin, sources);
    if (file.empty())
      throw InputError(fmt::format(
          "{} is by the plug-in '{}', and there is none of that name{}; give its file with "
          "--plugin, or the folder that holds {}{} with --plugin-folder",
          scene::display_name("shape", scene.shapes[i].name, scene.spheres.size() + i), form->plugin,
          sources.folder.empty() ? "" : fmt::format(" in {}", sources.folder.string()), form->plugin,
          kEnding));
    libraries[form->plugin] = open_plugin(file);
  }
  return libraries;
}

}  // namespace orbs::tracer
