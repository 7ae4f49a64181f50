// Tracks: the animated values of a file with several objects, as keys of curves.
#include "read/scenes/tracks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <iterator>
#include <map>
#include <memory>
#include <string_view>
#include <utility>

#include "io/encoding.hpp"
#include "numbers/decimal_time.hpp"
#include "numbers/parse_number.hpp"
#include "numbers/print_number.hpp"
#include "read/key_builder.hpp"
#include "schema/columns.hpp"
#include "schema/units.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

Error track_number_too_large(std::string_view number) {
  return data_error("{} is beyond the range of doubles; expected less than 1.8e308 in size", in_quotes(number));
}

constexpr std::string_view object_name = "object", track_name = "track";

std::string path_of(const Track& track) { return track.object + "/" + track.name; }

bool is_chosen(const Track& track, std::string_view pattern) {
  return matches(path_of(track), pattern) || matches(track.object, pattern);
}

std::vector<std::string> paths_of(const std::vector<Track>& tracks) {
  std::vector<std::string> paths;
  std::ranges::transform(tracks, std::back_inserter(paths), path_of);
  return paths;
}

std::vector<std::string> names_of(const Track& track) {
  std::vector<std::string> names;
  for (const TrackChannel& channel : track.channels) names.push_back(channel.name);
  return names;
}

/// A name in UTF-8, to which others are converted from Windows-1252, in which products write them. Throws: Error (data)
/// for a name in neither encoding.
bool make_utf8(std::string& name) {
  if (find_invalid_utf8(name) == std::string::npos) return false;
  std::optional<std::string> converted = in_utf8(name, Encoding::windows_1252);
  if (!converted) {
    throw data_error(
        "the name {} of an object, track or channel is neither in UTF-8 nor in Windows-1252; expected UTF-8; rename it",
        in_quotes(name));
  }
  name = std::move(*converted);
  return true;
}

/// Makes the names of objects, tracks and channels UTF-8. Converted ones stay distinct.
void make_utf8(std::vector<Track>& tracks, InputFacts& facts) {
  bool are_converted = false;
  for (Track& track : tracks) {
    are_converted |= make_utf8(track.object);
    are_converted |= make_utf8(track.name);
    for (TrackChannel& channel : track.channels) are_converted |= make_utf8(channel.name);
  }
  if (!are_converted) return;
  facts.encoding = name_of(Encoding::windows_1252);
  std::map<std::string, std::size_t> count;
  for (Track& track : tracks) {
    const std::size_t nth = ++count[path_of(track)];
    if (nth > 1) track.object += fmt::format(" ({})", nth);
  }
}

/// Removes the tracks that are not read; those that are left out are named in `facts`.
void choose(std::vector<Track>& tracks, const std::vector<std::string>& patterns, InputFacts& facts) {
  for (const std::string& pattern : patterns) {
    if (std::ranges::any_of(tracks, [&](const Track& track) { return is_chosen(track, pattern); })) continue;
    throw usage_error(
        "no object or track is {}; expected one of {}; correct it, where * is any text and ? any character",
        in_quotes(pattern), listed(paths_of(tracks)))
        .about("--only");
  }
  const auto is_wanted = [&](const Track& track) {
    return patterns.empty() ||
           std::ranges::any_of(patterns, [&](const std::string& pattern) { return is_chosen(track, pattern); });
  };
  const bool takes_constant = !patterns.empty() && std::ranges::none_of(tracks, [&](const Track& track) {
    return is_wanted(track) && !track.is_constant();
  });
  std::vector<Track*> wanted;
  for (Track& track : tracks) {
    if (!is_wanted(track)) continue;
    if (track.is_constant() && !takes_constant) {
      facts.constant_tracks.push_back(path_of(track));
    } else {
      wanted.push_back(&track);
    }
  }
  for (const Track* const track : wanted) {
    if (track->failure) throw *track->failure;
  }
  std::vector<Track> chosen;
  std::vector<std::string> names;
  for (Track* const track : wanted) {
    if (chosen.empty()) names = names_of(*track);
    if (names_of(*track) == names) {
      chosen.push_back(std::move(*track));
      continue;
    }
    if (!patterns.empty())
      throw usage_error(
          "{} has other channels than {}; expected tracks with the same channels; choose one kind, such as */position",
          in_quotes(path_of(*track)), in_quotes(path_of(chosen.front())))
          .about("--only");
    facts.other_tracks.push_back(path_of(*track));
  }
  if (chosen.empty() && facts.constant_tracks.empty()) {
    throw data_error("the file has no tracks; expected an object with keys");
  }
  if (chosen.empty()) {
    throw data_error(
        "no track has more than one key; expected one that changes; choose one of {} with --only to read it all the "
        "same",
        listed(facts.constant_tracks));
  }
  tracks = std::move(chosen);
}

