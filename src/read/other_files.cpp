// Other files: the table of those of other products, which are neither read nor written.
#include "read/other_files.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <ranges>
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

/// Whether the first line is a count, and the third one a word and three numbers, as in a geometry of atoms.
bool is_xyz(std::string_view text) {
  constexpr std::string_view digits = "0123456789";
  const std::size_t count = text.find_first_not_of(digits), first = text.find('\n');
  const std::size_t second = first == std::string_view::npos ? first : text.find('\n', first + 1);
  if (count == 0 || second == std::string_view::npos || text.find_first_not_of(" \r", count) != first) return false;
  const std::string_view row = text.substr(second + 1, text.find('\n', second + 1) - second - 1);
  std::size_t words = 0, numbers = 0;
  for (std::size_t at = row.find_first_not_of(" \t\r"); at < row.size(); at = row.find_first_not_of(" \t\r", at)) {
    const std::string_view word = row.substr(at, row.find_first_of(" \t\r", at) - at);
    if (word.find_first_of(digits) <= 1 && word.find_first_not_of("0123456789.+-eE") == std::string_view::npos)
      ++numbers;
    ++words;
    at += word.size();
  }
  return words == 4 && numbers == 3;
}

bool is_geojson(std::string_view type) {
  constexpr std::array types{"FeatureCollection"sv, "Feature"sv,      "Point"sv,
                             "MultiPoint"sv,        "LineString"sv,   "MultiLineString"sv,
                             "Polygon"sv,           "MultiPolygon"sv, "GeometryCollection"sv};
  return std::ranges::count(types, type) > 0;
}

bool is_topojson(std::string_view type) { return type == "Topology"; }

/// How a file is recognized: some bytes at a place, and texts somewhere in the first ones; or a test. JSON is
/// recognized by its members, and a test of the member "type" of all.
struct Signature {
  std::string_view bytes = {};
  std::size_t at = 0;
  std::array<std::string_view, 2> within = {};
  std::array<std::string_view, 3> members = {};
  bool (*test)(std::string_view text) = nullptr;
};

/// A file of another product.
struct OtherFile {
  std::array<std::string_view, 5> endings = {};  ///< of names, none of which an output gets
  Signature signature = {};                      ///< empty: it is not recognized
  std::string_view name = {};
  std::string_view remedy = {};
  std::string_view word = {};  ///< in the place of WORD in the remedy; of JSON it is the option for the list of keys
};

constexpr std::string_view export_keys = "export the keys as CSV or JSON", export_csv = "export the keys as CSV",
                           fbx_scene = "an FBX scene (nearly all are binary, which was never read)",
                           decompress = "decompress it, as in WORD FILE | tcbsample",
                           take_file = "take a file out of it, as in WORD FILE NAME | tcbsample",
                           save_table = "save its table as CSV", export_arrays = "export its arrays as CSV or .npy",
                           export_track = "export its track as CSV, with all digits",
                           export_topic = "export the messages of a topic as CSV or JSON",
                           write_keys = "write an object of time and position for each key";

constexpr std::string_view zip = "PK\x03\x04", compound = "\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1"sv;
/// The names of the streams of a compound file, which are in UTF-16.
constexpr std::string_view class_directory = "C\0l\0a\0s\0s\0D\0i\0r\0e\0c\0t\0o\0r\0y\0"sv,
                           workbook = "W\0o\0r\0k\0b\0o\0o\0k\0"sv, book = "B\0o\0o\0k\0"sv;

