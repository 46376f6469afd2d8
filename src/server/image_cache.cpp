#include "server/image_cache.h"

#include <algorithm>

namespace orbs::server {

ImageCache::Bytes ImageCache::find(const std::string& key) {
  const auto at =
      std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) { return entry.key == key; });
  if (at == entries_.end()) return nullptr;
  entries_.splice(entries_.begin(), entries_, at);
  return at->bytes;
}

void ImageCache::keep(const std::string& key, const Bytes& bytes) {
  if (bytes->size() > most_bytes_ || find(key)) return;
  entries_.push_front({key, bytes});
  bytes_ += bytes->size();
  while (bytes_ > most_bytes_) {
    bytes_ -= entries_.back().bytes->size();
    entries_.pop_back();
  }
}

ImageCache::Bytes ImageCache::get(const std::string& key, const std::function<std::string()>& pack) {
  std::unique_lock lock(mutex_);
  if (auto found = find(key)) return found;
  freed_.wait(lock, [&] { return free_ > 0; });
  // Another request may have packed the same image meanwhile.
  if (auto found = find(key)) return found;
  --free_;
  lock.unlock();
  const auto give_back = [&] {
    lock.lock();
    ++free_;
    // Wakes all: a request that finds its image kept by now packs nothing, and would leave the others
    // waiting.
    freed_.notify_all();
  };
  try {
    const auto bytes = std::make_shared<const std::string>(pack());
    give_back();
    keep(key, bytes);
    return bytes;
  } catch (...) {
    give_back();
    throw;
  }
}

}  // namespace orbs::server
