// LightWave: the motions of scenes (.lws) and of motion files (.mot) as keys.
//
// A motion has the tracks position (x, y, z), rotation (x, y, z: heading, pitch, bank; in radians, before version 3 in
// degrees) and scale. A span is the segment that ends at a key:
//   TCB     tangents by the preset lightwave
//   Hermite, Bezier 1D   the tangents of the key, per segment
//   linear  the chord
//   stepped the value of the key before, up to the last time before the key
// Where all keys of a channel are TCB, the rules of the preset apply; otherwise the file decides all its velocities.
// Bezier 2D is not a cubic in time, and is refused.
// Source: the documentation of the scene format and the samples of the LightWave SDK; files of LightWave, for the
//   tangents at the ends and the numbers of Hermite spans.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "error.hpp"
#include "numbers/parse_number.hpp"
#include "read/scenes/tracks.hpp"
#include "tcb/spline/rules.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

Error no_such_span(std::size_t number) {
  return data_error(
      "the span of the key is of type {}; expected 0 to 4 (TCB, Hermite, Bezier 1D, linear, stepped), in version 2 no "
      "Hermite",
      number);
}

Error scene_key_count(std::size_t found, std::size_t expected) {
  return data_error("there are {} keys or values; expected {}, the count above them", found, expected);
}

Error scene_word_expected(std::string_view word, std::string_view found) {
  return data_error("{} is here; expected {}, as in a motion of LightWave", in_quotes(found), in_quotes(word));
}

Error number_of_file_expected(std::string_view found) {
  return data_error("{} is not a number of a key or a rate; expected a number", in_quotes(found));
}

Error count_of_file_expected(std::string_view found) {
  return data_error("{} is not a count; expected a whole number", in_quotes(found));
}

/// The lines of a file as words, one after the other.
class TextLines {
 public:
  explicit TextLines(std::string_view text) : text_(text) {}

  /// Reads the next line that is not blank; false at the end.
  bool next() {
    words_.clear();
    while (!text_.empty()) {
      const std::size_t end = std::min(text_.find('\n'), text_.size());
      line_ = text_.substr(0, end);
      text_.remove_prefix(std::min(end + 1, text_.size()));
      ++number_;
      const std::size_t first = line_.find_first_not_of(" \t\r");
      if (first == std::string_view::npos) continue;
      line_ = line_.substr(first, line_.find_last_not_of(" \t\r") + 1 - first);
      for (std::size_t at = 0; at < line_.size();) {
        const std::size_t stop = std::min(line_.find_first_of(" \t", at), line_.size());
        words_.push_back(line_.substr(at, stop - at));
        at = std::min(line_.find_first_not_of(" \t", stop), line_.size());
      }
      return true;
    }
    return false;
  }
  /// Throws: Error (data) at the end.
  void require_next() {
    if (!next()) {
      throw at(data_error("the file ends within an object; expected the rest; copy the file again"));
    }
  }

  const std::vector<std::string_view>& words() const { return words_; }
  std::string_view word(std::size_t i) const { return i < words_.size() ? words_[i] : ""; }
  /// The line from a word on.
  std::string_view from_word(std::size_t i) const {
    return i < words_.size() ? line_.substr(static_cast<std::size_t>(words_[i].data() - line_.data())) : "";
  }
  std::uint64_t number() const { return number_; }
  Error at(const Error& error) const { return error.at({"", number_, 0}); }

  /// A word as a number or a count. Throws: Error (data) for another one.
  WrittenNumber number_in(std::size_t i) const {
    const auto value = parse_number(word(i));
    if (!value) throw at(number_of_file_expected(word(i)));
    return {*value, std::string(word(i))};
  }
  std::size_t count_in(std::size_t i) const {
    const auto count = in_digits<std::size_t>(word(i));
    if (!count) throw at(count_of_file_expected(word(i)));
    return *count;
  }
  /// Throws: Error (data) where a word is beyond those of a key.
  void require_end(std::size_t i) const {
    if (i < words_.size()) {
      throw at(data_error("{} follows the numbers of the key; expected the end of the line", in_quotes(from_word(i))));
    }
  }

