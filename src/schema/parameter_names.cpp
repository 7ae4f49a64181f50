// Names of parameters: the sets of columns that may be tension, continuity and bias.
#include "schema/parameter_names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <deque>
#include <map>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "schema/usual_names.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

using Kind = ParameterSet::Kind;
using Rest = ParameterSet::Rest;

constexpr std::array<std::string_view, 3> parameter_words{"tension", "continuity", "bias"};
constexpr std::array parameter_roles{Role::tension, Role::continuity, Role::bias};
constexpr std::array channel_roles{Role::channel_tension, Role::channel_continuity, Role::channel_bias};

/// The words in German, French, Spanish, Italian and Portuguese.
constexpr std::array<std::string_view, 3> foreign_words{
    "spannung tensi\u00F3n tensione tensao tens\u00E3o",
    "kontinuit\u00E4t kontinuitaet stetigkeit continuit\u00E9 continuite continuidad continuit\u00E0 continuita "
    "continuidade",
    "neigung tendenz biais sesgo"};

constexpr std::array<std::string_view, 3> plurals{"tensions", "continuities", "biases"};

// What may be beside a parameter in its name.
constexpr std::string_view words_of_tcb = "tcb tbc kb kochanek bartels";
constexpr std::string_view words_of_parameters = "param params parameter parameters default defaults";
constexpr std::string_view words_of_keys =
    "k kf key keys keyframe keyframes knot knots cp spline curve interpolation interp tangent tangents";

/// What a word says of a parameter.
struct Meaning {
  std::size_t parameter;
  Kind kind;
  bool needs_others = false;  ///< it has other meanings unless the two other parameters are there
};

/// Whether the letters of a short name are some of those of a word, in their order, as in tns.
bool is_skeleton(std::string_view name, std::string_view word) {
  constexpr std::size_t most = 4;
  if (name.size() < 2 || name.size() > most || name[0] != word[0]) return false;
  std::size_t at = 0;
  return std::ranges::all_of(name, [&](char c) {
    at = word.find(c, at);
    return at++ != std::string_view::npos;
  });
}

std::optional<Meaning> meaning_of(std::string_view word) {
  constexpr std::size_t least = 3;
  for (std::size_t i = 0; i < parameter_words.size(); ++i) {
    const std::string_view known = parameter_words[i];
    if (word == known || word == plurals[i]) return Meaning{i, Kind::word};
    if (word.size() >= least && known.starts_with(word)) return Meaning{i, Kind::beginning};
    if (word == known.substr(0, 1)) return Meaning{i, Kind::letter};
    if (lists_word(foreign_words[i], word)) return Meaning{i, Kind::beginning, true};
    if (is_near(word, known)) return Meaning{i, Kind::unclear};
    if (is_skeleton(word, known)) return Meaning{i, Kind::unclear, true};
  }
  return std::nullopt;
}

/// The unit in a name, without its brackets.
std::string_view unit_in(std::string_view name) {
  const std::string_view unit = name.substr(without_unit(name).size());
  return without_brackets(unit.substr(std::min(unit.find_first_not_of(' '), unit.size())));
}

/// Whether the unit of a name repeats its parameter, as in "T (tension)" and "tension (T)".
bool repeats_parameter(std::string_view name) {
  const std::string unit = in_lower_case(unit_in(name));
  if (unit.empty()) return false;
  const auto of_unit = meaning_of(unit), of_name = meaning_of(in_lower_case(without_unit(name)));
  return of_unit && of_name && of_unit->parameter == of_name->parameter && of_unit->kind != Kind::unclear;
}

/// Whether a name has no unit, or one without letters as in "tension (0-1)"; others are those of other quantities.
bool has_no_unit(std::string_view name) {
  const std::string_view unit = unit_in(name);
  const auto is_letter = [](char c) {
    return (lower(c) >= 'a' && lower(c) <= 'z') || static_cast<unsigned char>(c) > 127;
  };
  return std::ranges::none_of(unit, is_letter) ||
         lists_word("none unitless dimensionless normalized", in_lower_case(unit));
}

/// The words of a name without the one that is the parameter: those before and those behind it.
std::string rest_of(std::span<const std::string> words, std::size_t parameter) {
  return fmt::format("{}|{}", fmt::join(words.first(parameter), " "), fmt::join(words.subspan(parameter + 1), " "));
}

