// File notes: what is reported about an input, from its first bytes to its last curve.
#include "run/file_notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "io/encoding.hpp"
#include "io/input_file.hpp"
#include "keys/curves.hpp"
#include "numbers/dates.hpp"
#include "numbers/decimal_time.hpp"
#include "numbers/print_number.hpp"
#include "read/input.hpp"
#include "run/curve_pipeline.hpp"
#include "run/gap_rows.hpp"
#include "run/key_options.hpp"
#include "sample/curve_spec.hpp"
#include "sample/grid.hpp"
#include "sample/table.hpp"
#include "schema/doubts.hpp"
#include "schema/usual_names.hpp"
#include "tcb/spline/rules.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

template <class... Args>
Note important(fmt::format_string<Args...> text, Args&&... args) {
  return {fmt::format(text, std::forward<Args>(args)...), true};
}

/// A frame rate was given as a decimal such as 29.97, which stands for a ratio.
Note broadcast_note(const std::string& decimal, const Rational& rate) {
  return important("the frame rate {} is taken as {}; give {} for exactly {}", decimal, ratio_text(rate),
                   ratio_text(parse_rational(decimal).value_or(rate)), decimal);
}

/// The columns of positions where they follow from their names, and these tell little; else nothing. A format that has
/// columns of its own needs no names.
std::vector<std::string> found_by_elimination(const Input& input) {
  const Schema& schema = input.schema;
  if (input.facts.format->input->has_own_columns || !schema.named) return {};
  const std::vector<std::string> names = moving_channels(schema);
  return std::ranges::all_of(names, is_usual_channel) ? std::vector<std::string>{} : names;
}

/// The columns of positions from the least to the largest one, as in "2-4", where they are requested by two numbers
/// that may be meant as a range; else empty.
std::string range_of_numbers(const ColumnOptions& requested) {
  std::vector<std::size_t> numbers;
  for (const RoleRequest& request : requested.roles) {
    if (request.role != Role::position) continue;
    for (const std::string& column : request.columns) numbers.push_back(in_digits<std::size_t>(column).value_or(0));
  }
  const bool is_range = numbers.size() == 2 && numbers[0] > 0 && numbers[0] + 1 < numbers[1];
  return is_range ? fmt::format("{}-{}", numbers[0], numbers[1]) : "";
}

/// What doubts look at in a request.
RequestNeeds needs_of(const Input& input, const KeyOptions& options, const SamplingRequest& request,
                      std::span<const std::size_t> chosen) {
  RequestNeeds needs;
  needs.lengths = by_length(request) || options.rules.equal_speed ||
                  std::ranges::any_of(chosen, [](std::size_t field) { return fields()[field].over_metric; });
  const bool is_of_format = !input.facts.format->offers(offer::marks) && !input.facts.format->is_json;
  needs.chooses_metric = options.rules.metric || input.keys.curve_info.settings.metric || is_of_format;
  needs.time_gap = input.facts.time_gap;
  needs.is_rate = request.is_rate;
  needs.range_like_clock = request.range_like_clock;
  needs.shown_rate = input.facts.shown_rate;
  if (request.mode == Mode::step && request.step > 0) {  // else nothing is requested
    (request.in_seconds.step ? needs.step : needs.plain_step) = nearest_double(request.step);
  }
  return needs;
}

/// An input, and what is requested of it.
struct NotedInput {
  const Input& input;
  const KeyOptions& options;
  const SamplingRequest& request;
  std::span<const std::size_t> fields;

  const TimeSchema& time() const { return input.schema.time; }
  bool chooses_positions() const {
    return std::ranges::count(options.input.columns.roles, Role::position, &RoleRequest::role) > 0;
  }
  /// Of rows, or of the period of the keys.
  bool has_duration() const {
    const auto& period = options.rules.period;
    return request.in_seconds.has_duration || (period && period->value.in_seconds);
  }
};

using MaybeNote = std::optional<Note>;

MaybeNote on_encoding(const NotedInput& noted) {
  const std::string& encoding = noted.input.facts.encoding;
  if (encoding.empty()) return std::nullopt;
  if (encoding != name_of(Encoding::windows_1252)) {
    return important("the text is in {}, and was converted to UTF-8", encoding);
  }
  const std::string_view named = noted.input.keys.traits.has_whole_curves ? "objects and tracks" : "columns";
  return important("names of {} are not in UTF-8; they are taken as {}", named, encoding);
}

