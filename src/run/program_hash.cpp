#include "run/program_hash.h"

#include "adapters/job.h"
#include "adapters/process/programs.h"
#include "base/error.h"
#include "base/files.h"
#include "registry/placeholders.h"

#include <algorithm>

#include <fmt/format.h>

namespace orbs::run {

namespace {

// True when the text is the same for every render of the renderer.
bool is_fixed(const std::string& text) {
  const auto& fixed = registry::executable_placeholders();
  const auto& all = registry::command_placeholders();
  return std::none_of(all.begin(), all.end(), [&](const std::string& name) {
    return !fixed.contains(name) && registry::uses_placeholder(text, name);
  });
}

}  // namespace

std::vector<std::filesystem::path> program_files(const ChosenRenderer& renderer, const Plan& plan) {
  const registry::Placeholders values{{"executable", renderer.executable.string()},
                                      {"root", plan.root.string()},
                                      {"build", plan.build.string()}};
  std::vector<std::filesystem::path> files{renderer.executable};
  const auto add = [&](const std::filesystem::path& file) {
    if (file.is_absolute() && no_file_problem(file).empty() &&
        std::find(files.begin(), files.end(), file) == files.end())
      files.push_back(file);
  };
  const auto& command = renderer.entry.command.words;
  for (std::size_t i = 0; i < command.size(); ++i) {
    if (!is_fixed(command[i])) continue;
    const auto word = registry::fill_placeholders(command[i], values);
    if (i == 0)
      if (const auto program = adapters::find_program(word)) add(*program);
    add(word);
    if (const auto equals = word.find('='); equals != std::string::npos) add(word.substr(equals + 1));
  }
  for (const auto& file : adapters::plugin_files(renderer.entry, plan.root, plan.build)) add(file);
  return files;
}

std::string FileHashes::of(const std::filesystem::path& file) {
  const std::lock_guard lock(mutex_);
  auto state = file_state(file);
  auto& entry = known_[file];
  if (entry.state == state) return entry.hash;
  entry.state = std::move(state);
  entry.hash = "";
  if (entry.state.empty()) return "";
  try {
    entry.hash = hash_text(content_hash(read_file(file)));
  } catch (const InputError&) {
    entry.hash = hash_text(content_hash(entry.state));
  }
  return entry.hash;
}

std::string program_hash(const ChosenRenderer& renderer, const Plan& plan, FileHashes& hashes) {
  std::string text;
  for (const auto& file : program_files(renderer, plan)) text += hashes.of(file) + '\n';
  return hash_text(content_hash(text));
}

ProgramWatch::ProgramWatch(const Plan& plan) : plan_(plan) {
  for (const auto& renderer : plan.renderers) at_start_.push_back(program_hash(renderer, plan, hashes_));
}

bool ProgramWatch::has_changed(std::size_t renderer) {
  return program_hash(plan_.renderers[renderer], plan_, hashes_) != at_start_[renderer];
}

}  // namespace orbs::run
