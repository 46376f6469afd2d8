#pragma once

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <string>

namespace orbs::server {

/// Packed images that were asked for lately. Packing takes memory for the decoded image, so only a few
/// are packed at a time and the others wait, however many clients ask.
class ImageCache {
 public:
  ImageCache(std::size_t most_bytes, int most_at_a_time) : most_bytes_(most_bytes), free_(most_at_a_time) {}

  using Bytes = std::shared_ptr<const std::string>;
  /// What is kept under `key`, or what `pack` returns, which is then kept. What `pack` throws passes through.
  Bytes get(const std::string& key, const std::function<std::string()>& pack);

 private:
  struct Entry {
    std::string key;
    Bytes bytes;
  };
  Bytes find(const std::string& key);
  void keep(const std::string& key, const Bytes& bytes);

  std::size_t most_bytes_;
  int free_;  // places for packing
  std::mutex mutex_;
  std::condition_variable freed_;
  std::list<Entry> entries_;  // the last used first
  std::size_t bytes_ = 0;
};

}  // namespace orbs::server
