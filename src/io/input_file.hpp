// Input files: their bytes as they arrive, and what kind of file a path is.
#pragma once

#include <string>

#include "stream/source.hpp"

namespace tcb {

/// The bytes of a file in parts as they arrive, each 256 KiB at most; "-" is standard input.
/// Throws: Error (usage) if it cannot be opened or read, or changes in the meantime.
Source<std::string> read_file(const std::string& path);

/// Standard streams that the caller closed are opened to where they fail, so that no other file takes their numbers.
void keep_standard_streams();

/// The name of a file for messages.
std::string shown_name(const std::string& path);

/// Reads from a pipe, a socket or a terminal: rows should be written as soon as they are computed.
bool is_live(const std::string& path);

/// Whether a read or write that failed, by errno, is to be repeated; waits until it may succeed.
/// `events`: those of poll() to wait for.
bool is_to_repeat(int descriptor, short events);

}  // namespace tcb
