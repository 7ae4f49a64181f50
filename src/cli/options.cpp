// Options: the table of names, texts, defaults and how each value is stored, in the order of the help.
#include "cli/options.hpp"

#include <algorithm>
#include <tuple>

#include "option_names.hpp"
#include "sample/extrapolation.hpp"
#include "sample/request.hpp"
#include "tcb/spline/rules.hpp"
#include "text/suggest.hpp"

namespace tcb {
namespace {

using Typed = TypedOptions;
using Text = const std::string&;
using enum ValueKind;

struct ParameterName {
  std::string_view name;
};
constexpr std::array parameter_names{ParameterName{"uniform"}, ParameterName{"chordal"}, ParameterName{"centripetal"}};

struct SideName {
  std::string_view name;
  bool left;
};
constexpr std::array side_names{SideName{"right", false}, SideName{"left", true}};

constexpr std::string_view input_group = "Input", curve_group = "Curve", sampling_group = "Sampling",
                           output_group = "Output", files_group = "Many files", comparison_group = "Comparison",
                           about_group = "About";

/// The option changes the rows, so it is part of their provenance.
constexpr bool recorded = true, unrecorded = false;

constexpr std::array<OptionRow, option_count> option_rows{{
    {Option::input_format, "-i,--input-format", "FORMAT", input_group,
     "csv, tsv, ssv (separated by whitespace), json or jsonl; by default the format of the file's ending, else JSON if "
     "the text begins with [ or {, else delimited text",
     "", name, recorded, [](Typed& to, Text text) { to.job.input.format = input_format(text); },
     input_format_names},
    {Option::delimiter, "-d,--delimiter", "CHAR", input_group,
     "The separator of cells: one character, or tab, comma, semicolon, space or pipe; by default the first of tab, ; , "
     "and blank that the first record has",
     "", name, recorded, [](Typed& to, Text text) { to.job.input.delimiter = delimiter(text); },
     names_in<delimiter_names>},
    {Option::header, "--header", "", input_group,
     "The first record names the columns; by default it does if a cell in it is not a number", "", flag, recorded,
     [](Typed& to, Text) { to.job.input.header = true; }},
    {Option::no_header, "--no-header", "", input_group, "The first record is a key", "", flag, recorded,
     [](Typed& to, Text) { to.job.input.header = false; }},
    {Option::comment, "--comment", "PREFIX", input_group, "Skips lines that begin with PREFIX; none: skips none", "#",
     other, recorded, [](Typed& to, Text text) { to.job.input.comment = text == "none" ? "" : text; }},
    {Option::columns, "--columns", "ROLE=NAME,...", input_group,
     "The roles of columns, by name or number, as in time=frame,position=px:py:pz,tension=k,carry=label; by default "
     "from the header, or without one the time first and positions after it",
     "", roles, recorded,
     [](Typed& to, Text text) {
       auto roles = parse_roles(text);
       to.job.input.roles.insert(to.job.input.roles.begin(), roles.begin(), roles.end());
     }},
    {Option::tcb, "--tcb", "T,C,B", input_group, "Tension, continuity and bias of keys that have none", "0,0,0", other,
     recorded, [](Typed& to, Text text) { to.job.input.tcb = tcb_values(text); }},
    {Option::tcb_scale, "--tcb-scale", "SCALE", input_group,
     "The scale of tension, continuity and bias: 3dsmax, from 0 to 50 with 25 for 0; none, unchanged; by default "
     "unchanged, and numbers beyond 5 are rejected with presets of products that show 0 to 50 or percent",
     "", name, recorded, [](Typed& to, Text text) { to.job.input.tcb_scale = named_row(tcb_scales, text).scale; },
     names_in<tcb_scales>},
    {Option::decimal, "--decimal", "MARK", input_group, "The decimal mark of numbers, a point or a comma", ".", other,
     recorded, [](Typed& to, Text text) { to.job.input.decimal = decimal_mark(text); }},
    {Option::group, "-g,--group", "COL[,COL]", input_group,
     "Rows with the same values in these columns make a curve, in any order; the columns are repeated in front of its "
     "samples",
     "", columns, recorded,
     [](Typed& to, Text text) {
       to.job.input.roles.push_back({Role::group, column_list(text), option::group});
     }},
    {Option::missing, "--missing", "POLICY", input_group,
     "For a cell that is empty or a sign of a missing number, such as NA: error rejects it; skip-row skips the key; skip-cell interpolates "
     "that channel through its other keys; break begins a new curve after it",
     "error", name, recorded,
     [](Typed& to, Text text) { to.job.input.missing = named_row(missing_names, text).value; },
     names_in<missing_names>},
    {Option::na, "--na", "TEXT,...", input_group,
     "Further signs of a missing number, besides NA, N/A, nan, null, None, missing, - and the like", "", other, recorded,
     [](Typed& to, Text text) { to.job.input.signs = column_list(text); }},
    {Option::time_unit, "--time-unit", "UNIT", input_group,
     "The unit of the times: s, ms, us, ns, min, h, d or frames; --rate then is per second; by default that of the "
     "column's name, as in time_ms",
     "", name, recorded,
     [](Typed& to, Text text) { to.job.input.time_unit = named_row(time_units, text).unit; }, names_in<time_units>},
    {Option::input_fps, "--input-fps", "HZ", input_group,
     "The times are numbers of frames, HZ a second, such as 24 or 30000/1001; they become seconds", "", other, recorded,
     [](Typed& to, Text text) { to.job.input.input_rate = positive_ratio(text); }},
    {Option::scale, "--scale", "CHANNEL=FACTOR,...", input_group,
     "Multiplies the positions of channels by exact decimals or ratios, as in x=0.01", "", columns, recorded,
     [](Typed& to, Text text) { to.job.input.scales = channel_scales(text); }},
    {Option::rotation, "--rotation", "FORM=COLUMN:...", input_group,
     "Columns that together are a rotation: quaternion=X:Y:Z:W, axis-angle=X:Y:Z:ANGLE[,relative], "
     "euler=A:B:C,order=XYZ or matrix=M11:M12:M13:M21:M22:M23:M31:M32:M33, by name or number; once for each rotation. none: "
     "all are plain channels. By default columns such as qx, qy, qz and qw",
     "", other, recorded,
     [](Typed& to, Text text) {
       RotationOptions& options = to.job.input.rotation;
       options.requests = rotations(text, options.none);
     }},
    {Option::angles, "--angles", "UNIT", input_group, "The unit of the angles of rotations: radians or degrees", "radians", name,
     recorded, [](Typed& to, Text text) { to.job.input.rotation.degrees = named_row(angle_units, text).degrees; },
     names_in<angle_units>},
    {Option::rotation_output, "--rotation-output", "FORM", input_group,
     "How rows show rotations: quaternion, axis-angle, matrix, or euler=XYZ; by default as the input gives them", "", other,
     recorded, [](Typed& to, Text text) { to.job.input.rotation.shown = rotation_form(text); }},
    {Option::angle, "--angle", "CHANNEL=UNIT,...", input_group,
     "Channels that are angles in degrees or radians: from key to key they turn less than half a turn; rows have them from "
     "0 to 360 degrees, or if a key is negative from -180 to 180",
     "", columns, recorded, [](Typed& to, Text text) { to.job.input.rotation.angles = angle_channels(text); }},
    {Option::normalize, "--normalize", "", input_group, "Takes quaternions of any norm but 0, and divides them by it; takes the rotation nearest to a matrix", "", flag, recorded,
     [](Typed& to, Text) { to.job.input.rotation.normalize = true; }},
    {Option::duplicates, "--duplicates", "POLICY", input_group,
     "For keys with equal times: error rejects them; first or last keeps that one; break begins a new curve with the "
     "second",
     "error", name, recorded,
     [](Typed& to, Text text) { to.job.curves.duplicates = named_row(duplicates_names, text).value; },
     names_in<duplicates_names>},
    {Option::sort, "--sort", "", input_group, "Sorts keys by time first; those of equal times keep their order", "", flag,
     recorded, [](Typed& to, Text) { to.job.curves.sort = true; }},

    {Option::preset, "--preset", "NAME", curve_group, "The rules of a product for tangents and ends; see --list-presets", "gte", name,
     recorded, [](Typed& to, Text text) { to.job.curve.preset = {std::string(named_row(spline::presets, text).name), {option::preset}}; },
     names_in<spline::presets>},
    {Option::tangents, "--tangents", "RULE", curve_group,
     "The rule for the tangents at inner keys, instead of the preset's", "", name, recorded,
     [](Typed& to, Text text) { to.job.curve.tangents = {std::string(named_row(spline::tangent_rules<double>, text).name), {option::tangents}}; },
     names_in<spline::tangent_rules<double>>},
    {Option::ends, "--ends", "RULE[,RULE]", curve_group,
     "The rule for the tangents at the first and the last key, one for both or one for each, instead of the preset's; "
     "velocity=V:V... gives a velocity, a number for each channel",
     "", names, recorded, [](Typed& to, Text text) { to.job.curve.ends = {text, {option::ends}}; }, names_in<spline::end_rules<double>>},
    {Option::closed, "--closed", "", curve_group,
     "The curve continues from the last key to the first; a last key that repeats the first position gives the time of "
     "the return only",
     "", flag, recorded, [](Typed& to, Text) { to.job.curve.closed = {true, {option::closed}}; }},
    {Option::period, "--period", "P", curve_group,
     "The time that a closed curve takes to return to its first key; implies --closed", "", other, recorded,
     [](Typed& to, Text text) { to.job.curve.period = {text, {option::period}}; }},
    {Option::equal_speed, "--equal-speed", "", curve_group,
     "Gives both tangents of a key the same speed, also where C is not 0", "", flag, recorded,
     [](Typed& to, Text) { to.job.curve.equal_speed = true; }},
    {Option::parameter, "--parameter", "NAME", curve_group,
     "Makes times for keys without any: uniform, chordal, centripetal, or an exponent of the distances", "uniform",
     name, recorded, [](Typed& to, Text text) { to.job.curve.parameter = {text, {option::parameter}}; }, names_in<parameter_names>},
    {Option::metric, "--metric", "CHANNEL,...", curve_group,
     "The channels that lengths and speeds are measured over, by name or number; by default all. rotation: lengths are the "
     "angles that rotations turn through, in radians",
     "", columns, recorded,
     [](Typed& to, Text text) { to.job.curve.metric = {text, {option::metric}}; }},
    {Option::rotation_curve, "--rotation-curve", "NAME", curve_group,
     "The curve between rotations, instead of the preset's: squad, casteljau, components or slerp", "", name, recorded,
     [](Typed& to, Text text) { to.job.curve.rotation_curve = {std::string(named_row(spline::rotation_curves, text).name), {option::rotation_curve}}; },
     names_in<spline::rotation_curves>},
    {Option::no_ease, "--no-ease", "", curve_group, "Ignores the columns ease_in and ease_out", "", flag, recorded,
     [](Typed& to, Text) { to.job.curve.no_ease = true; }},
    {Option::extrapolate, "--extrapolate", "RULE", curve_group,
     "Times outside the curve: error rejects them; hold, linear, repeat, offset and oscillate extend the curve", "error", name,
     recorded, [](Typed& to, Text text) { to.job.curve.extrapolate = {std::string(named_row(extrapolations, text).name), {option::extrapolate}}; },
     names_in<extrapolations>},

    {Option::step, "-s,--step", "H", sampling_group,
     "Samples every H of time from the first key; H is a decimal or a ratio such as 1/24", "", other, recorded,
     [](Typed& to, Text text) {
       to.job.sampling.mode = Mode::step;
       to.job.sampling.step = positive_ratio(text);
     }},
    {Option::rate, "--rate,--fps", "HZ", sampling_group, 
     "HZ samples per second, or per unit of time if that is not known: a step of exactly 1/HZ", "", other, recorded,
     [](Typed& to, Text text) {
       to.job.sampling.mode = Mode::step;
       to.job.sampling.is_rate = true;
       to.job.sampling.step = step_of_rate(text);
     }},
    {Option::count, "-n,--count", "N", sampling_group,
     "N samples equally spaced in time, including the first and the last key", "", other, recorded,
     [](Typed& to, Text text) {
       to.job.sampling.mode = Mode::count;
       to.job.sampling.count = positive_count(text);
     }},
    {Option::segments, "--segments", "N", sampling_group, "N equal intervals of time, so N+1 samples", "", other, recorded,
     [](Typed& to, Text text) {
       to.job.sampling.mode = Mode::segments;
       to.job.sampling.count = positive_count(text);
     }},
    {Option::per_segment, "--per-segment", "N", sampling_group, "N equal intervals in every segment between two keys", "",
     other, recorded,
     [](Typed& to, Text text) {
       to.job.sampling.mode = Mode::per_segment;
       to.job.sampling.count = positive_count(text);
     }},
    {Option::at, "--at", "T,...", sampling_group,
     "These times, in this order; A:B:H: from A to B in steps of H; @FILE: those in a file, separated by whitespace, "
     "commas or lines; @FILE:COLUMN: those in a column of a file of any format, by groups; -: those of standard input", "", places, recorded,
     [](Typed& to, Text text) {
       to.job.sampling.mode = Mode::at;
       store_places(to, Option::at, text);
     }},
    {Option::arc_step, "-a,--arc-step", "H", sampling_group, "Samples every H of arc length from the first key", "", other,
     recorded,
     [](Typed& to, Text text) {
       to.job.sampling.mode = Mode::arc_step;
       to.job.sampling.step = positive_ratio(text);
     }},
    {Option::arc_count, "--arc-count", "N", sampling_group,
     "N samples equally spaced in arc length, including both ends", "", other, recorded,
     [](Typed& to, Text text) {
       to.job.sampling.mode = Mode::arc_count;
       to.job.sampling.count = positive_count(text);
     }},
    {Option::arc_at, "--arc-at", "S,...", sampling_group, "These arc lengths, in the same forms as times", "",
     places, recorded,
     [](Typed& to, Text text) {
       to.job.sampling.mode = Mode::arc_at;
       store_places(to, Option::arc_at, text);
     }},
    {Option::tolerance, "--tolerance", "D[,ANGLE]", sampling_group,
     "Samples, as few as a greedy search finds, whose polyline stays within D of the curve, over the metric channels, and "
     "rotations within ANGLE, such as 0.5deg or 0.01rad", "", other, recorded,
     [](Typed& to, Text text) {
       to.job.sampling.mode = Mode::tolerance;
       to.job.sampling.tolerance = curve_tolerance(text);
     }},
    {Option::emit, "--emit", "FORM", sampling_group,
     "The exact cubics instead of samples, a row for each segment: hermite, position and velocity at both ends; bezier, "
     "four control points; poly, the coefficients of (t - start)^0 to ^3, or polyN, padded to N with zeros", "", name,
     recorded,
     [](Typed& to, Text text) {
       to.job.sampling.mode = Mode::emit;
       to.job.sampling.count = 1;
       to.form = form_of_pieces(text);
     },
     names_in<form_table>},
    {Option::fit, "--fit", "D,...", sampling_group,
     "Keys in place of samples: the fewest found whose curve is within D of every sample of the input, over the metric channels; "
     "NAME=D for a channel alone, 0.5deg or 0.01rad for rotations", "", other, recorded,
     [](Typed& to, Text text) {
       to.job.sampling.mode = Mode::fit;
       std::tie(to.job.fit.tolerances, to.job.fit.angle) = fit_limits(text);
     }},
    {Option::fit_keys, "--fit-keys", "KIND", sampling_group,
     "What the keys of --fit carry: tcb, tension and bias, or hermite, velocities", "tcb", name, recorded,
     [](Typed& to, Text text) { to.job.fit.keys = named_row(fit_key_names, text).keys; }, names_in<fit_key_names>},
    {Option::keep_times, "--keep-times", "T,...", sampling_group, "Times of samples that become keys in any case, as in --at",
     "", places, recorded, [](Typed& to, Text text) { store_places(to, Option::keep_times, text); }},
    {Option::corner, "--corner", "DEGREES", sampling_group,
     "Where the samples turn by more, a key of --fit may be a corner", "", other, recorded,
     [](Typed& to, Text text) { to.job.fit.corner = corner_angle(text); }},
    {Option::from, "--from", "T", sampling_group,
     "Where sampling begins, in time, or in arc length for the arc modes; by default the first key", "", other,
     recorded, [](Typed& to, Text text) { to.job.sampling.from = ratio(text); }},
    {Option::to, "--to", "T", sampling_group, "Where sampling ends; by default the last key", "", other, recorded,
     [](Typed& to, Text text) { to.job.sampling.to = ratio(text); }},
    {Option::end, "--end", "POLICY", sampling_group,
     "If the steps do not meet the end: drop stops before it; keep adds it after a shorter step; fit takes the "
     "nearest whole number of equal steps, fit-down the largest equal steps of at most H, fit-up the smallest of at "
     "least H",
     "drop", name, recorded,
     [](Typed& to, Text text) { to.job.sampling.end = named_row(end_policies, text).policy; },
     names_in<end_policies>},
    {Option::keys, "--keys", "", sampling_group,
     "Every key is also a sample; it replaces a sample within a billionth of a step of it", "", flag, recorded,
     [](Typed& to, Text) { to.job.sampling.keys = true; }},
    {Option::max_rows, "--max-rows", "N", sampling_group, "An error if there are more samples than N", "1e9", other, recorded,
     [](Typed& to, Text text) { to.job.sampling.max_rows = count_between(text, 1, INT64_MAX); }},

    {Option::output, "-o,--output", "FILE", output_group,
     "Writes to FILE, which appears when it is complete; -: standard output", "", file, unrecorded,
     [](Typed& to, Text text) { to.job.output = text; }},
    {Option::output_format, "-f,--output-format", "FORMAT", output_group,
     "csv, tsv, ssv, json, jsonl, npy (an array for NumPy), or svg (a picture); by default the format of FILE's ending, "
     "else csv",
     "", name, recorded,
     [](Typed& to, Text text) { to.job.output_format = output_format(text); }, output_format_names},
    {Option::fields, "--fields", "FIELD,...", output_group,
     "The fields of a row, in order: time, position, s (arc length), velocity, acceleration, jerk, speed, tangent, "
     "curvature, torsion, angular_velocity, angular_speed, segment, u, key, arc_error; with --emit, those added to its cubics: s, length",
     "time,position", names, recorded, [](Typed& to, Text text) { to.job.fields = field_list(text); }, field_names},
    {Option::side, "--side", "SIDE", output_group,
     "The segment whose values a row at a key has if they differ: right, the one after the key, or left, the one "
     "before",
     "right", name, recorded,
     [](Typed& to, Text text) { to.job.sampling.from_left = named_row(side_names, text).left; },
     names_in<side_names>},
    {Option::digits, "--digits", "N", output_group,
     "Numbers have N significant digits, 1 to 17, or with --golden to 100; by default the shortest text that reads "
     "back as the same double",
     "", other, recorded,
     [](Typed& to, Text text) { to.notation = {Notation::Kind::digits, digit_count(text, 1)}; }},
    {Option::fixed, "--fixed", "N", output_group, "Numbers have N decimals, 0 to 100", "", other, recorded,
     [](Typed& to, Text text) { to.notation = {Notation::Kind::fixed, digit_count(text, 0)}; }},
    {Option::jobs, "-j,--jobs", "N", output_group,
     "The number of threads; by default one per core, and a single one for a live pipe. The bytes are the same for "
     "every N",
     "", other, unrecorded,
     [](Typed& to, Text text) { to.job.jobs = static_cast<unsigned>(count_between(text, 1, 1024)); }},
    {Option::golden, "--golden", "", output_group, "Every number is the exact one, rounded once; slow", "", flag, recorded,
     [](Typed&, Text) {}},
    {Option::exact_input, "--exact-input", "", output_group,
     "With --golden, a decimal in the input is exactly that decimal, not the double nearest to it", "", flag, recorded,
     [](Typed&, Text) {}},
    {Option::meta, "--meta", "", output_group,
     "Adds provenance to the rows: version, rules, options, SHA-256 of the input, and counts, as comment lines or in "
     "JSON as an object",
     "", flag, recorded, [](Typed&, Text) {}},
    {Option::from_meta, "--from-meta", "FILE", output_group,
     "Reproduces FILE, an output with provenance: takes all options from it", "", file, unrecorded,
     [](Typed&, Text) {}},
    {Option::hex, "--hex", "", output_group,
     "Numbers are hexadecimal as in C, such as 0x1.8p+1, which strtod reads back bit for bit", "", flag, recorded,
     [](Typed& to, Text) { to.notation = {Notation::Kind::hex}; }},
    {Option::no_output_header, "--no-output-header", "", output_group,
     "No names above the rows; the default if the input has none", "", flag, recorded,
     [](Typed& to, Text) { to.job.output_header = false; }},
    {Option::file_column, "--file-column", "[=NAME]", output_group,
     "Adds the input's name as the first column, called NAME; without a blank line between files", "file", attached,
     recorded, [](Typed& to, Text text) { to.job.file_column = text; }},
    {Option::time_format, "--time-format", "FORMAT", output_group,
     "The notation of times: seconds, frames, clock (hh:mm:ss.fff), smpte (timecode) or iso (dates of ISO 8601); by "
     "default that of the input",
     "", name, recorded,
     [](Typed& to, Text text) { to.job.time_notation = named_row(time_notations, text).notation; },
     names_in<time_notations>},
    {Option::rename, "--rename", "OLD=NEW,...", output_group,
     "Other names for columns of the input, in the output and in the options about channels", "", columns, recorded,
     [](Typed& to, Text text) { to.job.input.renamings = renamings(text); }},
    {Option::plot, "--plot", "", output_group,
     "Draws the curve and its samples, as -f svg does; without a sampling option, 51 of them equally spaced in time",
     "", flag, unrecorded, [](Typed& to, Text) { to.job.output_format = FormatId::svg; }},
    {Option::axes, "--axes", "X:Y", output_group,
     "With a picture: the channels to the right and up in the view of the path, by name or number; by default the "
     "first two metric ones",
     "", column_pair, unrecorded, [](Typed& to, Text text) { to.job.picture.axes = axis_names(text); }},
    {Option::title, "--title", "TEXT", output_group, "With a picture: its title; by default the name of the file", "", other,
     unrecorded, [](Typed& to, Text text) { to.job.picture.title = text; }},
    {Option::size, "--size", "WxH", output_group, "With a picture: its size in pixels; by default as required by its contents", "",
     other, unrecorded, [](Typed& to, Text text) { to.job.picture.size = picture_size(text); }},

    {Option::output_dir, "--output-dir", "DIR", files_group,
     "Writes a file for each input into this folder, with the format's ending", "", folder, unrecorded,
     [](Typed& to, Text text) { to.job.output_folder = text; }},
    {Option::files, "--files", "LIST", files_group, "More files, one per line of LIST; -: standard input", "", file,
     unrecorded, [](Typed& to, Text text) { to.job.batch.list = text; }},
    {Option::null, "-0,--null", "", files_group, "The names in LIST end in NUL, not in a line end", "", flag, unrecorded,
     [](Typed& to, Text) { to.job.batch.nul = true; }},
    {Option::recursive, "--recursive", "", files_group,
     "Takes all files below a folder that have the ending of a format, or with --input-format all files; the tree is "
     "mirrored in DIR",
     "", flag, unrecorded, [](Typed& to, Text) { to.job.batch.recursive = true; }},
    {Option::suffix, "--suffix", "S", files_group, "Appends S to the outputs' names, before the ending", "", other,
     unrecorded, [](Typed& to, Text text) { to.job.batch.suffix = name_part(text); }},
    {Option::update, "--update", "", files_group, "Only files that are newer than their outputs, or have none", "", flag,
     unrecorded, [](Typed& to, Text) { to.job.batch.update = true; }},
    {Option::fail_fast, "--fail-fast", "", files_group,
     "Stops at the first file that fails; without it the others are finished", "", flag, unrecorded,
     [](Typed& to, Text) { to.job.batch.fail_fast = true; }},

    {Option::check, "--check", "FILE", comparison_group,
     "Compares the samples in FILE, from any program, with the curve at their times, or arc lengths s, and prints a "
     "report; exit code 1 if they differ",
     "", file, recorded, [](Typed& to, Text text) { to.comparison.file = text; }},
    {Option::abs, "--abs", "[COL=]D,...", comparison_group,
     "With --check: the largest difference of two numbers, in all columns or in one, as in x=1e-6", "", other, recorded,
     [](Typed& to, Text text) { to.comparison.abs = tolerances(text); }},
    {Option::rel, "--rel", "[COL=]D,...", comparison_group, "The same, as a fraction of the curve's number", "", other,
     recorded, [](Typed& to, Text text) { to.comparison.rel = tolerances(text); }},
    {Option::ulp, "--ulp", "[COL=]N,...", comparison_group,
     "The same, in units in the last place: steps between neighbouring doubles; by default 0, so equality", "", other,
     recorded, [](Typed& to, Text text) { to.comparison.ulp = tolerances(text); }},
    {Option::map, "--map", "THEIRS=OURS,...", comparison_group,
     "Names that the columns of FILE are compared by, as in frame_time=t,px=x", "", other, recorded,
     [](Typed& to, Text text) { to.comparison.maps = renamings(text); }},
    {Option::identify, "--identify", "FILE", comparison_group,
     "Finds the tangents, ends, speeds, and order and signs of T, C, B that gave the positions in FILE, and prints a "
     "ranked table; exit code 1 if none fits",
     "", file, recorded,
     [](Typed& to, Text text) {
       to.comparison.file = text;
       to.comparison.identify = true;
     }},

    {Option::explain, "--explain", "", about_group, "Prints what was found and would be done, without samples", "", flag,
     recorded, [](Typed& to, Text) { to.job.explain = true; }},
    {Option::progress, "--progress", "", about_group,
     "Shows the progress on a terminal once the work takes a second, also if the rows go to it; by default only "
     "if they do not",
     "", flag, unrecorded, [](Typed&, Text) {}},
    {Option::no_progress, "--no-progress", "", about_group, "Does not show the progress", "", flag, unrecorded,
     [](Typed&, Text) {}},
    {Option::quiet, "-q,--quiet", "", about_group, "Nothing but errors on standard error", "", flag, unrecorded,
     [](Typed& to, Text) { to.job.verbosity.quiet = true; }},
    {Option::color, "--color", "WHEN", about_group,
     "Colors errors, warnings and notes: auto, on a terminal, unless NO_COLOR is set or TERM is dumb; always; never. With "
     "auto, CLICOLOR_FORCE colors them anywhere",
     "auto", name, unrecorded, [](Typed& to, Text text) { to.color = named_row(color_names, text).when; }, names_in<color_names>},
    {Option::generate, "--generate", "KIND", about_group,
     "Prints the manual page (man), completions for a shell (bash, zsh, fish), or the names of the columns of FILE (columns)", "", name, unrecorded,
     [](Typed& to, Text text) { to.generated = named_row(generated_names, text).kind; }, names_in<generated_names>},
    {Option::list_presets, "--list-presets", "", about_group, "Prints the presets and the rules with their formulas", "",
     flag, unrecorded, [](Typed&, Text) {}},
    {Option::version, "-V,--version", "", about_group, "Prints the version", "", flag, unrecorded, [](Typed&, Text) {}},
    {Option::help, "-h,--help", "", about_group, "Prints the most common options; --help prints all", "", flag, unrecorded, [](Typed&, Text) {}},
}};

}  // namespace

std::span<const OptionRow> option_table() { return option_rows; }

std::string_view OptionRow::long_name() const {
  const std::string_view from_dashes = names.substr(names.find("--"));
  return from_dashes.substr(0, from_dashes.find(','));
}

std::vector<std::string_view> OptionRow::all_names() const { return split(names, ','); }

std::string OptionRow::description() const {
  return std::string(text) + (default_value.empty() ? "" : "; default " + std::string(default_value));
}

ColorWhen color_of(int argc, const char* const* argv) {
  const std::string_view name = row_of(Option::color).long_name();
  std::string_view value;
  for (int i = 1; i < argc && std::string_view(argv[i]) != "--"; ++i) {
    const std::string_view word = argv[i];
    if (word == name && i + 1 < argc) value = argv[i + 1];
    if (word.starts_with(name) && word.substr(name.size()).starts_with('=')) value = word.substr(name.size() + 1);
  }
  const auto row = std::ranges::find(color_names, value, &ColorName::name);
  return row == color_names.end() ? ColorWhen::by_terminal : row->when;
}

bool TypedOptions::wants_text() const {
  return std::ranges::any_of(std::array{Option::help, Option::list_presets, Option::version, Option::generate},
                             [&](Option option) { return has(option); });
}

}  // namespace tcb
