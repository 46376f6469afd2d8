// Images packed for many clients at once.
#include "server/image_cache.h"

#include <atomic>
#include <thread>

#include <gtest/gtest.h>

// Everybody who waited for a place gets the image, also when it is there before the place is: a client that
// was forgotten would wait for ever. The first packs only when the others have come, so that they wait.
TEST(ImageCache, GivesEveryWaitingClientItsImage) {
  constexpr int kClients = 16;
  for (int round = 0; round < 20; ++round) {
    orbs::server::ImageCache cache(1 << 20, 1);
    std::atomic<int> arrived = 0;
    std::atomic<int> served = 0;
    std::vector<std::thread> clients;
    for (int i = 0; i < kClients; ++i)
      clients.emplace_back([&] {
        ++arrived;
        const auto bytes = cache.get("image", [&] {
          while (arrived < kClients) std::this_thread::yield();
          return std::string("packed");
        });
        if (*bytes == "packed") ++served;
      });
    for (auto& client : clients) client.join();
    EXPECT_EQ(served, kClients);
  }
}
