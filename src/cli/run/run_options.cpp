#include "cli/run/run_options.h"

#include "cli/options.h"

#include <algorithm>
#include <cctype>
#include <variant>

#include <fmt/format.h>

namespace orbs::cli {

namespace {

using registry::RunSettings;
using registry::SizeDivisor;

struct Setting {
  std::string key;
  json::Field field;
  std::variant<std::string*, int*, double*, bool*, SizeDivisor*> member;
};

// The visitor of fields() that makes a table of them.
struct Table {
  std::vector<Setting> settings;

  template <class T>
  void operator()(const std::string& key, T& value, const json::Field& field) {
    settings.push_back({key, field, &value});
  }
};

std::vector<Setting> table_of(RunSettings& settings) {
  Table table;
  fields(table, settings);
  return table.settings;
}

// "-j,--jobs" and "NUMBER" of "-j,--jobs NUMBER".
std::string names_of(const json::Field& field) {
  return std::string(field.option.substr(0, field.option.find(' ')));
}

std::string value_name_of(const json::Field& field) {
  const auto space = field.option.find(' ');
  return space == std::string_view::npos ? "" : std::string(field.option.substr(space + 1));
}

// "--jobs"
std::string long_name_of(const json::Field& field) {
  const auto names = names_of(field);
  const auto begin = names.find("--");
  return names.substr(begin, names.find(',', begin) - begin);
}

// "a folder" for FOLDER.
std::string what_it_needs(const json::Field& field) {
  auto word = value_name_of(field);
  for (char& letter : word) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return "a " + word;
}

std::string default_of(const Setting& setting) {
  struct {
    std::string operator()(const std::string* text) const { return *text == "*" ? "" : *text; }
    std::string operator()(const int* number) const { return fmt::format("{}", *number); }
    std::string operator()(const double* number) const { return fmt::format("{}", *number); }
    std::string operator()(const bool* flag) const { return *flag ? "yes" : ""; }
    std::string operator()(const SizeDivisor* size) const { return to_text(*size); }
  } initial;
  return setting.field.unset.empty() ? std::visit(initial, setting.member) : std::string(setting.field.unset);
}

std::string help_of(const Setting& setting) {
  std::string text(setting.field.help);
  text.erase(std::remove(text.begin(), text.end(), '`'), text.end());
  const auto unset = default_of(setting);
  return unset.empty() ? text : fmt::format("{} (default: {})", text, unset);
}

// Adds one option, which fills the setting or what it is made of.
struct AddOption {
  const command_line::Command& command;
  RunOptions& options;
  const Setting& setting;

  void operator()(std::string* text) const {
    const auto names = names_of(setting.field);
    const auto word = value_name_of(setting.field);
    if (setting.field.is_list)
      command.add_option(names, options.lists[setting.key], help_of(setting)).value_name(word);
    else
      command.add_option(names, *text, help_of(setting))
          .value_name(word)
          .not_empty(what_it_needs(setting.field));
  }

  void operator()(int* number) const {
    const auto& range = setting.field.range;
    const auto option = command.add_option(names_of(setting.field), *number, help_of(setting));
    if (range.min == 0) option.zero_or_more();
    option.range(static_cast<int>(range.min), static_cast<int>(range.max))
        .value_name(value_name_of(setting.field));
  }

  void operator()(double* number) const {
    const auto word = value_name_of(setting.field);
    const auto option =
        command.add_option(names_of(setting.field), *number, help_of(setting)).value_name(word);
    if (word == "TIME")
      option.in_units(command_line::kTimes);
    else
      option.above_zero();
  }

  void operator()(bool* flag) const {
    const auto no = "!--no-" + long_name_of(setting.field).substr(2);
    command.add_flag(names_of(setting.field) + "," + no, *flag, help_of(setting));
  }