Rest meaning_of_rest(std::string_view rest) {
  if (rest == "|") return Rest::nothing;
  const std::size_t middle = rest.find('|');
  const std::string_view before = rest.substr(0, middle);
  for (const std::string_view word : {before.substr(before.rfind(' ') + 1), rest.substr(middle + 1)}) {
    if (lists_word(words_of_tcb, word)) return Rest::of_tcb;
    if (lists_word(words_of_parameters, word)) return Rest::of_parameters;
    if (lists_word(words_of_keys, word)) return Rest::of_keys;
    if (in_digits<std::size_t>(word)) return Rest::number;
  }
  return Rest::other;
}

bool is_time_by_name(std::string_view name) {
  return role_of_name(name) == Role::time || is_usual_time(name) || time_part_of(name);
}

bool is_of_tcb_by_name(std::string_view name) { return name == "T" || name == "C" || name == "B"; }

/// Whether the last step of a path is one of the words.
bool is_word_in_path(std::string_view name) {
  const std::size_t point = name.rfind('.');
  return point != std::string_view::npos &&
         std::ranges::count(parameter_words, in_lower_case(name.substr(point + 1))) > 0;
}

/// Separates words that are written together, as in xtension, tcbt, and tx, where x is one of the names of one letter.
/// Returns whether they may mean something else.
bool separate(std::vector<std::string>& words, std::string_view single_letters) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string word = words[i];
    const auto is_name = [&](char c) { return single_letters.find(c) != std::string_view::npos; };
    const auto is_parameter = [](char c) { return c == 't' || c == 'c' || c == 'b'; };
    const bool has_letters = word.size() == 2 && is_parameter(word[0]) != is_parameter(word[1]);
    std::size_t at = has_letters && is_name(is_parameter(word[0]) ? word[1] : word[0]) ? 1 : 0;
    if (at == 0 && meaning_of(word)) continue;
    for (const std::string_view known : parameter_words) {
      if (word.ends_with(known)) at = word.size() - known.size();
      if (word.starts_with(known)) at = known.size();
    }
    constexpr std::string_view tcb = "tcb";
    const bool is_of_tcb = word.starts_with(tcb) && meaning_of(std::string_view(word).substr(tcb.size()));
    if (is_of_tcb) at = tcb.size();
    if (at == 0) continue;
    words[i].resize(at);
    words.insert(words.begin() + static_cast<std::ptrdiff_t>(i) + 1, word.substr(at));
    return !is_of_tcb;
  }
  return false;
}

/// The columns whose names have the same rest.
struct Readings {
  std::string rest;
  std::array<std::vector<std::pair<std::size_t, Meaning>>, 3> parameters = {};
  std::array<std::vector<std::size_t>, 4> places = {};  ///< by their number in an array
  std::string letters = {};                             ///< others in the place of the parameter

  /// Letters of one parameter say nothing, but beside "tcb".
  bool says_nothing() const {
    const auto has_letters_alone = [](const auto& columns) {
      return std::ranges::all_of(columns, [](const auto& one) { return one.second.kind == Kind::letter; });
    };
    const auto is_empty = [](const auto& columns) { return columns.empty(); };
    return std::ranges::all_of(places, is_empty) && std::ranges::count_if(parameters, is_empty) > 1 &&
           std::ranges::all_of(parameters, has_letters_alone) && meaning_of_rest(rest) != Rest::of_tcb;
  }

  /// Adds the columns that are parameters by a word, or by letters alone of which there are all.
  void add_likely(std::unordered_set<std::size_t>& cells) const {
    const bool are_letters = std::ranges::all_of(parameters, [](const auto& columns) {
      const auto is_letter = [](const auto& one) { return one.second.kind == Kind::letter; };
      return !columns.empty() && std::ranges::all_of(columns, is_letter);
    });
    for (const auto& columns : parameters) {
      for (const auto& [cell, meaning] : columns) {
        if (are_letters || meaning.kind == Kind::word || meaning.kind == Kind::beginning) cells.insert(cell);
      }
    }
  }

