// Options: the table of names, texts, defaults, and how each value is stored.
#include "cli/options.hpp"

#include <algorithm>
#include <tuple>

#include "cli/values.hpp"
#include "fit/fit.hpp"
#include "formats/formats.hpp"
#include "sample/extrapolation.hpp"
#include "sample/request.hpp"
#include "tcb/spline/rules.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

using Typed = TypedOptions;
using Text = const std::string&;
using enum ValueKind;

constexpr auto fit_key_names = std::to_array<Named<FitKeys>>({{"tcb", FitKeys::tcb}, {"hermite", FitKeys::hermite}});
constexpr auto retiming_names = std::to_array<Named<bool>>({{"slower", false}, {"fit", true}});
constexpr auto closing_names = std::to_array<Named<bool>>({{"yes", true}, {"no", false}});
constexpr auto side_names = std::to_array<Named<bool>>({{"right", false}, {"left", true}});

/// For an option whose value is asked for by has() or value().
void only_given(Typed&, Text) {}

constexpr std::string_view expects_time_zero =
    "is not a time; expected a number in the unit of the times of the keys, or first";

/// The value of a time or a step, whose unit is noted.
Rational stored_time(SamplingRequest& sampling, std::string_view words, Text text, bool InSeconds::*member) {
  TimeValue time = time_value(words, text);
  sampling.in_seconds.*member = time.in_seconds;
  sampling.in_seconds.has_duration |= time.in_seconds;
  return std::move(time.value);
}

/// A bound of the samples, which may also be a date or a time of day.
Rational stored_bound(Typed& typed, Text text, bool InSeconds::*member) {
  const std::optional<Rational> seconds = seconds_in_words(typed.keys.input.units, text);
  if (!seconds) return stored_time(typed.sampling, expects_ratio, text, member);
  typed.sampling.in_seconds.*member = typed.sampling.in_seconds.has_duration = true;
  return *seconds;
}

void set_rate(SamplingRequest& sampling, const Rational& rate, Text text) {
  sampling.mode = Mode::step;
  sampling.is_rate = sampling.in_seconds.step = true;
  sampling.step = step_of_rate(rate, text);
}

// Products whose output an option may change.
constexpr Products any_product = 2 * of_explained_samples - 1;
constexpr Products explains = of_explanation | of_explained_samples, checks = of_check | of_expected_rows;
constexpr Products printed = of_samples | of_pieces | of_fit, pictures = of_picture | of_drawn_samples;
constexpr Products of_any_rows = of_samples | of_pieces | checks;
constexpr Products in_folders = printed | pictures;
constexpr Products retimed = of_samples | of_pieces | pictures;
constexpr Products placed = of_samples | of_expected_rows | of_drawn_samples | of_explained_samples;
constexpr Products but(int others) { return static_cast<Products>(any_product & ~others); }

