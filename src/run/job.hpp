// Parts of jobs: the samples, tolerances, threads and messages that several products request.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "error.hpp"
#include "io/input_list.hpp"
#include "numbers/print_number.hpp"
#include "numbers/rational.hpp"
#include "run/key_options.hpp"
#include "sample/request.hpp"

namespace tcb {

struct InputCurve;
struct Schema;

/// Times or arc lengths for each group, by the contents of its texts.
using GroupedPlaces = std::map<std::vector<std::string>, std::vector<Rational>>;

/// The places of a curve's group, which `option` lists. Throws: Error (data) for a group without places.
const std::vector<Rational>& places_of_group(const GroupedPlaces& places, std::string_view option,
                                             const InputCurve& curve, const Schema& schema);

/// The samples that are requested of each curve.
struct SampleOptions {
  SamplingRequest request;
  GroupedPlaces grouped_places;             ///< instead of request.places, if groups have their own
  std::optional<Error> unless_frames = {};  ///< the samples are the frames of the input; the error where it has none

  bool takes_frames() const { return unless_frames.has_value(); }

  /// The request for one curve. Throws: Error (data) for a group without places.
  SamplingRequest of(const InputCurve& curve, const Schema& schema) const;
};

/// The largest accepted distance between two numbers, in one measure.
struct Tolerance {
  std::string column;  ///< empty: all columns without a tolerance of their own
  double most = 0;
};

/// Rows of correctly rounded numbers.
struct GoldenOptions {
  bool decimal = false;    ///< a number of the input is the decimal as written, not the double nearest to it
  Notation notation = {};  ///< in which the numbers are rounded
};

struct ThreadOptions {
  std::optional<unsigned> requested;  ///< nothing: all cores, and one to read a live pipe

  unsigned count() const;
  /// The number of threads for one input: one if it is live, as more would delay rows until later keys arrive.
  unsigned for_reading(unsigned available, bool live) const { return live && !requested ? 1 : available; }
};

/// What is printed on standard error besides errors.
struct Verbosity {
  bool quiet = false;     ///< nothing
  bool notes = false;     ///< unexpected facts about inputs
  bool progress = false;  ///< the progress, once the work takes a while
  bool color = false;     ///< places and kinds of messages are colored
};

/// What jobs have in common that make an output of each file of keys, or one of all.
struct FilesJob {
  InputListOptions files;
  KeyOptions keys;
  ThreadOptions threads;
  Verbosity verbosity;
};

}  // namespace tcb
