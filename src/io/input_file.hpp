// Input files: their bytes as they arrive, what kind of file a path is, and SHA-256 of bytes.
//
// Source: FIPS 180-4; computed by Nettle.
#pragma once

#include <sys/stat.h>

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "stream/source.hpp"

namespace tcb {

/// The bytes of a file in parts as they arrive, each at most 256 KiB; "-" is standard input.
/// Throws: Error (usage) if it cannot be opened or read, or changes in the meantime.
Source<std::string> read_file(const std::string& path);

/// Opens standard streams that the caller closed, such that their use fails, so that no other file takes their numbers.
void keep_standard_streams();

/// The name of a file for messages.
std::string shown_name(const std::string& path);

/// Whether it is standard input from a terminal.
bool is_terminal(const std::string& path);

/// Whether it is a pipe, a socket or a terminal: rows should be written as soon as they are computed.
bool is_live(const std::string& path);

/// Tells whether a file changes, by its size, its modification time and its change time. Standard input, pipes and
/// devices do not count as changing.
class ChangeWatch {
 public:
  /// Watches from now on. A file that does not exist now does not count as changing.
  explicit ChangeWatch(std::string path);
  bool has_changed() const;

 private:
  std::string path_;
  std::optional<struct stat> before_;
};

/// Whether a failed read or write has to be repeated, by errno; waits until it may succeed.
/// `events`: those of poll() to wait for.
bool is_to_repeat(int descriptor, short events);

class Sha256 {
 public:
  Sha256();
  Sha256(Sha256&&) noexcept;
  Sha256& operator=(Sha256&&) noexcept;
  ~Sha256();

  void add(std::string_view bytes);

  /// The checksum of all bytes so far, in 64 hexadecimal digits; the next bytes begin a new one.
  std::string digest();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace tcb
