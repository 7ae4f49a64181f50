// Fuzzer of the whole program: for any options and any input it prints valid rows or an error, and the same with one
// thread and with four.
//
// Most inputs are new command lines with new keys, in which options agree with each other and with the keys, so that
// more than half of the runs succeed; the others are mutations. At its end the fuzzer reports the runs of each mode and
// format, and how many succeeded. Everything follows from libFuzzer's seed.
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "cli/plan.hpp"
#include "error.hpp"
#include "formats/formats.hpp"
#include "invariant.hpp"
#include "io/terminal.hpp"
#include "numbers/parse_number.hpp"
#include "read/input.hpp"
#include "read/input_options.hpp"
#include "sample/fields.hpp"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace tcb::fuzz {
namespace {

constexpr std::uint64_t most_rows = 300;

std::vector<std::string_view> split(std::string_view text, char delimiter) {
  std::vector<std::string_view> parts;
  for (;;) {
    parts.push_back(text.substr(0, text.find(delimiter)));
    if (parts.back().size() == text.size()) return parts;
    text.remove_prefix(parts.back().size() + 1);
  }
}

/// A file in memory that replaces standard input or output.
class MemoryFile {
 public:
  explicit MemoryFile(int descriptor) : descriptor_(descriptor) {
    const int file = ::memfd_create("fuzz", MFD_CLOEXEC);
    require(file >= 0 && ::dup2(file, descriptor) == descriptor, "no file in memory", "");
    ::close(file);
  }

  void set(std::string_view text) const {
    const bool emptied = ::ftruncate(descriptor_, 0) == 0 && ::lseek(descriptor_, 0, SEEK_SET) == 0;
    const ssize_t count = ::pwrite(descriptor_, text.data(), text.size(), 0);
    require(emptied && count == static_cast<ssize_t>(text.size()), "a file in memory fails", "");
  }

  std::string text() const {
    std::string text(static_cast<std::size_t>(::lseek(descriptor_, 0, SEEK_END)), '\0');
    const ssize_t count = ::pread(descriptor_, text.data(), text.size(), 0);
    require(count == static_cast<ssize_t>(text.size()), "a file in memory fails", "");
    return text;
  }

