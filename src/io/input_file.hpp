// Input files: their bytes as they arrive, and what kind of file a path is.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "io/system.hpp"
#include "stream/source.hpp"

namespace tcb {

/// The bytes of an input, and whether more of them arrive without a long wait: at once from a file, and from a pipe
/// until it was waited for a second in total.
struct InputBytes {
  Source<std::string> bytes;
  std::function<bool()> arrive;
};

/// Opens a file; "-" is standard input. Its parts have at most 256 KiB each. The beginning of a pipe is gathered as far
/// as it comes without a pause, so that its parts are those of a file; later parts come as they arrive.
/// Throws: Error (usage) if it cannot be opened or read, or its contents change in the meantime. Other links, another
/// name or mode of a file are no change.
InputBytes open_file(const std::string& path);
inline Source<std::string> read_file(const std::string& path) { return open_file(path).bytes; }

/// The name of a file for messages.
std::string shown_name(const std::string& path);

/// Whether it is standard input from a terminal.
bool is_terminal(const std::string& path);

/// Whether it is a pipe, a socket or a terminal: rows should be written as soon as they are computed.
bool is_live(const std::string& path);

/// What changed of a file; the last: its contents, or only its links, name or mode.
enum class FileChange { none, contents, contents_or_status };

/// Tells whether a file changes, by its size, its modification time and its change time. Standard input, pipes and
/// devices do not count as changing.
class ChangeWatch {
 public:
  /// Watches from now on. A file that does not exist now does not count as changing.
  explicit ChangeWatch(std::string path);
  FileChange change() const;

 private:
  std::string path_;
  std::optional<system::FileStatus> before_;
};

}  // namespace tcb
