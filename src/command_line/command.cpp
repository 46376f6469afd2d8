#include "command_line/command.h"

#include "base/text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>
#include <string_view>
#include <system_error>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace orbs::command_line {

namespace {

CLI::Validator number_check(bool (*holds)(double), const char* expected) {
  const auto problem = [=](const std::string& text) -> std::string {
    const auto number = to_number(text);
    if (number && std::isfinite(*number) && holds(*number)) return "";
    return fmt::format("expected {}, not '{}'", expected, text);
  };
  return {problem, ""};
}

// CLI11's own Range words its complaint in another way in each of its versions. The help shows `type` and the
// limits.
template <class Number>
CLI::Validator number_within(Number least, Number most, const char* type) {
  const auto problem = [=](const std::string& text) -> std::string {
    Number number{};
    const auto* end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, number);
    if (read.ec == std::errc{} && read.ptr == end && number >= least && number <= most) return "";
    return fmt::format("expected a number from {} to {}, not '{}'", least, most, text);
  };
  std::ostringstream help;
  help << type << " in [" << least << " - " << most << "]";
  return {problem, help.str()};
}

// The words for the value that the help shows: those that were set, or the type. "NUMBER:INT in [1 - 8]" has
// the check behind it.
std::string value_of(const CLI::Option& option) {
  if (option.get_type_size() == 0) return "";
  const auto text = option.get_option_text().empty() ? option.get_type_name() : option.get_option_text();
  return std::string(trim(text.substr(0, text.find(':'))));
}

// CLI11 writes the value that a flag sets behind its name, "--no-log{false}", which nobody can type.
class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_option_name(const CLI::Option* option, bool is_positional) const override {
    constexpr std::string_view kValue = "{false}";
    auto name = CLI::Formatter::make_option_name(option, is_positional);
    if (const auto at = name.find(kValue); at != std::string::npos) name.erase(at, kValue.size());
    return name;
  }
};

}  // namespace

Option Option::required() const {
  option_->required();
  return *this;
}

Option Option::range(int least, int most) const {
  option_->check(number_within(least, most, "INT"));
  return *this;
}

Option Option::range(double least, double most) const {
  option_->check(number_within(least, most, "FLOAT"));
  return *this;
}

Option Option::any_number() const {
  option_->check(number_check([](double) { return true; }, "a number"));
  return *this;
}

Option Option::above_zero() const {
  option_->check(number_check([](double number) { return number > 0; }, "a number above 0"));
  return *this;
}

Option Option::zero_or_more() const {
  option_->check(number_check([](double number) { return number >= 0; }, "0 or more"));
  return *this;
}

