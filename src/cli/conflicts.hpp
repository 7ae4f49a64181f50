// Conflicts: the one table of options that exclude each other, need another, or have no effect.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string_view>

#include "cli/options.hpp"

namespace tcb {

/// A set of options.
class OptionSet {
 public:
  constexpr OptionSet() = default;
  constexpr OptionSet(std::initializer_list<Option> options) {
    for (const Option option : options) words_[index_of(option) / 64] |= bit(option);
  }
  constexpr bool has(Option option) const { return (words_[index_of(option) / 64] & bit(option)) != 0; }
  constexpr bool empty() const { return *this == OptionSet{}; }
  constexpr bool operator==(const OptionSet&) const = default;
  constexpr OptionSet operator|(const OptionSet& other) const {
    OptionSet both = *this;
    for (std::size_t i = 0; i < words_.size(); ++i) both.words_[i] |= other.words_[i];
    return both;
  }

 private:
  static constexpr std::uint64_t bit(Option option) { return std::uint64_t{1} << index_of(option) % 64; }

  std::array<std::uint64_t, (option_count + 63) / 64> words_{};
};

/// The options that place the samples.
inline constexpr OptionSet sampling_options{Option::step,        Option::rate,     Option::count,    Option::segments,
                                            Option::per_segment, Option::at,       Option::arc_step, Option::arc_count,
                                            Option::arc_at,      Option::tolerance};

enum class Relation {
  exclude,  ///< at most one of `options`, or of `options` and `others`
  need,     ///< each of `options` needs one of `others`
  idle,     ///< each of `options` has no effect with any of `others`; without `others`, where `applies` holds
};

/// A conflict of options. To add one: a row of the table.
struct Conflict {
  OptionSet options;
  Relation relation;
  OptionSet others = {};
  std::string_view reason = {};                          ///< goes on after the last option in the message
  bool (*applies)(const TypedOptions& typed) = nullptr;  ///< a further condition on the values; none: always
};

std::span<const Conflict> conflict_table();

/// Throws: Error (usage) for the first conflict of the options given.
void require_no_conflict(const TypedOptions& typed);

}  // namespace tcb
