// Provenance options: the options that an output's provenance has, and the way back from there to a job.
#include <algorithm>

#include "cli/help.hpp"
#include "cli/plan.hpp"
#include "io/input_file.hpp"

namespace tcb {
namespace {

/// An option as one word; numbers are listed in it, wherever they came from.
std::string word(const OptionRow& row, const TypedOptions& typed) {
  std::string word(row.long_name());
  if (row.kind != ValueKind::flag) word += "=" + typed.text(row.id);
  if (word.find_first_of("\r\n") != std::string::npos) {
    throw Error(Exit::usage, ErrorCode::line_end_in_provenance).about(row.id);
  }
  return word;
}

/// Throws: Error unless all options of an earlier output are such that provenance has, --meta among them.
void require_recorded(const std::vector<std::string>& words) {
  const TypedOptions typed = read_options(words);
  for (const OptionRow& row : option_table()) {
    if (typed.has(row.id) && !row.changes_rows)
      throw Error(Exit::data, ErrorCode::option_not_of_provenance).about(row.id);
  }
  if (!typed.job.files.empty()) throw Error(Exit::data, ErrorCode::file_in_provenance, {typed.job.files[0]});
  if (!typed.has(Option::meta)) throw Error(Exit::data, ErrorCode::provenance_incomplete).about(Option::meta);
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
    throw Error(Exit::usage, ErrorCode::option_in_provenance, {from}).about(row.id);
  }
  ProvenanceRequest request;
  request.from = from;
  in_file(shown_name(from), [&] {
    request.earlier = read_meta(read_file(from));
    require_recorded(request.earlier.options);
  });
  const std::uint64_t files = std::max<std::size_t>(typed.job.files.size(), 1), before = request.earlier.inputs.size();
  const bool counted = typed.job.batch.list.empty() && !typed.job.batch.recursive;
  if (counted && files != before) throw Error(Exit::usage, ErrorCode::other_number_of_files, {from, before, files});
  return request;
}

}  // namespace tcb