Option Option::in_units(const Units& units) const {
  const auto convert = [=](std::string& text) -> std::string {
    const auto end =
        std::min(text.find_last_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"), text.size());
    const auto digits = end == text.size() ? "" : text.substr(0, end + 1);
    const auto number = to_number(digits);
    std::string known;
    for (const auto& [name, factor] : units) {
      if (number && *number > 0 && std::isfinite(*number) && text.substr(digits.size()) == name) {
        text = fmt::format("{}", *number * factor);
        return "";
      }
      if (!name.empty()) known += fmt::format("{}{}", known.empty() ? "" : ", ", name);
    }
    return fmt::format("'{}' is no number above 0 with one of the units {}", text, known);
  };
  option_->transform(CLI::Validator(convert, ""));
  return *this;
}

Option Option::not_empty(const std::string& what) const {
  option_->check({[=](const std::string& text) { return text.empty() ? "needs " + what : ""; }, ""});
  return *this;
}

Option Option::one_of(const std::vector<std::string>& words) const {
  option_->check(CLI::IsMember(words));
  return *this;
}

Option Option::existing_folder() const {
  option_->check(CLI::ExistingDirectory);
  return *this;
}

Option Option::excludes(const Option& other) const {
  option_->excludes(other.option_);
  return *this;
}

Option Option::separated_by(char letter) const {
  option_->delimiter(letter);
  return *this;
}

Option Option::one_value_each() const {
  option_->take_all()->allow_extra_args(false);
  return *this;
}

Option Option::value_name(const std::string& name) const {
  option_->option_text(name);
  return *this;
}

Option Option::shows_default() const {
  option_->capture_default_str();
  return *this;
}

Option Command::add_option(const std::string& names, std::string& value, const std::string& text) const {
  return Option(*app_->add_option(names, value, text));
}

Option Command::add_option(const std::string& names, int& value, const std::string& text) const {
  return Option(*app_->add_option(names, value, text));
}

Option Command::add_option(const std::string& names, std::uint64_t& value, const std::string& text) const {
  return Option(*app_->add_option(names, value, text));
}

Option Command::add_option(const std::string& names, double& value, const std::string& text) const {
  return Option(*app_->add_option(names, value, text));
}

Option Command::add_option(const std::string& names,
                           std::optional<double>& value,
                           const std::string& text) const {
  return Option(*app_->add_option(names, value, text));
}

Option Command::add_option(const std::string& names,
                           std::vector<std::string>& values,
                           const std::string& text) const {
  return Option(*app_->add_option(names, values, text));
}

Option Command::add_option(const std::string& names,
                           std::vector<int>& values,
                           const std::string& text) const {
  return Option(*app_->add_option(names, values, text));
}

Option Command::add_option(const std::string& names,
                           std::filesystem::path& value,
                           const std::string& text) const {
  return Option(*app_->add_option(names, value, text));
}

Option Command::add_option(const std::string& names,
                           std::vector<std::filesystem::path>& values,
                           const std::string& text) const {
  return Option(*app_->add_option(names, values, text));
}

Option Command::add_flag(const std::string& names, bool& value, const std::string& text) const {
  return Option(*app_->add_flag(names, value, text));
}

void Command::refuse_option(const std::string& name, const std::string& message) const {
  // Not by a check: CLI11 puts the option's name before the message, and an option that the help does not
  // list has none.
  app_->add_option_function<std::string>(
          name, [=](const std::string& /*value*/) { throw CLI::ValidationError(name, message); })
      ->expected(0, 1)
      ->group("");
}

Command Command::add_command(const std::string& name,
                             const std::string& text,
                             const std::string& group) const {
  auto* command = app_->add_subcommand(name, text);
  if (!group.empty()) command->group(group);
  return Command(*command);
}

Option Command::option(const std::string& name) const { return Option(*app_->get_option(name)); }

void Command::remove_option(const std::string& name) const { app_->remove_option(app_->get_option(name)); }

bool Command::is_given(const std::string& name) const {
  const auto* option = app_->get_option_no_throw(name);
  return option != nullptr && option->count() > 0;
}

void Command::needs_command() const { app_->require_subcommand(1); }

void Command::footer(const std::string& text) const { app_->footer(text); }

void Command::callback(const std::function<void()>& call) const { app_->callback(call); }

std::string Command::name() const { return app_->get_name(); }

std::string Command::description() const { return app_->get_description(); }

std::string Command::footer() const { return app_->get_footer(); }

std::vector<OptionText> Command::options() const {
  std::vector<OptionText> texts;
  for (const auto* option : app_->get_options())
    if (!option->get_group().empty())
      texts.push_back({option->get_snames(), option->get_lnames(), option->get_name(true),
                       option->get_description(), value_of(*option)});
  return texts;
}

std::vector<Command> Command::commands() const {
  std::vector<Command> found;
  for (auto* command : app_->get_subcommands({})) found.emplace_back(*command);
  return found;
}

std::optional<Command> Command::chosen() const {
  const auto commands = app_->get_subcommands();
  if (commands.empty()) return {};
  return Command(*commands.front());
}

Command Command::parent() const { return Command(*app_->get_parent()); }

Program::Program(const std::string& name, const std::string& description, const std::string& version)
    : app_(std::make_unique<CLI::App>(description)) {
  app_->formatter(std::make_shared<HelpFormatter>());
  app_->get_formatter()->label("SUBCOMMAND", "COMMAND");
  app_->name(name);
  app_->set_version_flag("--version", version);
}

Program::~Program() = default;

Parsed Program::parse(int argc, char** argv) const {
  try {
    app_->parse(argc, argv);
  } catch (const CLI::ExtrasError& error) {
    return {.problem = error.what(), .has_extras = true};
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) return {.problem = error.what()};
    std::ostringstream text;
    app_->exit(error, text, text);
    return {.text = text.str()};
  }
  return {};
}

}  // namespace orbs::command_line
