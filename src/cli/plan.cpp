// Plan: from arguments to typed options, and from these to the job of a product.
#include "cli/plan.hpp"

#include <algorithm>
#include <array>

#include "cli/help.hpp"
#include "cli/options.hpp"
#include "cli/values.hpp"
#include "formats/formats.hpp"
#include "io/compression.hpp"
#include "io/input_file.hpp"
#include "io/input_list.hpp"
#include "io/system.hpp"
#include "read/earlier_output.hpp"
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
};

std::optional<NameOfOutput> name_of_output(const OutputPaths& outputs) {
  if (outputs.file != "-") return NameOfOutput{"--output", outputs.file};
  if (!outputs.suffix.empty()) return NameOfOutput{"--suffix", outputs.suffix};
  return std::nullopt;
}

/// Sets the format that the ending of an output names, unless an option gives the same. A report is JSON by its ending.
/// `earlier`: the format is that of an earlier output. Throws: Error (usage) for another format than the option's, and
/// for the ending of a format that is not written.
void set_output_format(TypedOptions& typed, bool earlier) {
  const auto name = name_of_output(typed.files.outputs);
  if (!name) return;
  const bool is_report = is_comparison(typed) || prints_limits(typed);
  const Format* const named = find_output_format(name->text);
  const std::string other(other_ending(name->text));
  if (named == nullptr && !other.empty()) {
    throw usage_error(
        "{} {}: {} is not an output format; expected one of {}; choose another ending, and convert the file "
        "afterwards",
        name->option, name->text, other, listed(output_endings()));
  }
  if (named == nullptr || (is_report && !named->has_reports)) return;
  if (typed.has("--output-format") || typed.has("--plot") || earlier) {
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

// The options that provenance records, and those of an earlier output.

/// Throws: Error (data) if an option of an earlier output, which may be a stranger's, names a file to be read.
void require_no_file(const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    const std::size_t end = std::min(word.find('='), word.size());
    for (const OptionRow& row : option_table()) {
      const bool is_named = std::ranges::count(row.all_names(), std::string_view(word).substr(0, end)) > 0;
      const std::string_view value = std::string_view(word).substr(std::min(end + 1, word.size()));
      const bool reads = row.kind == ValueKind::file || row.kind == ValueKind::folder ||
                         (row.kind == ValueKind::places && (value.starts_with('@') || value == "-"));
      if (is_named && row.changes_rows && reads)
        throw data_error(
            "the provenance has {} with the name of a file to be read; expected the numbers themselves, as the program "
            "records them; replace the name",
            row.name);
    }
  }
}

/// An option as one word; numbers are listed in it, wherever they came from.
std::string word_of(const OptionRow& row, const TypedOptions& typed) {
  std::string word(row.name);
  if (row.kind != ValueKind::flag) word += "=" + typed.value(row.name);
  if (word.find_first_of("\r\n") != std::string::npos) {
    throw usage_error(
        "the value has a line end, which --meta cannot record; expected a value of one line; remove --meta, or rename "
        "columns")
        .about(row.name);
  }
  return word;
}

/// Throws: Error unless all options of an earlier output are such that provenance records, --meta among them, and none
/// names a file to be read, as the output may be a stranger's.
void require_recorded(const std::vector<std::string>& words) {
  require_no_file(words);
  const TypedOptions typed = read_options(words);
  for (const OptionRow& row : option_table()) {
    if (!typed.has(row.name) || row.changes_rows) continue;
    throw data_error(
        "the provenance has the option {}, which does not affect the rows; expected options that do; remove it from "
        "the provenance",
        row.name);
  }
  if (!typed.files.files.empty())
    throw data_error(
        "the provenance has the file {} among its options; expected options only; remove it from the provenance",
        in_quotes(typed.files.files[0]));
  if (!typed.has("--meta"))
    throw data_error("the provenance lacks the option --meta; expected all options of the run; add it");
}

/// The provenance of an output that is made with these options: its program, and all options that change a byte.
/// Throws: Error (usage) for a value that no line can hold.
Provenance new_provenance(const TypedOptions& typed) {
  Provenance provenance;
  provenance.program = version_text();
  for (const OptionRow& row : option_table()) {
    if (row.changes_rows && typed.has(row.name)) provenance.options.push_back(word_of(row, typed));
  }
  return provenance;
}

/// The provenance of the output to reproduce. Throws: Error (usage) if options are given that it has,
/// or another number of files than it was made from; Error where it cannot be read.
ProvenanceRequest earlier_provenance(const TypedOptions& typed) {
  const std::string from = typed.value("--from-meta");
  for (const OptionRow& row : option_table()) {
    if (!row.changes_rows || !typed.has(row.name)) continue;
    throw usage_error("{} is given with --from-meta, which takes all options from {}; remove {}", row.name, from,
                      row.name);
  }
  ProvenanceRequest request;
  request.from = from;
  in_file(shown_name(from), [&] {
    EarlierOutput earlier = read_earlier_output(decompressed(read_file(from)), typed.keys.input.max_memory);
    request.earlier.program = std::move(earlier.program);
    request.earlier.options = std::move(earlier.options);
    request.earlier.inputs = std::move(earlier.inputs);
    require_recorded(request.earlier.options);
  });
  const std::size_t files = std::max<std::size_t>(typed.files.files.size(), 1), before = request.earlier.inputs.size();
  const bool counted = typed.files.list.empty() && !typed.files.recursive;
  if (counted && files != before)
    throw usage_error("the number of key files is {}, but {} was made from {}; give the same files", files, from,
                      before);
  return request;
}

/// Whether an earlier output measured lengths over all channels by default, as versions before 0.4 did.
bool measures_all_channels(std::string_view program, const std::vector<std::string>& options) {
  constexpr std::array<std::string_view, 4> before{" 0.0.", " 0.1.", " 0.2.", " 0.3."};
  const bool is_before =
      std::ranges::any_of(before, [&](std::string_view version) { return program.find(version) != std::string::npos; });
  const TypedOptions typed = is_before ? read_options(options) : TypedOptions();
  return is_before && program != version_text() && !typed.has("--metric") && !needs_no_metric(typed);
}

/// An output of pieces has the exact ones where no samples are requested.
void set_exact_pieces(TypedOptions& typed, std::string_view form) {
  typed.sampling.mode = Mode::emit;
  typed.sampling.count = 1;
  typed.form = field_of(form);
  typed.give("--emit", std::string(form));
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
                     listed(std::vector<std::string_view>(sampling_options.begin(), sampling_options.end())));
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
  if (find_output_format(files.outputs.suffix) == nullptr) files.outputs.ending = typed.output.format->ending;
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
  keys.input.keys.keeps_decimals = typed.has("--exact-input");
  const auto positions = std::ranges::find(keys.input.columns.roles, Role::position, &RoleRequest::role);
  if (positions != keys.input.columns.roles.end()) {  // the numbers of requested rotations are positions as well
    for (const GivenRotation& rotation : keys.input.rotation.requests) {
      keys.input.columns.roles.push_back(
          {.role = Role::position, .columns = rotation.columns, .option = "--rotation", .unless_taken = true});
    }
  }
  if (typed.output.format->poses != nullptr) {
    keys.input.rotation.shown = {.form = typed.output.format->poses->form};
    keys.input.rotation.shown_by_format = true;
  }
  if (typed.output.format->has_nodes) {
    keys.input.rotation.shown = spline::RotationNotation{};
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
  if (typed.output.format->poses != nullptr) {
    const bool has_times = typed.output.format->poses->has_times;
    return has_times ? std::vector{field_of("time"), field_of("position")} : std::vector{field_of("position")};
  }
  if (typed.output.format->has_pieces) return {field_of("duration"), field_of("poly8")};
  if (typed.output.format->has_nodes) {
    if (typed.sampling.mode != Mode::emit) return {field_of("time"), field_of("position")};
    return {field_of("start"), field_of("duration"), field_of("hermite")};
  }
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

std::optional<GoldenOptions> golden_of(const TypedOptions& typed) {
  if (!typed.has("--golden")) return std::nullopt;
  return GoldenOptions{typed.has("--exact-input"), typed.output.notation};
}

/// Throws: Error (usage) for rows that a terminal cannot show.
WriterOptions rows_of(const TypedOptions& typed, std::optional<ProvenanceRequest> provenance) {
  const bool to_terminal =
      typed.files.outputs.file == "-" && !typed.files.outputs.folder && system::is_terminal(system::standard_output);
  if (to_terminal && typed.output.format->is_binary) {
    throw usage_error(
        "the format npy is binary, and standard output is a terminal; expected a file or a pipe; give --output "
        "FILE.npy");
  }
  WriterOptions rows = typed.output;
  rows.fields = fields_of(typed);
  rows.provenance = std::move(provenance);
  rows.frame_rate = typed.keys.input.units.frame_rate;
  return rows;
}

Verbosity verbosity_of(const TypedOptions& typed) {
  const bool quiet = typed.has("--quiet"), notes = !quiet && system::is_terminal(system::standard_error);
  const bool to_file =
      typed.has("--output") || typed.has("--output-dir") || !system::is_terminal(system::standard_output);
  return {quiet, notes, notes && to_file, colors_messages(typed.color)};
}

/// The samples that the provenance of an output asks for; nothing for an output of several inputs or of other rows
/// than samples, and for options that are unknown here or name a file.
std::optional<ExpectedSamples> recorded_samples(const EarlierOutput& earlier) {
  if (earlier.inputs.size() != 1) return std::nullopt;
  TypedOptions typed;
  try {
    require_recorded(earlier.options);
    typed = read_options(earlier.options);
  } catch (const Error&) {
    return std::nullopt;
  }
  if (!has_sampling_option(typed) || typed.has("--emit") || typed.has("--fit")) return std::nullopt;
  if (measures_all_channels(earlier.program, earlier.options)) typed.keys.rules.metric = {{"all"}, {"--metric"}};
  ExpectedSamples expected{samples_of(typed), typed.keys.rules.metric, typed.output.notation, typed.output.time_zero};
  SamplingRequest& request = expected.samples.request;
  const std::optional<TimeUnit>& unit = typed.keys.input.units.time;
  if (unit && *unit != TimeUnit::frames) request.convert_seconds(units_per_second(*unit));  // keys of a check have none
  return expected;
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
    comparison.expected = ExpectedSamples{samples_of(typed)};
  } else if (!identifies) {
    comparison.recorded = recorded_samples;
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

FitJob fit_job(const TypedOptions& typed, std::optional<ProvenanceRequest> provenance) {
  FitOptions options = typed.fit;
  options.kept_times = typed.places.list;
  options.grouped_kept_times = typed.places.grouped;
  return {files_job(typed), options, rows_of(typed, std::move(provenance)), typed.picture};
}

PlotJob plot_job(const TypedOptions& typed) {
  PlotJob job{files_job(typed), samples_of(typed), typed.picture};
  job.keys.input.rotation.as_curves = true;
  return job;
}

ResampleJob resample_job(const TypedOptions& typed, std::optional<ProvenanceRequest> provenance) {
  return {files_job(typed), samples_of(typed), golden_of(typed), rows_of(typed, std::move(provenance))};
}

/// Throws: Error (usage) without limits or samples.
RetimeJob retime_job(const TypedOptions& typed, std::optional<ProvenanceRequest> provenance) {
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
  return {std::move(limits), resample_job(typed, std::move(provenance))};
}

/// The job of these options. `provenance`: that of its output, if it has one. Requires: no conflict. Throws: Error
/// (usage) if they do not fit each other.
Job make_job(const TypedOptions& typed, std::optional<ProvenanceRequest> provenance) {
  require_one_reader(typed);
  if (is_comparison(typed)) return compare_job(typed);
  if (typed.has("--retime")) return retime_job(typed, std::move(provenance));
  if (typed.has("--limits")) return limits_job(typed);
  require_samples(typed);
  if (typed.has("--explain")) return explain_job(typed);
  if (typed.has("--fit")) return fit_job(typed, std::move(provenance));
  if (typed.output.format->is_picture) return plot_job(typed);
  return resample_job(typed, std::move(provenance));
}

}  // namespace

Job parse(std::vector<std::string> words, ColorWhen* color) {
  if (words.empty() && system::is_terminal(system::standard_input)) return PrintText{usage_text(), Exit::usage};
  TypedOptions typed = read_options(words, color);
  if (typed.wants_text()) return PrintText{asked_text(typed, words)};
  std::optional<ProvenanceRequest> provenance;
  if (typed.has("--from-meta")) {
    provenance = earlier_provenance(typed);
    words.insert(words.begin(), provenance->earlier.options.begin(), provenance->earlier.options.end());
    if (measures_all_channels(provenance->earlier.program, provenance->earlier.options))
      words.insert(words.begin(), "--metric=all");
    typed = read_options(words);
    typed.files.other_inputs.push_back(provenance->from);
  }
  set_output_format(typed, provenance.has_value());
  if (!has_sampling_option(typed) && typed.output.format->has_nodes) set_exact_pieces(typed, "hermite");
  if (!has_sampling_option(typed) && typed.output.format->has_pieces) set_exact_pieces(typed, "poly8");
  require_no_conflict(typed);
  read_place_column(typed);
  if (typed.has("--meta") && !provenance) provenance.emplace();
  if (provenance) provenance->meta = new_provenance(typed);
  return make_job(typed, std::move(provenance));
}

}  // namespace tcb
