// Shown times: how rows show their times.
#include "write/shown_times.hpp"

#include <algorithm>

#include "error.hpp"
#include "numbers/decimal_time.hpp"
#include "numbers/print_number.hpp"
#include "schema/pose_formats.hpp"
#include "schema/units.hpp"
#include "text/utf8.hpp"

namespace tcb {

TimeNotation notation_of_times(const WriterOptions& options, const TimeSchema& time) {
  const auto given = options.time_notation;
  if (!options.format->offers(offer::words_of_time)) return TimeNotation::seconds;
  if (!given) return options.time_zero && is_date(time.notation) ? TimeNotation::seconds : time.notation;
  const bool drops = given == TimeNotation::smpte && time.notation == TimeNotation::drop_frame;
  return drops ? TimeNotation::drop_frame : *given;
}

ShownTimes::ShownTimes(const WriterOptions& options, const TimeSchema& time, bool are_kept)
    : rate_(options.frame_rate.value_or(1)), are_json_(options.format->is_json), decimal_(options.decimal) {
  if (const PoseFormat* const poses = options.format->poses) {
    if (!poses->unit && !are_kept) return;
    if (time.unit == TimeUnit::frames) throw times_without_rate(time.name);
    are_of_poses_ = true;
    are_whole_ = poses->unit == TimeUnit::ns;
    if (!time.unit && time.notation == TimeNotation::seconds && are_whole_) {
      throw data_error(
          "the times in column {} have no known unit, but those of {} are in nanoseconds; expected a unit; give "
          "--time-unit s if they are seconds",
          in_quotes(time.name), options.format->name);
    }
    unit_ = units_per_second(poses->unit.value_or(TimeUnit::s)) / units_per_second(time.unit.value_or(TimeUnit::s));
    is_converted_ = unit_ != 1 && !are_kept;
    return;
  }
  const bool is_given = options.time_notation.has_value();
  if (options.time_zero && is_given && is_date(*options.time_notation)) {
    throw usage_error(
        "times that count from --time-zero are not dates; expected another notation; give --time-format seconds, or "
        "neither");
  }
  if (is_given && time.unit == TimeUnit::frames) throw times_without_rate(time.name);
  const TimeUnit unit = is_given ? time.unit.value_or(TimeUnit::s) : TimeUnit::s;
  unit_ = Rational(1) / units_per_second(unit);
  notation_ = notation_of_times(options, time);
  if (are_kept) return;
  is_converted_ = notation_ == TimeNotation::frames || unit_ != 1;
  if (notation_ == TimeNotation::seconds || notation_ == TimeNotation::frames) return;
  const bool is_fixed = options.notation.kind == Notation::Kind::fixed;
  const auto decimals = is_fixed ? std::optional(options.notation.count) : std::nullopt;
  words_.emplace(notation_, rate_, decimals, is_given ? DateFormat() : time.dates, unit);
}

/// A time as another number.
Time ShownTimes::converted(const Time& time) const {
  const Rational seconds = exact_time(time) * unit_;
  Rational number = seconds;
  if (notation_ == TimeNotation::frames) {  // between frames that of the double, whose error is the smaller
    number = whole_frame(seconds, rate_).value_or(Rational(time.hi) * unit_ * rate_);
  }
  if (are_whole_) number = floor(number + Rational(1, 2));
  const Time nanoseconds = nearest_time(number, 9);  // poses have them in seconds
  return are_of_poses_ && exact_time(nanoseconds) == number ? nanoseconds : nearest_time(number);
}

void ShownTimes::Texts::append(std::string& out, const Time& time) {
  const auto begin = static_cast<std::ptrdiff_t>(out.size());
  if (!words_) {
    append_time(out, times_.converted(time));
    if (times_.decimal_ != '.') std::replace(out.begin() + begin, out.end(), '.', times_.decimal_);
    return;
  }
  if (times_.are_json_) out += '"';  // of words without characters that JSON would escape
  if (!words_->append(out, time)) {
    const TimeNotation notation = times_.notation_;
    const char* const name = notation == TimeNotation::clock ? "clock" : is_date(notation) ? "a date" : "timecode";
    throw data_error(
        "the time {} of a row cannot be written as {}; expected a time that is not before 0 and is at a frame for "
        "timecode, and a year from 0 to 9999 for a date; give --time-format seconds",
        time_text(time), name);
  }
  if (times_.are_json_) {
    out += '"';
  } else if (times_.decimal_ != '.') {
    const auto colon = std::find(out.rbegin(), out.rend() - begin, ':').base();
    if (colon != out.begin() + begin) std::replace(colon, out.end(), '.', times_.decimal_);
  }
}

}  // namespace tcb
