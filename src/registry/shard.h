#pragma once

#include <string>

namespace orbs::registry {

/// A part of the renders of a run: 3/16 is the third of sixteen. 1/1 is all of them.
struct Shard {
  int index = 1;  // from 1 to count
  int count = 1;
};

/// Reads "3/16". InputError saying what can be read.
Shard parse_shard(const std::string& text);

/// "3/16".
std::string shard_text(const Shard& shard);

/// As fields() write and read it.
inline std::string to_text(const Shard& shard) { return shard_text(shard); }
inline void from_text(const std::string& text, Shard& shard) { shard = parse_shard(text); }

}  // namespace orbs::registry
