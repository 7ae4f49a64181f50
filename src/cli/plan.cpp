// Plan: from arguments to typed options, from these to the job, and the options that provenance records.
#include "cli/plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>

#include "cli/errors.hpp"
#include "cli/help.hpp"
#include "cli/options.hpp"
#include "cli/output_ending.hpp"
#include "cli/places.hpp"
#include "cli/read_options.hpp"
#include "cli/values.hpp"
#include "io/compression.hpp"
#include "io/input_file.hpp"
#include "read/earlier_output.hpp"
#include "sample/curve_spec.hpp"
#include "sample/fields.hpp"

namespace tcb {
namespace {

std::string asked_text(const TypedOptions& typed, const std::vector<std::string>& words) {
  const bool is_long = std::ranges::count(words, option::help) > 0;
  if (typed.has(option::help)) return is_long ? help_text() : short_help_text();
  if (typed.has(option::list_presets)) return presets_text();
  if (typed.has(option::version)) return version_text();
  return generated_text(*typed.generated, typed.job.files);
}

}  // namespace

Invocation parse(int argc, const char* const* argv) {
  std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  if (words.empty() && ::isatty(STDIN_FILENO) != 0) return {usage_text(), {}, Exit::usage};
  TypedOptions typed = read_options(words);
  if (typed.wants_text()) return {asked_text(typed, words)};
  std::optional<ProvenanceRequest> provenance;
  if (typed.has(option::from_meta)) {
    provenance = earlier_provenance(typed);
    words.insert(words.begin(), provenance->earlier.options.begin(), provenance->earlier.options.end());
    typed = read_options(words);
  }
  set_output_format(typed, provenance.has_value());
  require_no_conflict(typed);
  read_place_column(typed);
  if (typed.has(option::meta) && !provenance) provenance.emplace();
  if (provenance) provenance->meta = new_provenance(typed);
  Job job = make_job(typed);
  job.meta = std::move(provenance);
  return {{}, std::move(job)};
}

namespace {

/// Throws: Error (usage) unless a sampling option is given, and the range of the samples runs forwards.
void require_samples(const TypedOptions& typed) {
  const bool given = std::ranges::any_of(sampling_options, [&](auto option) { return typed.has(option); });
  if (!given && !typed.has(option::plot)) throw no_sampling_option(sampling_options);
  const SamplingRequest& sampling = typed.job.sampling;
  if (sampling.from && sampling.to && *sampling.to < *sampling.from) {
    throw range_backwards(typed.text(option::from), typed.text(option::to));
  }
}

/// Throws: Error (usage) if standard input would be read twice.
void require_one_reader(const TypedOptions& typed) {
  const bool keys_from_input = std::ranges::count(typed.job.files, "-") > 0;
  const bool no_files = typed.job.files.empty();
  const auto require = [](bool reads_twice, std::string_view option) {
    if (reads_twice) throw standard_input_twice().about(option);
  };
  require(typed.text(option::files) == "-" && keys_from_input, option::files);
  const std::string_view places = typed.has(option::at) ? option::at : option::arc_at;
  require(typed.places_from_input && (keys_from_input || no_files), places);
  require(typed.text(option::check) == "-" && (keys_from_input || no_files), option::check);
  require(typed.text(option::identify) == "-" && (keys_from_input || no_files), option::identify);
}

void set_comparison(Job& job, const TypedOptions& typed) {
  job.comparison = typed.comparison;
  if (job.files.size() > 1) {
    throw comparison_of_several_files(job.files.size())
        .about(typed.comparison.identify ? option::identify : option::check);
  }
}

/// The samples of a picture, where no option asks for others.
void set_plot(Job& job, const TypedOptions& typed) {
  const bool sampled = std::ranges::any_of(sampling_options, [&](auto option) { return typed.has(option); });
  if (sampled || !typed.has(option::plot)) return;
  job.sampling.mode = Mode::segments;
  job.sampling.count = 50;
}

/// A row at a key has the values of the segment after it, unless no field can differ between the two.
void set_side(Job& job, const TypedOptions& typed) {
  if (typed.has(option::side)) return;
  job.sampling.from_left = !job.fields.empty() &&
                           std::ranges::none_of(job.fields, [](std::size_t field) { return fields()[field].has_side; });
}

void set_verbosity(Job& job, const TypedOptions& typed) {
  const bool quiet = typed.has(option::quiet), terminal = ::isatty(STDERR_FILENO) != 0;
  const bool to_file = typed.has(option::output) || typed.has(option::output_dir) || ::isatty(STDOUT_FILENO) == 0;
  const bool by_default = to_file && !typed.has(option::no_progress) && !quiet;
  const bool progress = terminal && (typed.has(option::progress) || by_default);
  job.verbosity = {quiet, terminal && !quiet, progress, colors_messages(typed.color)};
}

}  // namespace

Job make_job(const TypedOptions& typed) {
  Job job = typed.job;
  require_one_reader(typed);
  if (typed.has(option::check) || typed.has(option::identify)) {
    set_comparison(job, typed);
  } else {
    require_samples(typed);
    set_plot(job, typed);
    if (typed.form) job.fields.insert(job.fields.begin(), {field_of("start"), field_of("duration"), *typed.form});
    if (job.fields.empty()) job.fields = field_list(std::string(row_of(option::fields).default_value));
  }
  if (job.files.empty() && job.batch.list.empty()) job.files = {"-"};
  (void)make_spec(job.curve);  // refuses rules that do not fit each other
  job.input.columns.timeless = job.curve.parameter.has_value();
  job.input.keys.keeps_decimals = typed.has(option::exact_input);
  if (typed.has(option::tcb) && job.input.keys.tcb_scale == TcbScale::max3ds) {
    for (double* const value :
         {&job.input.keys.tcb.tension, &job.input.keys.tcb.continuity, &job.input.keys.tcb.bias}) {
      *value = nearest_double(from_0_to_50(exact_time(Time(*value))));
    }
  }
  const bool to_terminal = job.output == "-" && !job.output_folder && ::isatty(STDOUT_FILENO) != 0;
  if (to_terminal && format_of(job.output_format).family == FormatFamily::array && !job.explain) {
    throw binary_to_terminal();
  }
  set_side(job, typed);
  set_verbosity(job, typed);
  job.notation = typed.notation;
  if (typed.has(option::golden)) job.golden = GoldenOptions{typed.has(option::exact_input), typed.notation};
  return job;
}

namespace {

/// An option as one word; numbers are listed in it, wherever they came from.
std::string word(const OptionRow& row, const TypedOptions& typed) {
  std::string word(row.name);
  if (row.kind != ValueKind::flag) word += "=" + typed.text(row.name);
  if (word.find_first_of("\r\n") != std::string::npos) {
    throw line_end_in_provenance().about(row.name);
  }
  return word;
}

/// Throws: Error unless all options of an earlier output are such that provenance has, --meta among them.
void require_recorded(const std::vector<std::string>& words) {
  const TypedOptions typed = read_options(words);
  for (const OptionRow& row : option_table()) {
    if (!typed.has(row.name) || row.changes_rows) continue;
    throw option_not_of_provenance(row.name);
  }
  if (!typed.job.files.empty()) throw file_in_provenance(typed.job.files[0]);
  if (!typed.has(option::meta)) throw provenance_without_meta();
}

}  // namespace

Provenance new_provenance(const TypedOptions& typed) {
  Provenance provenance;
  provenance.program = version_text();
  for (const OptionRow& row : option_table()) {
    if (row.changes_rows && typed.has(row.name)) provenance.options.push_back(word(row, typed));
  }
  return provenance;
}

ProvenanceRequest earlier_provenance(const TypedOptions& typed) {
  const std::string& from = typed.text(option::from_meta);
  for (const OptionRow& row : option_table()) {
    if (!row.changes_rows || !typed.has(row.name)) continue;
    throw option_besides_provenance(row.name, from);
  }
  ProvenanceRequest request;
  request.from = from;
  in_file(shown_name(from), [&] {
    EarlierOutput earlier = read_earlier_output(decompressed(read_file(from)));
    request.earlier.program = std::move(earlier.program);
    request.earlier.options = std::move(earlier.options);
    request.earlier.inputs = std::move(earlier.inputs);
    require_recorded(request.earlier.options);
  });
  const std::size_t files = std::max<std::size_t>(typed.job.files.size(), 1), before = request.earlier.inputs.size();
  const bool counted = typed.job.batch.list.empty() && !typed.job.batch.recursive;
  if (counted && files != before) throw other_number_of_files(from, before, files);
  return request;
}

}  // namespace tcb
