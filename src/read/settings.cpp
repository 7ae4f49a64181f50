// Settings of a file: members by their names and values.
#include "read/settings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <unordered_set>
#include <utility>

#include "numbers/parse_number.hpp"
#include "numbers/time_notation.hpp"
#include "schema/columns.hpp"
#include "schema/parameter_names.hpp"
#include "schema/roles.hpp"
#include "tcb/spline/rules.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

using Kind = FileMember::Kind;
using Value = FileMember::Value;

// Names of members without case and punctuation.

/// Of booleans that close a curve.
constexpr std::string_view closing_names =
    "closed isclosed isclosedcurve closedcurve closedloop closedpath loop isloop loopclosed looped looping cyclic "
    "iscyclic usecyclic usecyclicu periodic isperiodic close";

/// Words in the names of objects among the members of another one that hold settings of it.
constexpr std::string_view inner_words =
    "params param parameters default defaults setting settings option options spline curve interpolation interp config "
    "configuration cfg header metadata properties props attributes attrs tcb tbc kb kochanek bartels";
/// Those of tension, continuity and bias.
constexpr std::string_view words_of_tcb = "tcb tbc kb kochanek bartels";

/// Of what tells a spline.
constexpr std::string_view spline_names =
    "type curvetype splinetype interpolation interpolationtype interpolationmode interp spline curve mode kind method";
/// Those of them that tell nothing else.
constexpr std::string_view interpolation_names =
    "curvetype splinetype interpolation interpolationtype interpolationmode interp";

constexpr std::string_view rate_names =
    "fps framerate framespersecond framepersecond samplerate samplingrate samplefrequency samplingfrequency frequency "
    "samplespersecond";
/// Of the time from one key to the next. A unit may follow.
constexpr std::string_view step_names =
    "dt deltat timestep timedelta sampleinterval samplinginterval sampleperiod samplingperiod sampletime frametime "
    "frameduration";

/// Names of settings in the program's own layout.
constexpr std::array<std::string_view, 9> own_names{"preset",   "tangents", "ends",   "closed", "period",
                                                    "channels", "keys",     "curves", "id"};

/// Options that are not settings.
constexpr std::array options_only{"--equal-speed",    "--parameter",       "--metric", "--extrapolate", "--no-ease",
                                  "--rotation-curve", "--rotation-output", "--angles", "--normalize"};

std::string compact(std::string_view name) { return fmt::format("{}", fmt::join(words_of(name), "")); }

std::string shown(const FileMember& member) {
  std::vector<std::string> texts;
  for (const Value& value : member.values) texts.push_back(value.text);
  return fmt::format("{}", fmt::join(texts, ","));
}

/// Whether all values have a kind, and there is one at least.
bool are_all(const FileMember& member, Kind kind) {
  const auto has_kind = [&](const Value& value) { return value.kind == kind; };
  return !member.values.empty() && std::ranges::all_of(member.values, has_kind);
}

/// Whether all values are numbers, which may be in quotes.
bool are_numbers(const FileMember& member) {
  const auto is_number = [](const Value& value) {
    return value.kind == Kind::number || (value.kind == Kind::text && parse_number(value.text));
  };
  return !member.values.empty() && std::ranges::all_of(member.values, is_number);
}

bool is_one(const FileMember& member, Kind kind) { return !member.is_array && are_all(member, kind); }

/// The name of an object, without the path to it.
std::string_view last_name(const FileObject& object) {
  return std::string_view(object.path).substr(object.path.find_last_of('.') + 1);
}

bool has_word_of(std::string_view name, std::string_view list) {
  return std::ranges::any_of(words_of(name), [&](const std::string& word) { return lists_word(list, word); });
}

/// What is before the names of parameters in an object whose name says what they are.
std::string prefix_of_parameters(const FileObject& object) {
  return has_word_of(last_name(object), words_of_tcb) ? "tcb." : "";
}

