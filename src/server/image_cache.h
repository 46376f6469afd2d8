#pragma once

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <string>

namespace orbs::server {

/// The packed images that were requested most recently. Packing needs memory for the decoded image, so only a
/// few are packed at the same time and further requests wait.
class ImageCache {
 public:
  ImageCache(std::size_t most_bytes, int most_at_a_time) : most_bytes_(most_bytes), free_(most_at_a_time) {}

  using Bytes = std::shared_ptr<const std::string>;
  /// The image kept under `key`, or else the result of `pack`, which is then kept. Exceptions of `pack` pass
  /// through.
  Bytes get(const std::string& key, const std::function<std::string()>& pack);

 private:
  struct Entry {
    std::string key;
    Bytes bytes;
  };
  Bytes find(const std::string& key);
  void keep(const std::string& key, const Bytes& bytes);

  std::size_t most_bytes_;
  int free_;  // images that may still be packed now
  std::mutex mutex_;
  std::condition_variable freed_;
  std::list<Entry> entries_;  // the most recently used first
  std::size_t bytes_ = 0;
};

}  // namespace orbs::server
