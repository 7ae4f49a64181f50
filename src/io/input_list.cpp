// Input lists: files that are named, listed, or found in folders, and the path of the output of each.
#include "io/input_list.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include "error.hpp"
#include "io/input_file.hpp"
#include "io/system.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

namespace fs = std::filesystem;

/// In bytes; systems allow less.
constexpr std::size_t longest_name = 65536;

/// The names in a list, without blank lines and carriage returns at the ends of lines. Names that end in NUL may not be
/// empty.
void append_listed(std::vector<std::string>& names, const InputListOptions& options) {
  const char end = options.nul ? '\0' : '\n';
  const Source<std::string> bytes = read_file(options.list);
  std::string name;
  bool is_first = true;
  const auto take = [&] {
    if (std::exchange(is_first, false) && name.starts_with(byte_order_mark)) name.erase(0, byte_order_mark.size());
    if (!options.nul && name.ends_with('\r')) name.pop_back();
    const bool blank = !options.nul && name.find_first_not_of(" \t") == std::string::npos;
    if (!name.empty() && !blank) names.push_back(name);
    name.clear();
  };
  while (const std::optional<std::string> text = bytes()) {
    for (const char c : *text) {
      if (c == end) {
        if (options.nul && name.empty())
          throw usage_error(
              "the list of files has an empty name; expected a name before each NUL byte, as find -print0 prints them")
              .in(shown_name(options.list));
        take();
      } else {
        if (c == '\0')
          throw usage_error(
              "the list of files has a NUL byte; expected one name per line; give --null if the names end in NUL")
              .in(shown_name(options.list));
        name += c;
        if (name.size() > longest_name)
          throw usage_error(
              "the list of files has a name of more than {} bytes; expected one name per line; give --null if the "
              "names end in NUL",
              longest_name)
              .in(shown_name(options.list));
      }
    }
  }
  take();
}

/// Whether it is no pipe or device. A link without a target counts as a file, so that reading it reports the error.
bool is_or_should_be_regular(const fs::directory_entry& entry) {
  std::error_code none;
  return entry.is_regular_file(none) || !entry.exists(none);
}

/// Whether a file in a folder is an input, by its ending before that of compressed files.
bool is_input(std::string_view path, const InputListOptions& options) {
  const auto ends = [&](std::string_view ending) { return without_compression(path).ends_with(ending); };
  return options.endings.empty() || std::ranges::any_of(options.endings, ends);
}

/// The files below a folder, sorted, except those below the output folder.
void append_folder(Inputs& inputs, const std::string& folder, const InputListOptions& options) {
  std::error_code error;
  const auto inside = static_cast<std::uint32_t>(system::path_text(fs::path(folder) / "").size());
  const std::size_t begin = inputs.files.size();
  fs::recursive_directory_iterator entry(folder, error);
  for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    std::error_code none;
    if (entry->is_directory(none)) {
      if (fs::equivalent(entry->path(), *options.outputs.folder, none)) entry.disable_recursion_pending();
    } else if (std::string path = system::path_text(entry->path());
               is_or_should_be_regular(*entry) && is_input(path, options)) {
      inputs.files.push_back({std::move(path), inside});
    } else {
      ++inputs.others;
    }
  }
  if (error) throw usage_error("the folder cannot be read: {}", error.message()).in(folder);
  std::sort(inputs.files.begin() + static_cast<std::ptrdiff_t>(begin), inputs.files.end(),
            [](const InputFile& a, const InputFile& b) { return a.path < b.path; });
}

/// Where outputs lead through links in the output folder.
class RealPaths {
 public:
  std::string of(const std::string& path) {
    std::error_code none;
    std::string folder = system::path_text(fs::path(path).parent_path());
    if (folder != folder_ || real_folder_.empty()) {
      real_folder_ = fs::weakly_canonical(folder.empty() ? "." : folder, none);
      if (none) real_folder_ = folder;
      folder_ = std::move(folder);
    }
    const fs::path target = fs::is_symlink(path, none) ? fs::canonical(path, none) : fs::path();
    const bool is_replaced = target.empty();  // also a link without a target
    return system::path_text(is_replaced ? real_folder_ / fs::path(path).filename() : target);
  }

 private:
  std::string folder_;  ///< the last one, whose files mostly follow one another
  fs::path real_folder_;
};

/// Throws: Error (usage) if two files have the same output.
void require_distinct_outputs(const std::vector<InputFile>& files, const OutputPaths& outputs) {
  std::vector<std::pair<std::size_t, std::size_t>> by_hash;  // so that not all paths are kept
  by_hash.reserve(files.size());
  RealPaths real;
  for (std::size_t i = 0; i < files.size(); ++i) {
    by_hash.emplace_back(std::hash<std::string>()(real.of(output_path(files[i], outputs))), i);
  }
  std::ranges::sort(by_hash);
  for (std::size_t i = 0; i < by_hash.size(); ++i) {
    const InputFile& file = files[by_hash[i].second];
    for (std::size_t j = i; j-- > 0 && by_hash[j].first == by_hash[i].first;) {
      const InputFile& other = files[by_hash[j].second];
      const std::string path = output_path(file, outputs);
      if (real.of(path) == real.of(output_path(other, outputs)))
        throw usage_error(
            "its output {} is also the output of {}; expected an output for each input; rename one of the inputs, or "
            "process them into different folders",
            path, other.path)
            .in(file.path);
    }
  }
}