 private:
  std::string_view text_, line_;
  std::vector<std::string_view> words_;
  std::uint64_t number_ = 0;
};

/// The extrapolation of a behavior by its number, or nothing; reset (0) goes to the value 0.
constexpr std::array<std::string_view, 6> behaviors{"", "hold", "repeat", "oscillate", "offset", "linear"};

/// Heading, pitch, bank: around y, then the x that was turned, then the z.
constexpr std::array<std::uint8_t, 3> axes_of_angles{1, 0, 2};

enum class Span { tcb, hermite, bezier, linear, stepped, bezier2 };

struct EnvelopeKey : TrackKey {
  Span span = Span::tcb;
  WrittenNumber incoming, outgoing;  ///< tangents of Hermite and Bezier spans, each per its own segment

  bool has_tangents() const { return span == Span::hermite || span == Span::bezier; }
};

/// The memory that a key takes at most, as one of an envelope and then of a channel.
constexpr std::uint64_t memory_of_envelope_key = 2 * sizeof(EnvelopeKey) + memory_of_key;

/// The keys of a channel, and its extrapolations as in TrackChannel.
struct Envelope {
  std::vector<EnvelopeKey> keys = {};
  std::string_view before = {}, after = {};
};

/// The velocities of the keys of a channel whose spans are not all TCB.
class Velocities {
 public:
  explicit Velocities(const std::vector<EnvelopeKey>& keys) : keys_(keys) {}

  /// The velocity of the segment before key i, at its end.
  Rational incoming(std::size_t i) const {
    const EnvelopeKey& key = keys_[i];
    if (key.span == Span::linear) return chord(i - 1) / duration(i - 1);
    if (key.has_tangents()) return exact_number(key.incoming) / duration(i - 1);
    return by_preset(i, -exact_number(key.continuity));
  }
  /// That of the segment after key i, at its start.
  Rational outgoing(std::size_t i) const {
    const EnvelopeKey& key = keys_[i];
    if (keys_[i + 1].span == Span::linear) return chord(i) / duration(i);
    if (key.has_tangents()) return exact_number(key.outgoing) / duration(i);
    return key.span == Span::stepped ? Rational(0) : by_preset(i, exact_number(key.continuity));
  }

 private:
  Rational duration(std::size_t i) const { return exact_number(keys_[i + 1].time) - exact_number(keys_[i].time); }
  Rational chord(std::size_t i) const { return exact_number(keys_[i + 1].value) - exact_number(keys_[i].value); }

  /// By the preset lightwave, with the continuity C of an outgoing velocity, and -C of an incoming one. After a linear
  /// span, the tension, continuity and bias are 0.
  Rational by_preset(std::size_t i, const Rational& continuity) const {
    const EnvelopeKey& key = keys_[i];
    const bool is_linear = key.span == Span::linear, is_first = i == 0, is_last = i + 1 == keys_.size();
    const Rational loose = is_linear ? Rational(1) : 1 - exact_number(key.tension);
    const Rational c = is_linear ? Rational(0) : continuity, b = is_linear ? Rational(0) : exact_number(key.bias);
    Rational sum(0), time(0);
    if (!is_first) sum += (1 + c) * (1 + b) * chord(i - 1);
    if (!is_last) sum += (1 - c) * (1 - b) * chord(i);
    if (!is_first) time += duration(i - 1);
    if (!is_last) time += duration(i);
    if (is_first || is_last) time += Rational(1, 3600);
    return loose * sum / time;
  }

  const std::vector<EnvelopeKey>& keys_;
};