  /// Some of the words are among the names, but not all.
  bool lacks_words() const {
    const auto has_word = [](const auto& columns) {
      return std::ranges::any_of(columns, [](const auto& one) { return one.second.kind == Kind::word; });
    };
    const auto words = std::ranges::count_if(parameters, has_word);
    return rest == "|" && words > 0 && words < std::ssize(parameters);
  }

  /// The names are the words for tension, continuity and bias.
  bool has_words_alone() const {
    const auto are_words = [](const auto& columns) {
      return std::ranges::all_of(columns, [](const auto& one) { return one.second.kind == Kind::word; });
    };
    return rest == "|" && letters.empty() && std::ranges::all_of(parameters, are_words) &&
           std::ranges::all_of(places, [](const auto& columns) { return columns.empty(); });
  }
};

/// The columns that may be positions, by the words of their names.
class ChannelNames {
 public:
  void add(std::string_view name, std::size_t cell) {
    cells_.push_back(cell);
    const std::vector<std::string> words = words_of(without_unit(name));
    by_words_.emplace(joined(words_of(name)), cell);
    by_words_.emplace(joined(words), cell);
    if (words.empty()) return;
    const bool ends_in_axis = std::string_view("xyz").find(words.back().back()) != std::string_view::npos;
    if (words.size() > 1) {
      add_part(words.back(), cell);
      const std::string stem = joined(std::span(words).first(words.size() - 1));
      add_part(stem, cell);
      by_stems_[stem].push_back(cell);
    } else if (ends_in_axis && is_coordinate(name)) {  // as in px
      add_part(words[0].substr(words[0].size() - 1), cell);
    }
  }

  /// The column with these words, or the only one that begins or ends with them, as pos_x for x.
  std::optional<std::size_t> find(const std::string& words) const {
    if (words.empty()) return std::nullopt;
    for (const std::string_view end : {"", " value", " v"}) {  // as x.value beside x.tension
      const auto found = by_words_.find(words + std::string(end));
      if (found != by_words_.end()) return found->second;
    }
    const auto found = by_parts_.find(words);
    return found != by_parts_.end() ? found->second : std::nullopt;
  }

  /// The columns that have one more word than these.
  std::vector<std::size_t> with_stem(const std::string& words) const {
    const auto found = by_stems_.find(words);
    return found != by_stems_.end() ? found->second : std::vector<std::size_t>();
  }

  const std::map<std::string, std::size_t>& by_words() const { return by_words_; }
  const std::vector<std::size_t>& all() const { return cells_; }

 private:
  static std::string joined(std::span<const std::string> words) { return fmt::format("{}", fmt::join(words, " ")); }

  void add_part(const std::string& words, std::size_t cell) {
    const auto [place, is_new] = by_parts_.emplace(words, cell);
    if (!is_new) place->second.reset();
  }

  std::vector<std::size_t> cells_;
  std::map<std::string, std::size_t> by_words_;
  std::map<std::string, std::optional<std::size_t>> by_parts_;  ///< nothing where several columns have the part
  std::map<std::string, std::vector<std::size_t>> by_stems_;
};

class SetFinder {
 public:
  SetFinder(std::span<const std::string> names, const std::vector<bool>& usable, const ColumnOptions& requested)
      : names_(names), has_time_(requested.timeless || requested.has(Role::time)) {
    for (const std::string& name : names) {
      const bool is_letter = name.size() == 1 && single_letters_.find(lower(name[0])) == std::string::npos;
      if (is_letter) single_letters_ += lower(name[0]);
      if (name.ends_with(')') || name.ends_with(']')) have_brackets_ = true;
    }
    if (have_brackets_) all_names_.insert(names.begin(), names.end());
    for (std::size_t cell = 0; cell < names.size(); ++cell) {
      constexpr std::size_t longest = 64;
      if (usable[cell] && !names[cell].empty() && names[cell].size() <= longest) read(cell);
    }
    const bool may_complete = std::ranges::any_of(readings_, [](const Readings& one) { return one.lacks_words(); });
    if (!may_complete) std::erase_if(readings_, [](const Readings& readings) { return readings.says_nothing(); });
    const bool are_words = std::ranges::all_of(readings_, [](const Readings& one) { return one.has_words_alone(); });
    are_times_.resize(names.size());
    if (are_words) return;                       // whose meaning no other column changes
    std::unordered_set<std::size_t> parameters;  // which are no channels
    for (const Readings& readings : readings_) readings.add_likely(parameters);
    for (std::size_t cell = 0; cell < names.size(); ++cell) {
      are_times_[cell] = is_time_by_name(names[cell]);
      if (parameters.contains(cell)) continue;
      const bool may_be_channel = usable[cell] && role_of_name(names[cell]) == Role::position && !are_times_[cell];
      if (may_be_channel) channels_.add(names[cell], cell);
    }
    times_ = std::ranges::count(are_times_, true);
  }

