// Formats: the list of all of them, with their halves that read and write.
#include "formats/formats.hpp"

#include <algorithm>
#include <array>

#include "read/other_files.hpp"
#include "schema/pose_formats.hpp"
#include "text/suggest.hpp"

namespace tcb {

// The halves, each in the file of its name.
extern const InputFormat delimited_input, json_input, camera_path_input, poses_input, npy_input, lightwave_input,
    studio_3ds_input;
extern const OutputFormat delimited_output, json_output, jsonl_output, pose_output, camera_path_output, npy_output,
    gltf_output;

namespace {

constexpr std::uint16_t text_rows = offer::any_columns | offer::column_names | offer::keys | offer::pieces |
                                    offer::decimals | offer::times | offer::words_of_time | offer::provenance;

/// To add a format: a row here, and the halves that it names.
constexpr std::array list_of_formats{
    Format{.name = "csv",
           .ending = ".csv",
           .input = &delimited_input,
           .output = &delimited_output,
           .delimiter = ',',
           .offered = text_rows | offer::marks | offer::any_delimiter},
    Format{.name = "tsv",
           .ending = ".tsv",
           .input = &delimited_input,
           .output = &delimited_output,
           .delimiter = '\t',
           .offered = text_rows | offer::marks},
    Format{.name = "ssv",
           .ending = ".ssv",
           .input = &delimited_input,
           .output = &delimited_output,
           .delimiter = ' ',
           .offered = text_rows | offer::marks},
    Format{.name = "json",
           .ending = ".json",
           .input = &json_input,
           .output = &json_output,
           .offered = text_rows,
           .is_json = true,
           .nests = true,
           .has_reports = true},
    Format{.name = "jsonl",
           .ending = ".jsonl",
           .input = &json_input,
           .output = &jsonl_output,
           .offered = text_rows,
           .is_json = true},
    Format{.name = "tum",
           .ending = ".tum",
           .input = &poses_input,
           .output = &pose_output,
           .delimiter = ' ',
           .poses = &tum_poses,
           .fields = "time,position",
           .offered = offer::decimals | offer::times},
    Format{.name = "euroc",
           .ending = ".euroc",
           .input = &poses_input,
           .output = &pose_output,
           .delimiter = ',',
           .poses = &euroc_poses,
           .fields = "time,position",
           .offered = offer::decimals | offer::times},
    Format{.name = "kitti",
           .ending = ".kitti",
           .input = &poses_input,
           .output = &pose_output,
           .delimiter = ' ',
           .poses = &kitti_poses,
           .fields = "position",
           .offered = offer::decimals},
    Format{.name = "nerfstudio",
           .ending = ".json",
           .input = &camera_path_input,
           .output = &camera_path_output,
           .poses = &nerfstudio_poses,
           .fields = "time,position",
           .offered = offer::decimals | offer::times},
    Format{.name = "lws", .ending = ".lws", .input = &lightwave_input},
    Format{.name = "3ds", .ending = ".3ds", .input = &studio_3ds_input},
    Format{.name = "gltf",
           .ending = ".gltf",
           .output = &gltf_output,
           .fields = "time,position",
           .offered = offer::pieces | offer::times,
           .has_nodes = true},
    Format{.name = "npy",
           .ending = ".npy",
           .input = &npy_input,
           .output = &npy_output,
           .offered = offer::any_columns | offer::keys | offer::pieces | offer::times,
           .is_binary = true},
    Format{.name = "svg",
           .ending = ".svg",
           .offered = offer::column_names | offer::keys | offer::drawing,
           .is_picture = true},
};

std::vector<std::string_view> endings(bool (Format::*can)() const) {
  std::vector<std::string_view> found;
  for (const Format& format : list_of_formats) {
    if ((format.*can)() && std::ranges::count(found, format.ending) == 0) found.push_back(format.ending);
  }
  return found;
}

}  // namespace

std::span<const Format> formats() { return list_of_formats; }

const Format* find_format(std::string_view name) {
  const auto found = std::ranges::find(list_of_formats, name, &Format::name);
  return found == list_of_formats.end() ? nullptr : &*found;
}

const Format* find_output_format(std::string_view path) {
  path = without_compression(path);
  const auto names = [&](const Format& format) { return format.can_write() && has_ending(path, format.ending); };
  const auto found = std::ranges::find_if(list_of_formats, names);
  return found == list_of_formats.end() ? nullptr : &*found;
}

std::string_view other_ending(std::string_view path) {
  path = without_compression(path);
  for (const Format& format : list_of_formats) {
    if (!format.can_write() && has_ending(path, format.ending)) return format.ending;
  }
  return ending_of_other_file(path);
}

std::vector<std::string_view> input_endings() { return endings(&Format::can_read); }
std::vector<std::string_view> output_endings() { return endings(&Format::can_write); }

}  // namespace tcb
