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

bool has_positions_of_fanuc(std::string_view text) {
  return text.find("P[") != std::string_view::npos && text.find("CONFIG :") != std::string_view::npos;
}

bool has_curves_of_nuke(std::string_view text) { return text.find("{curve ") != std::string_view::npos; }

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

constexpr std::string_view
    export_keys = "export the keys as CSV or JSON",
    by_bvh = "convert it, as in bvh-converter FILE, which writes FILE_worldpos.csv",
    by_echo = "print them as a table, as in rostopic echo -p TOPIC or ros2 topic echo --csv TOPIC",
    by_fbx = "export it as ASCII, or convert it with the FBX Converter of Autodesk",
    by_max = "export the scene from 3ds Max as ASE, 3DS or ASCII FBX",
    by_gpsbabel = "convert it, as in gpsbabel -t -i WORD -f FILE -o unicsv -F - | tcbsample",
    by_maya = "export the scene from Maya as ASCII FBX",
    by_mcap = "convert it, as in mcap cat FILE --topics TOPIC --json | tcbsample -i jsonl",
    by_rosbag = "convert it, as in rostopic echo -b FILE -p TOPIC | tcbsample",
    by_gcode =
        "take the coordinates, of which each line changes some, as in awk '{gsub(/\\([^)]*\\)|;.*| /, \"\"); "
        "gsub(/[A-Z]/, \" &\"); k = 0; for (i = 1; i <= NF; ++i) if ($i ~ /^[XYZ]/) {p[substr($i, 1, 1)] = "
        "substr($i, 2); k = 1}} k && \"X\" in p && \"Y\" in p {print p[\"X\"], p[\"Y\"], (\"Z\" in p) ? p[\"Z\"] : 0}' "
        "FILE | tcbsample --parameter uniform",
    by_sqlite = "convert a table of it, as in sqlite3 -csv -header FILE 'SELECT * FROM TABLE' | tcbsample",
    by_tar = "take a file out of it, as in tar -xOf FILE NAME | tcbsample",
    by_after_effects = "take the keys of a property, as in awk '!/^\\t/ {p = /Position/} p && /^\\t/' FILE | tcbsample",
    by_anim =
        "take the keys of its curves, as in awk '/^anim /{c = $3} /keys {/{k = 1; next} /}/{k = 0} k {print c, $1, "
        "$2}' FILE | tcbsample --columns group=1,time=2,position=3",
    by_clip =
        "take its tracks as columns, as in sed -n 's/.*data = //p' FILE | python3 -c 'import sys; "
        "print(*map(\",\".join, zip(*map(str.split, sys.stdin))), sep=\"\\n\")' | tcbsample --parameter uniform",
    by_fanuc =
        "take its positions, as in perl -ne 'push @n, /[XYZWPR] = +([-\\d.]+)/g; if (/};/) {print \"@n\\n\"; @n = ()}' "
        "FILE | tcbsample --parameter uniform",
    by_godot =
        "take the keys of a track, as in perl -0777 -ne '($t) = /\"times\": \\w+\\(([^)]*)/; ($v) = /\"values\": "
        "\\[(.*?)\\]/s; @t = split /, */, $t; @v = grep {defined} $v =~ /\\w+\\(([^)]*)\\)|(-?\\d[\\d.e-]*)/g; print "
        "map {\"$t[$_],$v[$_]\\n\"} 0 .. $#t' FILE | tcbsample",
    by_lammps =
        "convert it, as in awk '/^ITEM: TIMESTEP/ {getline t; p = 0; next} /^ITEM: ATOMS/ {if (!n++) print \"time\" "
        "substr($0, 12); p = 1; next} /^ITEM/ {p = 0} p {print t, $0}' FILE | tcbsample --group id",
    by_nuke =
        "take the keys of a curve, as in grep -oE '\\{curve[^}]*' FILE | sed -n 1p | awk '{for (i = 2; i <= NF; ++i) "
        "if ($i ~ /^x/) f = substr($i, 2); else if ($i ~ /^[-0-9]/) print f++, $i}' | tcbsample",
    by_feature = "take one of them, as in jq '.features[0]' FILE | tcbsample",
    by_spine =
        "take the keys of a bone, as in jq '.animations[\"NAME\"].bones[\"NAME\"].translate | map({time: (.time // 0), "
        "x: (.x // 0), y: (.y // 0)})' FILE | tcbsample",
    by_srt =
        "take its times and the numbers in brackets, as in awk '/-->/ {t = $1; sub(/,/, \".\", t)} /\\[/ "
        "{gsub(/[^-+.0-9]+/, \" \"); print t, $0}' FILE | tcbsample",
    by_xyz =
        "convert it, as in awk 'BEGIN {print \"frame atom x y z\"} NF == 1 {++f; i = 0; getline; next} {print f - 1, "
        "++i, $2, $3, $4}' FILE | tcbsample --group atom",
    by_three_js =
        "take a track as rows, as in jq -r '.tracks[0] | .times as $t | .values as $v | ($v | length / ($t | length)) "
        "as $n | range($t | length) | [$t[.], $v[. * $n:(. + 1) * $n][]] | @csv' FILE | tcbsample",
    by_yaml =
        "convert it, as in python3 -c 'import json, sys, yaml; json.dump(yaml.safe_load(open(sys.argv[1])), "
        "sys.stdout)' FILE | tcbsample",
    by_zip = "take a file out of it, as in unzip -p FILE NAME | tcbsample",
    by_npz = "take an array out of it, as in unzip -p FILE NAME.npy | tcbsample",
    by_netcdf =
        "convert it, as in python3 -c 'import sys, xarray; "
        "xarray.open_dataset(sys.argv[1]).to_dataframe().to_csv(sys.stdout)' FILE | tcbsample",
    by_hdf5 =
        "convert a dataset of it, as in python3 -c 'import h5py, numpy, sys; numpy.savetxt(sys.stdout, "
        "h5py.File(sys.argv[1])[sys.argv[2]])' FILE DATASET | tcbsample",
    by_matlab =
        "convert a matrix of it, as in python3 -c 'import numpy, scipy.io, sys; numpy.savetxt(sys.stdout, "
        "scipy.io.loadmat(sys.argv[1])[sys.argv[2]])' FILE VARIABLE | tcbsample",
    by_lz4 = "decompress it, as in lz4cat FILE | tcbsample", by_xz = "decompress it, as in xzcat FILE | tcbsample",
    by_bzip2 = "decompress it, as in bzcat FILE | tcbsample",
    by_pandas =
        "convert it, as in python3 -c 'import pandas, sys; pandas.WORD(sys.argv[1]).to_csv(sys.stdout, index=False)' "
        "FILE | tcbsample";

