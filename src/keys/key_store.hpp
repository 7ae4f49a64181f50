// Key store: the keys of a curve that has to be read to its end, in 8 bytes per number.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

#include "schema/key_block.hpp"
#include "stream/source.hpp"

namespace tcb {

/// Number of keys that are linked at once, so that their segments fit the cache.
inline constexpr std::size_t keys_at_once = 512;

/// All keys of a curve, which can be read more than once.
class KeyStore {
 public:
  /// Reads the source to its end. Requires: at least one key.
  explicit KeyStore(const Source<KeyBlock>& blocks);
  /// These keys, which have no lines.
  explicit KeyStore(const Keys& keys) : columns_(std::make_shared<Columns>()) { columns_->append(keys); }

  std::size_t size() const { return columns_->size(); }
  /// A single key; the last one is number size() - 1.
  Keys key(std::size_t number) const { return columns_->part(number, number + 1); }
  void drop_last();
  /// Gives the first key the incoming velocities and the turns of a key that repeats it.
  void join_seam(const Keys& repeated);
  /// The largest number of decimals of the times that have more digits than doubles; 0: there are none.
  int decimals() const;
  bool are_sparse() const;
  std::uint64_t first_line() const { return first_line_; }
  std::uint64_t last_line() const { return last_line_; }

  Keys all() const { return columns_->part(0, size()); }
  /// All keys, keys_at_once of them a block.
  Source<Keys> source() const;

 private:
  /// Times in deques, with their low parts only if there are any.
  struct Times {
    std::deque<double> high, low;  ///< low is empty if all low parts are 0

    std::size_t size() const { return high.size(); }
    Time operator[](std::size_t key) const { return low.empty() ? Time(high[key]) : Time(high[key], low[key]); }
    void push_back(const Time& time);
    void resize(std::size_t size);
  };

  /// As in spline::Keys. Deques grow without a copy and without unused capacity.
  struct Columns {
    std::size_t channels = 0;
    Times times;
    std::deque<double> positions;
    std::deque<spline::Tcb<double>> tcbs;
    spline::Tcb<double> common_tcb;
    std::deque<spline::Ease<double>> eases;
    std::deque<spline::Velocity<double>> velocities;
    std::vector<bool> given;
    std::deque<spline::TurnVector<double>> turns;
    std::deque<bool> missing;

    std::size_t size() const { return times.size(); }
    void append(const Keys& keys);
    Keys part(std::size_t first, std::size_t last) const;
  };

  std::shared_ptr<Columns> columns_;
  std::uint64_t first_line_ = 0, last_line_ = 0;
};

}  // namespace tcb
