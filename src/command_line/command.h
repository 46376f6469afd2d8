#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): the name is the library's
class App;
class Option;
}  // namespace CLI

/// The command lines of our programs. Only command.cpp includes CLI11, whose headers take a compiler ten
/// seconds.
namespace orbs::command_line {

/// Names and factors; "" where none is needed.
using Units = std::vector<std::pair<std::string, double>>;
/// In seconds.
inline const Units kTimes{{"s", 1}, {"", 1}, {"m", 60}, {"h", 3600}};

/// An option or an argument of a command, for as long as its command lives. Each call says more about it.
class Option {
 public:
  explicit Option(CLI::Option& option) : option_(&option) {}

  Option required() const;
  Option range(int least, int most) const;
  Option range(double least, double most) const;
  /// Accept any finite number, one above 0, or one from 0 up. CLI11's own checks print the range up to the
  /// largest double, with all of its 309 digits, and let "nan" pass.
  Option any_number() const;
  Option above_zero() const;
  Option zero_or_more() const;
  /// A finite number above 0, with one of these units behind it; the value is in that whose factor is 1.
  Option in_units(const Units& units) const;
  /// Refuses the empty text, which would count as an option that is not given. `what` is what the option
  /// needs: "a folder".
  Option not_empty(const std::string& what) const;
  Option one_of(const std::vector<std::string>& words) const;
  Option existing_folder() const;
  Option excludes(const Option& other) const;
  /// One text may hold several values, with this letter between them.
  Option separated_by(char letter) const;
  /// Each time that it is given brings one value.
  Option one_value_each() const;
  /// What stands for the value in the help: "FOLDER".
  Option value_name(const std::string& name) const;
  /// The help shows the value that the variable has now.
  Option shows_default() const;

 private:
  CLI::Option* option_;
};

/// What the help says of an option: {"o"}, {"output"}, "-o,--output". An argument has no short or long name.
struct OptionText {
  std::vector<std::string> short_names, long_names;
  std::string name;
  std::string description;
  std::string value;  // what stands for its value, "FOLDER"; "" for a flag
};

/// A program, or a command of one, for as long as its Program lives.
class Command {
 public:
  explicit Command(CLI::App& app) : app_(&app) {}

  /// Add an option, "-o,--output", or an argument, "folder". `value` must live as long as the program.
  Option add_option(const std::string& names, std::string& value, const std::string& text) const;
  Option add_option(const std::string& names, int& value, const std::string& text) const;
  Option add_option(const std::string& names, std::uint64_t& value, const std::string& text) const;
  Option add_option(const std::string& names, double& value, const std::string& text) const;
  Option add_option(const std::string& names, std::optional<double>& value, const std::string& text) const;
  Option add_option(const std::string& names,
                    std::vector<std::string>& values,
                    const std::string& text) const;
  Option add_option(const std::string& names, std::vector<int>& values, const std::string& text) const;
  Option add_option(const std::string& names, std::filesystem::path& value, const std::string& text) const;
  Option add_option(const std::string& names,
                    std::vector<std::filesystem::path>& values,
                    const std::string& text) const;
  /// "--log,!--no-log": --no-log sets it to false.
  Option add_flag(const std::string& names, bool& value, const std::string& text) const;
  /// An option of earlier versions: not in the help, and refused with this message whatever its value is.
  void refuse_option(const std::string& name, const std::string& message) const;
  Command add_command(const std::string& name, const std::string& text, const std::string& group = "") const;

  /// The option of this long name, which there must be.
  Option option(const std::string& name) const;
  void remove_option(const std::string& name) const;
  /// True if the command has this option and the user gave it.
  bool is_given(const std::string& name) const;

  void needs_command() const;
  void footer(const std::string& text) const;
  /// Called after all options are read, if the command is chosen.
  void callback(const std::function<void()>& call) const;

  std::string name() const;
  std::string description() const;
  std::string footer() const;
  std::vector<OptionText> options() const;
  std::vector<Command> commands() const;
  /// The one of its commands that the user chose.
  std::optional<Command> chosen() const;
  Command parent() const;

 private:
  CLI::App* app_;
};

/// What became of a command line.
struct Parsed {
  std::string text{};       // of --help or --version, to be printed in place of any work
  std::string problem{};    // in the words of CLI11; "": none
  bool has_extras = false;  // the problem: words that belong to no option
};

/// A program with its options and commands.
class Program {
 public:
  /// `version` is what --version prints.
  Program(const std::string& name, const std::string& description, const std::string& version);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  Command command() const { return Command(*app_); }
  /// Fills the variables of the options, and calls the callback of the chosen command.
  Parsed parse(int argc, char** argv) const;

 private:
  std::unique_ptr<CLI::App> app_;
};

}  // namespace orbs::command_line
