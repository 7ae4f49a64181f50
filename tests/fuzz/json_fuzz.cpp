// Fuzzer of the JSON reader: any text as JSON of any shape.
#include <cstdint>

#include "choices.hpp"
#include "reading.hpp"

/// The last bytes choose the options.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tcb;
  fuzz::Choices choices(data, size);
  InputOptions options;
  options.format = find_format(choices.one({"json", "jsonl"}));
  options.keys.missing = choices.one(missing_names).value;
  options.columns.timeless = choices.yes();
  const char* const columns = choices.one({"", "", "carry=label", "group=id", "position=x:y,time=t"});
  if (*columns != '\0') options.columns.roles = parse_roles(columns);
  const auto piece = 1 + choices.number(63);
  fuzz::require_same_readings(choices.rest(), options, piece, false);
  return 0;
}
