#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace orbs::adapters {

/// Output of a program, bounded: the first half of the allowance as it comes (so that the file can be
/// followed while the program runs), and of what comes later the last half.
class OutputLog {
 public:
  /// `file` may be empty: memory only. What it holds already stays, for the seeds of a job share their log.
  /// WriteError, here and below, when the disk refuses.
  OutputLog(const std::filesystem::path& file, std::size_t most_bytes);
  void append(std::string_view bytes);
  /// Writes what is still held back and returns all that was kept.
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
