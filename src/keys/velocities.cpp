// Velocities: the check of keys whose velocities are given.
#include "keys/velocities.hpp"

#include <cmath>
#include <cstdint>
#include <utility>

#include "keys/errors.hpp"

namespace tcb {
namespace {

/// The last key in each channel, whose outgoing velocity is needed if another one follows.
class VelocityCheck {
 public:
  VelocityCheck(std::vector<std::string> channels, bool equal_speed)
      : channels_(std::move(channels)), equal_speed_(equal_speed), before_(channels_.size()) {}

  KeyBlock operator()(KeyBlock block) {
    const Keys& keys = block.keys;
    if (keys.velocities.empty()) return block;
    if (equal_speed_) throw equal_speed_with_velocities();
    for (std::size_t i = 0; i < keys.velocities.size(); ++i) {
      const std::size_t channel = i % keys.channels;
      const bool is_key = !std::isnan(keys.positions[i]);
      if (keys.given[channel] && is_key) add(channel, keys.velocities[i], block.line(i / keys.channels));
    }
    return block;
  }

 private:
  struct Before {
    std::uint64_t line = 0;  ///< 0: there is none
    bool has_outgoing = false;
  };

  void add(std::size_t channel, const spline::Velocity<double>& velocity, std::uint64_t line) {
    Before& before = before_[channel];
    const bool has_before = before.line != 0;
    if (has_before && !before.has_outgoing) {
      throw outgoing_velocity_missing(channels_[channel]).at({"", before.line, 0});
    }
    if (has_before && std::isnan(velocity.in)) {
      throw incoming_velocity_missing(channels_[channel]).at({"", line, 0});
    }
    before = {line, !std::isnan(velocity.out)};
  }

  std::vector<std::string> channels_;
  bool equal_speed_;
  std::vector<Before> before_;
};

}  // namespace

Source<KeyBlock> with_complete_velocities(Source<KeyBlock> blocks, std::vector<std::string> channels,
                                          bool equal_speed) {
  return mapped(std::move(blocks), VelocityCheck(std::move(channels), equal_speed));
}

}  // namespace tcb