/// The identity of the file at a path, however the path is spelled.
using Identity = std::pair<std::uint64_t, std::uint64_t>;

/// Nothing for pipes and devices, and where there is no file. `stream`: what "-" is.
std::optional<Identity> identity_of(const std::string& path, int stream) {
  const auto status = path == "-" ? system::status_of(stream) : system::status_of(path);
  return status && status->is_regular ? std::optional(status->identity) : std::nullopt;
}

Error output_over_input(const std::string& output) {
  if (output != "-")
    return usage_error("its output {} would replace an input; expected a different file; give another output", output);
  return usage_error("standard output would overwrite an input; expected a different file; send it to another file");
}

/// Throws: Error (usage) if an output would replace an input.
void require_not_over_inputs(const std::vector<InputFile>& files, const std::vector<Identity>& sorted_identities,
                             const OutputPaths& outputs) {
  const auto check = [&](const std::string& output, const std::string& input) {
    const auto there = identity_of(output, system::standard_output);
    if (there && std::ranges::binary_search(sorted_identities, *there)) {
      throw output_over_input(output).in(shown_name(input));
    }
  };
  if (!outputs.folder) {
    check(outputs.file, files.front().path);
    return;
  }
  for (const InputFile& file : files) check(output_path(file, outputs), file.path);
}

/// Sets the sizes of the files, and whether their outputs are newer. Returns the sorted identities of all inputs.
std::vector<Identity> look_up(std::vector<InputFile>& files, const InputListOptions& options) {
  std::vector<Identity> identities;
  for (InputFile& file : files) {
    const bool is_stream = file.path == "-";
    const auto status = is_stream ? system::status_of(system::standard_input) : system::status_of(file.path);
    if (!status || !status->is_regular) continue;
    if (!is_stream) file.size = status->size;
    identities.push_back(status->identity);
    if (!options.update || is_stream) continue;
    const auto output = system::status_of(output_path(file, options.outputs));
    file.is_current = output && status->modified <= output->modified;
  }
  std::vector<std::string> others = options.other_inputs;
  if (!options.list.empty()) others.push_back(options.list);
  for (const std::string& path : others) {
    if (const auto identity = identity_of(path, system::standard_input)) identities.push_back(*identity);
  }
  std::ranges::sort(identities);
  return identities;
}

[[noreturn]] void refuse_none(const Inputs& inputs, const InputListOptions& options) {
  if (inputs.others == 0 && !options.list.empty())
    throw usage_error("the list of files has no names; expected one per line; add some").in(shown_name(options.list));
  if (inputs.others == 0) {
    throw usage_error("the folders hold no files; expected at least one; give other folders");
  }
  throw usage_error(
      "the folders hold no input (other files: {}); expected names that end in one of {}; give --input-format to take "
      "all files",
      inputs.others, listed(options.endings));
}

}  // namespace

std::string output_path(const InputFile& file, const OutputPaths& outputs) {
  if (file.path == "-")
    throw usage_error(
        "standard input has no name, but --output-dir names each output after its input; give --output instead");
  const fs::path kept = file.path.substr(file.inside);
  const fs::path below = file.inside == 0 ? fs::path() : kept.parent_path();
  const fs::path stem = fs::path(without_compression(system::path_text(kept))).stem();
  return system::path_text(fs::path(*outputs.folder) / below / stem) + outputs.suffix + std::string(outputs.ending);
}

void require_no_input_replaced(const std::string& output, const std::vector<std::string>& inputs) {
  const auto there = identity_of(output, system::standard_output);
  for (const std::string& input : inputs) {
    if (there && identity_of(input, system::standard_input) == there)
      throw output_over_input(output).in(shown_name(input));
  }
}

Inputs find_inputs(const InputListOptions& options) {
  std::vector<std::string> names = options.files;
  if (!options.list.empty()) append_listed(names, options);
  Inputs inputs;
  for (const std::string& name : names) {
    std::error_code none;
    if (options.recursive && fs::is_directory(name, none)) {
      append_folder(inputs, name, options);
    } else {
      inputs.files.push_back({name});
    }
  }
  if (inputs.files.empty()) refuse_none(inputs, options);
  if (options.outputs.folder) require_distinct_outputs(inputs.files, options.outputs);
  require_not_over_inputs(inputs.files, look_up(inputs.files, options), options.outputs);
  return inputs;
}

}  // namespace tcb
