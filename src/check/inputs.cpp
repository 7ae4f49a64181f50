// Inputs of a comparison: curves with their keys in memory, samples, and their columns that are compared.
#include "check/inputs.hpp"

#include <optional>
#include <utility>

#include "error.hpp"
#include "io/input_file.hpp"
#include "keys/curves.hpp"
#include "read/reader.hpp"

namespace tcb {

Source<KeyBlock> KeptCurve::keys() const {
  return [this, next = std::size_t{0}]() mutable {
    return next < blocks.size() ? std::optional(blocks[next++]) : std::nullopt;
  };
}

std::size_t KeptCurve::key_count() const {
  std::size_t count = 0;
  for (const KeyBlock& block : blocks) count += block.size();
  return count;
}

KeptCurves keep_curves(const Comparison& comparison, Source<std::string> bytes) {
  InputOptions options = comparison.keys.input;
  options.threads = comparison.threads.count();
  const Input input = open_input(comparison.keys_file, std::move(bytes), options);
  KeptCurves kept{input.schema, input.keys.traits, {}};
  Curves curves(input.schema, input.keys, comparison.keys.curves, false);
  while (const std::optional<CurveKeys> curve = curves.next()) {
    KeptCurve& one = kept.curves.emplace_back(KeptCurve{curve->group, curve->curve_info, {}});
    while (std::optional<KeyBlock> block = curve->keys()) one.blocks.push_back(std::move(*block));
  }
  return kept;
}

ComparisonInputs read_inputs(const Comparison& comparison, const std::vector<std::size_t>& chosen,
                             FileProgress* progress) {
  ComparisonInputs inputs;
  inputs.progress = progress;
  inputs.keys = shown_name(comparison.keys_file);
  inputs.file = shown_name(comparison.file);
  inputs.threads = comparison.threads.count();
  const auto bytes_of = [progress](const std::string& path) {
    return progress == nullptr ? read_file(path) : progress->observe_bytes(read_file(path));
  };
  inputs.kept = in_file(inputs.keys, [&] { return keep_curves(comparison, bytes_of(comparison.keys_file)); });
  in_file(inputs.file, [&] {
    const auto before_time = columns_before_time(chosen, inputs.kept.schema);
    inputs.table = read_samples(comparison, bytes_of(comparison.file), inputs.kept.schema, before_time);
    inputs.columns = match_columns(inputs.table, inputs.kept.schema, chosen);
  });
  return inputs;
}

}  // namespace tcb