MaybeNote on_index(const NotedInput& noted) {
  if (noted.input.facts.shape != JsonShape::table_by_index) return std::nullopt;
  return important("the index of the table is taken as the time");
}

MaybeNote on_list(const NotedInput& noted) {
  const std::string& records = noted.input.facts.records;
  if (!noted.options.input.records.empty() || records.empty()) return std::nullopt;
  return important("the keys are the list {}; --records takes another one", in_quotes(records));
}

MaybeNote on_quaternion(const NotedInput& noted) {
  if (!noted.input.facts.names_quaternion) return std::nullopt;
  return important(
      "columns x, y, z and w after x, y and z are taken as the quaternion qx, qy, qz, qw; --rotation none takes them "
      "as positions");
}

MaybeNote on_missing_times(const NotedInput& noted) {
  if (noted.time().is_given || noted.options.rules.parameter) return std::nullopt;
  const bool are_shown =
      std::ranges::any_of(noted.fields, [](std::size_t field) { return fields()[field].kind == CellKind::time; });
  return Note{"there is no time column; the times of the keys are 0, 1, 2, ...",
              are_shown || noted.request.is_rate || noted.request.in_seconds.has_duration};
}

MaybeNote on_zone(const NotedInput& noted) {
  if (noted.time().notation != TimeNotation::date) return std::nullopt;
  return important("the dates in column \"{}\" have no zone; they are taken as UTC", noted.time().name);
}

MaybeNote on_short_years(const NotedInput& noted) {
  if (!noted.time().dates.has_short_year) return std::nullopt;
  return important("the years of two digits in column \"{}\" are taken as 1969 to 2068", noted.time().name);
}

MaybeNote on_rate_of_keys(const NotedInput& noted) {
  const UnitOptions& units = noted.options.input.units;
  if (units.rate_as_decimal.empty()) return std::nullopt;
  return broadcast_note(units.rate_as_decimal, *units.frame_rate);
}

MaybeNote on_rate_of_rows(const NotedInput& noted) {
  const std::string& decimal = noted.request.rate_as_decimal;
  if (decimal.empty() || decimal == noted.options.input.units.rate_as_decimal) return std::nullopt;
  return broadcast_note(decimal, Rational(1) / noted.request.step);
}

MaybeNote on_radians(const NotedInput& noted) {
  const RotationOptions& rotation = noted.options.input.rotation;
  const auto has_angles = [](const GivenRotation& given) {  // the length of a vector is in radians by convention
    return given.notation.has_angles() && given.notation.form != spline::RotationForm::rotation_vector;
  };
  if (rotation.degrees || std::ranges::none_of(rotation.requests, has_angles)) return std::nullopt;
  return important("the angles of rotations are taken as radians; --angles degrees gives the other unit");
}

MaybeNote on_unit_of_times(const NotedInput& noted) {
  const TimeSchema& time = noted.time();
  if (time.epoch_unit) {
    return important(
        "the times in column \"{0}\" may be {1} since 1970; --time-unit {1} says so, and rates and durations are then "
        "in seconds",
        time.name, row_of(*time.epoch_unit).name);
  }
  if (!noted.has_duration() || time.unit) return std::nullopt;
  return important(
      "the unit of the times in column {} is unknown; they are taken as seconds; --time-unit gives another one",
      noted.input.schema.named ? in_quotes(time.name) : "1");
}

MaybeNote on_positions(const NotedInput& noted) {
  if (noted.chooses_positions() || !noted.options.input.renamings.empty()) return std::nullopt;
  const std::vector<std::string> names = found_by_elimination(noted.input);
  if (names.empty()) return std::nullopt;
  return important("positions: {}; --columns ignore=NAME leaves one out", listed(names));
}

MaybeNote on_other_tracks(const NotedInput& noted) {
  const std::vector<std::string>& tracks = noted.input.facts.other_tracks;
  if (tracks.empty()) return std::nullopt;
  return important("left out, as they have other channels: {}; --only reads them", listed(tracks));
}

MaybeNote on_constant_tracks(const NotedInput& noted) {
  const std::vector<std::string>& tracks = noted.input.facts.constant_tracks;
  if (tracks.empty()) return std::nullopt;
  return important("left out, as they have a single key: {}; --only reads them", listed(tracks));
}

