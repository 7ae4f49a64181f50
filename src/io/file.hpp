// Files: bytes in as they come; bytes out, whole or not at all.
#pragma once

#include <cstdio>
#include <memory>
#include <string>
#include <string_view>

#include "stream/stream.hpp"

namespace tcb {

/// The bytes of a file in pieces as they arrive, each 256 KiB at most; "-" is standard input.
/// Throws: Error (usage) if it cannot be opened or read.
Source<std::string> read_file(const std::string& path);

/// Standard streams that the caller closed are opened to where they fail, so that no other file takes their numbers.
void keep_standard_streams();

/// The name of a file for messages.
std::string shown_name(const std::string& path);

/// Reads from a pipe, a socket or a terminal: rows should be written as soon as they are known.
bool is_live(const std::string& path);

/// The folder that a file of this name is in; "" where the name alone says.
std::string folder_of(const std::string& path);

/// Makes a folder and those above it, where they are not there yet. Throws: Error (usage).
void make_folder(const std::string& path);

/// Where output goes: standard output, or a file that appears under its name only when it is complete.
class Output {
 public:
  /// "-" is standard output. `begins_last`: the first bytes are known when all others are written; what cannot go back
  /// to its beginning gets the bytes then, from a temporary file. Throws: Error (usage) if one cannot be written to.
  explicit Output(std::string path, bool begins_last = false);
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;
  /// Removes what was written if commit() was not reached.
  ~Output();

  /// Text goes out in large pieces, or with each call once `live` is set.
  void write(std::string_view text);
  void set_live(bool live) { live_ = live; }

  /// The first bytes once more, as they are to be. Requires: `begins_last`.
  void write_beginning(std::string_view bytes);

  /// Everything is out, and the file stands under its name. Throws: Error (usage) if it cannot be.
  void commit();

 private:
  void open();
  void flush();
  void put(std::string_view text);
  void remove();
  void send(int descriptor, std::string_view bytes) const;
  void send_spooled();
  [[noreturn]] void fail(const char* what) const;

  std::string path_;
  std::string temporary_;    ///< its name until it is complete, if it needs one
  bool unfinished_ = false;  ///< it is to get its name when it is complete
  std::string pending_;
  int descriptor_ = 1;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> spool_{nullptr, std::fclose};  ///< where all bytes wait
  bool live_ = false;
};

}  // namespace tcb