/// Adds a key for a step at the last double before a key, which gets the velocity of the step.
void add_step(TrackChannel& channel, TrackKey& second) {
  TrackKey& first = channel.keys.back();
  const Rational from = exact_number(first.time), to = exact_number(second.time);
  const Rational between(std::nextafter(nearest_double(to), -std::numeric_limits<double>::infinity()));
  if (between <= from || between >= to)
    throw data_error(
        "the step to the key is shorter than doubles can distinguish; expected keys that are farther apart; remove one "
        "of them")
        .at({"", second.line, 0});
  const Rational jump = exact_number(second.value) - exact_number(first.value);
  TrackKey middle = first;
  middle.time = {nearest_double(between), ratio_text(between)};
  first.velocity_out = middle.velocity_in = WrittenNumber();
  middle.velocity_out = second.velocity_in = written_number(jump / (to - between));
  channel.keys.push_back(std::move(middle));
}

/// Throws: Error (data) for times that do not increase, for a span that is no cubic in time, and as add_step().
TrackChannel channel_of(std::string_view name, const Envelope& envelope) {
  const std::vector<EnvelopeKey>& keys = envelope.keys;
  TrackChannel channel{std::string(name), {keys.begin(), keys.end()}, false, envelope.before, envelope.after};
  for (std::size_t i = 1; i < keys.size(); ++i) {
    if (exact_number(keys[i].time) <= exact_number(keys[i - 1].time)) throw times_of_track_repeat(keys[i]);
  }
  const auto is_tcb = [](const EnvelopeKey& key) { return key.span == Span::tcb; };
  if (keys.size() < 2 || std::ranges::all_of(keys, is_tcb)) return channel;
  for (const EnvelopeKey& key : keys) {
    if (key.span == Span::bezier2)
      throw data_error(
          "the span of the key is a Bezier 2D curve, which is not a cubic in time; expected TCB, Hermite, Bezier 1D, "
          "linear or stepped; change the key's curve in LightWave")
          .at({"", key.line, 0});
  }
  const Velocities velocities(keys);
  channel.has_velocities = true;
  channel.keys = {keys[0]};
  for (std::size_t i = 1; i < keys.size(); ++i) {
    TrackKey next = keys[i];
    if (keys[i].span == Span::stepped) {
      add_step(channel, next);
    } else {
      channel.keys.back().velocity_out = written_number(velocities.outgoing(i - 1));
      next.velocity_in = written_number(velocities.incoming(i));
    }
    channel.keys.push_back(std::move(next));
  }
  return channel;
}

/// Reads the motions of a scene.
class Motions {
 public:
  Motions(std::string_view text, MemoryUse& memory) : lines_(text), memory_(memory) {}

  std::vector<Track> read() {
    lines_.require_next();
    const bool is_motion = lines_.word(0) == "LWMO";
    if (!is_motion && lines_.word(0) != "LWSC")
      throw lines_.at(
          data_error("the text is not a scene of LightWave; expected LWSC or LWMO in its first line; give another "
                     "--input-format"));
    lines_.require_next();
    version_ = lines_.count_in(0);
    if (is_motion) name_object("motion");
    if (is_motion) read_motion();
    while (lines_.next()) read_keyword();
    return std::move(tracks_);
  }

 private:
  /// Objects of the same name are numbered, as in LightWave.
  void name_object(std::string_view name) {
    const std::size_t number = ++names_[std::string(name)];
    object_ = number == 1 ? std::string(name) : fmt::format("{} ({})", name, number);
  }

  /// The name of a file without its folders and its ending.
  static std::string_view stem(std::string_view path) {
    path.remove_prefix(std::min(path.find_last_of("/\\:") + 1, path.size()));
    return path.substr(0, path.rfind('.'));
  }

  bool has_number(std::size_t word) const {
    constexpr std::size_t digits = 8;
    const std::string_view text = lines_.word(word);
    return text.size() == digits && text.find_first_not_of("0123456789abcdefABCDEF") == std::string_view::npos;
  }

