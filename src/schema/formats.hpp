// Formats: the table of their names, file endings and capabilities.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace tcb {

enum class FormatId : std::size_t {
  csv,
  tsv,
  ssv,
  json,
  jsonl,
  tum,
  euroc,
  kitti,
  nerfstudio,
  lws,
  studio_3ds,
  ase,
  fbx,
  gltf,
  crazyswarm,
  npy,
  svg
};

/// What formats have in common.
enum class FormatFamily {
  delimited,  ///< lines of cells, with the names of the columns in one line above the rows
  json,       ///< an object for each row
  poses,      ///< lines of the numbers of poses, in fixed columns
  cameras,    ///< a JSON object with keyframes, and in outputs with a camera for each row
  tracks,     ///< the values of several objects over time, as the scenes of products have them
  scene,      ///< an animation of nodes
  pieces,     ///< lines of polynomials, one for each piece of a path of x, y, z and yaw
  array,      ///< doubles, not their texts; it can hold neither other texts nor more than one table
  picture,    ///< curves and samples, without rows
};

/// A format of inputs, outputs, or both. To add one: a row here, and how it is read (read/reader.cpp), written
/// (write/layout.cpp) or drawn (plot/).
struct Format {
  FormatId id;
  std::string_view name;
  std::string_view ending;  ///< of file names, with the point; that of another format does not name this one
  FormatFamily family;
  bool can_read;
  bool can_write;
  bool has_provenance;  ///< an output may hold its provenance
  bool nests;           ///< an output with groups is an object for each curve, with a list of rows
  char delimiter = 0;   ///< between the cells of lines; ' ' is any run of blanks and tabs
};

/// All formats, in the order of FormatId. The first is the default for output.
inline constexpr std::array<Format, 17> formats{{
    // id, name, ending, family, read, write, provenance, nests, delimiter
    {FormatId::csv, "csv", ".csv", FormatFamily::delimited, true, true, true, false, ','},
    {FormatId::tsv, "tsv", ".tsv", FormatFamily::delimited, true, true, true, false, '\t'},
    {FormatId::ssv, "ssv", ".ssv", FormatFamily::delimited, true, true, true, false, ' '},
    {FormatId::json, "json", ".json", FormatFamily::json, true, true, true, true},
    {FormatId::jsonl, "jsonl", ".jsonl", FormatFamily::json, true, true, true, false},
    {FormatId::tum, "tum", ".tum", FormatFamily::poses, true, true, false, false, ' '},
    {FormatId::euroc, "euroc", ".euroc", FormatFamily::poses, true, true, false, false, ','},
    {FormatId::kitti, "kitti", ".kitti", FormatFamily::poses, true, true, false, false, ' '},
    {FormatId::nerfstudio, "nerfstudio", ".json", FormatFamily::cameras, true, true, false, false},
    {FormatId::lws, "lws", ".lws", FormatFamily::tracks, true, false, false, false},
    {FormatId::studio_3ds, "3ds", ".3ds", FormatFamily::tracks, true, false, false, false},
    {FormatId::ase, "ase", ".ase", FormatFamily::tracks, true, false, false, false},
    {FormatId::fbx, "fbx", ".fbx", FormatFamily::tracks, true, false, false, false},
    {FormatId::gltf, "gltf", ".gltf", FormatFamily::scene, false, true, false, false},
    {FormatId::crazyswarm, "crazyswarm", ".csv", FormatFamily::pieces, false, true, false, false, ','},
    {FormatId::npy, "npy", ".npy", FormatFamily::array, true, true, false, false},
    {FormatId::svg, "svg", ".svg", FormatFamily::picture, false, true, false, false},
}};

constexpr const Format& format_of(FormatId id) { return formats[static_cast<std::size_t>(id)]; }

/// Rows are poses, in columns that the format decides.
constexpr bool has_pose_rows(const Format& format) {
  return format.family == FormatFamily::poses || format.family == FormatFamily::cameras;
}

/// The format with this name.
constexpr std::optional<FormatId> find_format(std::string_view name) {
  for (const Format& format : formats) {
    if (format.name == name) return format.id;
  }
  return std::nullopt;
}

/// The input format that the ending of the path names, before an ending of compressed files such as .gz.
std::optional<FormatId> find_input_format(std::string_view path);

/// The endings of the formats that can be read, and of those that can be written.
std::vector<std::string_view> input_endings();
std::vector<std::string_view> output_endings();

/// The format that can be written and whose ending the path has, in upper or lower case, before that of compressed
/// files.
std::optional<FormatId> find_output_format(std::string_view path);

}  // namespace tcb