 private:
  int descriptor_;
};

/// The samples of a comparison, which are made from its keys.
constexpr int samples_descriptor = 100;
constexpr const char* samples_path = "/proc/self/fd/100";

/// Slashes are allowed in ratios only: the fuzzer uses no files but standard input and the samples of comparisons.
bool names_a_file(std::string_view options) {
  for (std::size_t i = 0; i < options.size(); ++i) {
    const bool ratio = i > 0 && std::isdigit(static_cast<unsigned char>(options[i - 1])) != 0;
    if (options[i] == '@' || (options[i] == '/' && !ratio)) return true;
  }
  return false;
}

/// Jobs that read keys or recordings and write rows, a picture or an explanation.
template <class Product>
concept ReadsFiles = requires(Product job) {
  job.files;
};

/// The job of a line of options, from standard input to standard output with few rows; nothing for other jobs, and for
/// options that are refused.
std::optional<Job> job_of(std::string_view line) {
  if (names_a_file(line) || find_invalid_utf8(line) != std::string_view::npos) return std::nullopt;
  std::vector<std::string> words;
  for (const std::string_view word : split(line, ' ')) {
    if (!word.empty()) words.emplace_back(word.substr(0, word.find('\0')));
  }
  try {
    Job job = tcb::parse(words);
    const auto limit = []<class Product>(Product& one) {
      if constexpr (ReadsFiles<Product>) {
        one.files = {};
        one.files.files = {"-"};
        if constexpr (requires { one.verbosity; }) one.verbosity = {.quiet = true};
        if constexpr (requires { one.samples; }) {
          std::uint64_t& most = one.samples.request.max_rows;
          most = std::min(most, most_rows);
        }
      } else if constexpr (std::is_same_v<Product, CompareJob>) {
        one.comparison.keys_file = "-";
        one.comparison.file = samples_path;
        one.output = "-";
        one.verbosity = {.quiet = true};
      } else if constexpr (std::is_same_v<Product, LimitsJob>) {
        one.keys_file = one.output = "-";
        one.verbosity = {.quiet = true};
      }
      return !std::is_same_v<Product, PrintText> && !std::is_same_v<Product, RetimeJob>;
    };
    return std::visit(limit, job) ? std::optional(job) : std::nullopt;
  } catch (const Error& error) {
    require(error.exit() == Exit::usage, "options refused as if they were data", error_text(error));
    require(error_text(error).starts_with("tcbsample: error: "), "options refused elsewhere", error_text(error));
    return std::nullopt;
  }
}

/// job_of() with a cache of recent lines, because parsing takes longer than everything else.
const std::optional<Job>& parsed(std::string_view line) {
  static std::map<std::string, std::optional<Job>, std::less<>> known;
  constexpr std::size_t most = 4096;
  if (const auto found = known.find(line); found != known.end()) return found->second;
  if (known.size() == most) known.clear();
  return known.emplace(line, job_of(line)).first->second;
}

/// The result: rows, or an error.
struct Outcome {
  std::string out, refusal;
};

/// Runs a job by the entry of its product.
struct Entry {
  Exit operator()(const ResampleJob& job) const { return resample(job); }
  Exit operator()(const ExplainJob& job) const { return explain(job); }
  Exit operator()(const PlotJob& job) const { return plot(job); }
  Exit operator()(const FitJob& job) const { return fit(job); }
  Exit operator()(const CompareJob& job) const {
    return compare(job) == Exit::interrupted ? Exit::interrupted : Exit::done;
  }
  Exit operator()(const LimitsJob& job) const {
    return measure_limits(job) == Exit::interrupted ? Exit::interrupted : Exit::done;
  }
  Exit operator()(const auto&) const { return Exit::usage; }
};

Outcome run(Job job, unsigned threads, std::string_view input) {
  static const MemoryFile in(STDIN_FILENO), out(STDOUT_FILENO);
  in.set(input);
  out.set("");
  const auto set_threads = [threads](auto& one) {
    if constexpr (requires { one.threads; }) one.threads.requested = threads;
    if constexpr (requires { one.comparison; }) one.comparison.threads.requested = threads;
  };
  std::visit(set_threads, job);
  try {
    require(std::visit(Entry(), job) == Exit::done, "a failure without a refusal", input);
    return {out.text(), {}};
  } catch (const Error& error) {
    require(error.exit() == Exit::data || error.exit() == Exit::usage, "no exit code", error_text(error));
    const std::string text = error_text(error);
    require_refusal(text, text.starts_with(samples_path) ? samples_path : "standard input");
    return {{}, error_text(error)};
  }
}

/// Makes the samples of a comparison: rows of the keys, or the keys if there are none.
void make_samples(std::string_view input) {
  static const MemoryFile samples(samples_descriptor);
  const Outcome rows = run(*parsed("--count=5"), 1, input);
  samples.set(rows.refusal.empty() ? std::string_view(rows.out) : input);
}

/// The name of a job's mode.
struct ModeName {
  std::string_view operator()(const ResampleJob& job) const {
    constexpr auto names = std::to_array<std::string_view>(
        {"step", "count", "segments", "per-segment", "at", "arc-step", "arc-count", "arc-at", "tolerance", "emit"});
    const SamplingRequest& request = job.samples.request;
    return request.is_rate ? "rate" : names[static_cast<std::size_t>(request.mode)];
  }
  std::string_view operator()(const ExplainJob&) const { return "explain"; }
  std::string_view operator()(const PlotJob&) const { return "plot"; }
  std::string_view operator()(const FitJob&) const { return "fit"; }
  std::string_view operator()(const CompareJob& job) const { return job.identify ? "identify" : "check"; }
  std::string_view operator()(const LimitsJob&) const { return "limits"; }
  std::string_view operator()(const auto&) const { return "other"; }
};

std::string_view output_format(const Job& job) {
  const auto name = [](const auto& one) -> std::string_view {
    if constexpr (requires { one.rows.format->name; }) return one.rows.format->name;
    if constexpr (requires { one.format->name; }) return one.format != nullptr ? one.format->name : "text";
    return "svg";
  };
  return std::visit(name, job);
}

/// The format of keys as it looks from their first bytes.
std::string_view input_format(std::string_view keys) {
  const std::string_view line = keys.substr(0, keys.find('\n'));
  if (line.starts_with('[') || line.starts_with("{\"keys\"")) return "json";
  if (line.starts_with('{')) return line.ends_with('}') && line.size() < keys.size() ? "jsonl" : "json";
  if (line.find('\t') != std::string_view::npos) return "tsv";
  return line.find(',') != std::string_view::npos ? "csv" : "ssv";
}

/// Counts runs by their modes and formats, and prints the counts at the end.
class Counts {
 public:
  Counts() {
    (void)std::atexit([] { known().print(); });
  }
  static Counts& known() {
    static Counts& counts = *new Counts;  // never destroyed, because it is printed at the end
    return counts;
  }