/// Whether an array of this name has tension, continuity and bias, as "tcb" and "default_tbc" do.
bool names_tcb(std::string_view name) {
  const std::vector<std::string> words = words_of(name);
  return has_word_of(name, "tcb tbc") &&
         std::ranges::all_of(words, [](const std::string& word) { return lists_word(inner_words, word); });
}

/// A name without the unit at its end, and what one second is in this unit.
std::pair<std::string, Rational> word_and_unit(std::string_view name) {
  std::vector<std::string> words = words_of(name);
  const auto unit =
      words.size() < 2 ? time_units.end() : std::ranges::find(time_units, words.back(), &TimeUnitRow::name);
  const bool has_unit = unit != time_units.end() && unit->unit != TimeUnit::frames;
  if (has_unit || (words.size() > 1 && words.back() == "hz")) words.pop_back();
  return {fmt::format("{}", fmt::join(words, "")), has_unit ? units_per_second(unit->unit) : Rational(1)};
}

bool names_rate(std::string_view name) {
  const std::string word = word_and_unit(name).first;
  return lists_word(rate_names, word) || lists_word(step_names, word);
}

/// The frame rate, as --input-fps takes it, that a name and a number say; empty: none.
std::string rate_in(std::string_view name, std::string_view number) {
  const auto [word, unit] = word_and_unit(name);
  const std::optional<Rational> value = parse_rational(number);
  if (!value || *value <= 0) return "";
  std::string rate = lists_word(rate_names, word)   ? std::string(number)
                     : lists_word(step_names, word) ? ratio_text(unit / *value)
                                                    : "";
  if (rate.ends_with("/1")) rate.resize(rate.size() - 2);
  return frame_rate_in(rate) ? rate : "";
}

bool is_parameter(std::string_view word) { return lists_word("tension continuity bias tcb tbc", word); }

bool has_meaning(std::string_view name) {
  const std::string word = compact(name);
  return is_setting_name(name) || names_rate(name) || is_parameter(word) || names_tcb(name);
}

/// What replaces the preset, and the rules for tangents and ends, of the file.
std::string undo_of_rules() { return fmt::format("--preset {}", spline::presets[0].name); }

class SettingsReader {
 public:
  SettingsReader(std::span<const FileObject> objects, const InputOptions& options)
      : given_(options.given),
        has_tcb_(options.keys.tcb),
        has_rate_(options.units.frame_rate),
        scale_(options.keys.tcb_scale) {
    for (const FileObject& object : objects) {
      if (!object.is_apart) find_other_spline(object);
    }
    for (const FileObject& object : objects) {
      object_ = &object;
      object.is_apart ? note_members() : read();
    }
    add_notes();
  }

  FileSettings found;

 private:
  std::string path(std::string_view name) const {
    return object_->path.empty() ? std::string(name) : fmt::format("{}.{}", object_->path, name);
  }
  /// An error at the value of a member, or at its name.
  Error at(const FileMember& member, const Error& error) const {
    return error.about(path(member.name)).at(member.value_position);
  }
  Error at_name(const FileMember& member, const Error& error) const {
    return error.about(path(member.name)).at(member.position);
  }

  void find_other_spline(const FileObject& object) {
    for (const FileMember& member : object.members) {
      if (!is_one(member, Kind::text) || !lists_word(spline_names, compact(member.name))) continue;
      const std::string& value = member.values[0].text;
      if (!names_other_spline(value)) continue;
      other_spline_ = fmt::format("{} {}", in_quotes(member.name), in_quotes(value));
      const bool is_told = lists_word(interpolation_names, compact(member.name)) && !given_.tangents && !given_.preset;
      if (is_told) found.notes.push_back(other_interpolation(fmt::format("{} is", in_quotes(member.name)), value));
    }
  }

