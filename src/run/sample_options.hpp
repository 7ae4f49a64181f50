// Sample options: the samples that are requested of each curve, where groups may have their own places.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "error.hpp"
#include "numbers/rational.hpp"
#include "sample/request.hpp"

namespace tcb {

struct InputCurve;
struct Schema;

/// Times or arc lengths for each group, by the contents of its texts.
using GroupedPlaces = std::map<std::vector<std::string>, std::vector<Rational>>;

/// The places of a curve's group, which `option` lists. Throws: Error (data) for a group without places.
const std::vector<Rational>& places_of_group(const GroupedPlaces& places, std::string_view option,
                                             const InputCurve& curve, const Schema& schema);

/// The samples that are requested of each curve.
struct SampleOptions {
  SamplingRequest request;
  GroupedPlaces grouped_places;             ///< instead of request.places, if groups have their own
  std::optional<Error> unless_frames = {};  ///< the samples are the frames of the input; the error where it has none

  bool takes_frames() const { return unless_frames.has_value(); }

  /// The request for one curve. Throws: Error (data) for a group without places.
  SamplingRequest of(const InputCurve& curve, const Schema& schema) const;
};

}  // namespace tcb