  std::vector<ParameterSet> find() const {
    const auto words = std::ranges::find(readings_, "|", &Readings::rest);
    ParameterSet of_words;
    if (words != readings_.end()) of_words = set_of(*words);
    leave_letters(of_words);
    std::vector<ParameterSet> sets;
    for (const Readings& readings : readings_) {
      ParameterSet set = set_of(readings);
      set.completes = completes(set, of_words);
      if (!set.completes) leave_letters(set);
      if (set.count() > 0) sets.push_back(std::move(set));
    }
    find_stems(sets);
    return sets;
  }

 private:
  Readings& with_rest(std::string rest) {
    const auto [place, is_new] = places_.emplace(rest, readings_.size());
    if (is_new) readings_.push_back({std::move(rest)});
    return readings_[place->second];
  }

  void read(std::size_t cell) {
    std::vector<std::string> words = words_of(names_[cell]);
    const std::size_t size = words.size();
    if (size > 1 && (words[size - 2] == "tcb" || words[size - 2] == "tbc")) {
      const std::size_t axis = std::string_view("xyz").find(words.back());  // of a vector in a cell
      const auto number = axis < 3 ? std::optional(axis) : in_digits<std::size_t>(words.back());
      if (number && *number < Readings().places.size()) {
        return with_rest(rest_of(words, size - 1)).places[*number].push_back(cell);
      }
    }
    const bool has_words_in_brackets = have_brackets_ && has_words_in_its_brackets(names_[cell]);
    if (!has_words_in_brackets && !has_no_unit(names_[cell])) return;
    words = words_of(has_words_in_brackets ? names_[cell] : without_unit(names_[cell]));
    leave_repeated_letter(words);
    const bool may_mean_other = separate(words, single_letters_);
    for (std::size_t i = 0; i < words.size(); ++i) {
      if (words[i] == "r" || words[i] == "g" || words[i] == "a") with_rest(rest_of(words, i)).letters += words[i];
      auto meaning = meaning_of(words[i]);
      if (!meaning) continue;
      meaning->needs_others = meaning->needs_others || may_mean_other;
      with_rest(rest_of(words, i)).parameters[meaning->parameter].emplace_back(cell, *meaning);
    }
  }

  /// Whether what a name has in brackets is no unit, but the parameter, as in "x (tension)", or another column, as in
  /// "tension [x]".
  bool has_words_in_its_brackets(std::string_view name) const {
    const std::string_view text = unit_in(name);
    if (text.empty()) return false;
    const auto meaning = meaning_of(in_lower_case(text));
    const bool is_parameter = meaning && (meaning->kind == Kind::word || meaning->kind == Kind::beginning);
    return is_parameter || repeats_parameter(name) || (all_names_.contains(text) && !is_unit(text));
  }

  /// Leaves the letter out that repeats the parameter, as in "Tension T", unless it is the name of a channel.
  void leave_repeated_letter(std::vector<std::string>& words) const {
    for (std::size_t i = 0; words.size() > 1 && i < parameter_words.size(); ++i) {
      const std::string_view word = parameter_words[i], letter = word.substr(0, 1);
      const bool is_channel = letter != "t" && single_letters_.find(letter) != std::string::npos;
      if (!is_channel && std::ranges::count(words, word) > 0) std::erase(words, letter);
    }
  }

