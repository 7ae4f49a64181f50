// Kept keys: those of a curve that has to be known to its end, in little memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>

#include "curve/segment_blocks.hpp"

namespace tcb {

/// Keys that were read to the end, to be gone through more than once.
class KeyStore {
 public:
  /// Requires: one key at least.
  explicit KeyStore(const Source<KeyBlock>& blocks);

  std::size_t size() const { return columns_->times.size(); }
  /// A single key; the last one is number size() - 1.
  Keys key(std::size_t number) const { return columns_->part(number, number + 1); }
  void drop_last();
  /// Whether a position is missing.
  bool are_sparse() const;
  std::uint64_t first_line() const { return first_line_; }
  std::uint64_t last_line() const { return last_line_; }

  /// All keys, in small blocks.
  Source<Keys> source() const;

 private:
  /// As in spline::Keys. Deques grow without a copy, and without room that is not used.
  struct Columns {
    std::size_t channels = 0;
    std::deque<double> times, rests;  ///< rests: what the times are besides; none where no time has any
    std::deque<double> positions;
    std::deque<spline::Tcb<double>> tcbs;
    spline::Tcb<double> common_tcb;
    std::deque<spline::Ease<double>> eases;

    void append(const Keys& keys);
    Keys part(std::size_t first, std::size_t last) const;
  };

  std::shared_ptr<Columns> columns_;
  std::uint64_t first_line_ = 0, last_line_ = 0;
};

}  // namespace tcb
