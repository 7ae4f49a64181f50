// Reader: opens an input in its format.
#include "read/reader.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
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
#include "read/poses.hpp"
#include "read/products/ase.hpp"
#include "read/products/errors.hpp"
#include "read/products/fbx.hpp"
#include "read/products/lightwave.hpp"
#include "read/products/studio_3ds.hpp"
#include "read/products/tracks.hpp"
#include "schema/rotation_columns.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

using namespace std::string_view_literals;

/// Compressed files that are not read, by their first bytes, and the commands that decompress them.
struct OtherCompression {
  std::string_view bytes, name, command;
};
constexpr std::array compressions{
    OtherCompression{"BZh"sv, "bzip2", "bzcat"},
    OtherCompression{"\xFD\x37zXZ\0"sv, "xz", "xzcat"},
    OtherCompression{"\x04\x22\x4D\x18"sv, "LZ4", "lz4cat"},
};

/// Tables that are not read, by their first bytes, and the functions of pandas that read them.
struct OtherTable {
  std::string_view bytes, name, function;
};
constexpr std::array other_tables{
    OtherTable{"PAR1"sv, "a Parquet table", "read_parquet"},
    OtherTable{"ARROW1"sv, "an Arrow or Feather table", "read_feather"},
    OtherTable{"FEA1"sv, "a Feather table", "read_feather"},
};

/// Archives by the name of their first file, which is at byte 30.
struct OtherArchive {
  std::string_view file, name;
};
constexpr std::array other_archives{
    OtherArchive{"[Content_Types].xml", "an Excel workbook (.xlsx)"},
    OtherArchive{"_rels/", "an Excel workbook (.xlsx)"},
    OtherArchive{"xl/", "an Excel workbook (.xlsx)"},
    OtherArchive{"mimetype", "a LibreOffice document (.ods)"},
    OtherArchive{"", "a ZIP archive"},
};

/// The name of an archive of files, which is not read. Source: the ZIP file format, for the length of the name.
std::string_view archive_name(std::string_view beginning) {
  constexpr std::size_t size_at = 26, name_at = 30;
  const std::size_t size = beginning.size() > size_at ? static_cast<unsigned char>(beginning[size_at]) : 0;
  const std::string_view file = beginning.size() > name_at ? beginning.substr(name_at, size) : "";
  if (file.ends_with(".npy")) return "a NumPy archive (.npz)";
  return std::ranges::find_if(other_archives, [&](const auto& row) { return file.starts_with(row.file); })->name;
}

/// Formats that hold keys, or are taken for such, by their first bytes.
struct OtherFormat {
  std::string_view bytes, name;
};
constexpr std::array other_formats{
    OtherFormat{"\xD0\xCF\x11\xE0"sv, "an Excel workbook (.xls)"},
    OtherFormat{"HIERARCHY"sv, "a BVH motion capture file"},
    OtherFormat{"#usda"sv, "a USD scene (.usda)"},
    OtherFormat{"PXR-USDC"sv, "a USD scene (.usdc)"},
    OtherFormat{"glTF"sv, "a glTF scene (.glb)"},
    OtherFormat{"//Maya ASCII"sv, "a Maya scene"},
    OtherFormat{"BLENDER"sv, "a Blender file"},
    OtherFormat{"Ogawa"sv, "an Alembic scene"},
    OtherFormat{"\x89HDF"sv, "an HDF5 file"},
    OtherFormat{"SQLite format 3"sv, "an SQLite database"},
    OtherFormat{"MATLAB 5.0"sv, "a MATLAB file"},
    OtherFormat{"#ROSBAG"sv, "a ROS bag"},
    OtherFormat{"%PDF"sv, "a PDF document"},
    OtherFormat{"\x89PNG"sv, "a PNG picture"},
    OtherFormat{"%YAML"sv, "a YAML document"},
    OtherFormat{"<"sv, "XML or HTML"},
};

/// A binary FBX file, whose error has a remedy of its own.
constexpr std::string_view binary_fbx_bytes = "Kaydara FBX";

Error at_first_byte(const Error& error) { return error.at({"", 1, 1}); }

/// Throws: Error (data) for a format that is not read.
void require_known_format(std::string_view beginning) {
  const auto begins = [&](const auto& row) { return beginning.starts_with(row.bytes); };
  const auto compressed = std::ranges::find_if(compressions, begins);
  if (compressed != compressions.end()) throw at_first_byte(compressed_input(compressed->name, compressed->command));
  const auto table = std::ranges::find_if(other_tables, begins);
  if (table != other_tables.end()) throw at_first_byte(table_in_other_format(table->name, table->function));
  if (beginning.starts_with("PK\x03\x04")) throw at_first_byte(input_in_other_format(archive_name(beginning)));
  const std::size_t text = std::min(beginning.find_first_not_of(" \t\r\n"), beginning.size());
  const bool is_gltf = beginning.substr(text).starts_with('{') && beginning.find("\"asset\"") != std::string::npos &&
                       beginning.find("\"accessors\"") != std::string::npos;
  if (is_gltf) throw at_first_byte(input_in_other_format("a glTF scene"));
  beginning.remove_prefix(text);
  if (beginning.starts_with(binary_fbx_bytes)) throw at_first_byte(binary_fbx());
  const auto other = std::ranges::find_if(other_formats, begins);
  if (other != other_formats.end()) throw at_first_byte(input_in_other_format(other->name));
}

/// Whether further bytes may complete the beginning of another format, which few blanks come before.
bool may_begin_other_format(std::string_view beginning) {
  constexpr std::size_t most_blanks = 4096;
  if (beginning.size() > most_blanks) return false;
  beginning.remove_prefix(std::min(beginning.find_first_not_of(" \t\r\n"), beginning.size()));
  const auto may_complete = [&](std::string_view bytes) {
    return bytes.size() > beginning.size() && bytes.starts_with(beginning);
  };
  return may_complete(binary_fbx_bytes) || std::ranges::any_of(other_formats, may_complete, &OtherFormat::bytes);
}

/// The text in UTF-8 without a byte order mark; `encoding` gets the name of another encoding. Throws: Error (data) for
/// two marks.
Source<std::string> without_mark(Source<std::string> bytes, std::string& encoding) {
  std::string beginning;
  constexpr std::size_t enough = 6;              // for require_known_format(), and for detect()
  constexpr std::size_t enough_of_archive = 64;  // for archive_name()
  while (beginning.size() < enough || (beginning.starts_with("PK\x03\x04") && beginning.size() < enough_of_archive) ||
         may_begin_other_format(beginning)) {
    auto more = bytes();
    if (!more) break;
    beginning += *more;
  }
  require_known_format(beginning);
  encoding = encoding_of_mark(beginning);
  if (!encoding.empty()) {
    auto text = in_utf8(preceded_by(std::move(beginning), std::move(bytes)), encoding);
    if (!text) throw at_first_byte(text_not_in_utf8(encoding));
    return *std::move(text);
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
