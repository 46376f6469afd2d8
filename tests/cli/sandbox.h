#pragma once

#include "image/image.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace orbs::cli_tests {

struct Answer {
  int status = 0;    // exit status
  std::string text;  // both outputs
};

/// A folder with a small suite, renderers that fail in every way, and references: what the program is run in.
/// Cases: m1_grey (M1; scenes "grey" and "v1.5"), m3_mirror (M3; scenes "mirror", "grey", and "rest" = mirror
/// - grey). The images are 12 x 8 pixels, and the references grey of 0.5 all over.
class Sandbox {
 public:
  Sandbox();
  ~Sandbox();
  Sandbox(const Sandbox&) = delete;
  Sandbox& operator=(const Sandbox&) = delete;

  const std::filesystem::path& folder() const { return folder_; }
  void write(const std::string& file, const std::string& text) const;
  std::string read(const std::string& file) const;
  bool has(const std::string& file) const { return std::filesystem::exists(folder_ / file); }
  /// Adds members to the entry of the renderer "good": `, "spp_scale": 2`.
  void add_to_good(const std::string& members) const;
  /// Folders outputs-* that are there, sorted.
  std::vector<std::string> runs() const;

  /// Runs orbs in the folder.
  Answer orbs(const std::vector<std::string>& arguments) const;
  /// Likewise, with no file that it or what it starts writes larger than that.
  Answer orbs_with_small_files(const std::vector<std::string>& arguments, std::size_t most_bytes) const;
  /// Runs a line of the shell.
  Answer shell(const std::string& line) const;

 private:
  std::filesystem::path folder_;
};

bool contains(const std::string& text, const std::string& part);

/// Puts `with` in place of the first `old` in a file of the sandbox; the test fails when there is none.
void replace_in(const Sandbox& sandbox,
                const std::string& file,
                const std::string& old,
                const std::string& with);

/// configuration.json of the sandbox: one renderer per mode of the fake renderer, called as its mode, and
/// "absent", whose program is not there. Samples are fixed. `defaults` are further members of "defaults".
std::string configuration_with(const std::string& defaults);

}  // namespace orbs::cli_tests