  void operator()(SizeDivisor* /*size*/) const {
    std::vector<std::string> sizes;
    for (const auto divisor : registry::kSizeDivisors) sizes.push_back(to_text(divisor));
    command.add_option(names_of(setting.field), options.size, help_of(setting))
        .one_of(sizes)
        .value_name(value_name_of(setting.field));
  }
};

}  // namespace

std::set<std::string> settings_but(const std::set<std::string>& left_out) {
  RunSettings settings;
  std::set<std::string> keys;
  for (const auto& setting : table_of(settings))
    if (!left_out.contains(setting.key)) keys.insert(setting.key);
  return keys;
}

void add_settings(const command_line::Command& command,
                  RunOptions& options,
                  const std::set<std::string>& keys) {
  for (const auto& setting : table_of(options.given))
    if (keys.contains(setting.key)) std::visit(AddOption{command, options, setting}, setting.member);
  options.keys.insert(keys.begin(), keys.end());
}

void add_choice_options(const command_line::Command& command, RunOptions& options) {
  add_settings(command, options, settings_but(registry::kCallSettings));
}

void add_run_options(const command_line::Command& command, RunOptions& options) {
  add_settings(command, options, settings_but({}));
  const auto resume =
      command
          .add_option(
              "--resume", options.resume,
              "Continue the run in this folder, with its own suite, cases and renderers: render what is "
              "missing or outdated")
          .value_name("FOLDER")
          .not_empty("a folder");
  command
      .add_option("--shard", options.shard,
                  "Only this part of the renders, such as 3/16; 'orbs merge' puts all parts together")
      .value_name("PART")
      .not_empty("a part");
  const auto plan = command
                        .add_option("--plan", options.plan,
                                    "Execute the plan in this file: plan.json of a run or of orbs submit")
                        .value_name("FILE")
                        .not_empty("a file");
  command
      .add_option(
          "--accept-failures", options.accept_failures,
          "Write what fails in this run into the configuration as known failures of its suite and size, "
          "with this reason")
      .value_name("REASON")
      .excludes(command.option("--dry-run"))
      .not_empty("a reason");
  for (const char* choice : {"--suite", "--case", "--scene", "--requirement", "--renderer", "--size"}) {
    resume.excludes(command.option(choice));
    plan.excludes(command.option(choice));
  }
  for (const char* choice : {"--output", "--shard", "--plan", "--last-failed", "--label"})
    resume.excludes(command.option(choice));
  for (const char* choice : {"--resume", "--shard", "--plan", "--accept-failures", "--dry-run", "--view"})
    command.option("--repeat").excludes(command.option(choice));
  // The parts of one plan must choose the same: what failed last may be another run for each.
  for (const char* part : {"--plan", "--shard"})
    command.option("--last-failed").excludes(command.option(part));
  command.option("--quiet").excludes(command.option("--verbose"));
}

RunSettings run_settings(const command_line::Command& command,
                         const RunOptions& options,
                         RunSettings settings) {
  auto given = options.given;
  const auto from = table_of(given);
  const auto to = table_of(settings);
  for (std::size_t i = 0; i < from.size(); ++i) {
    // Another option of the same name may mean something else: the images of a probe have a size of their
    // own.
    if (!options.keys.contains(from[i].key) || !command.is_given(long_name_of(from[i].field))) continue;
    if (const auto list = options.lists.find(from[i].key); list != options.lists.end())
      **std::get_if<std::string*>(&from[i].member) = joined_list(list->second);
    if (const auto* size = std::get_if<SizeDivisor*>(&from[i].member))
      **size = registry::size_divisor(options.size);
    std::visit([&](auto* value) { **std::get_if<decltype(value)>(&to[i].member) = *value; }, from[i].member);
  }
  return settings;
}

RunSettings study_settings(const command_line::Command& command,
                           const RunOptions& options,
                           const RunSettings& defaults) {
  auto settings = run_settings(command, options, defaults);
  refuse_without_sandbox(settings.sandbox);
  return settings;
}

}  // namespace orbs::cli
