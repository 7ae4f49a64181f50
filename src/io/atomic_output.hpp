// Atomic outputs: standard output, and files that appear under their names when they are complete.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "io/compression.hpp"

namespace tcb {

/// The folder of the file with this name; "" if the name has none.
std::string folder_of(const std::string& path);

/// Removes the temporary files that ended programs left in a folder.
void remove_left_temporaries(const std::string& folder);

/// Creates a folder and those above it, unless they exist. Throws: Error (usage).
void make_folder(const std::string& path);

/// A descriptor for writing, and the temporary name of the file behind it, if it has one. The destructor closes the
/// descriptor, unless it is a standard stream, and removes the file.
struct OutputTarget {
  int descriptor = 1;
  bool is_file = false;        ///< a new file, which gets its final name when it is complete
  std::string temporary = {};  ///< empty also for a new file that has no name yet

  OutputTarget() = default;
  OutputTarget(const OutputTarget&) = delete;
  OutputTarget& operator=(const OutputTarget&) = delete;
  ~OutputTarget();
};

/// An output: standard output, or a file that appears under its name only when it is complete. An ending such as .gz
/// compresses it. What was written is removed unless commit() was called.
class Output {
 public:
  /// "-" is standard output. `begins_last`: the first bytes are final only when all others are written; an output
  /// without random access then gets all bytes from a temporary file. Throws: Error (usage) if it cannot be written.
  explicit Output(std::string path, bool begins_last = false);

  /// Writes in large parts, or on each call once `live` is set.
  void write(std::string_view text);
  void set_live(bool live) { live_ = live; }

  /// Writes the first bytes again, in their final form. Requires: `begins_last`.
  void write_beginning(std::string_view bytes);

  /// Writes what is pending and gives the file its name. Throws: Error (usage) if that fails.
  void commit();

 private:
  void open();
  void flush();
  void put(std::string_view text);
  void send_compressed(std::string_view bytes, bool last = false);
  void send(int descriptor, std::string_view bytes) const;
  void send_spooled();
  void give_final_name();
  [[noreturn]] void fail_to_write() const;
  std::string shown_name() const { return path_ == "-" ? "standard output" : path_; }

  std::string path_;
  OutputTarget open_;
  std::string pending_;
  std::unique_ptr<OutputTarget> spool_;        ///< all bytes, until the first ones are final
  std::optional<Compressor> compressor_ = {};  ///< of the bytes, by the ending of the path
  bool live_ = false;
};

/// From now on SIGINT, SIGTERM and SIGHUP, unless they are ignored, end the program with Exit::interrupted. A pipe
/// without a reader ends it without a message where it is an output, even if the caller ignores SIGPIPE; messages that
/// nobody reads are lost. An output beyond the limit of the size of files is an error, not a signal.
void end_when_interrupted();

/// From now on a thread waits for these signals and for the others that end a program, such as SIGQUIT and SIGXCPU. It
/// removes all unfinished files, and ends the program with Exit::interrupted.
/// Requires: no other thread runs yet.
void remove_unfinished_when_interrupted();

}  // namespace tcb
