// The command line: every option declared once.
#include "cli/options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "cli/meta.hpp"
#include "cli/plan.hpp"
#include "cli/presets.hpp"
#include "cli/reference.hpp"
#include "cli/sampling.hpp"
#include "error.hpp"
#include "text/suggest.hpp"

namespace tcb {
namespace {

void declare_input(CLI::App& app, TypedOptions& typed) {
  app.add_option("FILE", typed.files, "Files of keys; without any, or for -, standard input")->group("");
  const auto option = [&](const char* name, auto& value, const char* text) {
    return app.add_option(name, value, text)->group("Input");
  };
  const auto flag = [&](const char* name, bool& value, const char* text) {
    return app.add_flag(name, value, text)->group("Input");
  };
  option("-i,--input-format", typed.input_format,
         "csv, tsv, ssv (runs of blanks), json or jsonl; by default what the file's ending says, else JSON if the text "
         "begins with [ or {, else delimited text")
      ->type_name("FORMAT");
  option("-d,--delimiter", typed.delimiter,
         "Between cells: one character, or tab, comma, semicolon, space or pipe; by default the first of tab, ; , and "
         "blank that the first record has")
      ->type_name("CHAR");
  flag("--header", typed.header, "The first record names the columns; by default it does if a cell in it is no number");
  flag("--no-header", typed.no_header, "The first record is a key");
  option("--comment", typed.comment, "Lines that begin with this are skipped; default #; none: no line is")
      ->type_name("PREFIX");
  option("--columns", typed.columns,
         "Which columns are what, by name or number, as in time=frame,position=px:py:pz,tension=k,carry=label; by "
         "default by the header, or without one the time first and positions after it")
      ->type_name("ROLE=NAME,...");
  option("--tcb", typed.tcb, "Tension, continuity and bias of keys that carry none; default 0,0,0")->type_name("T,C,B");
  option("--decimal", typed.decimal, "The mark before the decimals of numbers: . (default) or , (a comma)")
      ->type_name("MARK");
}

void declare_curves(CLI::App& app, TypedOptions& typed) {
  const auto option = [&](const char* name, auto& value, const char* text) {
    return app.add_option(name, value, text)->group("Input");
  };
  option("-g,--group", typed.group,
         "Rows with the same values in these columns make a curve, in any order; the columns are repeated in front of "
         "its samples")
      ->type_name("COL[,COL]");
  option(
      "--missing", typed.missing,
      "What becomes of a cell that is empty, NA, nan or null: error (default); skip-row leaves the key out; skip-cell "
      "takes that channel through its other keys; break begins a new curve behind it")
      ->type_name("WAY");
  option(
      "--duplicates", typed.duplicates,
      "What becomes of keys with equal times: error (default); first or last keeps that one; break begins a new curve "
      "with the second")
      ->type_name("WAY");
  app.add_flag("--sort", typed.sort, "Keys are sorted by time first; those of equal times stay as they came")
      ->group("Input");
}

void declare_curve(CLI::App& app, TypedOptions& typed) {
  CurveSettings& curve = typed.curve;
  const auto option = [&](const char* name, auto& value, const char* text) {
    return app.add_option(name, value, text)->group("Curve");
  };
  const auto flag = [&](const char* name, auto& value, const char* text) {
    return app.add_flag(name, value, text)->group("Curve");
  };
  option("--preset", curve.preset, "Tangents and ends as a product has them, see --list-presets; default gte")
      ->type_name("NAME");
  option("--tangents", curve.tangents, "The rule for the tangents at inner keys, instead of the preset's")
      ->type_name("RULE");
  option("--ends", curve.ends,
         "The rule for the outer tangents at the first and the last key, one or one for each, instead of the preset's; "
         "velocity=V:V... gives a velocity, a number for each channel")
      ->type_name("RULE[,RULE]");
  flag("--closed", typed.closed,
       "The curve goes on from the last key to the first; a last key that repeats the first "
       "position only says when");
  option("--period", curve.period, "How long a closed curve takes to be back at its first key; implies --closed")
      ->type_name("P");
  flag("--equal-speed", curve.equal_speed, "The two tangents of a key are made equally fast, also where C is not 0");
  option("--parameter", curve.parameter,
         "Makes times for keys without any: uniform (default), chordal, centripetal, or the exponent of the distances")
      ->type_name("NAME");
  option("--metric", curve.metric, "The channels that lengths and speeds are over, by name or number; default: all")
      ->type_name("CHANNEL,...");
  flag("--no-ease", curve.no_ease, "Columns ease_in and ease_out do not count");
  option("--extrapolate", curve.extrapolate,
         "What stands for times outside the curve: error (default), hold, linear, repeat, offset or oscillate")
      ->type_name("WAY");
}

void declare_sampling(CLI::App& app, TypedOptions& typed) {
  const auto option = [&](const char* name, auto& value, const char* text) {
    return app.add_option(name, value, text)->group("Sampling");
  };
  option("-s,--step", typed.step, "Samples every H of time from the first key; H is a decimal or a ratio such as 1/24")
      ->type_name("H");
  option("--rate,--fps", typed.rate, "Samples this often per unit of time: a step of exactly 1/HZ")->type_name("HZ");
  option("-n,--count", typed.count, "N samples equally spaced in time, the first and the last key among them")
      ->type_name("N");
  option("--segments", typed.segments, "N equal intervals of time, so N+1 samples")->type_name("N");
  option("--per-segment", typed.per_segment, "N equal intervals in every segment between two keys")->type_name("N");
  option("--at", typed.at, "These times, in this order; @FILE: those in a file, apart by blanks, commas or lines")
      ->type_name("T,...");
  option("-a,--arc-step", typed.arc_step, "Samples every H of arc length from the first key")->type_name("H");
  option("--arc-count", typed.arc_count, "N samples equally spaced in arc length, both ends among them")
      ->type_name("N");
  option("--arc-at", typed.arc_at, "These arc lengths, in this order; @FILE: those in a file")->type_name("S,...");
  option("--tolerance", typed.tolerance,
         "The fewest samples whose polyline stays within D of the curve, over the metric channels")
      ->type_name("D");
  option("--from", typed.from,
         "Where sampling begins, in time, or in arc length for the arc modes; default: the first key")
      ->type_name("T");
  option("--to", typed.to, "Where sampling ends; default: the last key")->type_name("T");
}

void declare_range(CLI::App& app, TypedOptions& typed) {
  const auto option = [&](const char* name, auto& value, const char* text) {
    return app.add_option(name, value, text)->group("Sampling");
  };
  option(
      "--end", typed.end,
      "Where steps do not meet the end: drop (default) stops before it; keep adds it after a shorter step; fit takes "
      "the nearest whole number of equal steps, fit-down the largest steps that are not larger, fit-up the smallest "
      "that are not smaller")
      ->type_name("POLICY");
  app.add_flag("--keys", typed.keys, "Every key is a sample too; one within a billionth of a step gives way to it")
      ->group("Sampling");
  option("--max-rows", typed.max_rows, "Refuses to make more samples than this; default 1e9")->type_name("N");
}

void declare_output(CLI::App& app, TypedOptions& typed) {
  const auto option = [&](const char* name, auto& value, const char* text) {
    return app.add_option(name, value, text)->group("Output");
  };
  option("-o,--output", typed.output, "Writes to FILE, which appears when it is complete; -: standard output")
      ->type_name("FILE");
  option("-f,--output-format", typed.output_format, "csv (default), tsv, ssv, json, jsonl, or npy (an array for NumPy)")
      ->type_name("FORMAT");
  option("--fields", typed.fields,
         "What a row shows, in order: time, position, s (arc length), velocity, acceleration, jerk, speed, tangent, "
         "curvature, torsion, segment, u, key, arc_error; default time,position")
      ->type_name("FIELD,...");
  option(
      "--side", typed.side,
      "At a key, what differs from one side to the other is that of the segment behind it, right (default), or before "
      "it, left")
      ->type_name("SIDE");
  option("--digits", typed.digits,
         "Numbers have N significant digits, 1 to 17, or with --golden to 100; the default is the shortest text that "
         "reads back as the same double")
      ->type_name("N");
  option("--fixed", typed.fixed, "Numbers have N decimals, 0 to 100")->type_name("N");
  option("-j,--jobs", typed.jobs,
         "How many threads to use; default one a core, and a single one for a live pipe. The bytes are the same for "
         "every N")
      ->type_name("N");
  const auto flag = [&](const char* name, bool& value, const char* text) {
    return app.add_flag(name, value, text)->group("Output");
  };
  flag("--golden", typed.golden, "Every number is the exact one, rounded once; slow");
  flag("--exact-input", typed.exact_input,
       "With --golden, a decimal in the input is that decimal, not the double nearest to it");
  flag("--meta", typed.meta,
       "Provenance goes with the rows: version, rules, options, SHA-256 of the input, and counts, as comment lines or "
       "in "
       "JSON as an object");
  option("--from-meta", typed.from_meta, "Makes FILE, an output with provenance, again: takes all options from it")
      ->type_name("FILE");
  flag("--hex", typed.hex, "Numbers are C's hexadecimal, as 0x1.8p+1, which strtod reads back bit for bit");
  flag("--no-output-header", typed.no_output_header, "No names above the rows; the default where the input has none");
}

void declare_batch(CLI::App& app, TypedOptions& typed) {
  const auto option = [&](const char* name, auto& value, const char* text) {
    return app.add_option(name, value, text)->group("Many files");
  };
  const auto flag = [&](const char* name, bool& value, const char* text) {
    return app.add_flag(name, value, text)->group("Many files");
  };
  option("--output-dir", typed.output_dir, "Writes a file for each input into this folder, with the format's ending")
      ->type_name("DIR");
  option("--files", typed.list, "More files, one a line of LIST; -: standard input")->type_name("LIST");
  flag("-0,--null", typed.nul, "The names in LIST end in NUL, not in a new line");
  flag("--recursive", typed.recursive,
       "A folder stands for the files below it that end as a format does, or with --input-format for all; the tree is "
       "mirrored in DIR");
  option("--suffix", typed.suffix, "What to append to the outputs' names, before the ending")->type_name("S");
  flag("--update", typed.update, "Only files that are newer than their outputs, or have none");
  flag("--fail-fast", typed.fail_fast, "Stops at the first file that fails; without it the others are finished");
}

void declare_comparison(CLI::App& app, TypedOptions& typed) {
  const auto option = [&](const char* name, auto& value, const char* text) {
    return app.add_option(name, value, text)->group("Comparison");
  };
  option("--check", typed.check,
         "Compares the samples in FILE, from anywhere, with the curve at their times, or arc lengths s, and prints a "
         "report; exit code 1 where they differ")
      ->type_name("FILE");
  option("--abs", typed.abs, "With --check: numbers may be this far apart, in all columns or in one, as in x=1e-6")
      ->type_name("[COL=]D,...")
      ->join(',');
  option("--rel", typed.rel, "The same in parts of the curve's number")->type_name("[COL=]D,...")->join(',');
  option("--ulp", typed.ulp, "The same in doubles from one to the other; default 0, so equality")
      ->type_name("[COL=]N,...")
      ->join(',');
  option("--identify", typed.identify,
         "Says which tangents, ends, speeds, and order and signs of T, C, B made the positions in FILE, with a ranked "
         "table; exit code 1 if none did")
      ->type_name("FILE");
}

void declare_about(CLI::App& app, TypedOptions& typed) {
  app.add_flag("--explain", typed.explain, "Says what was found and would be done, without samples")->group("About");
  app.add_flag("--progress", typed.progress,
               "Shows on a terminal how far the work is, once it takes a second, also where rows go to it; by default "
               "where they do not")
      ->group("About");
  app.add_flag("--no-progress", typed.no_progress, "Does not show how far the work is")->group("About");
  app.add_flag("-q,--quiet", typed.quiet, "Nothing but errors on standard error")->group("About");
  app.add_option("--generate", typed.generate,
                 "Prints the manual page, or completions for a shell: man, bash, zsh or fish")
      ->type_name("KIND")
      ->group("About");
  app.add_flag("--list-presets", typed.list_presets, "Prints the presets and the rules with their formulas")
      ->group("About");
  app.add_flag("-V,--version", typed.version, "Prints the version")->group("About");
  app.add_flag("-h,--help", typed.help, "Prints this help")->group("About");
}

/// CLI11's complaint as one of ours: what is wrong, and the remedy.
[[noreturn]] void refuse(const CLI::App& app, const CLI::ParseError& error, const CLI::App& parsed) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const auto& name : option->get_lnames()) names.push_back("--" + name);
    for (const auto& name : option->get_snames()) names.push_back("-" + name);
  }
  const std::vector<std::string_view> known(names.begin(), names.end());
  const auto unknown = parsed.remaining();
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr && !unknown.empty()) {
    const std::string name = unknown.front().substr(0, unknown.front().find('='));
    throw Error(Exit::usage, "unknown option " + name + did_you_mean(name, known) + " (--help lists all options)");
  }
  const std::string what = error.what();
  if (const std::size_t at = what.find(": At Most 1 required but received"); at != std::string::npos) {
    throw Error(Exit::usage, what.substr(0, at) + " is there more than once; expected it once; take one out");
  }
  if (const std::size_t at = what.find(" was given a disallowed flag override"); at != std::string::npos) {
    throw Error(Exit::usage, "--" + what.substr(0, at) + " takes no value; take it out");
  }
  throw Error(Exit::usage, what + "; see --help");
}

}  // namespace

