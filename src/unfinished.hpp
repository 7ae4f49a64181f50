// Unfinished files: they have other names until they are complete, and are removed when the program is interrupted.
#pragma once

#include <string>

namespace tcb {

/// Creates a file, open for writing, in the folder of `path`, and answers its descriptor, or -1 with errno set.
/// `name` becomes its name.
int create_unfinished(const std::string& path, std::string& name);

/// The file has its final name, or is to be removed now.
/// Promises: false with errno set if it cannot be renamed.
bool finish(const std::string& name, const std::string& path);
void discard(const std::string& name);

/// From here on SIGINT, SIGTERM and SIGHUP, where they are not ignored, remove all unfinished files and end the
/// program with Exit::interrupted. A closed pipe ends it quietly, whatever the caller ignores.
/// Requires: no other thread runs yet.
void end_when_interrupted();

}  // namespace tcb
