#pragma once

#include "studies/probe_record.h"

#include <string>
#include <vector>

namespace orbs::studies {

/// True if the renderer gave both images and no pixel shows a wrong object or wrong coordinates.
bool is_mapped_right(const ProbeRecord& record);

/// "ok", or what differs: "scene mapping differs: instance 'box', material 'red' (412 pixels, first at (3,
/// 7), where there is nothing)".
std::string probe_message(const ProbeRecord& record);

/// The record for programs: a JSON list, one entry for each scene and renderer.
std::string probe_json(const std::vector<ProbeRecord>& records);

}  // namespace orbs::studies
