// Input format: the half of a format that reads it. Each is defined in one file of a room of readers, and a row of
// formats/formats.cpp names it.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "read/input.hpp"
#include "read/input_options.hpp"
#include "schema/format.hpp"
#include "stream/source.hpp"

namespace tcb {

struct InputFormat {
  /// Opens an input. Requires: the bytes have no byte order mark. Throws: Error (data).
  Records (*open)(const Format& format, Source<std::string> bytes, InputOptions options);

  /// The options with what the format decides, unless it is requested; null: nothing. The beginning of the bytes may be
  /// read.
  InputOptions (*options)(const Format& format, Source<std::string>& bytes, InputOptions given) = nullptr;

  /// Whether a file begins as those of this format alone, whatever its name is; null: no file does.
  bool (*begins)(std::string_view beginning) = nullptr;

  /// How well a text fits, where its name tells no format or several: 0 is not at all, and the best fit counts, the
  /// first of equal ones. Nothing: that depends on what follows. null: no text does.
  std::optional<int> (*fit)(std::string_view beginning) = nullptr;

  bool has_tracks = false;       ///< of several objects, of which --only chooses
  bool takes_delimiters = true;  ///< options of delimited text are no error
  bool has_own_columns = false;  ///< the format names its columns
  bool has_frames = false;       ///< a file may have samples of its own, so that no sampling option is needed
};

}  // namespace tcb
