// Names of parameters: the columns that are tension, continuity and bias by names that shorten or decorate these words.
//
// A name consists of words: "tcb_t" and "tcbT" of "tcb" and "t". One of them is the parameter: the word, its beginning
// of three letters or more, its letter, or its place in an array "tcb" or "tbc". The others are its rest. Columns with
// the same rest belong together, and a rest that is the name of a channel makes parameters of that.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "schema/columns.hpp"
#include "schema/roles.hpp"

namespace tcb {

/// Columns that may be tension, continuity and bias, in this order, by names with the same rest.
struct ParameterSet {
  /// How a name says it. Unclear ones only resemble a word.
  enum class Kind : std::uint8_t { word, place, beginning, letter, unclear };
  /// What the rest of the names says of the numbers.
  enum class Rest : std::uint8_t { nothing, other, number, of_keys, of_parameters, of_tcb };

  std::array<std::optional<std::size_t>, 3> cells = {};
  std::array<Kind, 3> kinds = {};
  Rest rest = Rest::nothing;             ///< nothing: the names have no rest
  std::string channel = {};              ///< the name of the column that the rest names; empty: none
  std::vector<std::size_t> stem = {};    ///< the channels, but not all, whose names begin with the rest
  bool may_be_others = false;            ///< beside the letters are r and g, or a
  std::optional<std::size_t> time = {};  ///< the column of times with this rest, where no other column is the time
  bool is_member = false;                ///< a whole word behind the path to it, as in properties.tension
  bool completes = false;                ///< the names of the other parameters are the words themselves

  std::size_t count() const;
  std::size_t count(Kind kind) const;
  bool is_complete() const { return count() == cells.size(); }
  /// Whether the columns are parameters unless something else is requested.
  bool is_clear() const;
  /// Whether they may be parameters, but their names are too short or too few to tell.
  bool is_doubtful() const;
  /// Whether the names are the words themselves, T, C and B, or as documented for one channel or for "tcb" and the
  /// like.
  bool has_whole_names(std::span<const std::string> names) const;
  ChannelRole role(std::size_t parameter) const;  ///< without a channel where it is that of all
  /// The roles as a value of --columns.
  std::string request(std::span<const std::string> names) const;
};

/// Whether a text names a spline that is not that of Kochanek and Bartels.
bool names_other_spline(std::string_view text);

/// The note on such a text, which has no effect. `place`: as in "column x is".
std::string other_interpolation(std::string_view place, std::string_view text);

/// The sets among columns, in the order of their first columns. `usable`: whether a column holds numbers, and no option
/// names it.
std::vector<ParameterSet> parameter_sets(std::span<const std::string> names, const std::vector<bool>& usable,
                                         const ColumnOptions& requested);

/// The roles of columns that are parameters by their names, as requests that give way to others.
std::vector<RoleRequest> parameters_by_name(std::span<const std::string> names, const std::vector<bool>& usable,
                                            const ColumnOptions& requested);

}  // namespace tcb
