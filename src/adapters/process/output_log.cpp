#include "adapters/process/output_log.h"

#include "base/error.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <fmt/format.h>

namespace orbs::adapters {

OutputLog::OutputLog(const std::filesystem::path& file, std::size_t most_bytes)
    : path_(file), half_(most_bytes / 2) {
  if (path_.empty()) return;
  file_.open(path_, std::ios::binary | std::ios::app);
  if (!file_)
    throw WriteError(fmt::format("{}: cannot be written: {}", path_.string(), std::strerror(errno)));
}

void OutputLog::append(std::string_view bytes) {
  const auto to_head = std::min(bytes.size(), half_ - head_.size());
  head_ += bytes.substr(0, to_head);
  if (!path_.empty() && !(file_ << bytes.substr(0, to_head) << std::flush))
    throw WriteError(fmt::format("{}: cannot be written: {}", path_.string(), std::strerror(errno)));
  tail_ += bytes.substr(to_head);
  // Cut at twice the allowance only, so that each byte is moved once on average.
  if (tail_.size() <= 2 * half_) return;
  left_out_ += tail_.size() - half_;
  tail_.erase(0, tail_.size() - half_);
}

std::string OutputLog::finish() {
  if (tail_.size() > half_) {
    left_out_ += tail_.size() - half_;
    tail_.erase(0, tail_.size() - half_);
  }
  const auto rest = left_out_ == 0 ? tail_ : fmt::format("\n[orbs: {} bytes left out]\n{}", left_out_, tail_);
  if (!path_.empty()) {
    file_ << rest << std::flush;
    if (!file_)
      throw WriteError(fmt::format("{}: cannot be written: {}", path_.string(), std::strerror(errno)));
  }
  return head_ + rest;
}

}  // namespace orbs::adapters
