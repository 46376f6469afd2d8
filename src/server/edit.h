#pragma once

#include "server/site.h"

namespace orbs::server {

/// Answers one admitted POST: shows what an edit makes of the user's configuration file, or writes it.
void answer_edit(Site& site, const Request& request, Response& response);

}  // namespace orbs::server