/// All of them; the first that fits counts.
constexpr OtherFile other_files[] = {
    // Compressed files and archives.
    {{".bz2"}, {"BZh"}, "a file compressed with bzip2", decompress, "bzcat"},
    {{".xz"}, {"\xFD\x37zXZ\0"sv}, "a file compressed with xz", decompress, "xzcat"},
    {{".lz4"}, {"\x04\x22\x4D\x18"}, "a file compressed with LZ4", decompress, "lz4cat"},
    {{".7z"}, {"7z\xBC\xAF\x27\x1C"}, "a 7-Zip archive", "take a file out of it"},
    {{".rar"}, {"Rar!\x1A\x07"}, "a RAR archive", "take a file out of it"},
    {{".tar", ".tgz"}, {"ustar", 257}, "a tar archive", take_file, "tar -xOf"},
    {{".npz"}, {zip, 0, {".npy"}}, "a NumPy archive (.npz)", take_file, "unzip -p"},
    {{".xlsx", ".xlsm"}, {zip, 0, {"[Content_Types].xml"}}, "an Excel workbook (.xlsx)", save_table},
    {{}, {zip, 0, {"_rels/"}}, "an Excel workbook (.xlsx)", save_table},
    {{}, {zip, 0, {"xl/"}}, "an Excel workbook (.xlsx)", save_table},
    {{".ods"}, {zip, 0, {"mimetype"}}, "a LibreOffice document (.ods)", save_table},
    {{".usdz"}, {zip, 0, {".usd"}}, "a USD scene (.usdz)", export_keys},
    {{".zip"}, {zip}, "a ZIP archive", take_file, "unzip -p"},
    {{".br", ".z"}},
    // Tables.
    {{".parquet"}, {"PAR1"}, "a Parquet table", save_table},
    {{".arrow", ".feather"}, {"ARROW1"}, "an Arrow or Feather table", save_table},
    {{}, {"FEA1"}, "a Feather table", save_table},
    {{".orc"}, {"ORC"}, "an ORC table", save_table},
    {{".avro"}, {"Obj\x01"}, "an Avro table", export_keys},
    {{".pkl", ".pickle"}, {"\x80\x04\x95"}, "a pickled object of Python", save_table},
    {{}, {"\x80\x05\x95"}, "a pickled object of Python", save_table},
    {{".db", ".sqlite"}, {"SQLite format 3"}, "an SQLite database", "export a table of it as CSV, with all digits"},
    {{}, {"netcdf ", 0, {"dimensions:"}}, "a listing of ncdump", export_arrays},
    {{".h5", ".hdf5"}, {"\x89HDF"}, "an HDF5 file", export_arrays},
    {{".nc"}, {"CDF\x01"}, "a NetCDF file", export_arrays},
    {{}, {"CDF\x02"}, "a NetCDF file", export_arrays},
    {{".mat"}, {"MATLAB 5.0"}, "a MATLAB file", export_arrays},
    {{".numbers"}},
    // Scenes and motions.
    {{}, {compound, 0, {class_directory}}, "a 3ds Max scene (.max)", export_keys},
    {{".xls"}, {compound, 0, {workbook}}, "an Excel workbook (.xls)", save_table},
    {{}, {compound, 0, {book}}, "an Excel workbook (.xls)", save_table},
    {{},
     {"\xD0\xCF\x11\xE0"},
     "a compound file of Microsoft, such as a workbook (.xls) or a 3ds Max scene (.max)",
     "export its table or its keys as CSV"},
    {{".fbx"}, {"Kaydara FBX"}, fbx_scene, export_csv},
    {{}, {"; FBX"}, fbx_scene, export_csv},
    {{}, {"FBXHeaderExtension"}, fbx_scene, export_csv},
    {{".ase"}, {"*3DSMAX_ASCIIEXPORT"}, "an ASE scene of 3ds Max", "export the keys as CSV, or the scene as .3ds"},
    {{".bvh"}, {"HIERARCHY"}, "a BVH motion capture file", export_keys},
    {{}, {"\x02P"}, "a C3D motion capture file", export_keys},
    {{}, {"Gamebryo File Format"}, "a NIF scene (.nif, .kf)", export_keys},
    {{}, {"NetImmerse File Format"}, "a NIF scene (.nif, .kf)", export_keys},
    {{}, {"Vocaloid Motion Data"}, "a motion of MikuMikuDance (.vmd)", export_keys},
    {{".usda"}, {"#usda"}, "a USD scene (.usda)", export_keys},
    {{".usdc", ".usd"}, {"PXR-USDC"}, "a USD scene (.usdc)", export_keys},
    {{".glb"}, {"glTF"}, "a glTF scene (.glb)", export_keys},
    {{}, {"{", 0, {"\"asset\"", "\"accessors\""}}, "a glTF scene", export_keys},
    {{}, {"//Maya ASCII"}, "a Maya scene", export_keys},
    {{}, {"FOR4"}, "a Maya scene (.mb)", export_keys},
    {{}, {"FOR8"}, "a Maya scene (.mb)", export_keys},
    {{}, {"LWO", 8}, "an object of LightWave, which has no keys", "give the scene (.lws) or a motion (.mot)"},
    {{}, {"animVersion "}, "an animation of Maya (.anim)", export_keys},
    {{}, {"Adobe After Effects"}, "a text of keyframes of After Effects", export_keys},
    {{}, {"{", 0, {"tracklength", "data ="}}, "a clip of Houdini", export_keys},
    {{".srt"}, {"1", 0, {"\n00:", " --> "}}, "a text of subtitles (.srt)", export_keys},
    {{".blend"}, {"BLENDER"}, "a Blender file", export_keys},
    {{".abc"}, {"Ogawa"}, "an Alembic scene", export_keys},
    {{".dae"}, {"<", 0, {"<COLLADA"}}, "a COLLADA scene (.dae)", export_keys},
    {{".obj"}},
    {{".mot"}},
    // JSON.
    {{},
     {.members = {"frames", "transform_matrix"}},
     "a transforms.json of poses without times",
     "give --records frames --parameter uniform --columns "
     "'position=transform_matrix[0][3]:transform_matrix[1][3]:transform_matrix[2][3]' --rotation "
     "'matrix=transform_matrix[0][0]:transform_matrix[0][1]:transform_matrix[0][2]:transform_matrix[1][0]:"
     "transform_matrix[1][1]:transform_matrix[1][2]:transform_matrix[2][0]:transform_matrix[2][1]:"
     "transform_matrix[2][2]'"},
    {{},
     {.members = {"R", "T", "glow_mode"}},
     "a camera path of instant-ngp, whose keys have no times and whose curve, a B-spline, does not pass through them",
     "give WORD--parameter uniform --columns position=T --rotation 'quaternion=R[0]:R[1]:R[2]:R[3]' for a curve "
     "that does"},
    {{},
     {.members = {"Meta", "Curves", "Segments"}},
     "a motion of Live2D, whose segments are a type and 2 or 6 numbers, of which the last 2 are a key",
     write_keys},
    {{}, {.members = {"layers", "ip", "op"}}, "a Lottie animation", "export its keyframes as a table"},
    {{}, {.members = {"sheetsById"}}, "a project of Theatre.js", "give WORD--columns time=position,position=value"},
    {{},
     {.members = {"fileType", "mission"}},
     "a plan of QGroundControl, whose items have no times",
     "give --records mission.items --parameter uniform --columns 'position=params[4]:params[5]:params[6]'"},
    {{},
     {.members = {"asset", "accessors", "animations"}},
     "a glTF scene, whose keys are in a buffer",
     "export them as a table"},
    {{},
     {.members = {"coordinates", "coordTimes"}, .test = is_geojson},
     "GeoJSON with the times of several tracks",
     export_keys},
    {{},
     {.members = {"coordinates", "times"}, .test = is_geojson},
     "GeoJSON with the times of several tracks",
     export_keys},
    {{},
     {.members = {"coordinates"}, .test = is_geojson},
     "GeoJSON, whose places have no times",
     "give WORD--parameter uniform"},
    {{},
     {.members = {"arcs"}, .test = is_topojson},
     "TopoJSON, whose places are differences without times",
     "convert an object of it to GeoJSON"},
    {{},
     {.members = {"skeleton", "bones", "animations"}},
     "a skeleton of Spine, whose keys leave out numbers",
     write_keys},
    {{},
     {.members = {"armature", "bone", "frameRate"}},
     "a skeleton of DragonBones, whose keys have durations and no times",
     write_keys},
    {{},
     {.members = {"img_name", "position", "rotation"}},
     "a cameras.json of Gaussian splatting, whose cameras have no times",
     "give WORD--parameter uniform --columns position=position"},
    {{},
     {.members = {"DisplayName", "in", "value"}},
     "a copy of keyframes of Kdenlive, which are one text",
     write_keys},
    // Recordings.
    {{".mcap"}, {"\x89MCAP"}, "an MCAP recording", export_topic},
    {{".bag"}, {"#ROSBAG"}, "a ROS bag", export_topic},
    {{}, {"ULog\x01"}, "a ULog of PX4", export_topic},
    {{}, {".FIT", 8}, "a FIT recording of Garmin", export_track},
    {{}, {"<", 0, {"<gpx"}}, "a GPX track", export_track},
    {{}, {"TDSm"}, "a TDMS recording of LabVIEW", export_arrays},
    {{}, {"header:", 0, {"stamp:"}}, "a text of ROS messages", export_topic},
    {{}, {"A", 0, {"\nHFDTE"}}, "a flight record (.igc)", export_track},
    {{}, {"$G", 0, {"GGA,"}}, "a text of NMEA 0183", export_track},
    {{}, {"$G", 0, {"RMC,"}}, "a text of NMEA 0183", export_track},
    {{},
     {"# Image list with two lines of data per image"},
     "a list of images of COLMAP",
     "take the lines of the poses alone"},
    {{}, {"ITEM: TIMESTEP"}, "a dump of LAMMPS", export_keys},
    {{}, {.test = is_xyz}, "a text of atoms (.xyz)", export_keys},
    {{}, {"MThd"}, "a MIDI file", export_keys},
    // Others.
    {{".pdf"}, {"%PDF"}, "a PDF document", export_keys},
    {{".png"}, {"\x89PNG"}, "a PNG picture", export_keys},
    {{".jpg", ".jpeg"}, {"\xFF\xD8\xFF"}, "a JPEG picture", export_keys},
    {{".gif"}, {"GIF8"}, "a GIF picture", export_keys},
    {{".mp4"}, {"ftyp", 4}, "a video", export_keys},
    {{}, {"%YAML", 0, {"tag:unity3d.com"}}, "a file of Unity", export_keys},
    {{}, {"[gd_"}, "a scene of Godot", export_keys},
    {{".yaml", ".yml"}, {"%YAML"}, "a YAML document", "convert it to JSON"},
    {{}, {"---\n"}, "a YAML document", "convert it to JSON"},
    {{}, {.test = is_yaml}, "a YAML document", "convert it to JSON"},
    {{".xml", ".html", ".htm"}, {"<", 0, {"</"}}, "XML or HTML", export_keys},
    {{}, {"<", 0, {"/>"}}, "XML or HTML", export_keys},
    {{}, {"<?xml"}, "XML or HTML", export_keys},
    {{}, {"<!"}, "XML or HTML", export_keys},
    {{".toml"}},
};