  /// Whether a set has exactly the parameters that the words themselves do not name. A letter with a number is a
  /// channel, and so is c beside tension and bias alone, the parameters of many products.
  static bool completes(const ParameterSet& set, const ParameterSet& of_words) {
    const bool are_words = of_words.count() > 0 && of_words.count(Kind::word) == of_words.count();
    if (!are_words || set.rest == Rest::nothing || !set.channel.empty()) return false;
    for (std::size_t i = 0; i < set.cells.size(); ++i) {
      if (set.cells[i].has_value() == of_words.cells[i].has_value()) return false;
    }
    const bool is_continuity = set.cells[1].has_value();
    const bool may_be_channel = set.rest == Rest::number || (set.rest == Rest::other && is_continuity);
    return set.count(Kind::letter) == 0 || !may_be_channel;
  }

  /// With all letters.
  ParameterSet set_of(const Readings& readings) const {
    ParameterSet set;
    set.rest = meaning_of_rest(readings.rest);
    if (!take_places(set, readings)) take_words(set, readings);
    set.is_member =
        std::ranges::any_of(set.cells, [&](const auto& cell) { return cell && is_word_in_path(names_[*cell]); });
    set.time = time_of(set, readings.rest);
    if (!set.is_complete()) set.time.reset();
    const std::string words = words_beside(readings.rest);
    const auto channel = channels_.find(words);
    if (channel && std::ranges::count(set.cells, *channel) == 0) set.channel = names_[*channel];
    if (set.channel.empty()) set.stem = channels_.with_stem(words);
    const auto has_letter = [&](char c) { return readings.letters.find(c) != std::string::npos; };
    set.may_be_others = has_letter('a') || (has_letter('r') && has_letter('g'));
    return set;
  }

  /// Takes the numbers of an array, which count from 0 or from 1; false where there are not all.
  static bool take_places(ParameterSet& set, const Readings& readings) {
    constexpr std::array<std::size_t, 3> tcb{0, 1, 2}, tbc{0, 2, 1};
    const auto& order = readings.rest.ends_with("tbc|") ? tbc : tcb;
    for (const std::size_t first : {0U, 1U}) {
      const auto places = std::span(readings.places).subspan(first, order.size());
      if (!std::ranges::all_of(places, [](const auto& cells) { return cells.size() == 1; })) continue;
      for (std::size_t i = 0; i < order.size(); ++i) set.cells[order[i]] = places[i][0];
      set.kinds.fill(Kind::place);
      return true;
    }
    return false;
  }

  /// Takes the clearest column of each parameter, or none where two are equally clear. Of t and T, and of two that are
  /// called t, the first is left for the time.
  void take_words(ParameterSet& set, const Readings& readings) const {
    const auto& all = readings.parameters;
    const bool have_all = std::ranges::none_of(all, [](const auto& columns) { return columns.empty(); });
    for (std::size_t i = 0; i < all.size(); ++i) {
      bool is_double = false;
      for (const auto& [cell, meaning] : all[i]) {
        if ((meaning.needs_others && !have_all) || is_time_of_all(cell)) continue;
        const bool is_same = set.cells[i] && meaning.kind == set.kinds[i];
        const bool is_letter_of_time = is_same && i == 0 && meaning.kind == Kind::letter;
        if (set.cells[i] && !is_same && meaning.kind > set.kinds[i]) continue;
        is_double = is_same && !is_letter_of_time;
        if (is_letter_of_time && is_capital(*set.cells[i]) && !is_capital(cell)) continue;
        set.cells[i] = cell;
        set.kinds[i] = meaning.kind;
      }
      if (is_double) set.cells[i].reset();
    }
  }
  bool is_capital(std::size_t cell) const { return names_[cell].find('T') != std::string::npos; }

  bool is_time_of_all(std::size_t cell) const { return !has_time_ && times_ == 1 && are_times_[cell]; }

  /// Letters count only where all three are there, or beside another time a t and one more.
  void leave_letters(ParameterSet& set) const {
    const auto is_letter = [&](std::size_t i) { return set.cells[i] && set.kinds[i] == Kind::letter; };
    const bool is_second_time = is_letter(0) && are_times_[*set.cells[0]] && set.count() > 1;
    if (set.is_complete() || set.rest == Rest::of_tcb || is_second_time) return;
    for (std::size_t i = 0; i < set.cells.size(); ++i) {
      if (is_letter(i)) set.cells[i].reset();
    }
  }