  void note_members() {
    for (const FileMember& member : object_->members) {
      const bool is_true = is_one(member, Kind::boolean) && shown(member) == "true";
      if (is_true || are_numbers(member)) found.unused.push_back(path(member.name));
    }
  }

  void read() {
    std::unordered_set<std::string_view> names;
    for (const FileMember& member : object_->members) {
      if (!names.insert(member.name).second && has_meaning(member.name))
        throw at_name(member, data_error("the object has this member twice; expected it once; remove one"));
    }
    const auto closes = [](const FileMember& member) {
      const bool is_setting = is_one(member, Kind::boolean) && lists_word(closing_names, compact(member.name));
      return is_setting ? shown(member) : "";
    };
    if (!given_.closed) require_same(closes, "--closed, or --closed=no");
    if (!has_rate_) require_same(rate_of, "--input-fps HZ");
    parameters_.clear();
    read_parameters();
    for (const FileMember& member : object_->members) {
      if (!parameters_.contains(&member) && !is_one(member, Kind::missing)) read_member(member);
    }
  }

  /// The frame rate of a member; empty: none.
  static std::string rate_of(const FileMember& member) {
    return is_one(member, Kind::number) ? rate_in(member.name, member.values[0].text) : "";
  }

  /// Throws: Error (data) where members of one meaning differ, such as "closed" and "loop", or "fps" and "dt".
  /// `value_of`: what a member says; empty: it has another meaning.
  template <class ValueOf>
  void require_same(ValueOf value_of, std::string_view option) const {
    const FileMember* first = nullptr;
    for (const FileMember& member : object_->members) {
      const std::string value = value_of(member);
      if (value.empty()) continue;
      if (first == nullptr) first = &member;
      if (value_of(*first) == value) continue;
      throw at_name(member, data_error("this is {}, and {} is {}, which have one meaning; expected one of them; remove "
                                       "one, or give {}",
                                       shown(member), first->name, shown(*first), option));
    }
  }

  // Tension, continuity and bias.

  void read_parameters() {
    std::vector<std::string> names;
    std::vector<bool> usable;
    struct Origin {
      const FileMember& member;
      const Value& value;
      std::string path;
    };
    std::vector<Origin> origins;
    const std::string outer = prefix_of_parameters(*object_);
    const auto add = [&](const std::string& name, const FileMember& member, const Value& value) {
      names.push_back(outer + name);
      usable.push_back(parse_number(value.text).has_value());
      origins.push_back({member, value, path(name)});
    };
    for (const FileMember& member : object_->members) {
      const std::string word = compact(member.name);
      const bool is_array = names_tcb(member.name) && !member.is_object && !is_one(member, Kind::missing);
      if (is_array) require_tcb(member);
      for (std::size_t i = 0; is_array && i < member.values.size(); ++i) {
        add(fmt::format("{}[{}]", member.name, i), member, member.values[i]);
      }
      if (!is_array && is_parameter(word)) require_number(member);
      if (!member.is_array && are_numbers(member)) add(member.name, member, member.values[0]);
    }
    std::array<const Origin*, 3> of_object{};
    for (const ParameterSet& set : parameter_sets(names, usable, {.timeless = true})) {
      const bool is_of_keys = set.rest == ParameterSet::Rest::nothing || set.rest == ParameterSet::Rest::of_keys;
      if (!set.is_clear() && !(is_of_keys && set.is_doubtful())) continue;
      std::vector<std::string> values{"0", "0", "0"};
      const FileMember* first = nullptr;
      for (std::size_t i = 0; i < values.size(); ++i) {
        if (!set.cells[i]) continue;
        const Origin& origin = origins[*set.cells[i]];
        if (first == nullptr) first = &origin.member;
        parameters_.insert(&origin.member);
        values[i] = origin.value.text;
      }
      if (has_tcb_) continue;
      require_parameters(set, *first, values);
      for (std::size_t i = 0; i < values.size(); ++i) {
        if (!set.cells[i]) continue;
        const Origin& origin = origins[*set.cells[i]];
        if (const Origin* const other = std::exchange(of_object[i], &origin)) {
          throw at(origin.member,
                   data_error("{} sets the same; expected one of them; remove one, or give --tcb T,C,B", other->path));
        }
        take_parameter(i, origin.path, values[i]);
      }
    }
  }