constexpr std::string_view zip = "PK\x03\x04", compound = "\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1"sv;
/// The names of the streams of a compound file, which are in UTF-16.
constexpr std::string_view class_directory = "C\0l\0a\0s\0s\0D\0i\0r\0e\0c\0t\0o\0r\0y\0"sv,
                           workbook = "W\0o\0r\0k\0b\0o\0o\0k\0"sv, book = "B\0o\0o\0k\0"sv;

/// All of them; the first that fits counts.
constexpr OtherFile other_files[] = {
    // Compressed files and archives.
    {{".bz2"}, {"BZh"}, "a file compressed with bzip2", by_bzip2},
    {{".xz"}, {"\xFD\x37zXZ\0"sv}, "a file compressed with xz", by_xz},
    {{".lz4"}, {"\x04\x22\x4D\x18"}, "a file compressed with LZ4", by_lz4},
    {{".7z"}, {"7z\xBC\xAF\x27\x1C"}, "a 7-Zip archive", "take a file out of it, as in 7z x -so FILE NAME | tcbsample"},
    {{".rar"}, {"Rar!\x1A\x07"}, "a RAR archive", "take a file out of it, as in unrar p -inul FILE NAME | tcbsample"},
    {{".tar", ".tgz"}, {"ustar", 257}, "a tar archive", by_tar},
    {{".npz"}, {zip, 0, {".npy"}}, "a NumPy archive (.npz)", by_npz},
    {{".xlsx", ".xlsm"}, {zip, 0, {"[Content_Types].xml"}}, "an Excel workbook (.xlsx)", by_pandas, "read_excel"},
    {{}, {zip, 0, {"_rels/"}}, "an Excel workbook (.xlsx)", by_pandas, "read_excel"},
    {{}, {zip, 0, {"xl/"}}, "an Excel workbook (.xlsx)", by_pandas, "read_excel"},
    {{".ods"}, {zip, 0, {"mimetype"}}, "a LibreOffice document (.ods)", by_pandas, "read_excel"},
    {{".usdz"}, {zip, 0, {".usd"}}, "a USD scene (.usdz)", export_keys},
    {{".zip"}, {zip}, "a ZIP archive", by_zip},
    {{".br", ".z"}},
    // Tables.
    {{".parquet"}, {"PAR1"}, "a Parquet table", by_pandas, "read_parquet"},
    {{".arrow", ".feather"}, {"ARROW1"}, "an Arrow or Feather table", by_pandas, "read_feather"},
    {{}, {"FEA1"}, "a Feather table", by_pandas, "read_feather"},
    {{".orc"}, {"ORC"}, "an ORC table", by_pandas, "read_orc"},
    {{".avro"}, {"Obj\x01"}, "an Avro table", export_keys},
    {{".pkl", ".pickle"}, {"\x80\x04\x95"}, "a pickled object of Python", by_pandas, "read_pickle"},
    {{}, {"\x80\x05\x95"}, "a pickled object of Python", by_pandas, "read_pickle"},
    {{".db", ".sqlite"}, {"SQLite format 3"}, "an SQLite database", by_sqlite},
    {{}, {"netcdf ", 0, {"dimensions:"}}, "a listing of ncdump", "give its NetCDF file as CSV or JSON"},
    {{".h5", ".hdf5"}, {"\x89HDF"}, "an HDF5 file", by_hdf5},
    {{".nc"}, {"CDF\x01"}, "a NetCDF file", by_netcdf},
    {{}, {"CDF\x02"}, "a NetCDF file", by_netcdf},
    {{".mat"}, {"MATLAB 5.0"}, "a MATLAB file", by_matlab},
    {{".numbers"}},
    // Scenes and motions.
    {{}, {compound, 0, {class_directory}}, "a 3ds Max scene (.max)", by_max},
    {{".xls"}, {compound, 0, {workbook}}, "an Excel workbook (.xls)", by_pandas, "read_excel"},
    {{}, {compound, 0, {book}}, "an Excel workbook (.xls)", by_pandas, "read_excel"},
    {{},
     {"\xD0\xCF\x11\xE0"},
     "a compound file of Microsoft, such as a workbook (.xls) or a 3ds Max scene (.max)",
     "export an .xls as CSV, or a .max as ASE"},
    {{}, {"Kaydara FBX"}, "a binary FBX file", by_fbx},
    {{".bvh"}, {"HIERARCHY"}, "a BVH motion capture file", by_bvh},
    {{}, {"\x02P"}, "a C3D motion capture file", "convert it, as in c3d2csv FILE | tcbsample"},
    {{}, {"Gamebryo File Format"}, "a NIF scene (.nif, .kf)", export_keys},
    {{}, {"NetImmerse File Format"}, "a NIF scene (.nif, .kf)", export_keys},
    {{}, {"Vocaloid Motion Data"}, "a motion of MikuMikuDance (.vmd)", export_keys},
    {{".usda"}, {"#usda"}, "a USD scene (.usda)", export_keys},
    {{".usdc", ".usd"}, {"PXR-USDC"}, "a USD scene (.usdc)", export_keys},
    {{".glb"}, {"glTF"}, "a glTF scene (.glb)", export_keys},
    {{}, {"{", 0, {"\"asset\"", "\"accessors\""}}, "a glTF scene", export_keys},
    {{}, {"//Maya ASCII"}, "a Maya scene", by_maya},
    {{}, {"FOR4"}, "a Maya scene (.mb)", by_maya},
    {{}, {"FOR8"}, "a Maya scene (.mb)", by_maya},
    {{}, {"LWO", 8}, "an object of LightWave, which has no keys", "give the scene (.lws) or a motion (.mot)"},
    {{}, {"animVersion "}, "an animation of Maya (.anim)", by_anim},
    {{}, {"Adobe After Effects"}, "a text of keyframes of After Effects", by_after_effects},
    {{}, {.test = has_curves_of_nuke}, "a script of Nuke", by_nuke},
    {{}, {"{", 0, {"tracklength", "data ="}}, "a clip of Houdini", by_clip},
    {{}, {.test = has_positions_of_fanuc}, "a program of a Fanuc robot", by_fanuc},
    {{".srt"}, {"1", 0, {"\n00:", " --> "}}, "a text of subtitles (.srt)", by_srt},
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
     "write an object of time and position for each key"},
    {{}, {.members = {"layers", "ip", "op"}}, "a Lottie animation", "export its keyframes as a table"},
    {{}, {.members = {"tracks", "times", "values"}}, "a clip of three.js, whose values are not by key", by_three_js},
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
     by_feature},
    {{},
     {.members = {"coordinates", "times"}, .test = is_geojson},
     "GeoJSON with the times of several tracks",
     by_feature},
    {{},
     {.members = {"coordinates"}, .test = is_geojson},
     "GeoJSON, whose places have no times",
     "give WORD--parameter uniform"},
    {{},
     {.members = {"arcs"}, .test = is_topojson},
     "TopoJSON, whose places are differences without times",
     "convert an object of it, as in topo2geo NAME=- < FILE | tcbsample --parameter uniform"},
    {{},
     {.members = {"skeleton", "bones", "animations"}},
     "a skeleton of Spine, whose keys leave out numbers",
     by_spine},
    {{},
     {.members = {"armature", "bone", "frameRate"}},
     "a skeleton of DragonBones, whose keys have durations and no times",
     "write an object of time and position for each key"},
    {{},
     {.members = {"img_name", "position", "rotation"}},
     "a cameras.json of Gaussian splatting, whose cameras have no times",
     "give WORD--parameter uniform --columns position=position"},
    {{},
     {.members = {"DisplayName", "in", "value"}},
     "a copy of keyframes of Kdenlive, which are one text",
     "take them as rows, as in jq -r '.[0].value' FILE | tr ';' '\\n' | sed 's/[^0-9:.]*=/ /' | tcbsample"},
    // Recordings.
    {{".mcap"}, {"\x89MCAP"}, "an MCAP recording", by_mcap},
    {{".bag"}, {"#ROSBAG"}, "a ROS bag", by_rosbag},
    {{}, {"ULog\x01"}, "a ULog of PX4", "convert it, as in ulog2csv FILE, which writes a .csv file for each topic"},
    {{}, {".FIT", 8}, "a FIT recording of Garmin", by_gpsbabel, "garmin_fit"},
    {{}, {"<", 0, {"<gpx"}}, "a GPX track", by_gpsbabel, "gpx"},
    {{},
     {"TDSm"},
     "a TDMS recording of LabVIEW",
     "convert it, as in python3 -c 'import nptdms, sys; "
     "nptdms.TdmsFile.read(sys.argv[1]).as_dataframe().to_csv(sys.stdout)' FILE | tcbsample"},
    {{}, {"header:", 0, {"stamp:"}}, "a text of ROS messages", by_echo},
    {{}, {"A", 0, {"\nHFDTE"}}, "a flight record (.igc)", by_gpsbabel, "igc"},
    {{}, {"$G", 0, {"GGA,"}}, "a text of NMEA 0183", by_gpsbabel, "nmea"},
    {{}, {"$G", 0, {"RMC,"}}, "a text of NMEA 0183", by_gpsbabel, "nmea"},
    {{},
     {"# Image list with two lines of data per image"},
     "a list of images of COLMAP",
     "take the lines of the poses, as in grep -v '^#' FILE | sed -n 'p;n' | tcbsample"},
    {{}, {"ITEM: TIMESTEP"}, "a dump of LAMMPS", by_lammps},
    {{}, {.test = is_xyz}, "a text of atoms (.xyz)", by_xyz},
    {{}, {"MThd"}, "a MIDI file", "convert it with midicsv FILE, and keep the lines of one kind of event"},
    // Others.
    {{".pdf"}, {"%PDF"}, "a PDF document", export_keys},
    {{".png"}, {"\x89PNG"}, "a PNG picture", export_keys},
    {{".jpg", ".jpeg"}, {"\xFF\xD8\xFF"}, "a JPEG picture", export_keys},
    {{".gif"}, {"GIF8"}, "a GIF picture", export_keys},
    {{".mp4"}, {"ftyp", 4}, "a video", export_keys},
    {{}, {"%YAML", 0, {"tag:unity3d.com"}}, "a file of Unity", export_keys},
    {{}, {"[gd_"}, "a scene of Godot", by_godot},
    {{".yaml", ".yml"}, {"%YAML"}, "a YAML document", by_yaml},
    {{}, {"---\n"}, "a YAML document", by_yaml},
    {{}, {.test = is_yaml}, "a YAML document", by_yaml},
    {{}, {"G", 0, {"\nG", " X"}}, "a program of G-code", by_gcode},
    {{}, {"%", 0, {"\nG", "X"}}, "a program of G-code", by_gcode},
    {{}, {"N", 0, {" G", " X"}}, "a program of G-code", by_gcode},
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
  const auto is_binary = [&] { return std::ranges::any_of(beginning, [](char c) { return c >= '\0' && c < '\t'; }); };
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
