// Key store: the keys of a curve that has to be read to its end.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>

#include "schema/key_block.hpp"
#include "stream/source.hpp"
#include "tcb/spline/keys.hpp"

namespace tcb {

/// Number of keys that are linked at once, so that their segments fit the cache.
inline constexpr std::size_t keys_at_once = 512;

/// All keys of a curve, which can be read more than once. Copies share them.
class KeyStore {
 public:
  /// Reads the source to its end. Requires: at least one key.
  explicit KeyStore(const Source<KeyBlock>& blocks);
  /// These keys, which have no lines.
  explicit KeyStore(const Keys& keys) { append(keys); }

  std::size_t size() const {
    return blocks_->empty() ? 0 : (blocks_->size() - 1) * keys_at_once + blocks_->back().size();
  }
  /// A single key; the last one is number size() - 1.
  Keys key(std::size_t number) const;
  void drop_last();
  /// Gives the first key the incoming velocities and the turns of a key that repeats it.
  void join_seam(const Keys& repeated);
  /// The largest number of decimals of the times that have more digits than doubles; 0: there are none.
  int decimals() const;
  bool are_sparse() const;
  std::uint64_t first_line() const { return first_line_; }
  std::uint64_t last_line() const { return last_line_; }

  Keys all() const;
  /// All keys, keys_at_once of them a block.
  Source<Keys> source() const;

 private:
  void append(const Keys& keys);

  std::shared_ptr<std::deque<Keys>> blocks_ = std::make_shared<std::deque<Keys>>();  ///< all full but the last one
  std::uint64_t first_line_ = 0, last_line_ = 0;
};

}  // namespace tcb
