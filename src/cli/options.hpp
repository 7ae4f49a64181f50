// The command line: every option declared once, checked, and turned into a plan.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/job.hpp"

namespace CLI {
class App;
}

namespace tcb {

/// What was typed, option by option; what it means is a Job.
struct TypedOptions {
  std::vector<std::string> files;
  std::string input_format, delimiter, comment, columns, tcb, group, missing, duplicates, decimal;
  bool header = false, no_header = false, sort = false;
  CurveSettings curve;
  bool closed = false;
  std::string step, rate, count, segments, per_segment, at, arc_step, arc_count, arc_at, tolerance;
  std::string end, max_rows, side, jobs;
  bool keys = false, explain = false, quiet = false;
  std::string from, to;
  std::string output, output_dir, output_format, fields;
  std::string digits, fixed;
  bool hex = false, golden = false, exact_input = false;
  bool no_output_header = false;
  std::string list, suffix;
  bool nul = false, recursive = false, update = false, fail_fast = false, progress = false, no_progress = false;
  bool meta = false;
  std::string from_meta;
  std::string check, abs, rel, ulp, identify;
  std::string generate;
  bool list_presets = false, help = false, version = false;
};

/// All options, bound to the fields of `typed`: the one place where they are declared.
std::unique_ptr<CLI::App> declare(TypedOptions& typed);

/// Sets what the words say, none of them empty. Throws: Error (usage).
void read_words(CLI::App& app, std::vector<std::string> words);

/// What the program is asked for: a text to print, or else a plan to carry out.
struct Invocation {
  std::optional<std::string> text;
  Job plan;
};

/// Throws: Error (usage) that names the option, what was expected, and the remedy.
Invocation parse(int argc, const char* const* argv);

}  // namespace tcb