/// A signature at the beginning may follow blanks, and a byte order mark.
std::string_view without_blanks(std::string_view text) {
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  return text;
}

/// `inner`: the beginning without blanks.
bool fits(const Signature& signature, std::string_view beginning, std::string_view inner) {
  const std::string_view text = signature.at == 0 ? inner : beginning;
  if (!signature.members[0].empty()) return false;
  if (signature.test != nullptr) return signature.test(text);
  if (signature.bytes.empty()) return false;
  if (text.size() < signature.at || !text.substr(signature.at).starts_with(signature.bytes)) return false;
  return std::ranges::all_of(signature.within, [&](auto part) { return text.find(part) != std::string_view::npos; });
}

std::string remedy_with(std::string_view remedy, std::string_view word) {
  std::string text(remedy);
  if (const std::size_t at = text.find("WORD"); at != std::string::npos) text.replace(at, 4, word);
  return text;
}

}  // namespace

std::optional<Error> other_file(std::string_view beginning) {
  const std::string_view inner = without_blanks(beginning);
  const auto* found =
      std::ranges::find_if(other_files, [&](const auto& row) { return fits(row.signature, beginning, inner); });
  if (found == std::ranges::end(other_files)) return std::nullopt;
  return data_error("this is {}; expected text with a key in each row, or JSON; {}", found->name,
                    remedy_with(found->remedy, found->word));
}

