#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace orbs::server {

struct ServeSettings {
  std::vector<std::filesystem::path> runs;  // and studies, at least one; the page opens with the first
  std::filesystem::path bundle;             // folder of the built page
  std::string address = "127.0.0.1";
  int port = 0;                                  // 0: any free port
  std::chrono::milliseconds head_timeout{5000};  // for a client to send its request
};

/// True for the addresses that only this machine can reach: 127.0.0.0/8 and ::1.
bool is_loopback_address(const std::string& address);

/// Serves the runs read-only until `stop` is set; `ready` gets the address of the page as soon as it answers.
/// InputError if a folder is neither run nor study, the page is not built, or the address cannot be
/// bound.
void serve(const ServeSettings& settings,
           const std::atomic<bool>& stop,
           const std::function<void(const std::string& url)>& ready);

}  // namespace orbs::server
