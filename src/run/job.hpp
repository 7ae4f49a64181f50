// Everything that one run of the program has to do.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "fit/fit.hpp"
#include "keys/curves.hpp"
#include "numbers/print_number.hpp"
#include "plot/scene.hpp"
#include "read/input_options.hpp"
#include "sample/request.hpp"
#include "schema/formats.hpp"
#include "stream/ordered_map.hpp"
#include "write/provenance.hpp"

namespace tcb {

/// Files besides those of the command line, and how all of them are processed.
struct BatchOptions {
  std::string list;        ///< a file that names files; "-": standard input; empty: none
  bool nul = false;        ///< the names in the list end in NUL, not in a new line
  bool recursive = false;  ///< a folder means the files in it
  std::string suffix;      ///< of the outputs' names, before the ending
  bool update = false;     ///< skips files with outputs that are not older
  bool fail_fast = false;  ///< stops at the first file that fails
};

/// The largest accepted distance between two numbers, in one measure.
struct Tolerance {
  std::string column;  ///< empty: all columns without a tolerance of their own
  double most = 0;
};

/// The times or arc lengths of samples, by the contents of the texts of groups.
using GroupedPlaces = std::map<std::vector<std::string>, std::vector<Rational>>;

/// A request to compare the samples of a file with the curve instead of printing samples.
struct Comparison {
  std::string file;                      ///< of the samples; "-" is standard input
  bool identify = false;                 ///< rank the conventions by agreement with them; otherwise check them
  std::vector<Tolerance> abs, rel, ulp;  ///< a number has to be within one of the three
  std::vector<Renaming> maps = {};       ///< of the columns of the file
};

/// Rows of correctly rounded numbers.
struct GoldenOptions {
  bool decimal = false;    ///< a number of the input is the decimal as written, not the double nearest to it
  Notation notation = {};  ///< in which the numbers are rounded
};

/// What is printed on standard error besides errors.
struct Verbosity {
  bool quiet = false;     ///< nothing
  bool notes = false;     ///< unexpected facts about inputs
  bool progress = false;  ///< the progress, once the work takes a while
  bool color = false;     ///< places and kinds of messages are colored
};

/// How the curves are drawn, where the output is a picture.
struct PictureOptions {
  std::vector<std::string> axes;     ///< two channels by name or number; none: the first two metric ones
  std::optional<std::string> title;  ///< nothing: the name of the file
  PictureSize size;
};

/// Keys for recordings, where the mode is Mode::fit.
struct FitOptions {
  std::vector<Tolerance> tolerances;
  std::optional<double> angle;  ///< of rotations from the samples, in radians; nothing: they are not fitted
  FitKeys keys = FitKeys::tcb;
  std::optional<double> corner;  ///< in degrees
};

/// Everything that one run of the program is to do.
struct Job {
  std::vector<std::string> files;  ///< "-" is standard input
  BatchOptions batch;
  InputOptions input;
  CurveOptions curves;
  CurveSettings curve;
  SamplingRequest sampling;
  FitOptions fit;
  GroupedPlaces grouped_places;          ///< instead of sampling.places, where curves have their own
  std::vector<std::size_t> fields;       ///< indices into fields(), in output order; none: those of the comparison
  std::optional<Comparison> comparison;  ///< instead of printing samples
  FormatId output_format = FormatId::csv;
  std::optional<bool> output_header;
  std::optional<GoldenOptions> golden;        ///< rows are exact, and rounded once
  std::optional<TimeNotation> time_notation;  ///< of the output; nothing: that of the input
  Notation notation;                          ///< of numbers that may have a fraction
  std::optional<ProvenanceRequest> meta;      ///< the output has its provenance
  PictureOptions picture;
  bool explain = false;          ///< print what was detected and would be done, no rows
  std::optional<unsigned> jobs;  ///< threads; nothing: all cores, one for a live pipe
  Verbosity verbosity;
  std::optional<std::string> file_column;    ///< the name of a column with the name of the input
  std::string output = "-";                  ///< one output for all files, or
  std::optional<std::string> output_folder;  ///< one for each, in this folder

  /// Outputs are files, which are unfinished for a while.
  bool writes_files() const { return output != "-" || output_folder; }
  /// The number of threads to use.
  unsigned threads() const { return jobs.value_or(available_threads()); }
};

}  // namespace tcb
