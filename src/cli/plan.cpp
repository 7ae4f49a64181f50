// Plan: from arguments to typed options, and from these to the job of a product.
#include "cli/plan.hpp"

#include <algorithm>
#include <array>

#include "cli/help.hpp"
#include "cli/options.hpp"
#include "cli/values.hpp"
#include "formats/formats.hpp"
#include "io/input_list.hpp"
#include "io/system.hpp"
#include "read/input.hpp"
#include "sample/curve_spec.hpp"
#include "sample/table.hpp"
#include "schema/pose_formats.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

std::string asked_text(const TypedOptions& typed, const std::vector<std::string>& words) {
  const bool is_long = std::ranges::count(words, "--help") > 0;
  if (typed.has("--help")) return is_long ? help_text() : short_help_text();
  if (typed.has("--list-presets")) return presets_text();
  if (typed.has("--version")) return version_text();
  return generated_text(*typed.generated);
}

/// The name whose ending may name the format: that of the output, or the suffix of the names of all outputs.
struct NameOfOutput {
  std::string_view option;
  std::string text;

  std::string file;  ///< the name of a file with this ending
};

std::optional<NameOfOutput> name_of_output(const OutputPaths& outputs) {
  if (outputs.file != "-") return NameOfOutput{"--output", outputs.file, outputs.file};
  if (!outputs.suffix.empty()) return NameOfOutput{"--suffix", outputs.suffix, "x" + outputs.suffix};
  return std::nullopt;
}

/// Sets the format that the ending of an output names, unless an option gives the same. A report is JSON by its ending.
/// Throws: Error (usage) for another format than the option's, and for the ending of a format that is not written.
void set_output_format(TypedOptions& typed) {
  const auto name = name_of_output(typed.files.outputs);
  if (!name) return;
  const bool is_report = is_comparison(typed) || prints_limits(typed);
  const Format* const named = find_output_format(name->file);
  const std::string other(other_ending(name->file));
  if (named == nullptr && !other.empty()) {
    throw usage_error(
        "{} {}: {} is not an output format; expected one of {}; choose another ending, and convert the file "
        "afterwards",
        name->option, name->text, other, listed(output_endings()));
  }
  if (named == nullptr || (is_report && !named->has_reports)) return;
  if (typed.has("--output-format") || typed.has("--plot")) {
    if (named->ending != typed.output.format->ending) {
      throw usage_error(
          "the ending of {} {} means {}, but --output-format is {}; expected the same format; change one of them",
          name->option, name->text, named->name, typed.output.format->name);
    }
    return;
  }
  if (named == &formats().front()) return;  // as without the ending
  typed.output.format = named;
  typed.give("--output-format", std::string(named->name));
}

/// An output of pieces has the exact ones where no samples are requested.
void set_exact_pieces(TypedOptions& typed) {
  typed.sampling.mode = Mode::emit;
  typed.sampling.count = 1;
  typed.form = field_of("hermite");
  typed.give("--emit", "hermite");
}

/// Throws: Error (usage) if standard input would be read twice.
void require_one_reader(const TypedOptions& typed) {
  const bool names_input = std::ranges::count(typed.files.files, "-") > 0;
  const bool keys_from_input = names_input || typed.files.files.empty();
  const bool samples_from_input = is_comparison(typed) && typed.comparison.file == "-";
  const auto require = [](bool reads_twice, std::string_view option) {
    if (reads_twice)
      throw usage_error(
          "the file and the keys are both standard input; expected it once; give a file name for one of them")
          .about(option);
  };
  require(typed.files.list == "-" && names_input, "--files");
  require(typed.places.from_input && (keys_from_input || samples_from_input), typed.has("--at") ? "--at" : "--arc-at");
  require(typed.pace_profile && typed.pace_profile->path == "-" && keys_from_input, "--pace");
  require(samples_from_input && keys_from_input, typed.has("--check") ? "--check" : "--identify");
}

