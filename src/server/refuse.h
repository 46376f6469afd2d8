#pragma once

#include <string>

#include <httplib.h>

namespace orbs::server {

/// A plain answer with this status.
void refuse(httplib::Response& response, int status, const std::string& reason);

}  // namespace orbs::server
