// Plan: from arguments to typed options, from these to the job, and the options that provenance records.
#include "cli/plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>
#include <CLI/CLI.hpp>

#include <algorithm>

#include "cli/options.hpp"
#include "io/compression.hpp"
#include "io/input_file.hpp"
#include "read/earlier_output.hpp"
#include "sample/curve_spec.hpp"
#include "sample/fields.hpp"
#include "text/suggest.hpp"

namespace tcb {
namespace {

/// Flags, and the lists that several options may give, as in --abs 1e-9 --abs x=1e-6.
bool may_repeat(const OptionRow& row) {
  return row.kind == ValueKind::flag || row.id == Option::abs || row.id == Option::rel || row.id == Option::ulp ||
         row.id == Option::rotation;
}

/// Checks and stores the value of an option; if a text is to be printed, only stores its text.
void store(const OptionRow& row, TypedOptions& typed, const std::vector<std::string>& values) {
  const bool wants_text = typed.wants_text();
  std::string& text = typed.texts[index_of(row.id)];
  text = row.kind == ValueKind::flag ? "true" : fmt::format("{}", fmt::join(values, ","));
  if (wants_text) return;
  try {
    if (values.size() > 1 && !may_repeat(row)) throw Error(Exit::usage, ErrorCode::option_repeated);
    if (std::ranges::count(values, "") > 0) throw Error(Exit::usage, ErrorCode::empty_value);
    row.store(typed, text);
  } catch (const Error& error) {
    throw error.about(row.long_name());
  }
}

/// Whether a word of the command line may name the option: it begins with its long name, or is a group of short names.
bool may_name(const std::string& word, const OptionRow& row) {
  return std::ranges::any_of(row.all_names(), [&word](std::string_view name) {
    if (name.starts_with("--")) return word.starts_with(name);
    return word.starts_with('-') && !word.starts_with("--") && word.find(name[1]) != std::string::npos;
  });
}

/// From the last to the first, so that an option for a text, such as --help, is stored before all others. CLI11
/// compares each new option with all others, so only those that the words may name are declared.
void declare(CLI::App& app, TypedOptions& typed, const std::vector<std::string>& words) {
  app.set_help_flag();
  app.add_option("FILE", typed.job.files);
  for (std::size_t i = option_count; i-- > 0;) {
    const OptionRow& row = option_table()[i];
    if (std::ranges::none_of(words, [&row](const std::string& word) { return may_name(word, row); })) continue;
    CLI::Option* const option = app.add_option(std::string(row.names), [&row, &typed](const CLI::results_t& values) {
      store(row, typed, values);
      return true;
    });
    option->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    if (row.kind == ValueKind::flag) option->expected(0)->disable_flag_override();  // --hex=false is no option
  }
}

/// CLI11's error as one of ours. It finds unknown options, flags with a value, and values that are missing at the end.
[[noreturn]] void refuse(const CLI::ParseError& error, const CLI::App& app, const std::vector<std::string>& words) {
  const auto name_of = [](const std::string& word) { return word.substr(0, word.find('=')); };
  std::vector<std::string> known, flags;
  for (const OptionRow& row : option_table()) {
    for (const std::string_view name : row.all_names()) {
      known.emplace_back(name);
      if (row.kind == ValueKind::flag) flags.emplace_back(name);
    }
  }
  if (const auto unknown = app.remaining(); dynamic_cast<const CLI::ExtrasError*>(&error) && !unknown.empty()) {
    throw Error(Exit::usage, ErrorCode::unknown_option, {name_of(unknown[0]), known});
  }
  for (const std::string& word : words) {
    const std::string name = name_of(word);
    if (name.size() < word.size() && std::ranges::count(flags, name) > 0) {
      throw Error(Exit::usage, ErrorCode::flag_with_value, {name});
    }
  }
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) && !words.empty()) {
    throw Error(Exit::usage, ErrorCode::value_missing, {name_of(words.back())});
  }
  throw Error(Exit::usage, ErrorCode::wrong_command_line, {std::string(error.what())});
}

std::string asked_text(const TypedOptions& typed, const std::vector<std::string>& words) {
  const bool is_long = std::ranges::count(words, row_of(Option::help).long_name()) > 0;
  if (typed.has(Option::help)) return is_long ? help_text() : short_help_text();
  if (typed.has(Option::list_presets)) return presets_text();
  if (typed.has(Option::version)) return version_text();
  return generated_text(*typed.generated, typed.job.files);
}