/// Throws: Error (usage) for a range of samples that runs backwards.
void require_forward_range(const TypedOptions& typed) {
  const SamplingRequest& sampling = typed.sampling;
  const InSeconds& seconds = sampling.in_seconds;
  if (by_length(sampling.mode) && (seconds.from || seconds.to)) {
    throw usage_error("a unit of time is given, but samples are placed by arc length; expected a length without a unit")
        .about(seconds.from ? "--from" : "--to");
  }
  if (sampling.from && sampling.to && seconds.from == seconds.to && *sampling.to < *sampling.from) {
    throw usage_error("--to {} is before --from {}; expected a later end; swap the two", typed.value("--to"),
                      typed.value("--from"));
  }
}

Error no_sampling_option() {
  return usage_error("there is no sampling option; expected one of {}; give one, as in tcbsample --step 0.1 keys.csv",
                     listed(split(sampling_options, ' ')));
}

/// Whether the input may be a camera path, which has frames of its own, so that no sampling option is needed.
bool may_have_frames(const TypedOptions& typed) {
  for (const std::string_view option : {"--fit", "--from", "--to", "--end", "--keys"}) {
    if (typed.has(option)) return false;
  }
  if (typed.keys.input.format != nullptr) return typed.keys.input.format->input->has_frames;
  return !typed.files.files.empty() && std::ranges::all_of(typed.files.files, [](std::string_view path) {
    return without_compression(path).ends_with(".json");
  });
}

/// Throws: Error (usage) unless a sampling option is given, and the range of the samples runs forwards.
void require_samples(const TypedOptions& typed) {
  const bool is_needed = !typed.has("--plot") && !typed.has("--explain") && !may_have_frames(typed);
  if (!has_sampling_option(typed) && is_needed) throw no_sampling_option();
  require_forward_range(typed);
}

// The parts that jobs have in common.

InputListOptions files_of(const TypedOptions& typed) {
  InputListOptions files = typed.files;
  if (files.files.empty() && files.list.empty()) files.files = {"-"};
  if (typed.keys.input.format == nullptr) files.endings = input_endings();
  if (find_output_format("x" + files.outputs.suffix) == nullptr) files.outputs.ending = typed.output.format->ending;
  return files;
}

/// Throws: Error (usage) for several files of keys.
InputListOptions one_file_of(const TypedOptions& typed, std::string_view option) {
  InputListOptions files = files_of(typed);
  if (files.files.size() > 1)
    throw usage_error("there are {} files of keys; expected one; remove the others", files.files.size()).about(option);
  return files;
}

/// Throws: Error (usage) for rules that do not fit each other.
KeyOptions keys_of(const TypedOptions& typed) {
  const CurveSpec spec = make_spec(typed.keys.rules);
  KeyOptions keys = typed.keys;
  keys.input.has_shown_tcb_scale = shown_tcb_scale(spec.preset).has_value();
  keys.input.columns.timeless = keys.rules.parameter.has_value();
  const CurveSettings& rules = keys.rules;
  const bool is_open = rules.closed && !rules.closed->value, has_preset = rules.preset.has_value();
  keys.input.given = {.closed = rules.closed || rules.period,
                      .period = is_open || rules.period,
                      .preset = has_preset,
                      .tangents = has_preset || rules.tangents,
                      .ends = has_preset || rules.ends};
  keys.input.keys.keeps_decimals = typed.has("--exact-input");
  const auto positions = std::ranges::find(keys.input.columns.roles, Role::position, &RoleRequest::role);
  if (positions != keys.input.columns.roles.end()) {  // the numbers of requested rotations are positions as well
    for (const GivenRotation& rotation : keys.input.rotation.requests) {
      keys.input.columns.roles.push_back(
          {.role = Role::position, .columns = rotation.columns, .option = "--rotation", .unless_taken = true});
    }
  }
  if (const Format& format = *typed.output.format; !format.fields.empty()) {
    const bool are_poses = format.poses != nullptr;
    keys.input.rotation.shown = {.form = are_poses ? format.poses->form : spline::RotationForm::quaternion};
    keys.input.rotation.shown_by_format = true;
  }
  if (typed.has("--tcb") && keys.input.keys.tcb_scale == TcbScale::max3ds) {
    for (double* const value :
         {&keys.input.keys.tcb->tension, &keys.input.keys.tcb->continuity, &keys.input.keys.tcb->bias}) {
      *value = nearest_double(from_0_to_50(exact_time(Time(*value))));
    }
  }
  return keys;
}