  void add_refused_options() { add("refused options", false); }
  void add_run(const Job& job, std::string_view input, bool succeeded) {
    add("runs", succeeded);
    add(fmt::format("mode {}", std::visit(ModeName(), job)), succeeded);
    const bool golden = std::visit([](const auto& one) { return is_golden(one); }, job);
    if (golden) add("mode golden", succeeded);
    add(fmt::format("input {}", input_format(input)), succeeded);
    add(fmt::format("output {}", output_format(job)), succeeded);
  }

 private:
  struct Count {
    std::uint64_t all = 0, succeeded = 0;
  };

  template <class Product>
  static bool is_golden(const Product& job) {
    if constexpr (requires { job.golden; }) return job.golden.has_value();
    return false;
  }
  void add(const std::string& what, bool succeeded) {
    Count& count = counts_[what];
    ++count.all;
    count.succeeded += succeeded ? 1 : 0;
  }
  void print() const {
    for (const auto& [what, count] : counts_) {
      (void)std::fputs(fmt::format("count: {}: {}, succeeded: {}\n", what, count.all, count.succeeded).c_str(), stderr);
    }
  }

  std::map<std::string, Count> counts_;
};

/// Every cell of delimited rows is a finite number or empty, and time does not go back.
void require_sound_rows(std::string_view rows, char delimiter, bool ordered) {
  std::optional<Time> last;
  for (const std::string_view row : split(rows, '\n')) {
    if (row.starts_with('#')) continue;  // provenance
    const std::vector<std::string_view> cells = split(row, delimiter);
    for (const std::string_view cell : cells) {
      const bool undefined = cell.empty() || (delimiter == ' ' && cell == "NA");
      require(undefined || parse_number(cell).has_value(), "a cell that is no number", rows);
    }
    const auto time = parse_time(cells[0]);
    require(!ordered || !last || !time || !(*time < *last), "time goes back", rows);
    last = time;  // an empty row begins a new curve
  }
}

/// Checks the rows of a job. Requires: it ended without an error.
template <class Product>
void require_sound(const Product& job, std::string_view text, std::string_view rows) {
  const Format& format = *job.rows.format;
  if (format.is_binary || format.is_picture || (format.poses != nullptr && format.delimiter != 0)) return;
  if (format.name == "json") return require(nlohmann::json::accept(rows), "not JSON", rows);
  if (format.name == "jsonl") {
    for (const std::string_view row : split(rows, '\n')) {
      require(row.empty() || nlohmann::json::accept(row), "not JSON", rows);
    }
    return;
  }
  const auto bytes = [text, read = false]() mutable {
    return std::exchange(read, true) ? std::nullopt : std::optional(std::string(text));
  };
  const Input input = open_input("-", bytes, job.keys.input);
  if (!input.schema.groups.empty() || !input.schema.labels.empty()) return;  // their texts may be anything
  if (job.rows.time_notation || input.schema.time.notation != TimeNotation::seconds) return;  // times are words
  const auto drop_line = [&rows] { rows.remove_prefix(std::min(rows.size(), rows.find('\n') + 1)); };
  while (rows.starts_with('#')) drop_line();  // provenance
  if (job.rows.header.value_or(input.schema.named)) {
    if (rows.substr(0, rows.find('\n')).find('"') != std::string_view::npos) return;
    drop_line();
  }
  bool in_order = true;
  if constexpr (std::is_same_v<Product, ResampleJob>) {
    const Mode mode = job.samples.request.mode;
    in_order = mode != Mode::at && mode != Mode::arc_at;
  }
  const char delimiter = format.name == "csv" ? ',' : format.name == "tsv" ? '\t' : ' ';
  require_sound_rows(rows, delimiter, in_order && fields()[job.rows.fields[0]].name == "time");
}

}  // namespace
}  // namespace tcb::fuzz

