// Unfinished files have another name until they are complete; interruptions leave none, and the next run clears up.
#pragma once

#include <sys/types.h>

#include <string>

namespace tcb {

/// Creates a file, open for writing and with these permissions as far as the umask grants them, beside `path`, and
/// answers its descriptor, or -1 with errno set. `name` becomes its name: that of `path` with a dot in front and
/// ".tcbsample" behind. The program holds a lock on it, so another one leaves it alone; where none is held, a program
/// was killed, and its file is replaced.
int create_unfinished(const std::string& path, mode_t permissions, std::string& name);

/// Gives the file its final name, in the place of any file that has it. The descriptor is left to the caller.
/// Promises: false with errno set if that cannot be done, or if writing it failed after all.
bool finish(int descriptor, const std::string& name, const std::string& path);

/// Removes the file that create_unfinished() made. The descriptor, which has the lock, is to be closed later.
void discard(const std::string& name);

/// From here on SIGINT, SIGTERM and SIGHUP, where they are not ignored, remove all unfinished files and end the
/// program with Exit::interrupted. A closed pipe ends it quietly, whatever the caller ignores.
/// Requires: no other thread runs yet.
void end_when_interrupted();

}  // namespace tcb
