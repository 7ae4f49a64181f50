// The halves that read JSON: keys of any shape, and camera paths.
#include <utility>

#include "read/input_format.hpp"
#include "read/json/camera_path.hpp"
#include "read/json/shapes.hpp"

namespace tcb {
namespace {

std::optional<int> fit_of_json(std::string_view beginning) {
  const std::size_t at = beginning.find_first_not_of(" \t\r\n");
  return at != std::string_view::npos && (beginning[at] == '[' || beginning[at] == '{') ? 2 : 0;
}

std::optional<int> fit_of_camera_path(std::string_view beginning) {
  const std::optional<bool> begins = begins_camera_path(beginning);
  return begins ? std::optional(*begins ? 3 : 0) : std::nullopt;
}

Records open_json_format(const Format&, Source<std::string> bytes, InputOptions options) {
  return open_json(std::move(bytes), options);
}

Records open_camera_path_format(const Format&, Source<std::string> bytes, InputOptions options) {
  return open_camera_path(std::move(bytes), options);
}

InputOptions options_of_camera_path_format(const Format&, Source<std::string>&, InputOptions options) {
  return options_of_camera_path(std::move(options));
}

}  // namespace

extern const InputFormat json_input{.open = open_json_format, .fit = fit_of_json};
extern const InputFormat camera_path_input{.open = open_camera_path_format,
                                           .options = options_of_camera_path_format,
                                           .fit = fit_of_camera_path,
                                           .has_own_columns = true,
                                           .has_frames = true};

}  // namespace tcb