/// The names of the columns of a track. A channel has columns of velocities where the file decides these, else of
/// tension, continuity and bias.
std::vector<std::string> header_of(const Track& track, const std::string& time) {
  std::vector<std::string> names{time, std::string(object_name), std::string(track_name)};
  for (const TrackChannel& channel : track.channels) names.push_back(channel.name);
  if (track.has_ease) {
    for (const Role role : {Role::ease_in, Role::ease_out}) names.emplace_back(role_name(role));
  }
  for (const TrackChannel& channel : track.channels) {
    using enum Role;
    const auto roles = channel.has_velocities ? std::vector{velocity_in, velocity_out}
                                              : std::vector{channel_tension, channel_continuity, channel_bias};
    for (const Role role : roles) names.push_back(role_name(ChannelRole{role, channel.name}));
  }
  return names;
}

Columns columns_of(const Track& track, const std::string& time, const InputOptions& options) {
  const std::vector<std::string> header = header_of(track, time);
  std::vector<bool> numeric(header.size(), true);
  numeric[1] = numeric[2] = false;
  std::vector<RoleRequest> requests = options.columns.roles;
  if (!options.columns.has(Role::group)) {
    requests.push_back({Role::group, {std::string(object_name), std::string(track_name)}});
  }
  return find_columns(header, numeric, requests, options.columns.timeless);
}

/// The extrapolation of a track at one side, which is that of all channels that change; an error where they differ.
Extrapolation extrapolation_of(const Track& track, std::string_view TrackChannel::*side) {
  const auto changes = [](const TrackChannel& channel) { return channel.keys.size() > 1; };
  const auto first = std::ranges::find_if(track.channels, changes);
  if (first == track.channels.end()) return Extrapolation::error;
  const std::string_view rule = (*first).*side;
  const auto has_rule = [&](const TrackChannel& channel) {
    if (!changes(channel)) return true;
    const bool has_same_range = channel.keys.front().time.decimal == first->keys.front().time.decimal &&
                                channel.keys.back().time.decimal == first->keys.back().time.decimal;
    return channel.*side == rule && (has_same_range || rule == "hold");
  };
  if (rule.empty() || !std::ranges::all_of(track.channels, has_rule)) return Extrapolation::error;
  return std::ranges::find(extrapolations, rule, &Named<Extrapolation>::name)->value;
}

/// The place of a channel among those of a track. Throws: Error (data) for another column.
std::size_t place_of(const Track& track, const std::string& channel) {
  const auto found = std::ranges::find(track.channels, channel, &TrackChannel::name);
  if (found == track.channels.end())
    throw data_error("{} is no position of a track; expected one of {}", in_quotes(channel), listed(names_of(track)))
        .about("--columns");
  return static_cast<std::size_t>(found - track.channels.begin());
}