  /// The words of a rest without those of tcb.
  static std::string words_beside(std::string_view rest) {
    std::vector<std::string> words;
    for (const std::string_view part : {rest.substr(0, rest.find('|')), rest.substr(rest.find('|') + 1)}) {
      for (const std::string_view word : split(part, ' ')) {
        if (!word.empty() && !lists_word(words_of_tcb, word)) words.emplace_back(word);
      }
    }
    return fmt::format("{}", fmt::join(words, " "));
  }

  /// Leaves in each stem the channels that are no parameters. Parameters of all channels have no stem.
  void find_stems(std::vector<ParameterSet>& sets) const {
    std::unordered_set<std::size_t> taken;
    for (const ParameterSet& set : sets) {
      for (const auto& cell : set.cells) {
        if (cell && (set.is_complete() || set.count(Kind::letter) == 0)) taken.insert(*cell);
      }
    }
    const auto is_taken = [&](std::size_t cell) { return taken.contains(cell); };
    const auto channels = std::ssize(channels_.all()) - std::ranges::count_if(channels_.all(), is_taken);
    for (ParameterSet& set : sets) {
      std::erase_if(set.stem, is_taken);
      if (set.stem.empty() || std::ssize(set.stem) < channels) continue;
      set.stem.clear();
      if (set.rest == Rest::other) set.rest = Rest::of_keys;
    }
  }

  /// The column of times that has the same words in front of its own, where no other column is the time.
  std::optional<std::size_t> time_of(const ParameterSet& set, std::string_view rest) const {
    if (has_time_ || times_ > 0 || rest.size() < 2 || !rest.ends_with('|')) return std::nullopt;
    const std::string front = std::string(rest.substr(0, rest.size() - 1)) + ' ';
    for (const auto& [words, cell] : channels_.by_words()) {
      const bool is_other = std::ranges::count(set.cells, cell) == 0;
      if (is_other && words.starts_with(front) && is_time_by_name(words.substr(front.size()))) return cell;
    }
    return std::nullopt;
  }

  const std::span<const std::string> names_;
  const bool has_time_;                                  ///< it is requested, or none is
  std::vector<bool> are_times_ = {};                     ///< the columns that are times by their names
  std::ptrdiff_t times_ = 0;                             ///< their number
  std::string single_letters_ = {};                      ///< names of one letter
  bool have_brackets_ = false;                           ///< some of the names
  std::unordered_set<std::string_view> all_names_ = {};  ///< if they have
  ChannelNames channels_ = {};
  std::unordered_map<std::string, std::size_t> places_ = {};  ///< of readings, by their rests
  std::deque<Readings> readings_ = {};
};

}  // namespace

bool names_other_spline(std::string_view text) {
  constexpr std::array known{"catmull",  "cardinal",    "bezier",  "bspline", "nurbs", "linear",   "step",
                             "polyline", "centripetal", "chordal", "akima",   "pchip", "constant", "hold"};
  const std::string word = fmt::format("{}", fmt::join(words_of(text), ""));
  return std::ranges::any_of(known, [&](std::string_view name) { return word.find(name) != std::string::npos; });
}

std::string other_interpolation(std::string_view place, std::string_view text) {
  const bool is_linear = in_lower_case(text).find("linear") != std::string::npos;
  return fmt::format("{} {}, but the curve has tension, continuity and bias all the same{}", place, in_quotes(text),
                     is_linear ? "; --tangents linear draws straight lines" : "");
}

std::size_t ParameterSet::count() const {
  return static_cast<std::size_t>(std::ranges::count_if(cells, [](const auto& cell) { return cell.has_value(); }));
}

std::size_t ParameterSet::count(Kind kind) const {
  std::size_t found = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) found += cells[i] && kinds[i] == kind ? 1 : 0;
  return found;
}

bool ParameterSet::is_clear() const {
  if (count(Kind::unclear) > 0) return false;
  const std::size_t letters = count(Kind::letter);
  if (completes) return letters == 0 || rest != Rest::other;
  if (rest == Rest::of_tcb || (rest == Rest::of_parameters && letters == 0)) return true;
  if (!stem.empty()) return false;
  const bool is_known = rest != Rest::other || !channel.empty();
  if (!is_complete()) return count(Kind::word) == count() && (rest == Rest::nothing || !channel.empty());
  return letters == 0 || (letters == count() && is_known && !may_be_others);
}