/// A row at a key has the values of the segment after it, unless no field can differ between the two. Without fields, a
/// comparison may have any of them.
bool is_from_left(const TypedOptions& typed, const std::vector<std::size_t>& chosen) {
  if (typed.has("--side")) return typed.sampling.from_left;
  return !chosen.empty() && std::ranges::none_of(chosen, [](std::size_t field) { return fields()[field].has_side; });
}

std::vector<std::size_t> fields_of(const TypedOptions& typed) {
  const std::string_view of_format = typed.output.format->fields;
  if (!of_format.empty() && !typed.form) return field_list(std::string(of_format));
  std::vector<std::size_t> chosen = typed.output.fields;
  if (typed.form) chosen.insert(chosen.begin(), {field_of("start"), field_of("duration"), *typed.form});
  return chosen.empty() ? field_list(std::string(row_of("--fields").default_value)) : chosen;
}

SampleOptions samples_of(const TypedOptions& typed) {
  SampleOptions samples{typed.sampling, typed.places.grouped};
  samples.request.places = typed.places.list;
  samples.request.in_seconds.places = typed.places.in_seconds;
  samples.request.in_seconds.has_duration |= typed.places.in_seconds;
  samples.request.from_left = is_from_left(typed, fields_of(typed));
  if (!has_sampling_option(typed)) {  // a picture has samples of its own, and an explanation mentions none
    samples.request.mode = Mode::intervals;
    samples.request.count = 50;
    const bool is_drawn = typed.output.format->is_picture || typed.has("--explain");
    if (!is_drawn && may_have_frames(typed)) samples.unless_frames = no_sampling_option();
  }
  return samples;
}

/// Reads the profile of a pace. Throws: Error.
void read_pace(TypedOptions& typed) {
  SamplingRequest request = samples_of(typed).request;
  request.pace.reset();
  typed.sampling.pace->profile = read_pace_profile(*typed.pace_profile, request, keys_of(typed));
}

std::optional<GoldenOptions> golden_of(const TypedOptions& typed) {
  if (!typed.has("--golden")) return std::nullopt;
  return GoldenOptions{typed.has("--exact-input"), typed.output.notation};
}

/// The command that prints an output with these options, without those that change no byte of it. Each output of a
/// folder has a command for its own input.
ProvenanceRequest provenance_of(const TypedOptions& typed) {
  constexpr std::array<std::string_view, 4> change_no_byte{"--output", "--jobs", "--quiet", "--color"};
  const bool is_one_of_many = typed.files.outputs.folder.has_value();
  ProvenanceRequest request{version_text(), {"tcbsample"}, std::nullopt};
  for (const OptionRow& row : option_table()) {
    const bool is_told =
        std::ranges::count(change_no_byte, row.name) == 0 && !(is_one_of_many && row.group == files_group);
    if (!is_told || !typed.has(row.name)) continue;
    const std::string value = row.kind == ValueKind::flag ? "" : "=" + typed.value(row.name);
    request.command.push_back(std::string(row.name) + value);
  }
  if (!is_one_of_many) request.files = files_of(typed).files;
  return request;
}

/// Throws: Error (usage) for rows that a terminal cannot show.
WriterOptions rows_of(const TypedOptions& typed) {
  const bool to_terminal =
      typed.files.outputs.file == "-" && !typed.files.outputs.folder && system::is_terminal(system::standard_output);
  if (to_terminal && typed.output.format->is_binary) {
    throw usage_error(
        "the format npy is binary, and standard output is a terminal; expected a file or a pipe; give --output "
        "FILE.npy");
  }
  WriterOptions rows = typed.output;
  rows.fields = fields_of(typed);
  if (typed.has("--meta")) rows.provenance = provenance_of(typed);
  rows.frame_rate = typed.keys.input.units.frame_rate;
  return rows;
}

Verbosity verbosity_of(const TypedOptions& typed) {
  const bool quiet = typed.has("--quiet"), notes = !quiet && system::is_terminal(system::standard_error);
  const bool to_file =
      typed.has("--output") || typed.has("--output-dir") || !system::is_terminal(system::standard_output);
  return {quiet, notes, notes && to_file, colors_messages(typed.color)};
}

// The jobs.

