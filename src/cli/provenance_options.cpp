// Provenance options: the options that the provenance of an output records, and those of an earlier output.
#include "cli/provenance_options.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>

#include "cli/help.hpp"
#include "cli/options.hpp"
#include "cli/typed_options.hpp"
#include "error.hpp"
#include "io/compression.hpp"
#include "io/input_file.hpp"
#include "option_names.hpp"
#include "read/earlier_output.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

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
            "the provenance has {} with the name of a file to be read; expected the numbers "
            "themselves, as the program records them; replace the name",
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
        "the value has a line end, which {} cannot record; expected a value of one line; remove {}, "
        "or rename columns",
        option::meta, option::meta)
        .about(row.name);
  }
  return word;
}

}  // namespace

void require_recorded(const std::vector<std::string>& words) {
  require_no_file(words);
  const TypedOptions typed = read_options(words);
  for (const OptionRow& row : option_table()) {
    if (!typed.has(row.name) || row.changes_rows) continue;
    throw data_error(
        "the provenance has the option {}, which does not affect the rows; expected options "
        "that do; remove it from the provenance",
        row.name);
  }
  if (!typed.files.files.empty())
    throw data_error(
        "the provenance has the file {} among its options; expected options only; remove it "
        "from the provenance",
        in_quotes(typed.files.files[0]));
  if (!typed.meta)
    throw data_error("the provenance lacks the option {}; expected all options of the run; add it", option::meta);
}

Provenance new_provenance(const TypedOptions& typed) {
  Provenance provenance;
  provenance.program = version_text();
  for (const OptionRow& row : option_table()) {
    if (row.changes_rows && typed.has(row.name)) provenance.options.push_back(word_of(row, typed));
  }
  return provenance;
}

ProvenanceRequest earlier_provenance(const TypedOptions& typed) {
  const std::string& from = typed.from_meta;
  for (const OptionRow& row : option_table()) {
    if (!row.changes_rows || !typed.has(row.name)) continue;
    throw usage_error("{} is given with {}, which takes all options from {}; remove {}", row.name, option::from_meta,
                      from, row.name);
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

}  // namespace tcb
