#pragma once

#include "server/editor.h"
#include "server/socket.h"

#include <atomic>
#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace orbs::server {

struct ServeSettings {
  std::vector<std::filesystem::path> runs;  // and studies, at least one; the page opens with the first
  std::filesystem::path bundle;             // folder of the built page
  std::string address = "127.0.0.1";
  int port = 0;                                     // 0: any free port
  std::chrono::milliseconds request_timeout{5000};  // for a client to send its request
  std::optional<Editor> editor{};                   // whoever has the page's whole address may use it
};

/// Serves the runs until `stop` is set; `ready` gets the address of the page as soon as it answers. Nothing
/// is written but through an editor. InputError if there is an editor and the address is no loopback address,
/// a folder is neither run nor study, the page is not built, or the address cannot be bound.
void serve(const ServeSettings& settings,
           const std::atomic<bool>& stop,
           const std::function<void(const std::string& url)>& ready);

}  // namespace orbs::server
