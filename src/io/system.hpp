// System: files, terminals and interruptions as the operating system has them.
//
// system_posix.cpp and system_windows.cpp implement it; nothing else calls the system. Paths are UTF-8. Functions that
// fail return -1, false or nothing, and error_text() then tells why.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tcb::system {

/// The arguments of main() in UTF-8, without the name of the program.
std::vector<std::string> arguments(int argc, char** argv);

/// A path in UTF-8, as it is, but with slashes where the system also has other separators.
inline std::string path_text(const std::filesystem::path& path) {
  constexpr bool has_slashes = std::filesystem::path::preferred_separator == '/';
  return has_slashes ? path.string() : path.generic_string();
}

/// The reason of the last failure in this thread.
std::string error_text();

/// Whether it was a name that exists, that a folder was read, or that a pipe without a reader was written.
bool already_exists();
bool failed_as_folder();
bool failed_as_closed_pipe();

struct FileStatus {
  bool is_regular = false;  ///< no folder, pipe or device
  std::uintmax_t size = 0;
  std::int64_t modified = 0, changed = 0;                 ///< times in the unit of the system, to compare
  std::pair<std::uint64_t, std::uint64_t> identity = {};  ///< the same for all paths of a file
  unsigned permissions = 0;

  /// Whether it is the same file, with the same size and time of modification. Where `changed` differs as well, its
  /// contents may have changed all the same, as another program may set the time of modification.
  bool seems_unmodified_since(const FileStatus& before) const {
    return identity == before.identity && size == before.size && modified == before.modified;
  }
};
std::optional<FileStatus> status_of(const std::string& path);
std::optional<FileStatus> status_of(int descriptor);
bool may_write(const std::string& path);

/// Sets the time of modification of a file just before that of another one.
void make_older(const std::string& path, const std::string& than);

// Descriptors.
inline constexpr int standard_input = 0, standard_output = 1, standard_error = 2;
int open_to_read(const std::string& path);
int open_to_write(const std::string& path);
int duplicate(int descriptor);
bool close(int descriptor);
/// Writes what the system has not yet written of a file, as far as closing it would, so that late failures are known.
bool complete(int descriptor);

/// Reads bytes as soon as there are some, and returns how many; 0 at the end.
std::ptrdiff_t read(int descriptor, char* bytes, std::size_t size);
/// Whether a pipe, socket or terminal has bytes, or has ended; waits for that, at most so long.
bool wait_to_read(int descriptor, std::chrono::milliseconds most);
/// Reads bytes at a place of a file. What read() reads next stays the same, unless it is at the end of the file.
std::ptrdiff_t read_at(int descriptor, std::uint64_t place, char* bytes, std::size_t size);
/// The place in a file where the next byte is read; 0 where it has no places.
std::uint64_t place_in(int descriptor);
bool write(int descriptor, std::string_view bytes);
bool go_to_begin(int descriptor);
bool go_to_end(int descriptor);

/// Opens standard streams that the caller closed, such that their use fails, so that no other file takes their numbers.
void keep_standard_streams();

// New files, which get their names when they are complete.

/// A file without a name, in a folder; -1 where the system has none. Permissions are as far as the umask grants them.
int create_unnamed(const std::string& folder, unsigned permissions);
bool give_name(int descriptor, const std::string& name);
int create(const std::string& name, unsigned permissions);
/// A file without a name, for reading and writing, in the folder of temporary files.
int create_temporary();
bool set_permissions(int descriptor, unsigned permissions);
/// Gives a file the name of another one, which is replaced.
bool replace(const std::string& name, const std::string& replaced);
void remove(const std::string& name);

/// Marks a new file as one that this program writes, until its descriptor is closed or the program ends, however it
/// does.
void mark_as_written(int descriptor);
/// Whether a file has a name, as it has until another program removes it.
bool has_name(int descriptor);
/// Removes a file, unless a program that writes it has marked it.
void remove_unless_written(const std::string& name);

// Terminals.
bool is_terminal(int descriptor);
/// The number of columns of the terminal on standard error; 80 if it is not known.
std::size_t terminal_width();
/// Whether the terminal on standard error shows colors.
bool has_colors();

// Interruptions.

/// Ends the process at once. A handler of signals may call it, and write().
[[noreturn]] void end_now(int exit);

/// Ends the process as a system does that ends whoever writes to a pipe without a reader.
[[noreturn]] void end_by_closed_pipe();

/// From now on signals that end the program, such as that of Ctrl-C, call `end`, which ends it, unless the caller
/// ignores them. Writing to a pipe without a reader, or beyond the limit of the size of files, is an error, no signal.
void call_when_interrupted(void (*end)());

/// As before, but in a thread of its own, so that `end` may call any function; also for the other signals that end a
/// program. Requires: no other thread runs yet.
void call_in_thread_when_interrupted(void (*end)());

}  // namespace tcb::system
