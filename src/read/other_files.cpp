// Other files: the table of those of other products, which are neither read nor written.
#include "read/other_files.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <ranges>
#include <span>
#include <string>

#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

using namespace std::string_view_literals;

/// Whether the first line is a name with a colon, and the next one an item or a member of it.
bool is_yaml(std::string_view text) {
  const std::string_view line = text.substr(0, text.find('\n'));
  const std::string_view next = text.substr(std::min(line.size() + 1, text.size()));
  const bool is_inside =
      next.starts_with("- ") || (next.starts_with(' ') && next.find_first_of("-:") < next.find('\n'));
  return line.size() > 1 && line.ends_with(':') && line.find_first_of(" ,;\t\"") == std::string_view::npos && is_inside;
}

/// Whether the names in a ZIP archive are those of a workbook.
bool is_workbook(std::string_view text) {
  constexpr std::array names{"[Content_Types].xml"sv, "_rels/"sv, "xl/"sv, "mimetype"sv};
  return std::ranges::any_of(names, [&](auto name) { return text.find(name) != std::string_view::npos; });
}

bool is_geojson(std::string_view type) {
  constexpr std::array types{"FeatureCollection"sv, "Feature"sv,      "Point"sv,
                             "MultiPoint"sv,        "LineString"sv,   "MultiLineString"sv,
                             "Polygon"sv,           "MultiPolygon"sv, "GeometryCollection"sv};
  return std::ranges::count(types, type) > 0;
}

/// How a kind of files is recognized: it begins with one of some bytes, maybe behind others, has texts somewhere in the
/// first ones, and passes a test.
struct Signature {
  std::array<std::string_view, 20> begins = {};
  std::size_t at = 0;
  std::array<std::string_view, 2> within = {};
  bool (*test)(std::string_view text) = nullptr;
};

/// A kind of files of other products.
struct OtherFile {
  std::string_view name, remedy;
  Signature signature;
};

constexpr std::string_view export_keys = "export the keys as CSV or JSON", save_table = "save its table as CSV",
                           export_arrays = "export its arrays as CSV or .npy",
                           export_track = "export its track or its messages as CSV or JSON, with all digits",
                           to_json = "convert it to JSON", scene = "a scene or a motion of another product",
                           recording = "a recording of another product";

constexpr std::string_view zip = "PK\x03\x04";

/// All of them; the first that fits counts.
constexpr OtherFile other_files[] = {
    // Compressed files and archives.
    {"a file compressed with bzip2", "decompress it, as in bzcat FILE | tcbsample", {{"BZh"}}},
    {"a file compressed with xz", "decompress it, as in xzcat FILE | tcbsample", {{"\xFD\x37zXZ\0"sv}}},
    {"a file compressed with LZ4", "decompress it, as in lz4cat FILE | tcbsample", {{"\x04\x22\x4D\x18"}}},
    {"a 7-Zip or RAR archive", "take a file out of it", {{"7z\xBC\xAF\x27\x1C", "Rar!\x1A\x07"}}},
    {"a tar archive", "take a file out of it, as in tar -xOf FILE NAME | tcbsample", {{"ustar"}, 257}},
    {"a workbook (.xlsx, .ods)", save_table, {{zip}, 0, {}, is_workbook}},
    {"a ZIP archive (.zip, .npz)", "take a file out of it, as in unzip -p FILE NAME | tcbsample", {{zip}}},
    {"a compound file of Microsoft, such as a workbook (.xls) or a 3ds Max scene (.max)",
     "export its table or its keys as CSV",
     {{"\xD0\xCF\x11\xE0"}}},
    // Tables and arrays.
    {"a table of another product (Parquet, Arrow, Feather, ORC, Avro, SQLite, pickle)",
     "save its table as CSV, with all digits",
     {{"PAR1", "ARROW1", "FEA1", "ORC", "Obj\x01", "SQLite format 3", "\x80\x04\x95", "\x80\x05\x95"}}},
    {"a file of arrays (HDF5, NetCDF, MATLAB, TDMS)",
     export_arrays,
     {{"\x89HDF", "CDF\x01", "CDF\x02", "MATLAB 5.0", "TDSm"}}},
    // Scenes, motions and recordings.
    {"an object of LightWave, which has no keys", "give the scene (.lws) or a motion (.mot)", {{"LWO"}, 8}},
    {scene,
     export_keys,
     {{"Kaydara FBX",
       "; FBX",
       "FBXHeaderExtension",
       "*3DSMAX_ASCIIEXPORT",
       "HIERARCHY",
       "\x02P",
       "Gamebryo File Format",
       "NetImmerse File Format",
       "Vocaloid Motion Data",
       "#usda",
       "PXR-USDC",
       "glTF",
       "//Maya ASCII",
       "FOR4",
       "FOR8",
       "animVersion ",
       "Adobe After Effects",
       "BLENDER",
       "Ogawa",
       "[gd_"}}},
    {scene, export_keys, {{"{"}, 0, {"\"asset\"", "\"accessors\""}}},
    {scene, export_keys, {{"{"}, 0, {"tracklength", "data ="}}},
    {scene, export_keys, {{"%YAML"}, 0, {"tag:unity3d.com"}}},
    {recording, export_track, {{"\x89MCAP", "#ROSBAG", "ULog\x01"}}},
    {recording, export_track, {{".FIT"}, 8}},
    {recording, export_track, {{"header:"}, 0, {"stamp:"}}},
    {recording, export_track, {{"A"}, 0, {"\nHFDTE"}}},
    {recording, export_track, {{"$G"}, 0, {"GGA,"}}},
    {recording, export_track, {{"$G"}, 0, {"RMC,"}}},
    {"a text of subtitles (.srt)", export_keys, {{"1"}, 0, {"\n00:", " --> "}}},
    // Others.
    {"a document, a picture, a video or a MIDI file",
     export_keys,
     {{"%PDF", "\x89PNG", "\xFF\xD8\xFF", "GIF8", "MThd"}}},
    {"a video", export_keys, {{"ftyp"}, 4}},
    {"a YAML document", to_json, {{"%YAML", "---\n"}}},
    {"a YAML document", to_json, {{""}, 0, {}, is_yaml}},
    {"XML or HTML", export_keys, {{"<?xml", "<!"}}},
    {"XML or HTML", export_keys, {{"<"}, 0, {"</"}}},
    {"XML or HTML", export_keys, {{"<"}, 0, {"/>"}}},
};

