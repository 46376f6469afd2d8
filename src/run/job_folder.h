#pragma once

#include <filesystem>
#include <string>

namespace orbs::run {

/// Makes `folder` and those above it, which renderers can reach from `within` on. What is no folder there in
/// the place of one, as the symbolic link that a renderer has put there, is removed first: else we would
/// write where it leads. True if there was such a thing. WriteError when the disk refuses.
bool make_own_folder(const std::filesystem::path& within, const std::filesystem::path& folder);

/// Prepares the folder of a render for the files that orbs writes there afterwards, whatever the renderer has
/// left: removes what is no regular file under a name of ours (a folder called job.json), takes from its
/// files the rights to act as another user (set-user-ID and such), and makes sure that the folder exists and
/// can be written to. What make_own_folder returns. WriteError when the disk refuses.
bool make_room(const std::filesystem::path& within, const std::filesystem::path& folder);

/// Removes all that is there under this name. InputError if something stays.
void make_way(const std::filesystem::path& path);

/// The text with paths into `folder` named relative to it, and "." for the folder itself: the folder of a
/// render is moved when it is complete.
std::string named_within(const std::filesystem::path& folder, std::string text);

}  // namespace orbs::run