std::unique_ptr<CLI::App> declare(TypedOptions& typed) {
  auto app = std::make_unique<CLI::App>("Resamples curves through keys with tension, continuity and bias", "tcbsample");
  app->set_help_flag();
  declare_input(*app, typed);
  declare_curves(*app, typed);
  declare_curve(*app, typed);
  declare_sampling(*app, typed);
  declare_range(*app, typed);
  declare_output(*app, typed);
  declare_batch(*app, typed);
  declare_comparison(*app, typed);
  declare_about(*app, typed);
  for (CLI::Option* option : app->get_options()) {
    if (option->get_items_expected_max() == 0) option->disable_flag_override();  // --hex=false is no option
  }
  return app;
}

void read_words(CLI::App& app, std::vector<std::string> words) {
  std::ranges::reverse(words);  // as CLI11 takes them
  try {
    app.parse(std::move(words));
  } catch (const CLI::ParseError& error) {
    refuse(app, error, app);
  }
  for (const CLI::Option* option : app.get_options()) {
    if (option->count() > 0 && std::ranges::count(option->results(), "") > 0) {
      throw Error(Exit::usage,
                  option->get_name() + ": an empty value; expected one as in --help; give it, or take the option out");
    }
  }
}

Invocation parse(int argc, const char* const* argv) {
  TypedOptions typed;
  auto app = declare(typed);
  std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  read_words(*app, words);
  if (typed.help) return {help_text(*app), {}};
  if (typed.list_presets) return {presets_text(), {}};
  if (typed.version) return {version_text(), {}};
  if (!typed.generate.empty()) return {generated_text(*app, typed.generate), {}};
  std::optional<ProvenanceRequest> meta;
  if (!typed.from_meta.empty()) {
    meta = earlier_meta(*app, typed);
    words.insert(words.begin(), meta->earlier.options.begin(), meta->earlier.options.end());
    typed = {};
    app = declare(typed);
    read_words(*app, words);
  }
  take_lists(typed);
  if (typed.meta) {
    const ProvenanceRequest earlier = meta.value_or(ProvenanceRequest{});
    meta = ProvenanceRequest{new_meta(*app, typed), earlier.earlier, earlier.from};
  }
  Job plan = make_plan(typed);
  plan.meta = std::move(meta);
  return {std::nullopt, std::move(plan)};
}

}  // namespace tcb