namespace {

/// A kind of options of which a command line has one at most.
using Choices = std::vector<std::string_view>;

const Choices of_rules{
    "--preset=vtk",     "--preset=3dsmax",    "--tangents=interval-c", "--tangents=kb1984", "--ends=natural",
    "--ends=zero,half", "--closed",           "--period=99",           "--equal-speed",     "--no-ease",
    "--tcb=0.5,0,-1",   "--tangents=uniform", "--no-overshoot"};
const Choices of_numbers{"--digits=3", "--fixed=2", "--hex", "--meta", "--no-output-header"};
const Choices of_formats{"-f tsv", "-f ssv", "-f json", "-f jsonl", "-f npy", "-f tum", "-f kitti"};
const Choices of_fields{"--fields=time,position,s",       "--fields=time,s,speed,curvature",
                        "--fields=velocity,acceleration", "--fields=time,position,key,u",
                        "--fields=jerk,segment",          "--fields=tangent,torsion"};
const Choices of_range{"--from=1", "--to=2", "--from=1/3 --to=1.5", "--keys"};
const Choices of_step{"--end=keep", "--end=fit", "--end=fit-up", "--end=fit-down"};
const Choices of_places{"--extrapolate=hold", "--extrapolate=linear", "--extrapolate=repeat", "--extrapolate=offset"};
const Choices of_fit{"--fit-keys=hermite", "--corner=30"};
const Choices of_check{"--abs=0.1", "--rel=1e-6", "--fields=time,position"};
const Choices of_reading{"--sort",        "--duplicates=last", "--missing=skip-cell", "--missing=break",
                         "--scale=x=1/3", "--rename=x=px",     "--max-gap=1.5"};
const Choices of_reports{"-f json", "-f svg"};
const Choices of_explained{"-f json"};
const Choices of_exact{"--exact-input", "--digits=40", "--exact-input --digits=20"};

struct ModeOptions {
  Choices modes;
  std::vector<const Choices*> others;  ///< that have an effect in these modes
};

/// Every mode; each is drawn as often as the others.
const std::vector<ModeOptions> all_modes{
    {{"--count=1", "--count=4", "--count=9"},
     {&of_rules, &of_numbers, &of_formats, &of_fields, &of_range, &of_reading}},
    {{"--step=0.25", "--step=1/3"},
     {&of_rules, &of_numbers, &of_formats, &of_fields, &of_range, &of_step, &of_reading}},
    {{"--rate=7", "--fps=30000/1001"},
     {&of_rules, &of_numbers, &of_formats, &of_fields, &of_range, &of_step, &of_reading}},
    {{"--per-segment=3", "--per-segment=1"}, {&of_rules, &of_numbers, &of_formats, &of_fields, &of_reading}},
    {{"--at=0.5,2,1", "--at=0:2:0.5"}, {&of_rules, &of_numbers, &of_formats, &of_fields, &of_places, &of_reading}},
    {{"--arc-step=0.5", "--arc-step=2"}, {&of_rules, &of_numbers, &of_formats, &of_fields, &of_step, &of_reading}},
    {{"--arc-count=1", "--arc-count=4"}, {&of_rules, &of_numbers, &of_formats, &of_fields, &of_reading}},
    {{"--arc-at=0,0.25", "--arc-at=0:0.5:0.125"}, {&of_rules, &of_numbers, &of_formats, &of_fields, &of_reading}},
    {{"--tolerance=0.5", "--tolerance=0.01"}, {&of_rules, &of_numbers, &of_formats, &of_fields, &of_reading}},
    {{"--emit=hermite --no-ease", "--emit=bezier --no-ease", "--emit=poly --no-ease"},
     {&of_numbers, &of_formats, &of_reading}},
    {{"--fit=0.5", "--fit=0.01", "--fit=0.01 -f svg"}, {&of_fit, &of_reading}},
    {{"--plot", "--count=7 -f svg", "--plot --size=400x900"}, {&of_rules, &of_reading}},
    {{"--explain --count=4", "--explain --step=0.5", "--explain --arc-count=3"},
     {&of_rules, &of_explained, &of_reading}},
    {{"--golden --count=4", "--golden --at=0.5,2", "--golden --step=1/2"},  // lengths take seconds with sanitizers
     {&of_rules, &of_exact, &of_formats}},
    {{"--check=samples"}, {&of_rules, &of_check, &of_reports}},
    {{"--identify=samples"}, {&of_reports}},
    {{"--limits", "--limits=speed=2,jerk", "--limits=velocity_x=-1:2,acceleration"},
     {&of_rules, &of_range, &of_explained}},
};

/// Draws choices, the same on all machines.
class Draw {
 public:
  explicit Draw(unsigned seed) : random_(seed) {}

