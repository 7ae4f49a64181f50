// Unfinished files: they have no name, or another one, until they are complete; interruptions and crashes leave none.
#pragma once

#include <string>

namespace tcb {

/// Creates a file, open for writing, in the folder of `path`, and answers its descriptor, or -1 with errno set.
/// `name` becomes its name, or stays empty where the file system can do without: then nothing is left of it even
/// where the program is killed.
int create_unfinished(const std::string& path, std::string& name);

/// Gives the file its final name, in the place of any file that has it, and closes it.
/// Promises: false with errno set if that cannot be done.
bool finish(int descriptor, const std::string& name, const std::string& path);

/// Removes a file that create_unfinished() gave a name. The descriptor is left to the caller.
void discard(const std::string& name);

/// From here on SIGINT, SIGTERM and SIGHUP, where they are not ignored, remove all unfinished files and end the
/// program with Exit::interrupted. A closed pipe ends it quietly, whatever the caller ignores.
/// Requires: no other thread runs yet.
void end_when_interrupted();

}  // namespace tcb