bool may_begin_other_file(std::string_view beginning) {
  constexpr std::size_t most_blanks = 4096, enough_of_container = 1UL << 16;
  if (beginning.starts_with(compound) || beginning.starts_with(zip)) return beginning.size() < enough_of_container;
  if (beginning.size() > most_blanks) return false;
  const std::string_view text = without_blanks(beginning);
  const auto is_binary = [&] { return std::ranges::any_of(beginning, [](unsigned char c) { return c < '\t'; }); };
  return std::ranges::any_of(other_files, [&](const OtherFile& row) {
    const Signature& signature = row.signature;
    if (signature.at > 0) return beginning.size() < signature.at + signature.bytes.size() && is_binary();
    return signature.bytes.size() > text.size() && signature.bytes.starts_with(text);
  });
}

std::optional<Error> other_json(const std::unordered_set<std::string_view>& members, std::string_view type,
                                std::string_view records) {
  const auto found = std::ranges::find_if(other_files, [&](const OtherFile& row) {
    const auto& names = row.signature.members;
    return !names[0].empty() && (row.signature.test == nullptr || row.signature.test(type)) &&
           std::ranges::all_of(names, [&](auto name) { return name.empty() || members.contains(name); });
  });
  if (found == std::ranges::end(other_files)) return std::nullopt;
  return data_error("this is {}; expected a list of keys; {}", found->name, remedy_with(found->remedy, records));
}

std::string_view ending_of_other_file(std::string_view path) {
  for (const OtherFile& row : other_files) {
    for (const std::string_view ending : row.endings) {
      if (!ending.empty() && has_ending(path, ending)) return ending;
    }
  }
  return "";
}

}  // namespace tcb