  void read_keyword() {
    const std::string_view keyword = lines_.word(0);
    if (keyword == "FramesPerSecond") {
      frame_rate_ = lines_.number_in(1);
      if (!(frame_rate_.value > 0)) throw lines_.at(number_of_file_expected(lines_.word(1)));
    } else if (keyword == "LoadObjectLayer") {
      name_object(stem(lines_.from_word(has_number(2) ? 3 : 2)));
    } else if (keyword == "LoadObject") {
      name_object(stem(lines_.from_word(1)));
    } else if (keyword == "AddNullObject") {
      name_object(lines_.from_word(has_number(1) ? 2 : 1));
    } else if (keyword == "LightName" || keyword == "CameraName" || keyword == "BoneName") {
      name_object(lines_.from_word(1));
    } else if (keyword == "AddLight" || keyword == "AddCamera" || keyword == "AddBone") {
      object_ = keyword.substr(3);  // until its name follows
    } else if (keyword == "ObjectMotion" || keyword == "LightMotion" || keyword == "CameraMotion" ||
               keyword == "BoneMotion") {
      if (object_.empty()) name_object(keyword.substr(0, keyword.size() - 6));
      read_motion();
    }
  }

  void read_motion() {
    constexpr std::array<std::string_view, 3> names{"position", "rotation", "scale"};
    constexpr std::array<std::string_view, 3> channels{"x", "y", "z"};
    const std::vector<Envelope> envelopes = version_ >= 3 ? read_channels() : read_old_channels();
    for (std::size_t first = 0; first + 3 <= envelopes.size() && first < 9; first += 3) {
      Track track{object_, std::string(names[first / 3])};
      for (std::size_t i = 0; i < 3; ++i) {
        const Envelope& envelope = envelopes[first + i];
        try {
          track.channels.push_back(channel_of(channels[i], envelope));
        } catch (const Error& error) {
          track.failure = error.about(fmt::format("{}/{}", object_, names[first / 3]));
        }
      }
      if (track.name == "rotation" && !track.failure) {
        track.euler = spline::RotationNotation{spline::RotationForm::euler, axes_of_angles, true, version_ < 3};
      }
      track.settings.preset = spline::Preset::lightwave;
      tracks_.push_back(std::move(track));
    }
  }

  std::vector<Envelope> read_channels() {
    lines_.require_next();
    if (lines_.word(0) != "NumChannels") throw lines_.at(scene_word_expected("NumChannels", lines_.word(0)));
    const std::size_t count = lines_.count_in(1);
    std::vector<Envelope> envelopes;
    for (std::size_t i = 0; i < count; ++i) {
      lines_.require_next();
      const std::string expected = fmt::format("Channel {}", i);
      if (lines_.from_word(0) != expected) throw lines_.at(scene_word_expected(expected, lines_.from_word(0)));
      envelopes.push_back(read_envelope());
    }
    return envelopes;
  }

  Envelope read_envelope() {
    lines_.require_next();
    if (lines_.word(0) != "{" || lines_.word(1) != "Envelope") {
      throw lines_.at(scene_word_expected("{ Envelope", lines_.from_word(0)));
    }
    lines_.require_next();
    const std::size_t count = lines_.count_in(0);
    Envelope envelope;
    std::vector<EnvelopeKey>& keys = envelope.keys;
    for (lines_.require_next(); lines_.word(0) != "}"; lines_.require_next()) {
      if (lines_.word(0) == "{") throw lines_.at(scene_word_expected("Key", lines_.from_word(0)));
      if (lines_.word(0) == "Key") keys.push_back(read_key(1));
      if (lines_.word(0) == "Behaviors") {
        envelope.before = behavior_in(1);
        envelope.after = behavior_in(2);
      }
    }
    if (keys.size() != count) throw lines_.at(scene_key_count(keys.size(), count));
    return envelope;
  }

  std::string_view behavior_in(std::size_t word) const {
    const std::size_t number = lines_.count_in(word);
    if (number >= behaviors.size())
      throw lines_.at(
          data_error("the behavior of the envelope is of type {}; expected 0 to 5 (reset, constant, repeat, oscillate, "
                     "offset repeat, linear)",
                     number));
    return behaviors[number];
  }

