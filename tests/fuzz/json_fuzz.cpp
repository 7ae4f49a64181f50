// Fuzzer of the JSON reader: any text as JSON of any shape.
#include <fuzzer/FuzzedDataProvider.h>

#include <cstdint>

#include "reading.hpp"

/// The last bytes choose the options.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tcb;
  FuzzedDataProvider choices(data, size);
  InputOptions options;
  options.format = find_format(choices.PickValueInArray({"json", "jsonl"}));
  options.keys.missing = choices.PickValueInArray(missing_names).value;
  options.columns.timeless = choices.ConsumeBool();
  const char* const columns = choices.PickValueInArray({"", "", "carry=label", "group=id", "position=x:y,time=t"});
  if (*columns != '\0') options.columns.roles = parse_roles(columns);
  const auto piece = choices.ConsumeIntegralInRange<std::size_t>(1, 64);
  fuzz::require_same_readings(choices.ConsumeRemainingBytesAsString(), options, piece, false);
  return 0;
}
