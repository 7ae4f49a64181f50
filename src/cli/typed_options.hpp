// Typed options: the options that a command line gives, and their values, each by itself.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "check/comparison.hpp"
#include "fit/fit_options.hpp"
#include "formats/formats.hpp"
#include "io/input_list.hpp"
#include "io/terminal.hpp"
#include "limits/limit_options.hpp"
#include "picture/picture.hpp"
#include "run/job.hpp"
#include "write/writer_options.hpp"

namespace tcb {

/// Texts that --generate prints instead of rows.
enum class Generated { manual, curves, bash, zsh, fish, columns, positions, tables };

/// A column of a file that has the times or arc lengths of an option.
struct PlaceColumn {
  std::string_view option;  ///< its name
  std::string path, name;
};

/// The times or arc lengths of the option that has them.
struct PlacesOption {
  std::vector<Rational> list;  ///< or else by group:
  bool in_seconds = false;     ///< the list has durations, as in 30min
  GroupedPlaces grouped = {};
  std::optional<PlaceColumn> column = {};  ///< until it is read
  bool from_input = false;                 ///< they are read from standard input
};

/// The values of the options, each by itself; make_job decides what they mean together. An option is identified by its
/// name, a constant of option_names.hpp.
struct TypedOptions {
  InputListOptions files;
  bool fail_fast = false;
  KeyOptions keys;
  SamplingRequest sampling;
  PlacesOption places;
  FitOptions fit;
  Comparison comparison;
  LimitOptions limits;
  WriterOptions output{.format = &formats().front()};
  PictureOptions picture;
  ThreadOptions threads;
  std::optional<Generated> generated;
  ColorWhen color = ColorWhen::by_terminal;
  std::optional<std::size_t> form = {};  ///< the field with the cubics of pieces

  bool golden = false, exact_input = false;
  bool meta = false;
  std::string from_meta = {};  ///< an earlier output
  bool explain = false, progress = false, no_progress = false, quiet = false;
  bool list_presets = false, version = false, help = false;

  /// Whether an option is given.
  bool has(std::string_view option) const { return find(option) != nullptr; }
  /// The value of an option as messages and provenance show it; "" of a flag, and where it is not given.
  std::string value(std::string_view option) const;
  /// Notes that an option is given, or has another value.
  void give(std::string_view option, std::string value = {});

  /// Whether a text is printed, so that no other value is read.
  bool wants_text() const { return help || list_presets || version || generated; }

 private:
  struct Given {
    std::string_view option;  ///< its name
    std::string value;        ///< as typed; of a list in a file its numbers
  };
  const Given* find(std::string_view option) const;

  std::vector<Given> given_;
};

/// Throws: Error (usage) for unknown options, and for values that are wrong in themselves. `color`: where errors are
/// shown, which is set before the first that is about a value.
TypedOptions read_options(const std::vector<std::string>& given, ColorWhen* color = nullptr);

}  // namespace tcb
