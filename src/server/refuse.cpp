#include "server/refuse.h"

namespace orbs::server {

void refuse(httplib::Response& response, int status, const std::string& reason) {
  response.status = status;
  response.set_content(reason + "\n", "text/plain; charset=utf-8");
}

}  // namespace orbs::server