  void require_tcb(const FileMember& member) const {
    if (has_tcb_ || (member.is_array && member.values.size() == 3 && are_numbers(member))) return;
    throw at(member, data_error("this is not an array of three numbers; expected [T,C,B]; correct it, or give --tcb "
                                "0,0,0 to leave it out"));
  }

  void require_number(const FileMember& member) const {
    if (has_tcb_ || (!member.is_array && are_numbers(member)) || is_one(member, Kind::missing)) return;
    if (member.is_object && (!object_->is_own || may_hold_settings(member.name))) return;
    throw at(member, data_error("{} is not a number; expected one; correct it, or give --tcb 0,0,0 to leave it out",
                                member.values.empty() ? "this" : in_quotes(shown(member))));
  }

  void require_parameters(const ParameterSet& set, const FileMember& first,
                          const std::vector<std::string>& values) const {
    const std::string given = fmt::format("--tcb {}", fmt::join(values, ","));
    if (!other_spline_.empty()) {
      throw at(first,
               data_error("the member {} names another spline; expected parameters of one by Kochanek and Bartels; "
                          "give --tcb 0,0,0 to leave them out, or {} to take them",
                          other_spline_, given));
    }
    const std::string commands = fmt::format("give {} if it is one, or --tcb 0,0,0 if not", given);
    if (!set.is_clear()) {
      throw at(first, data_error("this may be tension, continuity or bias; expected the whole word; {}", commands));
    }
    const auto is_beyond = [](const std::string& value) { return std::abs(parse_number(value).value_or(2)) > 1; };
    if (scale_ == TcbScale::unknown && std::ranges::any_of(values, is_beyond)) {
      throw at(first, data_error("tension, continuity and bias are usually from -1 to 1; {}", commands));
    }
  }

  void take_parameter(std::size_t parameter, std::string path, const std::string& value) {
    if (!found.tcb) found.tcb.emplace();
    double number = *parse_number(value);
    if (scale_ == TcbScale::max3ds) number = nearest_double(from_0_to_50(exact_time(Time(number))));
    (parameter == 0 ? found.tcb->tension : parameter == 1 ? found.tcb->continuity : found.tcb->bias) = number;
    shown_parameters_[parameter] = fmt::format("{} to {}", path, value);
  }

  // Other settings.

  void read_member(const FileMember& member) {
    const std::string word = compact(member.name);
    CurveSettings& settings = found.curve_info.settings;
    if (lists_word(closing_names, word) && (word != "close" || is_one(member, Kind::boolean))) {
      read_closing(member);
    } else if (word == "preset") {
      read_setting(member, given_.preset,
                   [&](const std::string& value, const auto&) { settings.preset = preset_in(value); });
    } else if (word == "tangents" && !are_all(member, Kind::number)) {
      read_setting(member, given_.tangents,
                   [&](const std::string& value, const auto&) { settings.tangents = tangents_in(value); });
    } else if (word == "ends") {
      read_setting(member, given_.ends, [&](const std::string& value, const SettingOrigin& origin) {
        settings.ends = {ends_in(value), origin};
      });
    } else if (word == "period") {
      read_setting(member, given_.period, [&](const std::string& value, const SettingOrigin& origin) {
        settings.period = {period_in(value), origin};
      });
    } else if (word == "channels" && (object_->is_own || are_all(member, Kind::text))) {
      read_channels(member);
    } else if (word == "id" && object_->is_own) {
      read_id(member);
    } else {
      read_other(member, word);
    }
  }

