// Fuzzer of the delimited reader: any text as CSV, TSV, SSV or lines of poses, with any options.
#include <cstdint>
#include <optional>

#include "choices.hpp"
#include "reading.hpp"

/// The last bytes choose the options.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tcb;
  fuzz::Choices choices(data, size);
  InputOptions options;
  options.format = find_format(choices.one({"csv", "csv", "tsv", "ssv", "tum", "euroc", "kitti"}));
  const char delimiter = choices.one({'\0', '\0', ';', '|', 'x', ' ', '\xA7'});
  if (delimiter != '\0') options.delimited.delimiter = delimiter;
  options.delimited.header = choices.one<std::optional<bool>>({std::nullopt, std::nullopt, true, false});
  options.delimited.comment = choices.one({"#", "#", "", "//", ">"});
  options.delimited.marks.decimal = choices.one({'.', '.', ','});
  options.delimited.marks.thousands = choices.one({'\0', '\0', '\'', ' '});
  options.keys.missing = choices.one(missing_names).value;
  options.columns.timeless = choices.yes();
  const char* const columns = choices.one({"", "", "", "time=1", "group=1,time=2", "carry=3", "carry=x"});
  if (*columns != '\0') options.columns.roles = parse_roles(columns);
  const auto piece = 1 + choices.number(63);
  // A table below other lines is looked for in what was read until then, so the errors may differ.
  fuzz::require_same_readings(choices.rest(), options, piece, false);
  return 0;
}