/// Throws: Error (usage) for several files of keys.
CompareJob compare_job(const TypedOptions& typed) {
  const bool identifies = typed.has("--identify");
  const InputListOptions files = one_file_of(typed, identifies ? "--identify" : "--check");
  Comparison comparison = typed.comparison;
  comparison.keys_file = files.files[0];
  comparison.keys = keys_of(typed);
  comparison.fields = typed.output.fields;
  comparison.from_left = is_from_left(typed, comparison.fields);
  comparison.threads = typed.threads;
  comparison.time_zero = typed.output.time_zero;
  if (has_sampling_option(typed)) {
    require_forward_range(typed);
    comparison.expected = samples_of(typed);
  }
  return {comparison,    identifies,          files.outputs.file, typed.output.format,
          typed.picture, verbosity_of(typed), files.other_inputs};
}

/// Throws: Error (usage) for several files of keys.
LimitsJob limits_job(const TypedOptions& typed) {
  const InputListOptions files = one_file_of(typed, "--limits");
  require_forward_range(typed);
  return {files.files[0],      keys_of(typed), typed.limits,  typed.sampling,      files.outputs.file,
          typed.output.format, typed.picture,  typed.threads, verbosity_of(typed), files.other_inputs};
}

ExplainJob explain_job(const TypedOptions& typed) {
  const bool has_samples = has_sampling_option(typed) || typed.has("--plot");
  return {files_of(typed),  keys_of(typed),   samples_of(typed),   has_samples,
          golden_of(typed), fields_of(typed), typed.output.format, typed.output.header};
}

FilesJob files_job(const TypedOptions& typed) {
  return {files_of(typed), keys_of(typed), typed.threads, verbosity_of(typed)};
}

FitJob fit_job(const TypedOptions& typed) {
  FitOptions options = typed.fit;
  options.kept_times = typed.places.list;
  options.grouped_kept_times = typed.places.grouped;
  return {files_job(typed), options, rows_of(typed), typed.picture};
}

PlotJob plot_job(const TypedOptions& typed) {
  PlotJob job{files_job(typed), samples_of(typed), typed.picture};
  job.keys.input.rotation.as_curves = true;
  return job;
}

ResampleJob resample_job(const TypedOptions& typed) {
  return {files_job(typed), samples_of(typed), golden_of(typed), rows_of(typed)};
}

/// Throws: Error (usage) without limits or samples.
RetimeJob retime_job(const TypedOptions& typed) {
  const auto has_limit = [](const Limit& limit) { return limit.most.has_value(); };
  if (std::ranges::none_of(typed.limits.limits, has_limit)) {
    throw usage_error("--limits gives no limit; expected one to keep, as in --limits=speed=2; give its number")
        .about("--retime");
  }
  const bool is_picture = typed.output.format->is_picture;
  if (!has_sampling_option(typed) && !is_picture) throw no_sampling_option();
  require_forward_range(typed);
  LimitsJob limits = limits_job(typed);
  limits.part = {};
  if (is_picture) return {std::move(limits), plot_job(typed)};
  return {std::move(limits), resample_job(typed)};
}

/// The job of these options. Requires: no conflict. Throws: Error (usage) if they do not fit each other.
Job make_job(const TypedOptions& typed) {
  const Product product = product_of(typed);
  if (is_comparison(typed)) return compare_job(typed);
  if (product == of_limits) return limits_job(typed);
  if (typed.has("--retime")) return retime_job(typed);
  require_samples(typed);
  if (typed.has("--explain")) return explain_job(typed);
  if (product == of_fit) return fit_job(typed);
  if (typed.output.format->is_picture) return plot_job(typed);
  return resample_job(typed);
}

}  // namespace

Job parse(const std::vector<std::string>& words, ColorWhen* color) {
  if (words.empty() && system::is_terminal(system::standard_input)) return PrintText{usage_text(), Exit::usage};
  TypedOptions typed = read_options(words, color);
  if (typed.wants_text()) return PrintText{asked_text(typed, words)};
  set_output_format(typed);
  if (!has_sampling_option(typed) && typed.output.format->has_nodes) set_exact_pieces(typed);
  require_no_conflict(typed);
  require_one_reader(typed);
  read_place_column(typed);
  if (typed.pace_profile) read_pace(typed);
  return make_job(typed);
}

}  // namespace tcb
