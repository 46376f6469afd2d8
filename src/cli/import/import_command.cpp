#include "base/files.h"
#include "base/terminal.h"
#include "cli/interrupt.h"
#include "cli/options.h"
#include "cli/program.h"
#include "importer/case_file.h"
#include "importer/import_scene.h"
#include "references/references.h"
#include "registry/cases.h"
#include "registry/new_suite.h"

#include <cstdio>

#include <fmt/format.h>

namespace orbs::cli {

namespace {

struct ImportOptions {
  std::string file;
  std::string folder = "my-cases";
  std::string suite = "mine";
  std::string name;
  std::string requirement;
  importer::View view;
  bool replaces = false;
  bool with_reference = false;
};

struct Imported {
  scene::Scene scene;
  importer::Report report;
  std::filesystem::path folder;
  std::filesystem::path configuration;
};

// Where a name becomes a folder and a word of lists.
void check_name(const std::string& name, const std::string& option) {
  const auto plain = importer::case_name(name + ".x");
  if (plain != name || name.size() > 100)
    throw InputError(
        fmt::format("{}: '{}' is to become a folder and a file: expected up to 100 letters, digits, "
                    "'-' and '_', such as '{}'",
                    option, name, plain.substr(0, 100)));
}

// The uppermost folder of the path that is not there: all in it is new.
std::filesystem::path first_missing(std::filesystem::path path) {
  std::error_code ignored;
  while (path.has_relative_path() && !std::filesystem::exists(path.parent_path(), ignored))
    path = path.parent_path();
  return path;
}

// The case is complete in a hidden folder, which suites do not read, before it gets its name.
Imported import(const ImportOptions& options) {
  const auto name = options.name.empty() ? importer::case_name(options.file) : options.name;
  check_name(name, "--name");
  check_name(options.suite, "--suite");
  const auto target = registry::suite_in(options.folder, options.suite);
  Imported made{{}, {}, target.suite.cases / name, target.file};
  std::error_code ignored;
  if (std::filesystem::exists(made.folder, ignored) && !options.replaces)
    throw InputError(
        fmt::format("{}: is there already; choose another --name, or put the new scene in its place "
                    "with --replace",
                    made.folder.string()));
  const auto unfinished = target.suite.cases / fmt::format(".{}.unfinished", name);
  remove_tree(unfinished);
  const auto added = first_missing(unfinished);
  make_folder(unfinished);
  try {
    made.scene = importer::import_scene(options.file, unfinished, name, options.view, made.report);
    const auto requirement =
        options.requirement.empty() ? importer::requirement_of(made.scene) : options.requirement;
    const auto text = importer::case_text(made.scene, options.file, requirement, made.report);
    write_file(unfinished / "case.json", text);
    registry::load_case(unfinished / "case.json");
  } catch (...) {
    remove_tree(added);
    throw;
  }
  put_in_place(unfinished, made.folder);
  make_folder(target.suite.references);
  registry::write_own(target.file, target.text);
  return made;
}

std::string counted(std::size_t count, const char* one) {
  return fmt::format("{} {}{}", count, one,
                     count == 1                              ? ""
                     : std::string_view(one).ends_with("sh") ? "es"
                                                             : "s");
}

void print(const Imported& made, const ImportOptions& options) {
  const auto& scene = made.scene;
  std::size_t triangles = 0;
  for (const auto& mesh : scene.meshes) triangles += mesh.triangles.size();
  print_clean("made {}\n", made.folder.string());
  print_clean("  {} x {} pixels, {}, {}, {}, {}, {}, {}\n", scene.camera.width_px, scene.camera.height_px,
              counted(scene.meshes.size(), "mesh"), counted(triangles, "triangle"),
              counted(scene.instances.size(), "instance"), counted(scene.materials.size(), "material"),
              counted(scene.textures.size(), "texture"), counted(scene.lights.size(), "light"));
  if (!made.report.choices().empty()) print_clean("chosen here:\n");
  for (const auto& sentence : made.report.choices()) print_clean("  {}\n", sentence);
  const auto remarks = made.report.remarks();
  print_clean("{}\n", remarks.empty() ? "all of the file was understood"
                                      : "not as in the file, how often, and what is drawn instead:");
  for (const auto& remark : remarks) print_clean("  {}\n", importer::text_of(remark));
  if (options.with_reference) return;
  print_clean("next:\n  cd {}\n  orbs reference --suite {} --scene {}\n  orbs run --suite {} --scene {}\n",
              options.folder, options.suite, scene.name, options.suite, scene.name);
}

int make_reference(const Imported& made, const ImportOptions& options, const Program& program) {
  const auto configuration = read_configuration(made.configuration.string(), program);
  registry::RunSettings selection;
  selection.suite = options.suite;
  selection.scenes = made.scene.name;
  references::ReferenceSettings settings;
  if (options.replaces) settings.reason = "the scene was imported again";
  const auto& stop = catch_interrupts();
  const auto say = [](const std::string& line) {
    print_clean("{}\n", line);
    std::fflush(stdout);
  };
  const int status = references::render_references(configuration, selection, settings,
                                                   {program.folder / "orbs-tracer", &stop, say});
  if (status == 0)
    print_clean("next:\n  cd {}\n  orbs run --suite {} --scene {}\n", options.folder, options.suite,
                made.scene.name);
  return status;
}

}  // namespace

void add_import_command(const command_line::Command& command, const Program& program, Action& action) {
  const auto options = std::make_shared<ImportOptions>();
  command.add_option("file", options->file, "The scene: a .gltf or .glb file of glTF 2.0").required();
  command
      .add_option("-o,--output", options->folder, "Folder of your own cases; it is made if it is not there")
      .value_name("FOLDER")
      .not_empty("a folder")
      .shows_default();
  command.add_option("--suite", options->suite, "Suite of that folder that gets the case").shows_default();
  command.add_option("--name", options->name, "Name of the case and its scene (default: that of the file)");
  command.add_option("--camera", options->view.camera,
                     "Camera of the file, by its name (default: the first)");
  command
      .add_option("--pixels", options->view.longer_side,
                  "Longer side of the image, unless a scene that orbs exported says its size")
      .range(1, 16384)
      .shows_default();
  command
      .add_option(
          "--sky", options->view.sky,
          "Radiance of an even sky around the scene (default: none; 0.4 and light from afar if nothing shines)")
      .zero_or_more();
  command.add_option(
      "--requirement", options->requirement,
      "Requirement that lists show the case under (default: B7 if a material calls for it, else G4)");
  command.add_flag("--replace", options->replaces, "Put the new scene in the place of a case of that name");
  command.add_flag("--reference", options->with_reference, "Render the reference at once");
  command.callback([=, &program, &action] {
    action = [=, &program] {
      const auto made = import(*options);
      print(made, *options);
      std::fflush(stdout);
      return options->with_reference ? make_reference(made, *options, program) : 0;
    };
  });
}

}  // namespace orbs::cli
