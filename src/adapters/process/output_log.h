#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace orbs::adapters {

/// Output of a program, bounded: the first half of the allowance is written as it arrives, so that the file
/// can be followed while the program runs; of all later output the last half is kept.
class OutputLog {
 public:
  /// `file` may be empty: memory only. An existing file is continued, for the seeds of a job share their log.
  /// WriteError, here and below, when the disk refuses.
  OutputLog(const std::filesystem::path& file, std::size_t most_bytes);
  void append(std::string_view bytes);
  /// Writes the part that is still held back and returns all that was kept.
  std::string finish();

 private:
  std::filesystem::path path_;
  std::ofstream file_;
  std::size_t half_;
  std::string head_;
  std::string tail_;
  std::size_t left_out_ = 0;
};

}  // namespace orbs::adapters