  std::size_t below(std::size_t end) { return (random_() >> 8) % end; }
  bool one_in(std::size_t count) { return below(count) == 0; }
  template <class Range>
  const auto& of(const Range& range) {
    return range[below(std::size(range))];
  }

 private:
  std::mt19937 random_;
};

/// New keys in one of the formats of input; `recorded`: without what only keys have.
std::string new_keys(Draw& draw, bool recorded) {
  constexpr auto numbers = std::to_array<std::string_view>(
      {"0", "1", "-1", "2.5", "7", "0.1", "1e-3", "-3.25", "100", "0.333333333333333333333"});
  constexpr auto quaternions = std::to_array<std::array<std::string_view, 4>>(
      {{"0", "0", "0", "1"}, {"0.6", "0", "0", "0.8"}, {"0.8", "0", "0", "0.6"}, {"0.5", "0.5", "-0.5", "0.5"}});
  constexpr auto parameters = std::to_array<std::string_view>({"0", "0.5", "-1", "1"});
  std::vector<std::string> names{"t", "x"};
  if (draw.below(3) > 0) names.emplace_back("y");
  if (draw.one_in(3)) names.emplace_back("z");
  const std::size_t channels = names.size() - 1;
  const bool has_rotation = draw.one_in(6), has_tcb = !recorded && draw.one_in(3),
             has_ease = !recorded && draw.one_in(8);
  if (has_rotation) names.insert(names.end(), {"qx", "qy", "qz", "qw"});
  if (has_tcb) names.insert(names.end(), {"tension", "continuity", "bias"});
  if (has_ease) names.insert(names.end(), {"ease_in", "ease_out"});
  std::vector<std::vector<std::string>> rows;
  const std::size_t keys = 3 + draw.below(4), first = draw.one_in(8) ? 1 : 0;
  for (std::size_t time = first * 1000; rows.size() < keys; time += 1 + draw.below(2)) {
    std::vector<std::string>& row = rows.emplace_back();
    row.push_back(std::to_string(time) + (draw.one_in(4) && first == 0 ? ".25" : ""));
    for (std::size_t i = 0; i < channels; ++i) row.emplace_back(draw.of(numbers));
    if (has_rotation) {
      for (const std::string_view number : draw.of(quaternions)) row.emplace_back(number);
    }
    for (std::size_t i = 0; has_tcb && i < 3; ++i) row.emplace_back(draw.of(parameters));
    for (std::size_t i = 0; has_ease && i < 2; ++i) row.emplace_back(draw.one_in(2) ? "0.25" : "0");
  }
  std::string text;
  const auto append_row = [&](const std::vector<std::string>& cells, char delimiter) {
    for (std::size_t i = 0; i < cells.size(); ++i) text += (i == 0 ? "" : std::string(1, delimiter)) + cells[i];
    text += '\n';
  };
  const auto append_object = [&](const std::vector<std::string>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      text += (i == 0 ? "{\"" : ",\"") + names[i] + "\":" + cells[i];
    }
    text += '}';
  };
  const std::size_t format = draw.below(6);
  if (format < 4) {
    const char delimiter = ",,\t "[format];
    append_row(names, delimiter);
    for (const auto& row : rows) append_row(row, delimiter);
  } else if (format == 4) {
    for (const auto& row : rows) {
      append_object(row);
      text += '\n';
    }
  } else {
    text = draw.one_in(2) ? "[" : "{\"keys\":[";
    const bool is_array = text.size() == 1;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (i > 0) text += ",\n";
      append_object(rows[i]);
    }
    text += is_array ? "]\n" : "]}\n";
  }
  return text;
}