bool ParameterSet::is_doubtful() const {
  if (is_clear()) return false;
  if (completes) return true;
  const std::size_t letters = count(Kind::letter);
  if (!stem.empty() && is_complete()) return true;
  if (letters > 0) return count(Kind::unclear) == 0 && (letters < count() || rest != Rest::other || !channel.empty());
  if (rest == Rest::nothing) return true;
  return rest == Rest::of_keys || !channel.empty() || count() > 1 || is_member;
}

bool ParameterSet::has_whole_names(std::span<const std::string> names) const {
  const auto is_letter = [&](const auto& cell) { return cell && is_of_tcb_by_name(names[*cell]); };
  if (std::ranges::all_of(cells, is_letter)) return true;
  if (count(Kind::word) < count()) return false;
  if (rest == Rest::nothing) {
    const auto is_word = [&](const auto& cell) {
      return !cell || std::ranges::count(parameter_words, in_lower_case(without_unit(names[*cell]))) > 0;
    };
    return std::ranges::all_of(cells, is_word);
  }
  if (rest == Rest::of_tcb || rest == Rest::of_parameters) return true;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (cells[i] && !channel.empty() && !same_in_any_case(names[*cells[i]], role_name(role(i)))) return false;
  }
  return !channel.empty();
}

ChannelRole ParameterSet::role(std::size_t parameter) const {
  return {channel.empty() ? parameter_roles[parameter] : channel_roles[parameter], channel};
}

std::string ParameterSet::request(std::span<const std::string> names) const {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::string name = channel.empty() ? std::string(role_name(parameter_roles[i])) : role_name(role(i));
    if (cells[i]) parts.push_back(requested_as(name, names, {&*cells[i], 1}));
  }
  if (!stem.empty()) parts.push_back(requested_as("position", names, stem));
  if (time) parts.insert(parts.begin(), requested_as("time", names, {&*time, 1}));
  return fmt::format("{}", fmt::join(parts, ","));
}

std::vector<ParameterSet> parameter_sets(std::span<const std::string> names, const std::vector<bool>& usable,
                                         const ColumnOptions& requested) {
  return SetFinder(names, usable, requested).find();
}

std::vector<RoleRequest> parameters_by_name(std::span<const std::string> names, const std::vector<bool>& usable,
                                            const ColumnOptions& requested) {
  std::vector<ParameterSet> sets = parameter_sets(names, usable, requested);
  // Letters in doubt are refused later, and are no times.
  const bool has_positions = requested.has(Role::position);
  std::erase_if(sets, [&](const ParameterSet& set) {
    return !set.is_clear() && (has_positions || !set.is_doubtful() || set.count(Kind::letter) == 0);
  });
  const auto is_of_all = [](const ParameterSet& set) { return set.channel.empty(); };
  const auto is_other = [&](const ParameterSet& set) { return is_of_all(set) && !set.completes; };
  const bool is_ambiguous = std::ranges::count_if(sets, is_other) > 1;
  if (sets.empty()) return {};
  const ColumnRequests columns(names);
  std::vector<RoleRequest> requests;
  const auto add = [&](const ChannelRole& role, std::size_t cell) {
    const bool has_role =
        role.channel.empty() ? role_of_name(names[cell]) == role.role : channel_role_of(names[cell]) == role;
    if (has_role) return;
    requests.push_back({role.role, {columns[cell]}, "", role.channel, true});
  };
  for (const ParameterSet& set : sets) {
    if (is_of_all(set) ? is_ambiguous : has_positions && !requested.has(set.channel)) continue;
    if (set.time) add({Role::time, ""}, *set.time);
    for (std::size_t i = 0; i < set.cells.size(); ++i) {
      const ChannelRole role = set.role(i);
      const auto is_same = [&](const RoleRequest& request) {
        return request.role == role.role && request.channel == role.channel;
      };
      if (set.cells[i] && std::ranges::none_of(requested.roles, is_same)) add(role, *set.cells[i]);
    }
  }
  return requests;
}

}  // namespace tcb