constexpr OptionRow option_rows[] = {
    {"--output-dir", "", "DIR", files_group, in_folders,
     "Writes one output for each input into the folder DIR, with the ending of the output format",
     "", folder, [](Typed& to, Text text) { to.files.outputs.folder = text; }},
    {"--files", "", "LIST", files_group, in_folders | explains,
     "Reads further names of files from LIST, one per line; - reads LIST from standard input",
     "", file, [](Typed& to, Text text) { to.files.list = text; }},
    {"--null", "-0", "", files_group, in_folders | explains,
     "The names in LIST end with NUL instead of a line end",
     "", flag, [](Typed& to, Text) { to.files.nul = true; }},
    {"--recursive", "", "", files_group, in_folders | explains,
     "A folder means all files below it whose ending names a format, or with --input-format all files below it; DIR "
     "gets the same tree",
     "", flag, [](Typed& to, Text) { to.files.recursive = true; }},
    {"--suffix", "", "S", files_group, in_folders,
     "Appends S to the name of each output, before the ending; an S such as _s.csv.gz is the end of the name, and names "
     "the format",
     "", other, [](Typed& to, Text text) { to.files.outputs.suffix = name_part(text); }},
    {"--update", "", "", files_group, in_folders,
     "Skips inputs that are not newer than their outputs",
     "", flag, [](Typed& to, Text) { to.files.update = true; }},

    {"--check", "", "FILE", comparison_group, checks,
     "Compares the samples in FILE, made by any program, with the curve, and prints a report. With a sampling "
     "option, a missing or surplus row is a difference as well",
     "", file, [](Typed& to, Text text) { to.comparison.file = text; }},
    {"--abs", "", "[COL=]D,...", comparison_group, checks,
     "With --check: the largest accepted difference between two numbers, in all columns, or in one, as in x=1e-6",
     "", other, [](Typed& to, Text text) { to.comparison.abs = tolerances(text); }},
    {"--rel", "", "[COL=]D,...", comparison_group, checks,
     "With --check: the largest accepted difference as a fraction of the number on the curve",
     "", other, [](Typed& to, Text text) { to.comparison.rel = tolerances(text); }},
    {"--ulp", "", "[COL=]N,...", comparison_group, checks,
     "With --check: the largest accepted difference in units in the last place, the steps between neighbouring "
     "doubles",
     "0", other, [](Typed& to, Text text) { to.comparison.ulp = tolerances(text); }},
    {"--map", "", "THEIRS=OURS,...", comparison_group, checks | of_identify,
     "Renames columns of FILE before they are compared, as in frame_time=t,px=x",
     "", other, [](Typed& to, Text text) { to.comparison.maps = renamings(text); }},
    {"--identify", "", "FILE", comparison_group, of_identify,
     "Finds the rules, and the order and signs of T, C, B, that produce the positions in FILE, and prints a ranked "
     "table",
     "", file, [](Typed& to, Text text) { to.comparison.file = text; }},
    {"--limits", "", "[=LIST]", comparison_group, of_limits | retimed,
     "Prints the largest speed, acceleration and jerk of each curve, and of each channel the range and the largest "
     "velocity, acceleration and jerk: a value that is attained, and a bound that is not exceeded. LIST chooses "
     "some, with limits, as in speed=2,acceleration_x=5,velocity_y=-1:2,position_z=0:3",
     "all", attached, [](Typed& to, Text text) { to.limits.limits = limit_list(text); }},
    {"--retime", "", "[=fit]", comparison_group, retimed,
     "With limits, prints samples at times that are scaled by the smallest factor of at least 1 by which all limits "
     "hold; with fit by the smallest factor, so that the curve may also become faster",
     "slower", attached,
     [](Typed& to, Text text) { to.limits.fits = named_row(retiming_names, text).value; }},

    {"--input-format", "-i", "FORMAT", input_group, any_product,
     "The format of the input: @NAMES@; see tcbsample-input(5). By default it follows from the first bytes and the "
     "ending of the file",
     "", name, [](Typed& to, Text text) { to.keys.input.format = format_with(&Format::can_read, text); },
     [] { return formats_with(&Format::can_read); }},
    {"--delimiter", "-d", "CHAR", input_group, any_product,
     "The character between cells, or tab, comma, semicolon, space or pipe; by default the first of tab, semicolon, "
     "comma, pipe and space that occurs in the first record",
     "", name,
     [](Typed& to, Text text) { to.keys.input.delimited.delimiter = delimiter(text); }, names_in<delimiter_names>},
    {"--header", "", "", input_group, any_product,
     "The first record names the columns; by default it does so if one of its cells is not a number",
     "", flag, [](Typed& to, Text) { to.keys.input.delimited.header = true; }},
    {"--no-header", "", "", input_group, any_product,
     "The first record is a key",
     "", flag, [](Typed& to, Text) { to.keys.input.delimited.header = false; }},
    {"--comment", "", "PREFIX", input_group, any_product,
     "Skips lines that begin with PREFIX; none skips no lines",
     "#", other, [](Typed& to, Text text) { to.keys.input.delimited.comment = text == "none" ? "" : text; }},
    {"--skip-lines", "", "N", input_group, any_product,
     "Skips the first N lines, which are not part of the table",
     "", other,
     [](Typed& to, Text text) { to.keys.input.delimited.skipped_lines = count_between(text, 0, INT64_MAX); }},
    {"--columns", "", "ROLE=NAME,...", input_group, any_product,
     "The roles of columns, by name or number, as in time=frame,position=px:py:pz,tension=k,carry=label. By default "
     "they follow from the header; without a header, the first column is the time, and the others are positions",
     "", roles,
     [](Typed& to, Text text) {
       auto roles = parse_roles(text);
       to.keys.input.columns.roles.insert(to.keys.input.columns.roles.begin(), roles.begin(), roles.end());
     }},
    {"--tcb", "", "T,C,B", input_group, but(of_fit),
     "Tension, continuity and bias of keys for which the input has none",
     "0,0,0", other, [](Typed& to, Text text) { to.keys.input.keys.tcb = tcb_values(text); }},
    {"--tcb-scale", "", "SCALE", input_group, but(of_fit),
     "The scale of tension, continuity and bias: 3dsmax converts 0 to 50 into -1 to 1; none, the default, takes "
     "them as they are",
     "", name,
     [](Typed& to, Text text) { to.keys.input.keys.tcb_scale = named_row(tcb_scales, text).value; },
     names_in<tcb_scales>},
    {"--decimal", "", "MARK", input_group, any_product,
     "The decimal mark of numbers, a point or a comma; by default a comma if the numbers of the first keys have one, "
     "and no point",
     "", other,
     [](Typed& to, Text text) {
       to.keys.input.delimited.marks.decimal = decimal_mark(text);
       to.keys.input.delimited.has_decimal = true;
     }},
    {"--thousands", "", "CHAR", input_group, any_product,
     "The mark between groups of three digits: a character, or comma, point, apostrophe, underscore or space",
     "", name,
     [](Typed& to, Text text) { to.keys.input.delimited.marks.thousands = thousands_mark(text); },
     names_in<thousands_names>},
    {"--group", "-g", "COL[,COL]", input_group, any_product,
     "Makes one curve of all rows with the same values in these columns, in any order; output rows begin with these "
     "columns",
     "", other,
     [](Typed& to, Text text) {
       to.keys.input.columns.roles.push_back({Role::group, column_list(text), "--group"});
     }},
    {"--only", "", "PATTERN,...", input_group, any_product,
     "Reads only these tracks of a file with several objects: OBJECT or OBJECT/TRACK, with * and ?",
     "", other,
     [](Typed& to, Text text) {
       for (const std::string_view pattern : split(text, ',')) to.keys.input.only.emplace_back(pattern);
     }},
    {"--records", "", "PATH", input_group, any_product,
     "Reads the list of keys at this path in JSON, such as data.result[0].values; with * for any name, each list is "
     "a curve",
     "", other, [](Typed& to, Text text) { to.keys.input.records = text; }},
    {"--max-memory", "", "SIZE", input_group, any_product,
     "Fails if a file that must be kept in memory as a whole needs more, such as 512MiB or 4GiB",
     "1GiB", other, [](Typed& to, Text text) { to.keys.input.max_memory = memory_size(text); }},
    {"--missing", "", "POLICY", input_group, any_product,
     "What happens to a cell that is empty or marks a missing number, such as NA: error rejects it; skip-row skips "
     "the key; skip-cell interpolates the channel through its other keys; break begins a new curve after it",
     "error", name,
     [](Typed& to, Text text) { to.keys.input.keys.missing = named_row(missing_names, text).value; },
     names_in<missing_names>},
    {"--na", "", "TEXT,...", input_group, any_product,
     "Further texts that mark a missing number, besides NA, nan, null, - and the like",
     "", other, [](Typed& to, Text text) { to.keys.input.keys.signs = column_list(text); }},
    {"--time-unit", "", "UNIT", input_group, any_product,
     "The unit of times: s, ms, us, ns, min, h, d or frames; --rate is then per second. By default the name of the "
     "column tells the unit, as in time_ms. With min, times such as 06:45 are hours and minutes",
     "", name,
     [](Typed& to, Text text) { to.keys.input.units.time = named_row(time_units, text).unit; }, names_in<time_units>},
    {"--input-fps", "", "HZ", input_group, any_product,
     "Converts times from frame numbers at HZ frames per second, such as 24 or 30000/1001, to seconds; HZ as for "
     "--fps. Where no column is the time, as with --parameter uniform, row i of a curve is at i/HZ",
     "", other,
     [](Typed& to, Text text) {
       UnitOptions& units = to.keys.input.units;
       units.frame_rate = frame_rate(text);
       if (*units.frame_rate > most_frames_per_second)
         throw usage_error("{} is too large a rate; expected at most 1000000000 frames per second", in_quotes(text));
       (void)step_of_rate(*units.frame_rate, text);
       if (broadcast_rate(text)) units.rate_as_decimal = text;
     }},
    {"--date-order", "", "ORDER", input_group, any_product,
     "The order of dates that do not tell it: dmy or mdy where the year is last, as in 01.02.2024; also ymd where "
     "years have two digits, which are 1969 to 2068",
     "", name,
     [](Typed& to, Text text) { to.keys.input.units.date_order = named_row(date_orders, text).order; },
     names_in<date_orders>},
    {"--time-start", "", "T", input_group, any_product,
     "The time of the first row where --input-fps gives rows their times: seconds, a date, a time of day or timecode",
     "0", other,
     [](Typed& to, Text text) {
       UnitOptions& units = to.keys.input.units;
       const auto seconds = seconds_in_words(units, text);
       units.start = seconds ? *seconds : time_value(expects_ratio, text).value;
     }},
    {"--scale", "", "CHANNEL=FACTOR,...", input_group, any_product,
     "Multiplies the positions of channels by exact decimals or ratios, as in x=0.01",
     "", other, [](Typed& to, Text text) { to.keys.input.units.scales = channel_scales(text); }},
    {"--rotation", "", "FORM=COLUMN:...", input_group, any_product,
     "The columns, by name or number, that together are a rotation: quaternion=X:Y:Z:W, "
     "axis-angle=X:Y:Z:ANGLE[,relative], axis-angle=X:Y:Z whose length is the angle, euler=A:B:C,order=XYZ or "
     "matrix=M11:M12:M13:M21:M22:M23:M31:M32:M33. "
     "The name of an array of these numbers stands for all, as in quaternion=q. "
     "Repeat the option for each rotation; none takes all columns as plain channels. By default columns with names "
     "such as qx, qy, qz and qw are a rotation",
     "", other,
     [](Typed& to, Text text) {
       RotationOptions& options = to.keys.input.rotation;
       options.requests = rotations(text, options.none);
     }},
    {"--angles", "", "UNIT", input_group, any_product,
     "The unit of the angles in rotations: radians or degrees",
     "radians", name,
     [](Typed& to, Text text) { to.keys.input.rotation.degrees = named_row(angle_units, text).value; },
     names_in<angle_units>},
    {"--rotation-output", "", "FORM", input_group, Effect(of_any_rows | of_identify | explains, offer::any_columns),
     "The form of rotations in rows: quaternion, axis-angle, rotation-vector, matrix, or euler=XYZ; by default the "
     "form in the input",
     "", other, [](Typed& to, Text text) { to.keys.input.rotation.shown = rotation_form(text); }},
    {"--angle", "", "CHANNEL=UNIT,...", input_group, any_product,
     "Channels that are angles, in degrees or radians, and turn the shorter way from key to key",
     "", other, [](Typed& to, Text text) { to.keys.input.rotation.angles = angle_channels(text); }},
    {"--normalize", "", "", input_group, any_product,
     "Divides quaternions by their norm, which may be any number but 0, and replaces matrices by the nearest rotation",
     "", flag, [](Typed& to, Text) { to.keys.input.rotation.normalize = true; }},
    {"--duplicates", "", "POLICY", input_group, any_product,
     "What happens to keys with equal times: error rejects them; first or last keeps that one; break begins a new "
     "curve with the second; spread gives them equal parts of the step to the next time",
     "error", name,
     [](Typed& to, Text text) { to.keys.curves.duplicates = named_row(duplicates_names, text).value; },
     names_in<duplicates_names>},
    {"--max-gap", "", "D", input_group, but(of_identify),
     "Begins a new curve where keys are further apart in time than D, a number or a duration such as 2s; with --missing "
     "skip-cell, a channel is also empty where its own keys are",
     "", other,
     [](Typed& to, Text text) {
       const std::optional<Rational> duration = read_duration(text);
       to.keys.curves.max_gap = duration ? *duration : positive_ratio(text);
       to.keys.curves.is_max_gap_in_seconds = duration.has_value();
     }},
    {"--sort", "", "", input_group, any_product,
     "Sorts keys by time before use; keys with equal times keep their order",
     "", flag, [](Typed& to, Text) { to.keys.curves.sort = true; }},

    {"--preset", "", "NAME", curve_group, but(of_fit | of_identify),
     "The rules of a product for tangents, ends and rotations; --list-presets shows all products",
     "tcb", name,
     [](Typed& to, Text text) { to.keys.rules.preset = preset_named(text); },
     names_in<spline::presets>},
    {"--tangents", "", "RULE", curve_group, but(of_fit | of_identify),
     "The rule for the tangents at inner keys, instead of the preset's rule; linear draws straight lines between keys",
     "", name,
     [](Typed& to, Text text) { to.keys.rules.tangents = named_row(spline::tangent_rules<double>, text).id; },
     names_in<spline::tangent_rules<double>>},
    {"--ends", "", "RULE[,RULE]", curve_group, but(of_fit | of_identify),
     "The rule for the tangents at the first and the last key, one for both or one for each, instead of the preset's "
     "rule; velocity=V:V... sets a velocity, a number for each channel",
     "", names,
     [](Typed& to, Text text) { to.keys.rules.ends = {ends_in(text), {"--ends"}}; },
     names_in<spline::end_rules<double>>},
    {"--closed", "", "[=no]", curve_group, but(of_fit),
     "The curve continues from the last key to the first; no leaves open a curve that the file closes",
     "yes", attached,
     [](Typed& to, Text text) { to.keys.rules.closed = {named_row(closing_names, text).value, {"--closed"}}; }},
    {"--period", "", "P", curve_group, but(of_fit),
     "The time that a closed curve takes to return to its first key, such as 4 or 4s; implies --closed",
     "", other, [](Typed& to, Text text) { to.keys.rules.period = {period_in(text), {"--period"}}; }},
    {"--equal-speed", "", "", curve_group, but(of_fit | of_identify),
     "Makes the speeds on both sides of a key equal, even if the continuity is not 0",
     "", flag, [](Typed& to, Text) { to.keys.rules.equal_speed = true; }},
    {"--no-overshoot", "", "", curve_group, but(of_fit | of_identify),
     "Keeps each channel between the positions of two neighbouring keys, by smaller tangents where it would leave them",
     "", flag, [](Typed& to, Text) { to.keys.rules.no_overshoot = true; }},
    {"--parameter", "", "NAME", curve_group, but(of_fit),
     "Makes times for keys that have none: uniform, chordal, centripetal, or an exponent of the distances between "
     "keys",
     "uniform", name,
     [](Typed& to, Text text) { to.keys.rules.parameter = parameter_in(text); }, names_in<parameter_names>},
    {"--metric", "", "CHANNEL,...", curve_group, any_product,
     "The channels, by name or number, over which lengths and speeds are measured; by default those called x, y and "
     "z if there are any, otherwise all. all means all channels",
     "", other,
     [](Typed& to, Text text) {
       const auto names = split(text, ',');
       to.keys.rules.metric = {{names.begin(), names.end()}, {"--metric"}};
     }},
    {"--rotation-curve", "", "NAME", curve_group, but(of_fit),
     "The curve between rotations, instead of the preset's curve: squad, casteljau, components or slerp",
     "", name,
     [](Typed& to, Text text) { to.keys.rules.rotation_curve = named_row(spline::rotation_curves, text).id; },
     names_in<spline::rotation_curves>},
    {"--no-ease", "", "", curve_group, but(of_fit),
     "Ignores the columns ease_in and ease_out",
     "", flag, [](Typed& to, Text) { to.keys.rules.no_ease = true; }},
    {"--extrapolate", "", "RULE[,RULE]", curve_group, but(of_fit | of_limits),
     "What happens to times outside the curve, one rule for both sides or one each for before and after: error "
     "rejects them; hold, linear, repeat, offset and oscillate extend the curve",
     "error", names,
     [](Typed& to, Text text) { to.keys.rules.extrapolate = extrapolation(text); }, names_in<extrapolations>},

    {"--step", "-s", "H", sampling_group, placed,
     "Samples every H of time from the first key; H is a decimal, a ratio such as 1/24, or a duration such as 20ms "
     "or 30min",
     "", other,
     [](Typed& to, Text text) {
       to.sampling.mode = Mode::step;
       to.sampling.step = stored_time(to.sampling, expects_positive_ratio, text, &InSeconds::step);
       if (to.sampling.step <= 0) throw usage_error("{} {}", in_quotes(text), expects_positive_ratio);
     }},
    {"--rate", "", "HZ", sampling_group, placed,
     "Samples HZ times per second, or per unit of time if the unit is unknown; the step is exactly 1/HZ",
     "", other, [](Typed& to, Text text) { set_rate(to.sampling, positive_ratio(text), text); }},
    {"--fps", "", "HZ", sampling_group, placed,
     "Samples as --rate does; the frame rates 23.976, 29.97, 59.94 and the like are 24000/1001, 30000/1001 and "
     "60000/1001",
     "", other,
     [](Typed& to, Text text) {
       set_rate(to.sampling, frame_rate(text), text);
       if (broadcast_rate(text)) to.sampling.rate_as_decimal = text;
     }},
    {"--count", "-n", "N", sampling_group, placed,
     "Takes N samples equally spaced in time, including the first and the last key",
     "", other,
     [](Typed& to, Text text) { to.sampling.mode = Mode::count; to.sampling.count = positive_count(text); }},
    {"--per-segment", "", "N", sampling_group, placed,
     "Divides every segment between two keys into N equal intervals of time",
     "", other,
     [](Typed& to, Text text) { to.sampling.mode = Mode::per_segment; to.sampling.count = positive_count(text); }},
    {"--at", "", "T,...", sampling_group, placed,
     "Samples at these times, in this order. A:B:H means from A to B in steps of H; @FILE means the numbers in a "
     "file; @FILE:COLUMN means a column of a recording; - means the numbers in standard input",
     "", places,
     [](Typed& to, Text text) { to.sampling.mode = Mode::at; store_places(to, "--at", text); }},
    {"--arc-step", "-a", "H", sampling_group, placed,
     "Samples every H of arc length from the first key",
     "", other,
     [](Typed& to, Text text) { to.sampling.mode = Mode::arc_step; to.sampling.step = positive_ratio(text); }},
    {"--arc-count", "", "N", sampling_group, placed,
     "Takes N samples equally spaced in arc length, including both ends",
     "", other,
     [](Typed& to, Text text) { to.sampling.mode = Mode::arc_count; to.sampling.count = positive_count(text); }},
    {"--arc-at", "", "S,...", sampling_group, placed,
     "Samples at these arc lengths, written as in --at",
     "", places,
     [](Typed& to, Text text) { to.sampling.mode = Mode::arc_at; store_places(to, "--arc-at", text); }},
    {"--tolerance", "", "D[,ANGLE]", sampling_group, placed,
     "Takes few samples, whose polyline stays within D of the curve over the metric channels, and whose rotations "
     "stay within ANGLE, such as 0.5deg or 0.01rad",
     "", other,
     [](Typed& to, Text text) { to.sampling.mode = Mode::tolerance; to.sampling.tolerance = curve_tolerance(text); }},
    {"--emit", "", "FORM", sampling_group, Effect(of_pieces | of_explained_samples, offer::pieces),
     "Prints the exact cubics instead of samples, one row for each segment: hermite has position and velocity at "
     "both ends, bezier four control points, and poly the coefficients of (t - start)^0 to ^3",
     "", name,
     [](Typed& to, Text text) {
       to.sampling.mode = Mode::emit;
       to.sampling.count = 1;
       to.form = form_of_pieces(text);
     }, form_names},
    {"--fit", "", "D,...", sampling_group, Effect(of_fit, offer::keys),
     "Finds a small set of keys whose curve stays within D of every sample in the input, over the metric channels, "
     "and prints these keys with their tension and bias, without which the curve is another one. NAME=D limits one "
     "channel; 0.5deg or 0.01rad limits rotations",
     "", other, [](Typed& to, Text text) { std::tie(to.fit.tolerances, to.fit.angle) = fit_limits(text); }},
    {"--fit-keys", "", "KIND", sampling_group, of_fit,
     "The parameters of the keys of --fit: tcb means tension and bias, hermite means velocities",
     "tcb", name,
     [](Typed& to, Text text) { to.fit.keys = named_row(fit_key_names, text).value; }, names_in<fit_key_names>},
    {"--keep-times", "", "T,...", sampling_group, of_fit,
     "Samples that --fit must keep as keys, by time, written as in --at",
     "", places, [](Typed& to, Text text) { store_places(to, "--keep-times", text); }},
    {"--corner", "", "DEGREES", sampling_group, of_fit,
     "Allows a key of --fit to be a corner where the samples turn by more than DEGREES",
     "", other, [](Typed& to, Text text) { to.fit.corner = corner_angle(text); }},
    {"--from", "", "T", sampling_group, placed | of_pieces | of_limits | of_picture,
     "Where sampling begins: a time, which may have a unit as in 20ms, or an arc length for the arc modes; by "
     "default the first key",
     "", other, [](Typed& to, Text text) { to.sampling.from = stored_bound(to, text, &InSeconds::from); }},
    {"--to", "", "T", sampling_group, placed | of_pieces | of_limits | of_picture,
     "Where sampling ends; by default the last key",
     "", other, [](Typed& to, Text text) { to.sampling.to = stored_bound(to, text, &InSeconds::to); }},
    {"--end", "", "POLICY", sampling_group, placed,
     "What happens if the steps do not meet the end: drop stops before it; keep adds it after a shorter step; fit "
     "takes the nearest whole number of equal steps, fit-down steps of at most H, and fit-up steps of at least H",
     "drop", name,
     [](Typed& to, Text text) { to.sampling.end = named_row(end_policies, text).value; }, names_in<end_policies>},
    {"--keys", "", "", sampling_group, placed,
     "Adds every key as a sample, in place of one within a billionth of a step of it",
     "", flag, [](Typed& to, Text) { to.sampling.keys = true; }},
    {"--pace", "", "PACE", sampling_group, of_samples | of_drawn_samples | of_explained_samples,
     "Moves rows at times along the curve by arc length, whatever the times between the first and the last key: "
     "constant is at one speed; ease starts and stops softly, each in a quarter of the duration, and ease=A,B in the "
     "parts A and B of it; @FILE is a profile of keys with a time and an arc length s, or a fraction of the length; "
     "@FILE:COLUMN names its column",
     "", other, [](Typed& to, Text text) { store_pace(to, text); }},
    {"--max-rows", "", "N", sampling_group, of_samples | of_pieces | of_expected_rows | of_drawn_samples,
     "Fails if there are more than N samples",
     "1e9", other, [](Typed& to, Text text) { to.sampling.max_rows = count_between(text, 1, INT64_MAX); }},

    {"--output", "-o", "FILE", output_group, any_product,
     "Writes to FILE, which appears when it is complete; - is standard output",
     "", file, [](Typed& to, Text text) { to.files.outputs.file = text; }},
    {"--output-format", "-f", "FORMAT", output_group, any_product,
     "The format of the output: @NAMES@; see tcbsample-output(5). By default it is that of FILE's ending, or csv",
     "", name, [](Typed& to, Text text) { to.output.format = format_with(&Format::can_write, text); },
     [] { return formats_with(&Format::can_write); }},
    {"--plot", "", "", output_group, any_product,
     "Draws the curve and its samples, as -f svg does; without a sampling option, it draws 51 samples equally "
     "spaced in time",
     "", flag, [](Typed& to, Text) { to.output.format = find_format("svg"); }},
    {"--fields", "", "FIELD,...", output_group, Effect(of_any_rows | of_explained_samples, offer::any_columns),
     "The fields of a row, in order: time, position, s (arc length), velocity, acceleration, jerk, speed, tangent, "
     "curvature, torsion, angular_velocity, angular_speed, segment, u, key, arc_error. With --emit: s and length, "
     "which follow the cubics",
     "time,position", names, [](Typed& to, Text text) { to.output.fields = field_list(text); }, field_names},
    {"--side", "", "SIDE", output_group, of_any_rows,
     "Which segment a row at a key describes if two segments differ there: right is the segment after the key, left "
     "is the segment before it",
     "right", name,
     [](Typed& to, Text text) { to.sampling.from_left = named_row(side_names, text).value; }, names_in<side_names>},
    {"--digits", "", "N", output_group, Effect(of_samples | of_pieces, offer::decimals),
     "Prints numbers with N significant digits, from 1 to 17, or with --golden to 100; by default as the shortest "
     "text that reads back as the same double",
     "", other,
     [](Typed& to, Text text) { to.output.notation = {Notation::Kind::digits, digit_count(text, 1)}; }},
    {"--fixed", "", "N", output_group, Effect(of_samples | of_pieces, offer::decimals),
     "Prints numbers with N decimals, from 0 to 100",
     "", other,
     [](Typed& to, Text text) { to.output.notation = {Notation::Kind::fixed, digit_count(text, 0)}; }},
    {"--jobs", "-j", "N", output_group, any_product,
     "The number of threads; by default one per core, or one thread for a live pipe. The output is the same for "
     "every N",
     "", other,
     [](Typed& to, Text text) { to.threads.requested = static_cast<unsigned>(count_between(text, 1, 1024)); }},
    {"--golden", "", "", output_group, of_samples | of_pieces | of_explained_samples,
     "Prints every number as the exact result, rounded once",
     "", flag, only_given},
    {"--exact-input", "", "", output_group, of_samples | of_pieces,
     "With --golden: a decimal in the input means exactly that decimal, not the nearest double",
     "", flag, only_given},
    {"--meta", "", "", output_group, Effect(printed, offer::provenance),
     "Adds provenance to the rows: version, rules, the whole command, SHA-256 of the input, and counts",
     "", flag, only_given},
    {"--hex", "", "", output_group, Effect(printed, offer::marks),
     "Prints numbers in hexadecimal as C does, such as 0x1.8p+1, which strtod reads back bit for bit",
     "", flag, [](Typed& to, Text) { to.output.notation = {Notation::Kind::hex}; }},
    {"--no-output-header", "", "", output_group, Effect(printed | of_explained_samples, offer::marks),
     "Prints no names above the rows; this is the default if the input has no names",
     "", flag, [](Typed& to, Text) { to.output.header = false; }},
    {"--output-delimiter", "", "CHAR", output_group, Effect(printed, offer::any_delimiter),
     "The character between the cells of csv, as for --delimiter; by default a comma",
     "", name,
     [](Typed& to, Text text) { to.output.delimiter = delimiter(text); }, names_in<delimiter_names>},
    {"--output-decimal", "", "MARK", output_group, Effect(printed, offer::marks),
     "The decimal mark of rows, a point or a comma",
     ".", other, [](Typed& to, Text text) { to.output.decimal = decimal_mark(text); }},
    {"--file-column", "", "[=NAME]", output_group, Effect(printed, offer::any_columns),
     "Adds the name of the input as the first column, called NAME, in place of a blank line between files",
     "file", attached, [](Typed& to, Text text) { to.output.file_column = text; }},
    {"--time-format", "", "FORMAT", output_group, Effect(printed, offer::words_of_time),
     "The notation of times in rows: seconds, frames, clock (hh:mm:ss.fff), smpte (timecode) or iso (dates of ISO "
     "8601); by default the notation in the input",
     "", name,
     [](Typed& to, Text text) { to.output.time_notation = named_row(time_notations, text).notation; },
     names_in<time_notations>},
    {"--time-zero", "", "T", output_group, Effect(printed | checks | of_identify, offer::times),
     "Subtracts T, a time in the unit of the keys, exactly from all times in the output; first is the time of the "
     "first key; with --check or --identify, adds it to those of the samples",
     "", other,
     [](Typed& to, Text text) {
       to.output.time_zero.emplace();
       if (text != "first") to.output.time_zero->time = ratio_or(expects_time_zero, text);
     }},
    {"--rename", "", "OLD=NEW,...", output_group, Effect(but(of_fit), offer::column_names),
     "Renames columns of the input, in the output and for the options about channels",
     "", other, [](Typed& to, Text text) { to.keys.input.renamings = renamings(text); }},
    {"--axes", "", "X:Y", output_group, Effect(but(explains), offer::drawing),
     "With a picture: the channels, by name or number, that point right and up; by default the first two metric "
     "channels",
     "", other, [](Typed& to, Text text) { to.picture.axes = axis_names(text); }},
    {"--title", "", "TEXT", output_group, Effect(but(explains), offer::drawing),
     "With a picture: its title; by default the name of the file",
     "", other, [](Typed& to, Text text) { to.picture.title = text; }},
    {"--size", "", "WxH", output_group, Effect(but(explains), offer::drawing),
     "With a picture: its width and height in pixels",
     "", other, [](Typed& to, Text text) { to.picture.size = picture_size(text); }},

    {"--explain", "", "", about_group, explains,
     "Prints what was detected, and with a sampling option what would be done, instead of samples",
     "", flag, only_given},
    {"--quiet", "-q", "", about_group, any_product,
     "Prints only errors on standard error",
     "", flag, only_given},
    {"--color", "", "WHEN", about_group, any_product,
     "When errors, warnings and notes are colored: always, never, or auto, on a terminal unless the environment "
     "says otherwise",
     "auto", name,
     [](Typed& to, Text text) { to.color = named_row(color_names, text).value; }, names_in<color_names>},
    {"--generate", "", "KIND", about_group, any_product,
     "Prints a page of the manual (man, man-curves), the completions for a shell (bash, zsh, fish), or all options and "
     "presets as JSON (tables)",
     "", name,
     [](Typed& to, Text text) { to.generated = named_row(generated_names, text).value; }, names_in<generated_names>},
    {"--list-presets", "", "", about_group, any_product,
     "Prints the presets, and the rules with their formulas",
     "", flag, only_given},
    {"--version", "-V", "", about_group, any_product,
     "Prints the version",
     "", flag, only_given},
    {"--help", "-h", "", about_group, any_product,
     "-h prints the most common options, --help prints all options",
     "", flag, only_given},
};

}  // namespace

std::span<const OptionRow> option_table() { return option_rows; }

const OptionRow& row_of(std::string_view name) { return *std::ranges::find(option_rows, name, &OptionRow::name); }

std::vector<std::string_view> OptionRow::all_names() const {
  if (other_name.empty()) return {name};
  if (other_name.starts_with("--")) return {name, other_name};
  return {other_name, name};
}

std::string OptionRow::description() const {
  constexpr std::string_view mark = "@NAMES@";
  std::string result(text);
  if (const std::size_t at = result.find(mark); at != std::string::npos) {
    result.replace(at, mark.size(), listed(known()));
  }
  return result + (default_value.empty() ? "" : " (default: " + std::string(default_value) + ")");
}

}  // namespace tcb