/// A new command line whose options agree with each other: a mode, and up to three others that have an effect in it.
std::string new_options(Draw& draw) {
  const ModeOptions& mode = draw.of(all_modes);
  std::string line(draw.of(mode.modes));
  std::vector<const Choices*> others = mode.others;
  for (std::size_t count = draw.below(4); count > 0 && !others.empty(); --count) {
    const std::size_t kind = draw.below(others.size());
    (line += ' ') += draw.of(*others[kind]);
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(kind));
  }
  return line;
}

/// Any option, from those of all modes.
std::string_view any_option(Draw& draw) {
  const ModeOptions& mode = draw.of(all_modes);
  const std::size_t kind = draw.below(mode.others.size() + 1);
  return kind == mode.others.size() ? draw.of(mode.modes) : draw.of(*mode.others[kind]);
}

/// Whole options: bytes that are changed one by one hardly ever make several valid ones.
constexpr auto whole_options = std::to_array<std::string_view>({"--step=0.25",
                                                                "--step=1/3",
                                                                "--step=1e-9",
                                                                "--rate=7",
                                                                "--count=1",
                                                                "--count=4",
                                                                "--per-segment=3",
                                                                "--at=0.5,2,1",
                                                                "--at=-7,9",
                                                                "--arc-step=0.5",
                                                                "--arc-count=1",
                                                                "--arc-count=4",
                                                                "--arc-at=0,1",
                                                                "--tolerance=0.5",
                                                                "--tolerance=1e-9",
                                                                "--tolerance=1,2deg",
                                                                "--tolerance=0.1rad",
                                                                "--fit=0.5",
                                                                "--fit=0.01,x=1",
                                                                "--fit-keys=hermite",
                                                                "--corner=30",
                                                                "--emit=hermite",
                                                                "--emit=bezier",
                                                                "--emit=poly",
                                                                "--from=1",
                                                                "--from=-3",
                                                                "--from=99",
                                                                "--to=2",
                                                                "--to=99",
                                                                "--to=-3",
                                                                "--end=drop",
                                                                "--end=keep",
                                                                "--end=fit",
                                                                "--end=fit-up",
                                                                "--keys",
                                                                "--extrapolate=hold",
                                                                "--extrapolate=linear",
                                                                "--extrapolate=repeat",
                                                                "--extrapolate=offset",
                                                                "--extrapolate=oscillate",
                                                                "--closed",
                                                                "--period=9",
                                                                "--period=1/3",
                                                                "--equal-speed",
                                                                "--normalize",
                                                                "--rotation=none",
                                                                "--rotation=quaternion=1:2:3:4",
                                                                "--rotation=matrix=1:2:3:5:6:7:9:10:11",
                                                                "--rotation=euler=x:y:z,order=ZYX",
                                                                "--rotation=axis-angle=x:y:z:w,relative",
                                                                "--rotation-output=euler=XZX",
                                                                "--rotation-output=axis-angle",
                                                                "--rotation-output=matrix",
                                                                "--angles=degrees",
                                                                "--angle=x=degrees",
                                                                "--angle=1=radians",
                                                                "--rotation-curve=casteljau",
                                                                "--rotation-curve=components",
                                                                "--no-ease",
                                                                "--golden",
                                                                "--exact-input",
                                                                "--preset=3dsmax",
                                                                "--preset=vtk",
                                                                "--tangents=interval-c",
                                                                "--ends=natural",
                                                                "--ends=velocity=1:2",
                                                                "--parameter=0.5",
                                                                "--metric=1",
                                                                "--side=left",
                                                                "--missing=skip-cell",
                                                                "--missing=break",
                                                                "--missing=skip-row",
                                                                "--duplicates=last",
                                                                "--duplicates=break",
                                                                "--sort",
                                                                "--group=1",
                                                                "--columns=carry=2",
                                                                "--no-header",
                                                                "--no-output-header",
                                                                "--meta",
                                                                "--digits=3",
                                                                "--fixed=2",
                                                                "--hex",
                                                                "--output-format=json",
                                                                "--output-format=npy",
                                                                "--input-format=ssv",
                                                                "--decimal=,",
                                                                "--fields=time,s,speed,curvature,torsion",
                                                                "--fields=time,position,key,segment,u",
                                                                "--fields=jerk,arc_error",
                                                                "--fields=s,length",
                                                                "--input-fps=24",
                                                                "--input-fps=30000/1001",
                                                                "--time-unit=ms",
                                                                "--time-format=clock",
                                                                "--time-format=smpte",
                                                                "--time-format=iso",
                                                                "--scale=1=1/3",
                                                                "--rename=2=3"});

