// Inputs: the files that are named, listed, or found in folders, and where the rows of each go.
#include "io/input_list.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include "error.hpp"
#include "io/file.hpp"

namespace tcb {
namespace {

namespace fs = std::filesystem;

std::optional<struct stat> status_of(const std::string& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 ? std::optional(status) : std::nullopt;
}

/// The names in a list; lines without any, and what a line may end in on other systems, are passed over.
void append_listed(std::vector<std::string>& names, const BatchOptions& batch) {
  const char end = batch.nul ? '\0' : '\n';
  const Source<std::string> bytes = read_file(batch.list);
  std::string name;
  const auto take = [&] {
    if (!batch.nul && name.ends_with('\r')) name.pop_back();
    const bool blank = !batch.nul && name.find_first_not_of(" \t") == std::string::npos;
    if (name.find('\0') != std::string::npos) {
      throw Error(Exit::usage, TextPosition{shown_name(batch.list)},
                  "a NUL byte between the names of files; expected one name a line; give -0 for names that end in NUL");
    }
    if (!name.empty() && !blank) names.push_back(name);
    name.clear();
  };
  while (const std::optional<std::string> text = bytes()) {
    for (const char c : *text) {
      if (c == end) {
        take();
      } else {
        name += c;
      }
    }
  }
  take();
}

bool has_known_ending(const std::string& path) {
  return std::ranges::any_of(formats,
                             [&](const Format& format) { return format.can_read && path.ends_with(format.ending); });
}

/// Not a pipe or a device; a link that leads nowhere is an error for the reader to find.
bool is_or_should_be_regular(const fs::directory_entry& entry) {
  std::error_code none;
  return entry.is_regular_file(none) || !entry.exists(none);
}

/// The files below a folder, sorted; those below the output folder are no inputs.
void append_folder(Inputs& inputs, const std::string& folder, const Job& plan) {
  std::error_code error;
  const auto inside = static_cast<std::uint32_t>((fs::path(folder) / "").native().size());
  const std::size_t begin = inputs.files.size();
  fs::recursive_directory_iterator entry(folder, error);
  for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    std::error_code none;
    if (entry->is_directory(none)) {
      if (fs::equivalent(entry->path(), *plan.output_folder, none)) entry.disable_recursion_pending();
    } else if (is_or_should_be_regular(*entry) && (plan.input.format || has_known_ending(entry->path().native()))) {
      inputs.files.push_back({entry->path().native(), inside});
    } else {
      ++inputs.left_alone;
    }
  }
  if (error)
    throw Error(Exit::usage, TextPosition{folder}, fmt::format("the folder cannot be read: {}", error.message()));
  std::sort(inputs.files.begin() + static_cast<std::ptrdiff_t>(begin), inputs.files.end(),
            [](const InputFile& a, const InputFile& b) { return a.path < b.path; });
}

/// Throws: Error (usage) where two files have the same output.
void require_distinct_outputs(const std::vector<InputFile>& files, const Job& plan) {
  std::vector<std::pair<std::size_t, std::size_t>> by_hash;  // so that not all paths have to be kept
  by_hash.reserve(files.size());
  for (std::size_t i = 0; i < files.size(); ++i) {
    by_hash.emplace_back(std::hash<std::string>()(output_path(files[i], plan)), i);
  }
  std::ranges::sort(by_hash);
  for (std::size_t i = 0; i < by_hash.size(); ++i) {
    const InputFile& file = files[by_hash[i].second];
    for (std::size_t j = i; j-- > 0 && by_hash[j].first == by_hash[i].first;) {
      const InputFile& other = files[by_hash[j].second];
      if (const std::string path = output_path(file, plan); path == output_path(other, plan)) {
        throw Error(Exit::usage, TextPosition{file.path},
                    fmt::format("its output {} is that of {} too; expected one for each; rename one of them, or use "
                                "two folders",
                                path, other.path));
      }
    }
  }
}

/// Which file a name leads to, however it is spelled.
using Identity = std::pair<dev_t, ino_t>;

/// Throws: Error (usage) where an output would take the place of an input.
void require_not_over_inputs(const std::vector<InputFile>& files, const std::vector<Identity>& sorted_identities,
                             const Job& plan) {
  const auto check = [&](const std::string& output, const std::string& input) {
    const auto there = status_of(output);
    if (!there || !S_ISREG(there->st_mode)) return;
    if (!std::ranges::binary_search(sorted_identities, Identity(there->st_dev, there->st_ino))) return;
    throw Error(Exit::usage, TextPosition{input},
                fmt::format("its output {} is an input too; expected two files; give another output", output));
  };
  if (!plan.output_folder) {
    check(plan.output, files.front().path);
    return;
  }
  for (const InputFile& file : files) check(output_path(file, plan), file.path);
}

/// What the file system knows of the files, and whether their outputs are newer.
std::vector<Identity> look_up(std::vector<InputFile>& files, const Job& plan) {
  const auto newer = [](const timespec& a, const timespec& b) {
    return a.tv_sec != b.tv_sec ? a.tv_sec > b.tv_sec : a.tv_nsec > b.tv_nsec;
  };
  std::vector<Identity> identities;
  for (InputFile& file : files) {
    const auto status = file.path == "-" ? std::nullopt : status_of(file.path);
    if (!status || !S_ISREG(status->st_mode)) continue;
    file.size = static_cast<std::uintmax_t>(status->st_size);
    identities.emplace_back(status->st_dev, status->st_ino);
    if (!plan.batch.update) continue;
    const auto output = status_of(output_path(file, plan));
    file.is_current = output && !newer(status->st_mtim, output->st_mtim);
  }
  std::ranges::sort(identities);
  return identities;
}

[[noreturn]] void refuse_none(const Inputs& inputs, const Job& plan) {
  if (inputs.left_alone == 0 && !plan.batch.list.empty()) {
    throw Error(Exit::usage, TextPosition{shown_name(plan.batch.list)},
                "no names of files; expected one a line; add some");
  }
  throw Error(Exit::usage, fmt::format("no files of keys among {} in the folders; expected .csv, .tsv, .ssv, .json or "
                                       ".jsonl; give --input-format to take all",
                                       inputs.left_alone));
}

}  // namespace

std::string output_path(const InputFile& file, const Job& plan) {
  if (file.path == "-") {
    throw Error(Exit::usage, "standard input has no name; --output-dir needs files; give -o instead");
  }
  const fs::path kept = file.path.substr(file.inside);
  const fs::path below = file.inside == 0 ? fs::path() : kept.parent_path();
  return (fs::path(*plan.output_folder) / below / kept.stem()) +=
         fmt::format("{}{}", plan.batch.suffix, format_of(plan.output_format).ending);
}

Inputs find_inputs(const Job& plan) {
  std::vector<std::string> names = plan.files;
  if (!plan.batch.list.empty()) append_listed(names, plan.batch);
  Inputs inputs;
  for (const std::string& name : names) {
    std::error_code none;
    if (plan.batch.recursive && fs::is_directory(name, none)) {
      append_folder(inputs, name, plan);
    } else {
      inputs.files.push_back({name});
    }
  }
  if (inputs.files.empty()) refuse_none(inputs, plan);
  if (plan.output_folder) require_distinct_outputs(inputs.files, plan);
  require_not_over_inputs(inputs.files, look_up(inputs.files, plan), plan);
  return inputs;
}

}  // namespace tcb
