// Shown times: how rows show their times.
#pragma once

#include <optional>
#include <string>

#include "numbers/dates.hpp"
#include "numbers/rational.hpp"
#include "numbers/time_notation.hpp"
#include "schema/schema.hpp"
#include "write/writer_options.hpp"

namespace tcb {

/// The notation in which rows show times.
TimeNotation notation_of_times(const WriterOptions& options, const TimeSchema& time);

class ShownTimes {
 public:
  /// The numbers of the rows, as they are.
  ShownTimes() = default;

  /// Times of keys as an output shows them. Those of poses are numbers in the unit of their format; without a known
  /// unit they are taken as seconds. `are_kept`: the format keeps the numbers of rows, and has a unit. Throws: Error
  /// (data) for frames without a rate.
  ShownTimes(const WriterOptions& options, const TimeSchema& time, bool are_kept);

  bool are_as_they_are() const { return !words_ && !is_converted_; }

  /// Of the shown times in that of the keys.
  const Rational& unit() const { return unit_; }

  /// The texts of times, one after another.
  class Texts {
   public:
    /// Requires: `times` outlives it.
    explicit Texts(const ShownTimes& times) : times_(times), words_(times.words_) {}

    /// Appends a time. Throws: Error (data) where the notation does not have it.
    void append(std::string& out, const Time& time);

   private:
    const ShownTimes& times_;
    std::optional<TimeWords> words_;
  };

 private:
  Time converted(const Time& time) const;

  TimeNotation notation_ = TimeNotation::seconds;
  std::optional<TimeWords> words_;  ///< nothing: times are numbers
  bool is_converted_ = false;       ///< they are other numbers than those of the rows
  Rational unit_ = 1, rate_ = 1;
  bool are_whole_ = false;  ///< they are rounded to whole numbers
  bool are_of_poses_ = false;
  bool are_json_ = false;
  char decimal_ = '.';
};

}  // namespace tcb
