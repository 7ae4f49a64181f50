// Opening of inputs: their bytes as text, and their format.
#include "formats/formats.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

#include "io/compression.hpp"
#include "io/encoding.hpp"
#include "read/csv/splitter.hpp"
#include "read/input.hpp"
#include "read/input_options.hpp"
#include "read/other_files.hpp"
#include "read/row_times.hpp"
#include "schema/schema.hpp"
#include "text/removed.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

Error at_first_byte(const Error& error) { return error.at({"", 1, 1}); }

/// The text in UTF-8 without a byte order mark; `encoding` gets the name of another encoding. Throws: Error (data) for
/// two marks.
Source<std::string> without_mark(Source<std::string> bytes, std::string& encoding) {
  std::string beginning;
  constexpr std::size_t enough = 6;  // for format_of()
  while ((beginning.size() < enough || may_begin_other_file(beginning)) && append_next(beginning, bytes)) {
  }
  if (const std::optional<Error> error = other_file(beginning)) throw at_first_byte(*error);
  const Encoding by_mark = encoding_of_mark(beginning);
  if (by_mark != Encoding::utf8) {
    encoding = name_of(by_mark);
    return in_utf8(preceded_by(std::move(beginning), std::move(bytes)), by_mark);
  }
  if (beginning.starts_with(byte_order_mark)) beginning.erase(0, byte_order_mark.size());
  if (beginning.starts_with(byte_order_mark)) {
    throw at_first_byte(data_error("the text begins with two byte order marks; expected at most one; remove one"));
  }
  return preceded_by(std::move(beginning), std::move(bytes));
}

/// Throws: Error (data) for a file whose ending names a format that is not read any more.
void require_no_removed_format(std::string_view path) {
  for (const RemovedName& row : removed_names()) {
    if (row.option != "--input-format" || !has_ending(without_compression(path), "." + std::string(row.value)))
      continue;
    throw data_error("{}", removed(row.option, row.value)->message());
  }
}

/// Whether further bytes decide how well a format fits.
bool is_undecided(std::string_view beginning) {
  return std::ranges::any_of(formats(), [&](const Format& format) {
    return format.can_read() && format.input->fit != nullptr && !format.input->fit(beginning);
  });
}

/// The format by the first bytes, by the file's ending, or by how well it fits.
const Format& format_of(std::string_view path, std::string_view beginning) {
  path = without_compression(path);
  const auto names = [&](const Format& format) { return format.can_read() && path.ends_with(format.ending); };
  const bool is_named = std::ranges::any_of(formats(), names);
  const Format* best = nullptr;
  int best_fit = -1;
  for (const Format& format : formats()) {
    if (!format.can_read()) continue;
    const InputFormat& input = *format.input;
    if (input.begins != nullptr && input.begins(beginning)) return format;
    if (is_named && !names(format)) continue;
    const int fit = input.fit == nullptr ? 0 : input.fit(beginning).value_or(0);
    if (fit > best_fit) best = &format;
    best_fit = std::max(fit, best_fit);
  }
  return *best;
}

/// Throws: Error (data) for JSON in a file whose name is that of another format.
void require_no_json(const Format& format, std::string_view path, std::string_view beginning) {
  const auto next = [&](std::size_t at) {
    return std::min(beginning.find_first_not_of(" \t\r\n", at), beginning.size());
  };
  const std::size_t first = next(0), second = next(first + 1);
  if (format.delimiter == 0 || second == beginning.size() || !without_compression(path).ends_with(format.ending))
    return;
  const std::string_view inside = beginning[first] == '{' ? "\"}" : beginning[first] == '[' ? "[{\"" : "";
  if (inside.find(beginning[second]) == std::string_view::npos) return;
  throw at_first_byte(
      data_error("this is JSON, and the name of the file is that of the format {}; expected the same; "
                 "give --input-format json, or rename the file",
                 format.name));
}

