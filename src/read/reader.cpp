// Reader: opens an input in its format.
#include "read/reader.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

#include "io/compression.hpp"
#include "io/encoding.hpp"
#include "read/csv/csv_reader.hpp"
#include "read/csv/splitter.hpp"
#include "read/errors.hpp"
#include "read/json/camera_path.hpp"
#include "read/json/shapes.hpp"
#include "read/npy.hpp"
#include "read/other_files.hpp"
#include "read/poses.hpp"
#include "read/products/ase.hpp"
#include "read/products/fbx.hpp"
#include "read/products/lightwave.hpp"
#include "read/products/studio_3ds.hpp"
#include "read/products/tracks.hpp"
#include "schema/rotation_columns.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

Error at_first_byte(const Error& error) { return error.at({"", 1, 1}); }

/// The text in UTF-8 without a byte order mark; `encoding` gets the name of another encoding. Throws: Error (data) for
/// two marks.
Source<std::string> without_mark(Source<std::string> bytes, std::string& encoding) {
  std::string beginning;
  constexpr std::size_t enough = 6;  // for detect()
  while (beginning.size() < enough || may_begin_other_file(beginning)) {
    auto more = bytes();
    if (!more) break;
    beginning += *more;
  }
  if (const std::optional<Error> error = other_file(beginning)) throw at_first_byte(*error);
  const Encoding by_mark = encoding_of_mark(beginning);
  if (by_mark != Encoding::utf8) {
    encoding = name_of(by_mark);
    return in_utf8(preceded_by(std::move(beginning), std::move(bytes)), by_mark);
  }
  if (beginning.starts_with(byte_order_mark)) beginning.erase(0, byte_order_mark.size());
  if (beginning.starts_with(byte_order_mark)) throw at_first_byte(two_byte_order_marks());
  return preceded_by(std::move(beginning), std::move(bytes));
}

/// The format by the file's ending, or by the first byte that is not blank.
FormatId detect(const std::string& path, const std::string& beginning) {
  if (beginning.starts_with("\x93NUMPY")) return FormatId::npy;
  constexpr std::size_t high_byte_of_size = 5;  // 0 below 16 MiB
  const bool is_3ds = beginning.starts_with("MM") && beginning.size() > high_byte_of_size;
  if (is_3ds && beginning[high_byte_of_size] == '\0') return FormatId::studio_3ds;
  if (beginning.starts_with("*3DSMA")) return FormatId::ase;
  if (beginning.starts_with("; FBX")) return FormatId::fbx;
  if (beginning.starts_with("LWSC") || beginning.starts_with("LWMO")) return FormatId::lws;
  const auto named = find_input_format(path);
  if ((!named || *named == FormatId::json) && begins_camera_path(beginning).value_or(false))
    return FormatId::nerfstudio;
  if (named) return *named;
  const std::size_t at = beginning.find_first_not_of(" \t\r\n");
  const bool json = at != std::string::npos && (beginning[at] == '[' || beginning[at] == '{');
  return json ? FormatId::json : FormatId::csv;
}

/// The options, with what the format decides unless it is requested.
InputOptions options_of(FormatId format, Source<std::string>& bytes, const InputOptions& given) {
  const FormatFamily family = format_of(format).family;
  if (family == FormatFamily::tracks) return options_of_tracks(format, given);
  if (!given.only.empty()) throw file_without_tracks(format_of(format).name);
  if (family == FormatFamily::poses) return options_of_poses(format, bytes, given);
  return family == FormatFamily::cameras ? options_of_camera_path(given) : given;
}

Records open_as(FormatId format, Source<std::string> bytes, InputOptions options) {
  const FormatFamily family = format_of(format).family;
  if (family == FormatFamily::cameras) return open_camera_path(std::move(bytes), options);
  if (family == FormatFamily::json) return open_json(std::move(bytes), options);
  const bool is_text = family != FormatFamily::tracks && family != FormatFamily::array;
  if (!is_text && options.delimited != DelimitedOptions{}) throw options_of_text(format_of(format).name);
  if (format == FormatId::studio_3ds) return open_3ds(bytes, options);
  if (format == FormatId::ase) return open_ase(bytes, options);
  if (format == FormatId::fbx) return open_fbx(bytes, options);
  if (format == FormatId::lws) return open_lightwave(bytes, options);
  if (format == FormatId::npy) bytes = text_of_npy(std::move(bytes), options);
  std::optional<char>& delimiter = options.delimited.delimiter;
  if (!delimiter && format != FormatId::csv) delimiter = format_of(format).delimiter;  // csv: any, to be found
  return open_delimited(std::move(bytes), options);
}

}  // namespace

Input open_input(const std::string& path, Source<std::string> bytes, const InputOptions& given) {
  std::string encoding;
  bytes = without_mark(decompressed(std::move(bytes)), encoding);
  constexpr std::size_t most_before_list = 1UL << 20;  // of JSON
  std::string beginning;
  for (bool blank = true; blank || !begins_camera_path(beginning);) {
    auto more = bytes();
    if (!more) break;
    blank = blank && more->find_first_not_of(" \t\r\n") == std::string::npos;
    beginning += *more;
    if (blank && beginning.size() > longest_record) throw at_first_byte(blank_beginning());
    if (!blank && beginning.size() > most_before_list) break;
  }
  const FormatId format = given.format ? *given.format : detect(path, beginning);
  bytes = preceded_by(std::move(beginning), std::move(bytes));
  const InputOptions options = options_of(format, bytes, given);
  Records records = open_as(format, std::move(bytes), options);
  const Columns& columns = records.columns;
  Input input{schema_of(columns, records.time_notation, records.dates), std::move(records.facts),
              std::move(records.keys)};
  RotationOptions rotation = options.rotation;
  if (records.rotation && rotation.requests.empty() && !rotation.none) rotation.requests.push_back(*records.rotation);
  if (!options.columns.samples) input.schema = with_rotations(std::move(input.schema), columns, rotation);
  input.schema = renamed(with_unit(std::move(input.schema), options.units), options.renamings);
  if (!input.schema.time.unit) input.schema.time.epoch_unit = records.epoch_unit;
  input.schema.marks = records.marks;
  input.schema.camera_path = std::move(records.camera_path);
  input.facts.format = format;
  if (!encoding.empty()) input.facts.encoding = encoding;
  if (!input.facts.is_recording) input.facts.roles = columns.shape_roles();
  input.facts.ignored = columns.ignored;
  input.facts.likely_rotation = columns.likely_rotation;
  KeyTraits& traits = input.keys.traits;
  traits.are_segments = columns.are_segments;
  traits.may_miss = options.keys.missing == Missing::skip_cell;
  traits.has_tcb_scale = options.keys.tcb_scale != TcbScale::unknown;
  traits.marks = columns.marks;
  if (columns.named) traits.channels = columns.channels;
  return input;
}

}  // namespace tcb