MaybeNote on_ignored(const NotedInput& noted) {
  if (noted.input.facts.ignored.empty()) return std::nullopt;
  const std::string ignored = listed(noted.input.facts.ignored);
  if (!noted.chooses_positions()) {
    return important("ignored: {}; --columns gives them roles, as in carry=NAME or position=NAME:NAME", ignored);
  }
  const std::string numbers = range_of_numbers(noted.options.input.columns);
  if (numbers.empty()) return Note{fmt::format("ignored, as --columns chooses others: {}", ignored)};
  return important("left out, as --columns chooses others: {}; position={} takes all columns between", ignored,
                   numbers);
}

/// The notes on an input, in the order in which they are told.
constexpr std::array notes_on_input{
    on_encoding,      on_index,       on_list,         on_quaternion,      on_missing_times,
    on_zone,          on_short_years, on_rate_of_keys, on_rate_of_rows,    on_radians,
    on_unit_of_times, on_positions,   on_other_tracks, on_constant_tracks, on_ignored};

}  // namespace

FileNotes::FileNotes(Report& report, const std::string& path) : report_(report), path_(path) {
  if (is_terminal(path)) add({"keys are read from the terminal; end them with Ctrl-D, or name a file"});
}

void FileNotes::add_input(const Input& input, const KeyOptions& options, const SamplingRequest& request,
                          std::span<const std::size_t> fields) {
  for (const std::string& doubt : input.facts.doubts) add({doubt, true});
  for (const std::string& doubt : doubts_of_request(input.schema, needs_of(input, options, request, fields))) {
    add({doubt, true});
  }
  for (const auto note_on : notes_on_input) {
    if (const MaybeNote note = note_on({input, options, request, fields})) add(*note);
  }
  time_ = input.schema.time;
  channels_ = input.schema.channels;
  has_nulls_ = input.facts.format->is_json;
  skips_cells_ = options.input.keys.missing == Missing::skip_cell;
}

Note angles_note(const std::vector<NamedAngle>& angles) {
  std::string list;
  std::vector<std::string_view> names;
  for (const auto& [name, degrees] : angles) {
    list += fmt::format("{}{}={}", list.empty() ? "" : ",", name, degrees ? "degrees" : "radians");
    names.push_back(name);
  }
  const bool may_be_euler = std::ranges::all_of(
      std::array{"yaw", "pitch", "roll"}, [&](std::string_view name) { return std::ranges::count(names, name) > 0; });
  const std::string euler = may_be_euler ? ", or --rotation euler=yaw:pitch:roll,order=ZYX as a rotation" : "";
  return important("angles seem to jump by more than half a turn; --angle {} turns them the shorter way{}",
                   in_shell(list), euler);
}

Note remainder_note(double distance, bool at_key) {
  constexpr std::size_t most_digits = 9;
  std::string shown = fmt::format("{}", distance);
  if (shown.size() > most_digits) shown = fmt::format("{:.6g}", distance);
  return important("{} is {} after the last row; --end keep or --end fit includes it",
                   at_key ? "the last key" : "the end of the range", shown);
}

void FileNotes::add_samples(const CurveSamples& samples, const SamplingRequest& request, bool is_closed) {
  const auto distance = samples.remainder();
  const bool ends_at_key = !request.to && !is_closed;
  is_open_ = is_open_ || !is_closed;
  if (distance && remainders_++ == 0) add(remainder_note(nearest_time(*distance).hi, ends_at_key));
  if (samples.gap_rows != nullptr) add_gap_rows(*samples.gap_rows);
  channel_gaps_.resize(channels_.size());
  for (const spline::ChannelGap& gap : samples.gaps) ++channel_gaps_[gap.channel];
  if (samples.facts.rows) {
    rows_ += *samples.facts.rows;
    least_rows_ += *samples.facts.least_rows;
  }
  if (samples.facts.step && request.end != EndPolicy::drop) {
    add({fmt::format("the step is {}", time_text(*samples.facts.step))});
  }
}