/// The options, with what the format decides unless it is requested.
InputOptions options_of(const Format& format, Source<std::string>& bytes, const InputOptions& given) {
  const InputFormat& input = *format.input;
  if (!input.has_tracks && !given.only.empty()) {
    throw usage_error(
        "a file in the format {} has no tracks of several objects; expected a scene, such as .lws; remove the option, "
        "or choose columns with --columns",
        format.name)
        .about("--only");
  }
  if (!format.is_json && !given.records.empty()) {
    throw usage_error(
        "a file in the format {} has no lists in JSON, of which one has the keys; expected JSON; remove the option, or "
        "give --input-format json if it is JSON",
        format.name)
        .about("--records");
  }
  if (!format.offers(offer::marks) && given.delimited != DelimitedOptions{}) {
    throw usage_error(
        "--delimiter, --header, --no-header, --comment, --skip-lines, --decimal and --thousands have no effect on an "
        "input in the format {}; remove them, or, if it is in another format, give that with --input-format",
        format.name);
  }
  return input.options == nullptr ? given : input.options(format, bytes, given);
}

}  // namespace

Input open_input(const std::string& path, Source<std::string> bytes, const InputOptions& given) {
  std::string encoding;
  bytes = without_mark(decompressed(std::move(bytes)), encoding);
  constexpr std::size_t most_before_list = 1UL << 20;  // of JSON
  std::string beginning;
  for (bool blank = true; blank || is_undecided(beginning);) {
    const std::size_t before = beginning.size();
    if (!append_next(beginning, bytes)) break;
    blank = blank && beginning.find_first_not_of(" \t\r\n", before) == std::string::npos;
    if (blank && beginning.size() > longest_record) {
      throw at_first_byte(
          data_error("the first 64 MiB are blank; expected keys; remove the blank lines, or check whether the file is "
                     "the right one"));
    }
    if (!blank && beginning.size() > most_before_list) break;
  }
  if (given.format == nullptr) require_no_removed_format(path);
  const Format& format = given.format != nullptr ? *given.format : format_of(path, beginning);
  if (given.format == nullptr) require_no_json(format, path, beginning);
  bytes = preceded_by(std::move(beginning), std::move(bytes));
  InputOptions options = options_of(format, bytes, given);
  options.keys.counts_rows = options.units.frame_rate && options.keys.missing == Missing::skip_row;
  Records records = format.input->open(format, std::move(bytes), options);
  const Columns& columns = records.columns;
  Input input{schema_of(columns, records.units.notation, records.units.dates), std::move(records.facts),
              std::move(records.keys)};
  RotationOptions rotation = options.rotation;
  if (records.rotation && rotation.requests.empty() && !rotation.none) rotation.requests.push_back(*records.rotation);
  if (!options.columns.samples && !options.columns.times_only) {
    input.schema = with_rotations(std::move(input.schema), columns, rotation);
  }
  UnitOptions units = options.units;
  if (records.frame_rate) units.frame_rate = records.frame_rate;
  input.schema = renamed(with_unit(std::move(input.schema), units), options.renamings);
  if (!input.schema.time.unit) input.schema.time.unit = records.time_unit;
  if (!input.schema.time.unit) input.schema.time.epoch_unit = records.units.epoch_unit;
  input.schema.marks = records.marks;
  input.schema.camera_path = std::move(records.camera_path);
  input.facts.format = &format;
  if (!encoding.empty()) input.facts.encoding = encoding;
  input.facts.roles = columns.shape_roles();
  input.facts.ignored = columns.ignored;
  input.facts.doubts = columns.doubts;
  input.facts.time_gap = columns.time_gap;
  KeyTraits& traits = input.keys.traits;
  traits.may_miss = options.keys.missing == Missing::skip_cell;
  traits.may_be_point = options.keys.missing == Missing::break_curve;
  traits.has_tcb_scale = options.keys.tcb_scale != TcbScale::unknown;
  traits.label = columns.label;
  if (input.schema.time.counts_rows) {
    input.keys.blocks =
        with_row_times(std::move(input.keys.blocks), input.schema.time,
                       traits.own_curves ? 0 : input.schema.groups.size(), options.keys.missing == Missing::skip_row);
  }
  return input;
}

}  // namespace tcb