  void read_closing(const FileMember& member) {
    if (given_.closed) return;
    const std::string value = shown(member);
    const bool is_true = value == "true" || value == "1", is_false = value == "false" || value == "0";
    if (member.is_array || is_one(member, Kind::text) || is_true == is_false) {
      const std::string_view kind = member.is_array ? "an array" : "an object";
      throw at(member, data_error("found {}; expected true or false; correct it, or give --closed, or --closed=no",
                                  member.values.empty() ? kind : in_quotes(value)));
    }
    found.curve_info.settings.closed = {is_true, add_place(member)};
    shown_closing_ = is_true ? fmt::format("{} to {}", path(member.name), value) : "";
  }

  /// Remembers where a setting is.
  SettingOrigin add_place(const FileMember& member) {
    const std::string name = path(member.name);
    found.curve_info.places.emplace_back(name, member.value_position);
    return {name, member.value_position};
  }

  /// Sets what a function makes of the text of a member, unless an option is given instead of it.
  template <class F>
  void read_setting(const FileMember& member, bool is_given, const F& set) {
    if (is_given) return;
    const std::string word = compact(member.name), value = shown(member);
    const std::string undo = word == "period" ? "--closed=no" : undo_of_rules();
    const bool may_be_array = word == "ends" && !member.values.empty();
    if (member.is_array ? !may_be_array : member.values.empty()) {
      throw at(member, data_error("this is {}; expected one text or number; correct it, or give {}",
                                  member.is_array ? "an array" : "an object", undo));
    }
    const SettingOrigin origin = add_place(member);
    try {
      set(value, origin);
    } catch (const Error& error) {
      throw Error(Exit::data, fmt::format("{}; or give {}", error.message(), undo))
          .about(origin.subject)
          .at(origin.position);
    }
    if (word == "period") {
      shown_closing_ = fmt::format("{} to {}", origin.subject, value);
    } else {
      std::erase_if(shown_rules_, [&](const auto& rule) { return rule.first == word; });
      shown_rules_.emplace_back(word, fmt::format("{} to {}", origin.subject, value));
    }
  }

  void read_channels(const FileMember& member) {
    if (!member.is_array || !are_all(member, Kind::text)) {
      throw at(member, data_error("this is not an array of names in quotes; expected one"));
    }
    add_place(member);
    found.channels.clear();
    std::unordered_set<std::string_view> names;
    for (const Value& value : member.values) {
      if (!names.insert(value.text).second) {
        throw at(member, data_error("two names are {}; expected different ones", in_quotes(value.text)));
      }
      if (role_of_name(value.text) != Role::position) {
        throw at(member, data_error("{} is the name of a role; expected names of channels; give it another name",
                                    in_quotes(value.text)));
      }
      found.channels.push_back(value.text);
    }
  }

  void read_id(const FileMember& member) {
    if (member.values.size() != 1 || member.is_array) {
      throw at(member, data_error("this is not a text or a number; expected one"));
    }
    const Value& id = member.values[0];
    found.curve_info.id = id.kind == Kind::text ? '"' + id.text : id.text;
  }

  /// Numbers of no setting are not used, except those about the rows of an earlier output.
  void read_other(const FileMember& member, std::string_view word) {
    if (const std::string rate = rate_of(member); !rate.empty()) {
      found.frame_rate = rate;
      found.rate_name = path(member.name);
      found.shown_rate = fmt::format("{} to {}", found.rate_name, member.values[0].text);
      return;
    }
    object_->is_own ? require_no_own_setting(member) : require_no_near_setting(member, word);
    const bool is_read = member.is_object && may_hold_settings(member.name);
    const bool has_number = object_->is_own ? member.holds_numbers : are_all(member, Kind::number);
    if (has_number && !is_read && member.name != "meta") found.unused.push_back(path(member.name));
  }