  /// A key: value, time, span, T, C, B, and since version 3 three numbers more.
  EnvelopeKey read_key(std::size_t first) {
    memory_.add(memory_of_envelope_key);
    EnvelopeKey key;
    key.value = lines_.number_in(first);
    key.time = lines_.number_in(first + 1);
    key.span = span_of(lines_.count_in(first + 2));
    key.tension = lines_.number_in(first + 3);
    key.continuity = lines_.number_in(first + 4);
    key.bias = lines_.number_in(first + 5);
    key.line = lines_.number();
    if (key.has_tangents()) key.incoming = lines_.number_in(first + 6);
    if (key.has_tangents()) key.outgoing = lines_.number_in(first + 7);
    lines_.require_end(first + (version_ == 2 ? 6 : 9));
    return key;
  }

  Span span_of(std::size_t number) const {
    constexpr std::size_t tcb_of_version_2 = 2;
    if (version_ == 2 && number == tcb_of_version_2) return Span::tcb;
    if (number > static_cast<std::size_t>(Span::bezier2)) throw lines_.at(no_such_span(number));
    const auto span = static_cast<Span>(number);
    if (version_ == 2 && (span == Span::hermite)) throw lines_.at(no_such_span(number));
    return span;
  }

  /// Version 2 has the keys of each channel, version 1 keys of all channels by frames.
  std::vector<Envelope> read_old_channels() {
    lines_.require_next();
    const std::size_t channels = lines_.count_in(0);
    constexpr std::size_t most_channels = 1000;
    if (channels > most_channels) throw lines_.at(count_of_file_expected(lines_.word(0)));
    std::vector<Envelope> envelopes(channels);
    if (version_ == 1) {
      lines_.require_next();
      const std::size_t keys = lines_.count_in(0);
      for (std::size_t i = 0; i < keys; ++i) read_whole_key(envelopes);
    } else {
      for (Envelope& envelope : envelopes) {
        lines_.require_next();
        const std::size_t keys = lines_.count_in(0);
        for (std::size_t i = 0; i < keys; ++i) {
          lines_.require_next();
          envelope.keys.push_back(read_key(0));
        }
      }
    }
    return envelopes;
  }

  /// A line of the values of all channels, and a line of the frame, whether the span is linear, and T, C, B.
  void read_whole_key(std::vector<Envelope>& envelopes) {
    std::vector<WrittenNumber> values;
    while (values.size() < envelopes.size()) {
      lines_.require_next();
      for (std::size_t i = 0; i < lines_.words().size(); ++i) values.push_back(lines_.number_in(i));
    }
    if (values.size() != envelopes.size()) throw lines_.at(scene_key_count(values.size(), envelopes.size()));
    lines_.require_next();
    EnvelopeKey key;
    const WrittenNumber frame = lines_.number_in(0);
    key.time = written_number(exact_number(frame) / exact_number(frame_rate_));
    key.span = lines_.count_in(1) != 0 ? Span::linear : Span::tcb;
    key.tension = lines_.number_in(2);
    key.continuity = lines_.number_in(3);
    key.bias = lines_.number_in(4);
    lines_.require_end(5);
    key.line = lines_.number();
    memory_.add(memory_of_envelope_key * envelopes.size());
    for (std::size_t i = 0; i < envelopes.size(); ++i) {
      key.value = values[i];
      envelopes[i].keys.push_back(key);
    }
  }

  TextLines lines_;
  MemoryUse& memory_;
  std::size_t version_ = 0;
  WrittenNumber frame_rate_{30, "30"};  ///< of scenes that do not give one
  std::string object_;                  ///< the current one
  std::map<std::string, std::size_t> names_;
  std::vector<Track> tracks_;
};

constexpr SceneFormat lightwave{[](std::string_view file, MemoryUse& memory) { return Motions(file, memory).read(); }};

}  // namespace

extern const InputFormat lightwave_input = input_of_scenes<lightwave>(
    [](std::string_view beginning) { return beginning.starts_with("LWSC") || beginning.starts_with("LWMO"); });

}  // namespace tcb