/// The option whose value may be left out has it in the same word, so that it does not take the name of a file.
/// Throws: Error (usage) for one without the value that its = announces, and for an empty value.
std::vector<std::string> with_values(std::vector<std::string> words) {
  const OptionRow& row = row_of(Option::file_column);
  const std::string name(row.long_name());
  for (auto word = words.begin(); word != words.end() && *word != "--"; ++word) {
    if (*word == name + "=") throw Error(Exit::usage, ErrorCode::value_missing, {name});
    if (*word != name) continue;
    if (word + 1 != words.end() && word[1].empty())
      throw Error(Exit::usage, ErrorCode::empty_value).about(row.long_name());
    *word += fmt::format("={}", row.default_value);
  }
  return words;
}

}  // namespace

TypedOptions read_options(const std::vector<std::string>& given) {
  const std::vector<std::string> words = with_values(given);
  TypedOptions typed;
  CLI::App app;
  declare(app, typed, words);
  try {
    app.parse(std::vector(words.rbegin(), words.rend()));  // CLI11 takes them from the back
  } catch (const CLI::ParseError& error) {
    refuse(error, app, words);
  }
  if (std::ranges::count(typed.job.files, "") > 0) throw Error(Exit::usage, ErrorCode::empty_file_name);
  return typed;
}

Invocation parse(int argc, const char* const* argv) {
  std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  if (words.empty() && ::isatty(STDIN_FILENO) != 0) return {usage_text(), {}, Exit::usage};
  TypedOptions typed = read_options(words);
  if (typed.wants_text()) return {asked_text(typed, words)};
  std::optional<ProvenanceRequest> provenance;
  if (typed.has(Option::from_meta)) {
    provenance = earlier_provenance(typed);
    words.insert(words.begin(), provenance->earlier.options.begin(), provenance->earlier.options.end());
    typed = read_options(words);
  }
  set_output_format(typed, provenance.has_value());
  require_no_conflict(typed);
  read_place_column(typed);
  if (typed.has(Option::meta) && !provenance) provenance.emplace();
  if (provenance) provenance->meta = new_provenance(typed);
  Job job = make_job(typed);
  job.meta = std::move(provenance);
  return {{}, std::move(job)};
}

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
  if (!given && !typed.has(Option::plot)) throw Error(Exit::usage, ErrorCode::no_sampling_option, {names});
  const SamplingRequest& sampling = typed.job.sampling;
  if (sampling.from && sampling.to && *sampling.to < *sampling.from) {
    throw Error(Exit::usage, ErrorCode::range_backwards, {typed.text(Option::to), typed.text(Option::from)});
  }
}

/// Throws: Error (usage) if standard input would be read twice.
void require_one_reader(const TypedOptions& typed) {
  const bool keys_from_input = std::ranges::count(typed.job.files, "-") > 0;
  const bool no_files = typed.job.files.empty();
  const auto require = [](bool reads_twice, Option option) {
    if (reads_twice) throw Error(Exit::usage, ErrorCode::standard_input_twice).about(row_of(option).long_name());
  };
  require(typed.text(Option::files) == "-" && keys_from_input, Option::files);
  const Option places = typed.has(Option::at) ? Option::at : Option::arc_at;
  require(typed.places_from_input && (keys_from_input || no_files), places);
  require(typed.text(Option::check) == "-" && (keys_from_input || no_files), Option::check);
  require(typed.text(Option::identify) == "-" && (keys_from_input || no_files), Option::identify);
}

void set_comparison(Job& job, const TypedOptions& typed) {
  job.comparison = typed.comparison;
  if (job.files.size() > 1) {
    throw Error(Exit::usage, ErrorCode::comparison_of_several_files, {std::uint64_t(job.files.size())})
        .about(typed.comparison.identify ? option::identify : option::check);
  }
}

/// The samples of a picture, where no option asks for others.
void set_plot(Job& job, const TypedOptions& typed) {
  const bool sampled = std::ranges::any_of(
      option_table(), [&](const OptionRow& row) { return sampling_options.has(row.id) && typed.has(row.id); });
  if (sampled || !typed.has(Option::plot)) return;
  job.sampling.mode = Mode::segments;
  job.sampling.count = 50;
}

/// A row at a key has the values of the segment after it, unless no field can differ between the two.
void set_side(Job& job, const TypedOptions& typed) {
  if (typed.has(Option::side)) return;
  job.sampling.from_left = !job.fields.empty() &&
                           std::ranges::none_of(job.fields, [](std::size_t field) { return fields()[field].has_side; });
}

