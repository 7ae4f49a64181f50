// Curves: the keys of an input split into groups, ordered by time, and split into curves.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "schema/input_keys.hpp"
#include "schema/key_block.hpp"
#include "schema/schema.hpp"
#include "stream/source.hpp"

namespace tcb {

/// The treatment of keys with equal times.
enum class Duplicates { error, first, last, break_curve };

struct DuplicatesName {
  std::string_view name;
  Duplicates value;
};
inline constexpr std::array duplicates_names{
    DuplicatesName{"error", Duplicates::error}, DuplicatesName{"first", Duplicates::first},
    DuplicatesName{"last", Duplicates::last}, DuplicatesName{"break", Duplicates::break_curve}};

/// How grouped() arranges keys.
struct Grouping {
  std::size_t groups = 0;        ///< number of texts, from a key's first, that identify its curve
  bool sort = false;             ///< by time; the sort is stable
  bool own_curves = false;       ///< a curve begins with each block that has curve_info
  std::vector<Mark> marks = {};  ///< columns that may distinguish curves, by which no sort mixes them
};

/// The keys of one curve after another, in order of first appearance, with a break before each. The first call reads
/// the source to its end: the last row of an input may belong to its first curve.
/// Memory: 100 to 200 bytes per curve, and 16 bytes per key besides its numbers.
Source<KeyBlock> grouped(Source<KeyBlock> blocks, const Grouping& grouping);

/// The same keys. Up to the block with the first time of more than 17 digits, times are doubles or whole numbers; from
/// there on each is its decimal.
Source<KeyBlock> with_time_digits(Source<KeyBlock> blocks);

/// The columns that may distinguish curves.
struct CurveLabels {
  std::vector<Mark> marks = {};            ///< of keys
  std::vector<std::string> channels = {};  ///< names of channels, if they have any; only those of whole numbers count

  /// The column for each of whose values the times of a block's keys increase, where they do not as they are; empty:
  /// there is none. `texts`: only those of texts.
  std::string distinguishing(const KeyBlock& block, bool texts) const;
};

/// The same keys without gaps, which become breaks. A break between two blocks is at the front of the later one.
Source<KeyBlock> without_gaps(Source<KeyBlock> blocks);

/// The keys whose times increase up to the next break. Decreasing times, and equal ones where they are an error, are
/// faults of the block, which name the column that distinguishes curves, if one does. Duplicates::last delays one key
/// until the next is read.
Source<KeyBlock> in_order(Source<KeyBlock> blocks, Duplicates duplicates, CurveLabels labels = {});

/// How the keys of an input make curves.
struct CurveOptions {
  Duplicates duplicates = Duplicates::error;
  bool sort = false;
  bool any_order = false;  ///< keys stay in the order of the input, whatever their times
};

/// The keys of one curve.
struct CurveKeys {
  std::vector<std::string> group;  ///< the texts that identify the curve, one for each of the input's groups
  std::shared_ptr<const CurveInfo> curve_info;
  Source<KeyBlock> keys;
};

/// The curves of an input, in order of first appearance.
class Curves {
 public:
  /// `live`: an error has only the faults in the bytes that were read, as more may take long to arrive.
  Curves(const Schema& schema, const InputKeys& keys, const CurveOptions& options, bool live);

  /// The next curve. It ends the previous one, whose remaining keys are skipped.
  /// Throws: Error (data) with all faults of the keys.
  std::optional<CurveKeys> next();

  /// Number of keys that were skipped so far.
  std::uint64_t skipped() const;

 private:
  class Splitter;
  std::shared_ptr<Splitter> splitter_;
};

}  // namespace tcb