/// The angles of a track by the channels of its columns; nothing where one is not read.
std::optional<EulerTrack> euler_in_columns(const Track& track, const Columns& columns) {
  if (!track.euler) return std::nullopt;
  EulerTrack euler{.notation = *track.euler};
  for (std::size_t i = 0; i < euler.channels.size(); ++i) {
    const auto found = std::ranges::find(columns.channels, track.channels[i].name);
    if (found == columns.channels.end()) return std::nullopt;
    euler.channels[i] = static_cast<std::size_t>(found - columns.channels.begin());
  }
  return euler;
}

class TrackKeys {
 public:
  TrackKeys(const Track& track, const std::string& time, const InputOptions& options)
      : track_(track),
        columns_(columns_of(track, time, options)),
        keys_(columns_, options.keys, units_of_keys(options.units, columns_, "")),
        next_(track.channels.size()) {
    for (const std::string& channel : columns_.channels) channels_.push_back(place_of(track, channel));
  }

  const Columns& columns() const { return columns_; }

  KeyBlock build() {
    while (const TrackKey* const first = first_key()) add(*first);
    return keys_.finish();
  }

 private:
  const TrackKey* key_of(std::size_t channel) const {
    const auto& keys = track_.channels[channel].keys;
    return next_[channel] < keys.size() ? &keys[next_[channel]] : nullptr;
  }

  /// The first of the next keys of all channels.
  const TrackKey* first_key() const {
    const TrackKey* first = nullptr;
    for (std::size_t i = 0; i < next_.size(); ++i) {
      const TrackKey* const key = key_of(i);
      if (key != nullptr && (first == nullptr || is_before(*key, *first))) first = key;
    }
    return first;
  }
  static bool is_before(const TrackKey& a, const TrackKey& b) {
    return a.time.value != b.time.value ? a.time.value < b.time.value : exact_number(a.time) < exact_number(b.time);
  }
  static bool is_same(const TrackKey& a, const TrackKey& b) {
    return a.time.decimal == b.time.decimal || (!is_before(a, b) && !is_before(b, a));
  }

  /// Adds the key of all channels that have one at the time of the first of them.
  void add(const TrackKey& first) {
    keys_.begin_key();
    std::uint64_t line = 0;
    for (const Columns::Column& column : columns_.cells) {
      if (column.role == Role::group) keys_.set_text(column, '"' + text_of(column));
      const bool is_of_one = column.role == Role::position || is_of_channel(column.role);
      const TrackKey* const key = is_of_one ? key_at(column, first) : &first;
      if (is_of_one && key != nullptr && line == 0) line = key->line;
      const WrittenNumber* const number = key == nullptr ? nullptr : number_of(*key, column.role);
      if (number != nullptr) add_number(column, *number, *key);
      if (is_of_one && number == nullptr) keys_.miss(column);  // is allowed, as options_of_scene() skips cells at least
    }
    for (std::size_t i = 0; i < next_.size(); ++i) {
      const TrackKey* const key = key_of(i);
      if (key == nullptr || !is_same(*key, first)) continue;
      ++next_[i];
      const TrackKey* const after = key_of(i);
      if (after != nullptr && !is_before(first, *after)) {
        throw times_of_track_repeat(*after).about(path_of(track_));
      }
    }
    if (keys_.end_key()) keys_.set_position(line, 0);
  }

  std::string text_of(const Columns::Column& column) const {
    const auto index = static_cast<std::size_t>(&column - columns_.cells.data());
    return index == 1 ? track_.object : track_.name;
  }

  void add_number(const Columns::Column& column, const WrittenNumber& number, const TrackKey& key) {
    if (!keys_.take(column, number.value, number.decimal)) {
      throw track_number_too_large(number.decimal).about(path_of(track_)).at({"", key.line, 0});
    }
  }

  const TrackKey* key_at(const Columns::Column& column, const TrackKey& first) const {
    const TrackKey* const key = key_of(channels_[column.channel]);
    return key != nullptr && is_same(*key, first) ? key : nullptr;
  }