void set_verbosity(Job& job, const TypedOptions& typed) {
  const bool quiet = typed.has(Option::quiet), terminal = ::isatty(STDERR_FILENO) != 0;
  const bool to_file = typed.has(Option::output) || typed.has(Option::output_dir) || ::isatty(STDOUT_FILENO) == 0;
  const bool by_default = to_file && !typed.has(Option::no_progress) && !quiet;
  const bool progress = terminal && (typed.has(Option::progress) || by_default);
  job.verbosity = {quiet, terminal && !quiet, progress, colors_messages(typed.color)};
}

}  // namespace

Job make_job(const TypedOptions& typed) {
  Job job = typed.job;
  require_one_reader(typed);
  if (typed.has(Option::check) || typed.has(Option::identify)) {
    set_comparison(job, typed);
  } else {
    require_samples(typed);
    set_plot(job, typed);
    if (typed.form) job.fields.insert(job.fields.begin(), {field_of("start"), field_of("duration"), *typed.form});
    if (job.fields.empty()) job.fields = field_list(std::string(row_of(Option::fields).default_value));
  }
  if (job.files.empty() && job.batch.list.empty()) job.files = {"-"};
  (void)make_spec(job.curve);  // refuses rules that do not fit each other
  job.input.timeless = job.curve.parameter.has_value();
  job.input.keeps_decimals = typed.has(Option::exact_input);
  if (typed.has(Option::tcb) && job.input.tcb_scale == TcbScale::max3ds) {
    for (double* const value : {&job.input.tcb.tension, &job.input.tcb.continuity, &job.input.tcb.bias}) {
      *value = nearest_double(from_0_to_50(exact_time(Time(*value))));
    }
  }
  const bool to_terminal = job.output == "-" && !job.output_folder && ::isatty(STDOUT_FILENO) != 0;
  if (to_terminal && format_of(job.output_format).is_binary && !job.explain) {
    throw Error(Exit::usage, ErrorCode::binary_to_terminal);
  }
  set_side(job, typed);
  set_verbosity(job, typed);
  job.notation = typed.notation;
  if (typed.has(Option::golden)) job.golden = GoldenOptions{typed.has(Option::exact_input), typed.notation};
  return job;
}

namespace {

/// An option as one word; numbers are listed in it, wherever they came from.
std::string word(const OptionRow& row, const TypedOptions& typed) {
  std::string word(row.long_name());
  if (row.kind != ValueKind::flag) word += "=" + typed.text(row.id);
  if (word.find_first_of("\r\n") != std::string::npos) {
    throw Error(Exit::usage, ErrorCode::line_end_in_provenance).about(row.long_name());
  }
  return word;
}

/// Throws: Error unless all options of an earlier output are such that provenance has, --meta among them.
void require_recorded(const std::vector<std::string>& words) {
  const TypedOptions typed = read_options(words);
  for (const OptionRow& row : option_table()) {
    if (!typed.has(row.id) || row.changes_rows) continue;
    throw Error(Exit::data, ErrorCode::option_not_of_provenance).about(row.long_name());
  }
  if (!typed.job.files.empty()) throw Error(Exit::data, ErrorCode::file_in_provenance, {typed.job.files[0]});
  if (!typed.has(Option::meta)) throw Error(Exit::data, ErrorCode::provenance_incomplete).about(option::meta);
}

}  // namespace

Provenance new_provenance(const TypedOptions& typed) {
  Provenance provenance;
  provenance.program = version_text();
  for (const OptionRow& row : option_table()) {
    if (row.changes_rows && typed.has(row.id)) provenance.options.push_back(word(row, typed));
  }
  return provenance;
}

ProvenanceRequest earlier_provenance(const TypedOptions& typed) {
  const std::string& from = typed.text(Option::from_meta);
  for (const OptionRow& row : option_table()) {
    if (!row.changes_rows || !typed.has(row.id)) continue;
    throw Error(Exit::usage, ErrorCode::option_in_provenance, {from}).about(row.long_name());
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
  const std::uint64_t files = std::max<std::size_t>(typed.job.files.size(), 1), before = request.earlier.inputs.size();
  const bool counted = typed.job.batch.list.empty() && !typed.job.batch.recursive;
  if (counted && files != before) throw Error(Exit::usage, ErrorCode::other_number_of_files, {from, before, files});
  return request;
}

}  // namespace tcb
