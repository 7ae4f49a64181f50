// Options of the command line: the long name of each, which identifies it; a misspelt name does not compile.
//
// Each begins the row of its option in cli/options.cpp, and errors and notes offer options by these names.
#pragma once

#include <string_view>

namespace tcb::option {

inline constexpr std::string_view input_format = "--input-format";
inline constexpr std::string_view delimiter = "--delimiter";
inline constexpr std::string_view header = "--header";
inline constexpr std::string_view no_header = "--no-header";
inline constexpr std::string_view comment = "--comment";
inline constexpr std::string_view columns = "--columns";
inline constexpr std::string_view tcb = "--tcb";
inline constexpr std::string_view tcb_scale = "--tcb-scale";
inline constexpr std::string_view decimal = "--decimal";
inline constexpr std::string_view thousands = "--thousands";
inline constexpr std::string_view group = "--group";
inline constexpr std::string_view max_memory = "--max-memory";
inline constexpr std::string_view missing = "--missing";
inline constexpr std::string_view na = "--na";
inline constexpr std::string_view time_unit = "--time-unit";
inline constexpr std::string_view input_fps = "--input-fps";
inline constexpr std::string_view date_order = "--date-order";
inline constexpr std::string_view scale = "--scale";
inline constexpr std::string_view rotation = "--rotation";
inline constexpr std::string_view angles = "--angles";
inline constexpr std::string_view rotation_output = "--rotation-output";
inline constexpr std::string_view angle = "--angle";
inline constexpr std::string_view normalize = "--normalize";
inline constexpr std::string_view duplicates = "--duplicates";
inline constexpr std::string_view sort = "--sort";
inline constexpr std::string_view preset = "--preset";
inline constexpr std::string_view tangents = "--tangents";
inline constexpr std::string_view ends = "--ends";
inline constexpr std::string_view closed = "--closed";
inline constexpr std::string_view period = "--period";
inline constexpr std::string_view equal_speed = "--equal-speed";
inline constexpr std::string_view no_overshoot = "--no-overshoot";
inline constexpr std::string_view max_gap = "--max-gap";
inline constexpr std::string_view parameter = "--parameter";
inline constexpr std::string_view metric = "--metric";
inline constexpr std::string_view rotation_curve = "--rotation-curve";
inline constexpr std::string_view no_ease = "--no-ease";
inline constexpr std::string_view extrapolate = "--extrapolate";
inline constexpr std::string_view step = "--step";
inline constexpr std::string_view rate = "--rate";
inline constexpr std::string_view fps = "--fps";
inline constexpr std::string_view count = "--count";
inline constexpr std::string_view segments = "--segments";
inline constexpr std::string_view per_segment = "--per-segment";
inline constexpr std::string_view at = "--at";
inline constexpr std::string_view arc_step = "--arc-step";
inline constexpr std::string_view arc_count = "--arc-count";
inline constexpr std::string_view arc_at = "--arc-at";
inline constexpr std::string_view tolerance = "--tolerance";
inline constexpr std::string_view emit = "--emit";
inline constexpr std::string_view fit = "--fit";
inline constexpr std::string_view fit_keys = "--fit-keys";
inline constexpr std::string_view keep_times = "--keep-times";
inline constexpr std::string_view corner = "--corner";
inline constexpr std::string_view from = "--from";
inline constexpr std::string_view to = "--to";
inline constexpr std::string_view end = "--end";
inline constexpr std::string_view keys = "--keys";
inline constexpr std::string_view max_rows = "--max-rows";
inline constexpr std::string_view output = "--output";
inline constexpr std::string_view output_format = "--output-format";
inline constexpr std::string_view fields = "--fields";
inline constexpr std::string_view side = "--side";
inline constexpr std::string_view digits = "--digits";
inline constexpr std::string_view fixed = "--fixed";
inline constexpr std::string_view jobs = "--jobs";
inline constexpr std::string_view golden = "--golden";
inline constexpr std::string_view exact_input = "--exact-input";
inline constexpr std::string_view meta = "--meta";
inline constexpr std::string_view from_meta = "--from-meta";
inline constexpr std::string_view hex = "--hex";
inline constexpr std::string_view output_delimiter = "--output-delimiter";
inline constexpr std::string_view output_decimal = "--output-decimal";
inline constexpr std::string_view like_input = "--like-input";
inline constexpr std::string_view no_output_header = "--no-output-header";
inline constexpr std::string_view file_column = "--file-column";
inline constexpr std::string_view time_format = "--time-format";
inline constexpr std::string_view time_zero = "--time-zero";
inline constexpr std::string_view rename = "--rename";
inline constexpr std::string_view plot = "--plot";
inline constexpr std::string_view axes = "--axes";
inline constexpr std::string_view title = "--title";
inline constexpr std::string_view size = "--size";
inline constexpr std::string_view output_dir = "--output-dir";
inline constexpr std::string_view files = "--files";
inline constexpr std::string_view null = "--null";
inline constexpr std::string_view only = "--only";
inline constexpr std::string_view records = "--records";
inline constexpr std::string_view recursive = "--recursive";
inline constexpr std::string_view suffix = "--suffix";
inline constexpr std::string_view update = "--update";
inline constexpr std::string_view fail_fast = "--fail-fast";
inline constexpr std::string_view check = "--check";
inline constexpr std::string_view abs = "--abs";
inline constexpr std::string_view rel = "--rel";
inline constexpr std::string_view ulp = "--ulp";
inline constexpr std::string_view map = "--map";
inline constexpr std::string_view identify = "--identify";
inline constexpr std::string_view explain = "--explain";
inline constexpr std::string_view progress = "--progress";
inline constexpr std::string_view no_progress = "--no-progress";
inline constexpr std::string_view quiet = "--quiet";
inline constexpr std::string_view color = "--color";
inline constexpr std::string_view generate = "--generate";
inline constexpr std::string_view list_presets = "--list-presets";
inline constexpr std::string_view version = "--version";
inline constexpr std::string_view help = "--help";

}  // namespace tcb::option
