#pragma once

#include <filesystem>
#include <string>

namespace orbs::run {

/// Prepares the folder of a render for the files that orbs writes there afterwards, over all that the
/// renderer has left: removes what is no regular file under a name of ours (a folder called job.json), and
/// makes sure that the folder exists and can be written to. WriteError when the disk refuses.
void make_room(const std::filesystem::path& folder);

/// Removes all that is there under this name. InputError if something stays.
void make_way(const std::filesystem::path& path);

/// The text with paths into `folder` named relative to it, and "." for the folder itself: the folder of a
/// render is moved when it is complete.
std::string named_within(const std::filesystem::path& folder, std::string text);

}  // namespace orbs::run