  static const WrittenNumber* number_of(const TrackKey& key, Role role) {
    switch (role) {
      case Role::time: return &key.time;
      case Role::ease_in: return &key.ease_in;
      case Role::ease_out: return &key.ease_out;
      case Role::position: return &key.value;
      case Role::channel_tension: return &key.tension;
      case Role::channel_continuity: return &key.continuity;
      case Role::channel_bias: return &key.bias;
      case Role::velocity_in: return key.velocity_in ? &*key.velocity_in : nullptr;
      case Role::velocity_out: return key.velocity_out ? &*key.velocity_out : nullptr;
      default: return nullptr;
    }
  }

  const Track& track_;
  const Columns columns_;
  KeyBuilder keys_;
  std::vector<std::size_t> next_;      ///< the number of the next key of each channel
  std::vector<std::size_t> channels_;  ///< the channel of the track for each channel of the columns
};

/// All bytes of a file. Throws: Error (data) for an empty file, and for one that needs too much memory.
std::string whole_file(const Source<std::string>& bytes, MemoryUse& memory) {
  std::deque<std::string> parts;
  std::size_t size = 0;
  while (std::optional<std::string> part = bytes()) {
    part->shrink_to_fit();
    memory.add(part->size());
    size += part->size();
    parts.push_back(std::move(*part));
  }
  if (size == 0) throw data_error("the file is empty; expected an object with keys; copy the file again");
  std::string file;
  file.reserve(size);
  for (; !parts.empty(); parts.pop_front()) file += parts.front();
  return file;
}

}  // namespace

WrittenNumber written_number(const Rational& exact) {
  if (!within_doubles(exact)) throw track_number_too_large(ratio_text(exact));
  return {nearest_double(exact), ratio_text(exact)};
}

Error times_of_track_repeat(const TrackKey& key) {
  return data_error("the key at {} seconds is not after the one before it; expected increasing times",
                    time_text(nearest_time(exact_number(key.time))))
      .at({"", key.line, 0});
}

bool Track::is_constant() const {
  const auto has_one_key = [](const TrackChannel& channel) { return channel.keys.size() < 2; };
  return !failure && std::ranges::all_of(channels, has_one_key);
}

InputOptions options_of_scene(const SceneFormat& format, InputOptions options) {
  if (!format.has_frames && !options.units.time && !options.units.frame_rate) options.units.time = TimeUnit::s;
  if (options.keys.missing == Missing::error) options.keys.missing = Missing::skip_cell;
  return options;
}

Records open_scene(const SceneFormat& format, const Source<std::string>& bytes, const InputOptions& options) {
  MemoryUse memory(options.max_memory);
  const std::string file = whole_file(bytes, memory);
  std::vector<Track> tracks = format.read(file, memory);
  Records records;
  make_utf8(tracks, records.facts);
  choose(tracks, options.only, records.facts);
  std::deque<KeyBlock> blocks;
  for (Track& track : tracks) {
    const Extrapolations rules{extrapolation_of(track, &TrackChannel::before),
                               extrapolation_of(track, &TrackChannel::after)};
    if (rules.extend_curve()) track.settings.extrapolate = rules;
    TrackKeys keys(track, format.has_frames ? "frame" : "t", options);
    if (blocks.empty()) records.columns = keys.columns();
    blocks.push_back(keys.build());
    blocks.back().curve_info = std::make_shared<const CurveInfo>(CurveInfo{track.settings});
    if (const std::optional<EulerTrack> euler = euler_in_columns(track, keys.columns())) {
      records.facts.euler_tracks.emplace(std::vector{'"' + track.object, '"' + track.name}, *euler);
    }
    std::vector<TrackChannel>().swap(track.channels);
  }
  records.rotation = tracks.front().rotation;
  records.keys.curve_info.settings = tracks.front().settings;
  records.keys.traits.has_whole_curves = true;
  records.keys.blocks = each_of(std::move(blocks));
  return records;
}

}  // namespace tcb
