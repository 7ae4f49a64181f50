// Parts of jobs: the bytes of keys, and the samples of each curve, where groups may have their own places.
#include "run/job.hpp"
#include "run/key_options.hpp"

#include <fmt/ranges.h>

#include <utility>

#include "io/input_file.hpp"
#include "keys/curves.hpp"
#include "schema/key_block.hpp"
#include "schema/schema.hpp"
#include "stream/ordered_map.hpp"

namespace tcb {

InputBytes KeyOptions::bytes_of(const std::string& path) const {
  if (path != "-" || !standard_input) return open_file(path);
  return {[left = standard_input]() mutable -> std::optional<std::string> {
            const std::shared_ptr<const std::string> all = std::exchange(left, nullptr);
            return all ? std::optional(*all) : std::nullopt;
          },
          nullptr};
}

const std::vector<Rational>& places_of_group(const GroupedPlaces& places, std::string_view option,
                                             const InputCurve& curve, const Schema& schema) {
  const auto found = places.find(contents(curve.group));
  if (found == places.end())
    throw data_error("the file has no rows for the curve {}; expected rows for each curve; add some",
                     fmt::join(group_title(schema.groups, curve.group), ", "))
        .about(option);
  return found->second;
}

unsigned ThreadOptions::count() const { return requested.value_or(available_threads()); }

SamplingRequest SampleOptions::of(const InputCurve& curve, const Schema& schema) const {
  SamplingRequest own = request;
  if (takes_frames()) {
    const std::optional<ViewerFrames>& frames = curve.curve_info->frames;
    if (!frames) throw Error(*unless_frames);
    own.mode = Mode::step;
    own.step = frames->step;
    own.from = 0;
    own.to = frames->step * Rational(frames->count - 1);
    return own;
  }
  if (grouped_places.empty()) return own;
  own.places = places_of_group(grouped_places, request.mode == Mode::at ? "--at" : "--arc-at", curve, schema);
  return own;
}

}  // namespace tcb
