#include "server/workers.h"

#include <system_error>
#include <utility>

namespace orbs::server {

Workers::Workers(std::size_t most, std::function<void(Visitor)> answer)
    : most_(most), answer_(std::move(answer)) {}

Workers::~Workers() {
  {
    const std::lock_guard lock(mutex_);
    is_ending_ = true;
    waiting_.clear();
  }
  changed_.notify_all();
}

void Workers::add(Visitor visitor) {
  {
    const std::lock_guard lock(mutex_);
    waiting_.push_back(std::move(visitor));
    if (waiting_.size() > idle_ && threads_.size() < most_) try {
        threads_.emplace_back([this] { work(); });
      } catch (const std::system_error&) {
        // The system gives no more threads: those that there are answer, one after the other.
        if (threads_.empty()) throw;
      }
  }
  changed_.notify_one();
}

void Workers::work() {
  std::unique_lock lock(mutex_);
  for (;;) {
    ++idle_;
    changed_.wait(lock, [&] { return is_ending_ || !waiting_.empty(); });
    --idle_;
    if (is_ending_) return;
    auto visitor = std::move(waiting_.front());
    waiting_.pop_front();
    lock.unlock();
    answer_(std::move(visitor));
    lock.lock();
  }
}

}  // namespace orbs::server
