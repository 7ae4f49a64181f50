// Fuzzer of the delimited reader: any text as CSV, TSV, SSV or lines of poses, with any options.
#include <fuzzer/FuzzedDataProvider.h>

#include <cstdint>
#include <optional>

#include "reading.hpp"

/// The last bytes choose the options.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tcb;
  FuzzedDataProvider choices(data, size);
  InputOptions options;
  options.format = find_format(choices.PickValueInArray({"csv", "csv", "tsv", "ssv", "tum", "euroc", "kitti"}));
  const char delimiter = choices.PickValueInArray({'\0', '\0', ';', '|', 'x', ' ', '\xA7'});
  if (delimiter != '\0') options.delimited.delimiter = delimiter;
  options.delimited.header = choices.PickValueInArray<std::optional<bool>>({std::nullopt, std::nullopt, true, false});
  options.delimited.comment = choices.PickValueInArray({"#", "#", "", "//", ">"});
  options.delimited.marks.decimal = choices.PickValueInArray({'.', '.', ','});
  options.delimited.marks.thousands = choices.PickValueInArray({'\0', '\0', '\'', ' '});
  options.keys.missing = choices.PickValueInArray(missing_names).value;
  options.columns.timeless = choices.ConsumeBool();
  const char* const columns = choices.PickValueInArray({"", "", "", "time=1", "group=1,time=2", "carry=3", "carry=x"});
  if (*columns != '\0') options.columns.roles = parse_roles(columns);
  const auto piece = choices.ConsumeIntegralInRange<std::size_t>(1, 64);
  fuzz::require_same_readings(choices.ConsumeRemainingBytesAsString(), options, piece, true);
  return 0;
}