  /// Throws: Error (data) for a name that has a meaning only elsewhere, or nearly that of a setting, in the program's
  /// own layout.
  void require_no_own_setting(const FileMember& member) const {
    if (member.name == "keys" || member.name == "curves") return require_no_second_list(member);
    constexpr std::array of_keys{Role::tension, Role::continuity, Role::bias, Role::ease_in, Role::ease_out};
    const auto of_channel = channel_role_of(member.name);
    const auto role = find_role(member.name);
    if (has_tcb_ && is_parameter(compact(member.name))) return;
    if ((role && std::ranges::count(of_keys, *role) > 0) || (of_channel && of_channel->role < Role::velocity)) {
      throw at_name(member, data_error("this member is outside the keys; expected it in each key; move it there"));
    }
    std::string option = "--" + member.name;
    std::ranges::replace(option, '_', '-');
    const auto known = std::ranges::find(options_only, option);
    if (known != options_only.end()) {
      throw at_name(member,
                    data_error("this is an option, not a setting of a file; expected it on the command line; remove "
                               "it, and give {}",
                               *known));
    }
    const std::string nearest = nearest_name(member.name, own_names);
    if (!nearest.empty()) throw at_name(member, data_error("there is no such setting; did you mean {}?", nearest));
  }

  /// Throws: Error (data) for "keys" beside "curves". The list that is read is empty here.
  void require_no_second_list(const FileMember& member) const {
    if (member.is_array || !member.values.empty()) return;
    throw at_name(member, data_error("the object has two lists, keys and curves; expected one of them; remove one, or "
                                     "give --records {}",
                                     member.name == "keys" ? "keys" : "'curves[*].keys'"));
  }

  /// Throws: Error (data) for a name that is nearly that of a setting, with a value of it.
  void require_no_near_setting(const FileMember& member, std::string_view word) const {
    const auto is_one_near = [&](Kind kind, std::string_view known) {
      return is_one(member, kind) && is_near(word, known) && word != "close" && fmt::format("{}s", word) != known;
    };
    const bool is_closing = is_one_near(Kind::boolean, "closed") || is_one_near(Kind::boolean, "cyclic");
    if (is_closing && !given_.closed) {
      throw at_name(member, data_error("there is no such setting; did you mean closed? give --closed, or --closed=no"));
    }
    const bool is_rule = is_one_near(Kind::text, "preset") || is_one_near(Kind::text, "tangents");
    if (is_rule && !given_.preset) {
      throw at_name(member,
                    data_error("there is no such setting; did you mean preset or tangents? correct it, or give {}",
                               undo_of_rules()));
    }
  }

  void add_notes() {
    std::vector<std::string> parameters(shown_parameters_.begin(), shown_parameters_.end());
    std::erase(parameters, "");
    std::vector<std::string> rules;
    for (const auto& [word, text] : shown_rules_) rules.push_back(text);
    const auto add = [&](const std::vector<std::string>& settings, std::string_view effect, std::string_view undo) {
      if (settings.empty()) return;
      found.notes.push_back(fmt::format("the file sets {}{}; {} undoes it", listed(settings), effect, undo));
    };
    add(parameters, ", for keys that have none", "--tcb 0,0,0");
    add(rules, "", undo_of_rules());
    if (!shown_closing_.empty()) add(std::vector{shown_closing_}, ", which closes the curve", "--closed=no");
  }

  const GivenSettings given_;
  const bool has_tcb_, has_rate_;
  const TcbScale scale_;
  const FileObject* object_ = nullptr;                     ///< the current one
  std::string other_spline_;                               ///< a member that names one, and its text
  std::unordered_set<const FileMember*> parameters_ = {};  ///< of the current object
  // What is set, and to which value:
  std::array<std::string, 3> shown_parameters_;
  std::vector<std::pair<std::string, std::string>> shown_rules_;  ///< by their names
  std::string shown_closing_;
};

