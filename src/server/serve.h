#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace orbs::server {

struct ServeSettings {
  std::vector<std::filesystem::path> runs;  // at least one; the first is what the page opens with
  std::filesystem::path bundle;             // folder of the built page
  std::string address = "127.0.0.1";
  int port = 0;                               // 0: any that is free
  std::chrono::milliseconds head_time{5000};  // that a client has for its request
};

/// True for the addresses that only this machine reaches: 127.0.0.0/8 and ::1.
bool is_loopback_address(const std::string& address);

/// Serves the runs read-only until `stop` is set; `ready` gets the address of the page as soon as it answers.
/// InputError when a folder is no run, the page is not built, or the address cannot be taken.
void serve(const ServeSettings& settings,
           const std::atomic<bool>& stop,
           const std::function<void(const std::string& url)>& ready);

}  // namespace orbs::server