/// Endings of the names of such files, none of which an output gets.
constexpr std::array other_endings{
    ".bz2"sv,  ".xz"sv,      ".lz4"sv,   ".7z"sv,     ".rar"sv, ".tar"sv,    ".tgz"sv,     ".npz"sv,   ".xlsx"sv,
    ".xlsm"sv, ".ods"sv,     ".usdz"sv,  ".zip"sv,    ".br"sv,  ".z"sv,      ".parquet"sv, ".arrow"sv, ".feather"sv,
    ".orc"sv,  ".avro"sv,    ".pkl"sv,   ".pickle"sv, ".db"sv,  ".sqlite"sv, ".h5"sv,      ".hdf5"sv,  ".nc"sv,
    ".mat"sv,  ".numbers"sv, ".xls"sv,   ".fbx"sv,    ".ase"sv, ".bvh"sv,    ".usda"sv,    ".usdc"sv,  ".usd"sv,
    ".glb"sv,  ".srt"sv,     ".blend"sv, ".abc"sv,    ".dae"sv, ".obj"sv,    ".mot"sv,     ".mcap"sv,  ".bag"sv,
    ".pdf"sv,  ".png"sv,     ".jpg"sv,   ".jpeg"sv,   ".gif"sv, ".mp4"sv,    ".yaml"sv,    ".yml"sv,   ".xml"sv,
    ".html"sv, ".htm"sv,     ".toml"sv};

/// A kind of JSON of other products, by the names of members and a test of the member "type". WORD in its remedy is the
/// option for the list of keys.
struct OtherJson {
  std::string_view name, remedy;
  std::array<std::string_view, 3> members;
  bool (*test)(std::string_view type) = nullptr;
};

constexpr std::string_view write_keys = "write an object of time and position for each key";

constexpr std::string_view places_without_times =
    "write an object of time and position for each key, or give WORD--parameter uniform for the places without times";