/// The names and values in a line: each value is a word behind ":" or "=", or behind the only delimiter of the line.
std::vector<std::pair<std::string_view, std::string_view>> pairs_in(std::string_view line) {
  std::vector<std::pair<std::string_view, std::string_view>> pairs;
  constexpr std::string_view marks = ":=", around = " \t\",;|#%!/*";
  const bool has_marks = line.find_first_of(marks) != std::string_view::npos;
  for (std::size_t begin = 0; begin < line.size();) {
    const std::size_t end = line.find_first_of(has_marks ? marks : std::string_view(",;\t"), begin);
    const std::size_t value = line.find_first_not_of(around, std::min(end, line.size() - 1) + 1);
    if (value == std::string_view::npos) break;
    const std::size_t last = std::min(line.find_first_of(" \t\r\",;|", value), line.size());
    std::string_view name = line.substr(begin, end - begin);
    name.remove_prefix(std::min(name.find_first_not_of(around), name.size()));
    name = name.substr(0, name.find_last_not_of(" \t") + 1);
    pairs.emplace_back(name, line.substr(value, last - value));
    begin = last;
  }
  return pairs;
}

}  // namespace

SettingsInText settings_in(std::string_view lines, const InputOptions& options, bool has_tcb) {
  SettingsInText found;
  std::vector<std::string> names, values;  // of numbers
  for (const std::string_view line : split(lines, '\n')) {
    for (const auto& [name, value] : pairs_in(line)) {
      const std::string word = compact(name);
      if (const std::string rate = rate_in(name, value); !rate.empty()) {
        found.frame_rate = rate;
        found.shown_rate = fmt::format("{} {}", name, value);
      }
      const bool closes = lists_word(closing_names, word) && lists_word("true yes on 1", in_lower_case(value));
      if (closes && !options.given.closed) {
        found.shown.push_back(fmt::format("{} {}", name, value));
        found.options.emplace_back("--closed");
      } else if (parse_number(value)) {
        names.emplace_back(name);
        values.emplace_back(value);
      }
    }
  }
  if (has_tcb || options.keys.tcb) return found;
  for (const ParameterSet& set : parameter_sets(names, std::vector<bool>(names.size(), true), {.timeless = true})) {
    if (!set.is_clear()) continue;
    std::array<std::string, 3> numbers{"0", "0", "0"};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (!set.cells[i]) continue;
      numbers[i] = values[*set.cells[i]];
      found.shown.push_back(fmt::format("{} {}", names[*set.cells[i]], numbers[i]));
    }
    found.options.push_back(fmt::format("--tcb {}", fmt::join(numbers, ",")));
    break;
  }
  return found;
}

bool may_hold_settings(std::string_view name) { return has_word_of(name, inner_words); }

bool may_shape_curve(std::string_view name) {
  const std::string word = compact(name);
  return is_parameter(word) || (lists_word(closing_names, word) && word != "close");
}

bool is_setting_name(std::string_view name) {
  const std::string word = compact(name);
  return lists_word(closing_names, word) || std::ranges::count(own_names, word) > 0;
}

void keep_settings(FileObject& object) {
  if (!prefix_of_parameters(object).empty()) return;
  std::vector<std::string> names;
  for (const FileMember& member : object.members) {
    if (is_one(member, Kind::number)) names.push_back(member.name);
  }
  // Other names than the words themselves depend on the names beside them.
  for (const ParameterSet& set : parameter_sets(names, std::vector<bool>(names.size(), true), {.timeless = true})) {
    if (!set.is_clear() && !set.is_doubtful()) continue;
    for (const auto& cell : set.cells) {
      if (cell && !is_parameter(compact(names[*cell]))) return;
    }
  }
  std::erase_if(object.members, [](const FileMember& member) {
    return !has_meaning(member.name) && !lists_word(spline_names, compact(member.name));
  });
}

FileSettings read_settings(std::span<const FileObject> objects, const InputOptions& options) {
  return std::move(SettingsReader(objects, options).found);
}

}  // namespace tcb
