// Plan: from typed options to the job.
#include "cli/plan.hpp"

#include <unistd.h>

#include <algorithm>

#include "cli/validators.hpp"
#include "curve/curve_spec.hpp"
#include "curve/fields.hpp"

namespace tcb {
namespace {

/// Throws: Error (usage) unless a sampling option is given, and the range of the samples runs forwards.
void require_samples(const TypedOptions& typed) {
  std::vector<std::string> names;
  bool given = false;
  for (const OptionRow& row : option_table()) {
    if (!sampling_options.has(row.id)) continue;
    names.emplace_back(row.long_name());
    given = given || typed.has(row.id);
  }
  if (!given) throw Error(Exit::usage, ErrorCode::no_sampling_option, {names});
  const SamplingRequest& sampling = typed.job.sampling;
  if (sampling.from && sampling.to && *sampling.to < *sampling.from) {
    throw Error(Exit::usage, ErrorCode::range_backwards, {typed.text(Option::to), typed.text(Option::from)});
  }
}

/// Throws: Error (usage) where standard input would be read twice.
void require_one_reader(const TypedOptions& typed) {
  const bool keys_from_input = std::ranges::count(typed.job.files, "-") > 0;
  const bool no_files = typed.job.files.empty();
  const auto require = [](bool reads_twice, Option option) {
    if (reads_twice) throw Error(Exit::usage, ErrorCode::standard_input_twice).about(option);
  };
  require(typed.text(Option::files) == "-" && keys_from_input, Option::files);
  require(typed.text(Option::check) == "-" && (keys_from_input || no_files), Option::check);
  require(typed.text(Option::identify) == "-" && (keys_from_input || no_files), Option::identify);
}

void set_comparison(Job& job, const TypedOptions& typed) {
  job.comparison = typed.comparison;
  if (job.files.size() > 1) {
    throw Error(Exit::usage, ErrorCode::comparison_of_several_files, {std::uint64_t(job.files.size())})
        .about(typed.comparison.identify ? Option::identify : Option::check);
  }
}

/// A row at a key has the values of the segment after it, unless no field can differ between the two.
void set_side(Job& job, const TypedOptions& typed) {
  if (typed.has(Option::side)) return;
  job.sampling.from_left = !job.fields.empty() &&
                           std::ranges::none_of(job.fields, [](std::size_t field) { return fields()[field].has_side; });
}

void set_verbosity(Job& job, const TypedOptions& typed) {
  const bool quiet = typed.has(Option::quiet);
  const bool terminal = ::isatty(STDERR_FILENO) != 0;
  const bool rows_go_there =
      !typed.has(Option::output) && !typed.has(Option::output_dir) && ::isatty(STDOUT_FILENO) != 0;
  const bool by_default = !rows_go_there && !typed.has(Option::no_progress) && !quiet;
  job.verbosity = {quiet, terminal && !quiet, terminal && (typed.has(Option::progress) || by_default)};
}

}  // namespace

Job make_job(const TypedOptions& typed) {
  Job job = typed.job;
  require_one_reader(typed);
  if (typed.has(Option::check) || typed.has(Option::identify)) {
    set_comparison(job, typed);
  } else {
    require_samples(typed);
    if (job.fields.empty()) job.fields = field_list(std::string(row_of(Option::fields).default_value));
  }
  if (job.files.empty() && job.batch.list.empty()) job.files = {"-"};
  (void)make_spec(job.curve);  // refuses rules that do not fit each other
  job.input.timeless = job.curve.parameter.has_value();
  job.input.keeps_decimals = typed.has(Option::exact_input);
  set_side(job, typed);
  set_verbosity(job, typed);
  job.notation = typed.notation;
  if (typed.has(Option::golden)) job.golden = GoldenOptions{typed.has(Option::exact_input), typed.notation};
  return job;
}

}  // namespace tcb