std::vector<Note> notes_of_rules(const Curves& curves, const KeyOptions& options) {
  const CurveSettings& rules = options.rules;
  const ObservedTcbs& tcbs = curves.tcbs();
  std::vector<Note> notes;
  std::vector<std::string> unused;
  const bool has_own_rules = rules.tangents || rules.preset;  // in place of those of the input
  if (is_linear(rules) ? tcbs.any() : !has_own_rules && tcbs.any_linear())
    unused.emplace_back("tension, continuity and bias of the keys");
  if (is_linear(rules) && tcbs.has_named_ends()) unused.emplace_back("the ends that the file names");
  if (!unused.empty())
    notes.push_back(important("the tangents are linear: {} have no effect", fmt::join(unused, ", and ")));
  const bool has_usual_ends = !rules.preset && !rules.ends && !is_linear(rules) && !rules.closed && !rules.period;
  if (has_usual_ends && !options.input.keys.tcb && tcbs.at_ends()) {
    notes.push_back(
        important("keys from --fit of 0.4 need --preset gte, as ends are one-sided now; --ends one-sided says so"));
  }
  return notes;
}

void FileNotes::end(const Curves& curves, const KeyOptions& rules) {
  for (const Note& note : notes_of_rules(curves, rules)) add(note);
  end(curves);
}

void FileNotes::add_gap_rows(GapRows& gap_rows) {
  const std::optional<RowsInGaps> found = gap_rows.found();
  if (!found || curves_with_gap_rows_++ > 0) return;
  const bool is_one = found->rows == 1;
  add(
      important("{} {} between keys that are more than 30 times the usual step apart, at most from {} to {}; --max-gap "
                "{} begins a new curve there",
                is_one ? "1 row" : fmt::format("{} rows", found->rows), is_one ? "is" : "are",
                shown_time(time_, found->from), shown_time(time_, found->to), text(found->max_gap)));
}

void FileNotes::end(const Curves& curves) {
  if (remainders_ > 1) {
    add(important("a remainder is also left in {} more curves", remainders_ - 1));
  }
  if (curves_with_gap_rows_ > 1) {
    const std::uint64_t more = curves_with_gap_rows_ - 1;
    add(important("rows are also between such keys of {} more {}", more, more == 1 ? "curve" : "curves"));
  }
  for (std::size_t i = 0; i < channel_gaps_.size(); ++i) {
    const std::uint64_t gaps = channel_gaps_[i];
    if (gaps == 0) continue;
    add(important("channel {} is empty in {} between its keys that {} longer than --max-gap", in_quotes(channels_[i]),
                  gaps == 1 ? "1 gap" : fmt::format("{} gaps", gaps), gaps == 1 ? "is" : "are"));
  }
  if (rows_ > 0) {
    add(important("{} rows; any polyline within the tolerance has at least {}", rows_, least_rows_));
  }
  if (curves.skipped() > 0) {
    add({fmt::format("rows skipped for missing numbers: {}", curves.skipped())});
  }
  if (const auto held = curves.channels().without_ends(); skips_cells_ && is_open_ && !held.empty()) {
    add(important(
        "at the first or the last key there is no number in {}; before and after its keys a channel keeps the "
        "nearest one; --missing skip-row leaves such rows out",
        listed(held)));
  }
  if (const std::uint64_t gaps = curves.gaps(); gaps > 0) {
    add(important("{} between keys {} a new curve; the largest is {}",
                  gaps == 1 ? "1 gap" : fmt::format("{} gaps", gaps), gaps == 1 ? "begins" : "begin",
                  curves.largest_gap()));
  }
  if (const std::uint64_t breaks = has_nulls_ ? curves.breaks() : 0; breaks > 0) {
    add(important("null in place of a key begins a new curve{}; remove it where a curve goes on",
                  breaks == 1 ? "" : fmt::format(", {} times", breaks)));
  }
  if (curves.midnights() > 0) {
    add(important("the times in column \"{}\" pass midnight, and count on from 24:00:00", time_.name));
  }
  if (const auto angles = curves.channels().likely_angles(); !angles.empty()) add(angles_note(angles));
  if (const auto signs = curves.channels().likely_signs(); !signs.empty()) {
    std::vector<std::string> names, numbers;
    for (const LikelySign& sign : signs) {
      names.push_back(sign.channel);
      const std::string number = fmt::format("{}", sign.number);
      if (std::ranges::count(numbers, number) == 0) numbers.push_back(number);
    }
    add(important("{} in {} may stand for a missing number; --na={} --missing skip-cell leaves it out", listed(numbers),
                  listed(names), fmt::join(numbers, ",")));
  }
}