constexpr OtherJson other_jsons[] = {
    {"a transforms.json of poses without times",
     "give --records frames --parameter uniform --columns "
     "'position=transform_matrix[0][3]:transform_matrix[1][3]:transform_matrix[2][3]' --rotation "
     "'matrix=transform_matrix[0][0]:transform_matrix[0][1]:transform_matrix[0][2]:transform_matrix[1][0]:"
     "transform_matrix[1][1]:transform_matrix[1][2]:transform_matrix[2][0]:transform_matrix[2][1]:"
     "transform_matrix[2][2]'",
     {"frames", "transform_matrix"}},
    {"a motion of Live2D, whose segments are a type and 2 or 6 numbers, of which the last 2 are a key",
     write_keys,
     {"Meta", "Curves", "Segments"}},
    {"a skeleton of Spine, whose keys leave out numbers", write_keys, {"skeleton", "bones", "animations"}},
    {"a skeleton of DragonBones, whose keys have durations and no times",
     write_keys,
     {"armature", "bone", "frameRate"}},
    {"a Lottie animation", write_keys, {"layers", "ip", "op"}},
    {"a project of Theatre.js", "give WORD--columns time=position,position=value", {"sheetsById"}},
    {"GeoJSON, whose places are not as many as its times",
     places_without_times,
     {"coordinates", "coordTimes"},
     is_geojson},
    {"GeoJSON, whose places are not as many as its times", places_without_times, {"coordinates", "times"}, is_geojson},
    {"GeoJSON, whose places have no times", "give WORD--parameter uniform", {"coordinates"}, is_geojson},
};

/// A signature at the beginning may follow blanks, and a byte order mark.
std::string_view without_blanks(std::string_view text) {
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  return text;
}

/// What such files may begin with: all up to the first empty one, or that.
std::span<const std::string_view> bytes_of(const Signature& signature) {
  const auto count = std::ranges::find(signature.begins, "") - signature.begins.begin();
  return std::span(signature.begins).first(std::max<std::size_t>(1, static_cast<std::size_t>(count)));
}

/// `inner`: the beginning without blanks.
bool fits(const Signature& signature, std::string_view beginning, std::string_view inner) {
  const std::string_view text = signature.at == 0 ? inner : beginning;
  if (text.size() < signature.at) return false;
  const auto begins = [&](std::string_view bytes) { return text.substr(signature.at).starts_with(bytes); };
  const auto has = [&](std::string_view part) { return text.find(part) != std::string_view::npos; };
  return std::ranges::any_of(bytes_of(signature), begins) && std::ranges::all_of(signature.within, has) &&
         (signature.test == nullptr || signature.test(text));
}

}  // namespace

std::optional<Error> other_file(std::string_view beginning) {
  const std::string_view inner = without_blanks(beginning);
  const auto* found =
      std::ranges::find_if(other_files, [&](const auto& row) { return fits(row.signature, beginning, inner); });
  if (found == std::ranges::end(other_files)) return std::nullopt;
  return data_error("this is {}; expected text with a key in each row, or JSON; {}", found->name, found->remedy);
}

bool may_begin_other_file(std::string_view beginning) {
  constexpr std::size_t most_blanks = 4096, enough_of_archive = 1UL << 16;
  if (beginning.starts_with(zip)) return beginning.size() < enough_of_archive;
  if (beginning.size() > most_blanks) return false;
  const std::string_view text = without_blanks(beginning);
  const auto is_binary = [&] { return std::ranges::any_of(beginning, [](unsigned char c) { return c < '\t'; }); };
  return std::ranges::any_of(other_files, [&](const OtherFile& row) {
    const Signature& signature = row.signature;
    return std::ranges::any_of(bytes_of(signature), [&](std::string_view bytes) {
      if (signature.at > 0) return beginning.size() < signature.at + bytes.size() && is_binary();
      return bytes.size() > text.size() && bytes.starts_with(text);
    });
  });
}

std::optional<Error> other_json(const std::unordered_set<std::string_view>& members, std::string_view type,
                                std::string_view records) {
  const auto* found = std::ranges::find_if(other_jsons, [&](const OtherJson& row) {
    const auto is_there = [&](std::string_view name) { return name.empty() || members.contains(name); };
    return (row.test == nullptr || row.test(type)) && std::ranges::all_of(row.members, is_there);
  });
  if (found == std::ranges::end(other_jsons)) return std::nullopt;
  std::string remedy(found->remedy);
  if (const std::size_t at = remedy.find("WORD"); at != std::string::npos) remedy.replace(at, 4, records);
  return data_error("this is {}; expected a list of keys; {}", found->name, remedy);
}

std::string_view ending_of_other_file(std::string_view path) {
  const auto* found = std::ranges::find_if(other_endings, [&](auto ending) { return has_ending(path, ending); });
  return found == other_endings.end() ? "" : *found;
}

}  // namespace tcb
