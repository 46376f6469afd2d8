#pragma once

#include "registry/cluster.h"
#include "registry/configuration_files.h"
#include "registry/expected.h"
#include "registry/renderer.h"
#include "registry/run_settings.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// configuration.json (format "orbs-configuration/1") as plain data: the only file a user edits to add a
/// renderer.
namespace orbs::registry {

struct Suite {
  std::string name;
  std::filesystem::path cases;       // absolute
  std::filesystem::path references;  // absolute
  /// Where the files that its scenes name may lie, beside a scene's own folder: its cases, the common data,
  /// and what its entry names under "data". Absolute.
  std::vector<std::filesystem::path> data{};
};

/// A suite as it stands in the file; its paths are relative to the file's folder.
struct SuiteEntry {
  std::string name;
  std::string cases;
  std::string references;
  std::vector<std::string> data;
};

template <class Visitor, json::RecordOf<SuiteEntry> Record>
void fields(Visitor& visit, Record& suite) {
  visit.required("name", suite.name);
  visit.required("cases", suite.cases, {.help = "Folder of the cases"});
  visit.required("references", suite.references, {.help = "Folder of the references"});
  visit(
      "data", suite.data,
      {.help =
           "Further folders of scene files. Meshes, textures, spectra and IES profiles that a scene names "
           "must lie in its own folder, in `cases`, in the `common` folder beside it or in one of these, also "
           "where `..` and symbolic links lead"});
}

/// The keys of the whole file.
struct ConfigurationFile {
  std::string format;
  std::vector<std::string> include;
  bool stands_alone = false;
  RunSettings defaults;
  LimitSettings limits;
  std::vector<SuiteEntry> suites;
  std::vector<RendererEntry> renderers;
  std::vector<ExpectedFailure> expected;
  SlurmSettings slurm;
};

template <class Visitor, json::RecordOf<ConfigurationFile> Record>
void fields(Visitor& visit, Record& file) {
  visit.required("format", file.format, {.help = "`\"orbs-configuration/1\"`"});
  visit(
      "include", file.include,
      {.help = "Files of this format, relative to this one, that it is over: what they hold, it may change"});
  visit("stands_alone", file.stands_alone,
        {.help = "`true`: neither the shipped configuration nor that of the system or the user is below it"});
  visit("defaults", file.defaults, {.help = "Of the options of `orbs run`"});
  visit.required("suites", file.suites,
                 {.help = "`name`, `cases` and `references`: two folders; optional `data`"});
  visit.required("renderers", file.renderers, {.help = "The entries"});
  visit("limits", file.limits, {.help = "Those of all renderers, where an entry states none"});
  visit("slurm", file.slurm, {.help = "For `orbs submit`: `partition`, `account`, `time`, `options`"});
  visit(
      "expected", file.expected,
      {.help =
           "Known failures: reports name them, and they do not make a run fail. The last entry that matches a "
           "target counts"});
}

struct Configuration {
  std::filesystem::path file;  // the uppermost
  std::filesystem::path root;  // the folder of the lowest file; what {root} stands for
  RunSettings defaults;
  std::vector<Suite> suites;
  std::vector<Renderer> renderers;
  std::vector<ExpectedFailure> expected{};
  SlurmSettings slurm{};
  ConfigurationFiles files{};                  // that it was read from
  std::vector<std::filesystem::path> below{};  // all files but the uppermost, the lowest first; absolute
  std::filesystem::path own_file{};            // that commands write to; it may not be there yet
};

/// Reads and checks the file. InputError with file, line and key: unknown keys, wrong types, names given
/// twice, unknown placeholders, a command without {scene} or {output}.
Configuration load_configuration(const std::filesystem::path& file);

/// Likewise all of them as one. A file over another may hold parts of entries and of settings alone: what it
/// says counts, null takes away what is below it, and its known failures are added.
Configuration load_configuration(const ConfigurationFiles& files,
                                 const std::optional<EditedFile>& edited = {});

/// As load_configuration, for a text that is not in the file yet.
Configuration parse_configuration(const std::filesystem::path& file, const std::string& text);

/// The suite of that name; InputError naming the nearest one.
const Suite& find_suite(const Configuration& configuration, const std::string& name);

/// The nearest configuration.json: in `from` or the folders above it; nothing when there is none up to the
/// root.
std::optional<std::filesystem::path> nearest_configuration(std::filesystem::path from);

}  // namespace orbs::registry
