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
#include "picture/picture.hpp"
#include "run/job.hpp"
#include "run/sample_options.hpp"
#include "write/writer.hpp"

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
  WriterOptions output{.format = &formats().front()};
  PictureOptions picture;
  ThreadOptions threads;
  std::optional<Generated> generated;
  ColorWhen color = ColorWhen::by_terminal;
  std::optional<std::size_t> form = {};  ///< the field with the cubics of pieces

  bool has(std::string_view option) const { return !text(option).empty(); }
  /// The value of an option as typed, or "" if the option is not given. For a list in a file: its numbers.
  const std::string& text(std::string_view option) const;
  void set_text(std::string_view option, std::string text);

  /// Whether a text is printed, so that no other value is read.
  bool wants_text() const;

 private:
  std::vector<std::pair<std::string_view, std::string>> texts_;  ///< by name, of the options that are given
};

}  // namespace tcb