std::string shown_time(const TimeSchema& schema, const Time& time) {
  const Rational exact = exact_time(time), rate = schema.frame_rate.value_or(1);
  const bool is_number = schema.notation == TimeNotation::seconds || schema.notation == TimeNotation::frames;
  const auto decimals = floor(exact) == exact ? std::nullopt : std::optional(3);
  const auto words = is_number ? std::nullopt : TimeWords(schema.notation, rate, decimals, schema.dates).text(time);
  return words.value_or(time_text(time));
}

std::string number_in_words(const Rational& value) { return fmt::format("{}", nearest_time(value).hi); }

Facts rules_in_words(const CurveSpec& spec) {
  const spline::CurveRules<double>& rules = spec.rules;
  Facts words{{"tangents", std::string(name_of(rules.tangents))}};
  if (spec.closed) {
    words.emplace_back("closed", "yes");
  } else {
    words.emplace_back("ends", fmt::format("{}, {}", name_of(rules.start.rule), name_of(rules.end.rule)));
  }
  if (rules.timing != spline::Timing::even) words.emplace_back("timing", std::string(name_of(rules.timing)));
  if (rules.equal_speed) words.emplace_back("equal speed", "yes");
  if (rules.no_overshoot) words.emplace_back("overshoot", "none");
  if (spec.extrapolations.extend_curve()) {
    const auto& [before, after] = spec.extrapolations;
    words.emplace_back("extrapolation", before == after ? std::string(name_of(before))
                                                        : fmt::format("{}, {}", name_of(before), name_of(after)));
  }
  if (!rules.rotations.empty()) {
    const auto& [curve, tangents, ends] = rules.rotation_rules;
    words.emplace_back("rotation curve", std::string(name_of(curve)));
    if (tangents) words.emplace_back("rotation tangents", std::string(name_of(*tangents)));
    if (ends && !spec.closed) words.emplace_back("rotation ends", std::string(name_of(*ends)));
  }
  if (!spec.timed) {
    const std::string made = spec.parameter ? spec.parameter->name : "uniform";
    words.emplace_back("times", fmt::format("none; made with --parameter {}", made));
  }
  return words;
}

Facts preset_in_words(const CurveSpec& spec) {
  Facts words{{"preset", std::string(spline::name_of(spec.preset))}};
  const Facts rules = rules_in_words(spec);
  words.insert(words.end(), rules.begin(), rules.end());
  return words;
}

namespace {

std::string pace_in_words(const Pace& pace) {
  if (pace.profile != nullptr) return pace.profile->are_parts ? "parts of the length" : "arc lengths";
  if (pace.is_constant()) return "a constant speed";
  return fmt::format("a speed that rises in {} of the duration, and falls in {}", ratio_text(pace.rise),
                     ratio_text(pace.fall));
}

}  // namespace

std::string samples_in_words(const SamplingRequest& request) {
  if (request.pace) {
    SamplingRequest times = request;
    times.pace.reset();
    return fmt::format("{}; at {}{}", samples_in_words(times),
                       request.pace->profile == nullptr ? "" : "the times of a profile of ",
                       pace_in_words(*request.pace));
  }
  const std::string_view of = by_length(request.mode) ? "arc length" : "time";
  switch (request.mode) {
    case Mode::step:
      if (request.is_rate) return fmt::format("{} per unit of time", number_in_words(Rational(1) / request.step));
      [[fallthrough]];
    case Mode::arc_step: return fmt::format("every {} of {}", number_in_words(request.step), of);
    case Mode::arc_count:
    case Mode::count: return fmt::format("{}, equally spaced in {}", request.count, of);
    case Mode::intervals: return fmt::format("{} equal intervals of time", request.count);
    case Mode::per_segment: return fmt::format("{} equal intervals in every segment", request.count);
    case Mode::at:
    case Mode::arc_at:
      return request.places.empty() ? fmt::format("at places in {} for each group", of)
                                    : fmt::format("at {} places in {}", request.places.size(), of);
    case Mode::emit: return "the cubic of each segment";
    case Mode::tolerance: {
      const auto& [distance, angle] = request.tolerance;
      if (!request.tolerance.limits_angle()) return fmt::format("within {} of the curve", distance);
      if (!request.tolerance.limits_distance()) return fmt::format("rotations within {} radians", angle);
      return fmt::format("within {} of the curve, rotations within {} radians", distance, angle);
    }
  }
  return "";
}

}  // namespace tcb