/// The line with a whole option more, less, or in the place of another.
std::string with_other_option(std::string_view line, unsigned seed) {
  std::vector<std::string_view> words;
  for (const std::string_view word : tcb::fuzz::split(line, ' ')) {
    if (!word.empty()) words.push_back(word);
  }
  Draw draw(seed);
  const std::string_view option = draw.one_in(3) ? any_option(draw) : draw.of(whole_options);
  const bool removes = seed / 8 % 4 == 0, replaces = seed / 8 % 4 == 1;
  if ((removes || replaces) && !words.empty()) words.erase(words.begin() + (seed / 32) % words.size());
  if (!removes) words.push_back(option);
  std::string result;
  for (const std::string_view word : words) (result += result.empty() ? "" : " ") += word;
  return result;
}

}  // namespace

/// In three of four cases a new command line with new keys. In the others libFuzzer's mutations, mostly of the input
/// alone, because new options take longer to parse than an input to resample; and other whole options.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
  if (Draw draw(seed); draw.below(4) > 0) {
    static const unsigned first_seed = seed;  // others for each seed of the fuzzer
    constexpr unsigned most_lines = 3000;     // parsed() keeps them
    Draw line(first_seed + static_cast<unsigned>(draw.below(most_lines)));
    const std::string options = new_options(line);
    const std::string fresh = options + '\n' + new_keys(draw, options.starts_with("--fit"));
    if (fresh.size() <= most) return static_cast<std::size_t>(std::ranges::copy(fresh, data).out - data);
  }
  const std::string_view all(reinterpret_cast<const char*>(data), size);
  const std::size_t input = std::min(all.find('\n'), all.size()) + 1;
  if (seed % 8 == 4 && input <= size) {
    const std::string changed =
        with_other_option(all.substr(0, input - 1), seed) + '\n' + std::string(all.substr(input));
    if (changed.size() <= most) return static_cast<std::size_t>(std::ranges::copy(changed, data).out - data);
  }
  if (seed % 4 == 0 || input > size || input >= most) return LLVMFuzzerMutate(data, size, most);
  return input + LLVMFuzzerMutate(data + input, size - input, most - input);
}

/// The first line is the options, the rest the input.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tcb::fuzz;
  const std::string_view all(reinterpret_cast<const char*>(data), size);
  const std::string_view line = all.substr(0, all.find('\n'));
  const std::string_view input = all.substr(std::min(all.size(), line.size() + 1));
  const auto& plan = parsed(line);
  if (!plan) {
    Counts::known().add_refused_options();
    return 0;
  }
  if (std::holds_alternative<tcb::CompareJob>(*plan)) make_samples(input);
  const Outcome outcome = run(*plan, 1, input);
  Counts::known().add_run(*plan, input, outcome.refusal.empty());
  const auto check_rows = [&](const auto& job) {
    if constexpr (requires { job.rows.format; }) require_sound(job, input, outcome.out);
  };
  if (outcome.refusal.empty()) std::visit(check_rows, *plan);
  if (size % 4 != 0) return 0;
  const Outcome threaded = run(*plan, 4, input);
  require_same(outcome.out, threaded.out, "-j 1 and -j 4");
  require_same(outcome.refusal, threaded.refusal, "-j 1 and -j 4");
  return 0;
}
