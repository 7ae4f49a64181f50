// Fuzzer of the readers of products' files: any bytes as a camera path, a scene, keyframes or an array.
#include <cstdint>

#include "choices.hpp"
#include "reading.hpp"

/// The last bytes choose the options.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tcb;
  fuzz::Choices choices(data, size);
  InputOptions options;
  options.format = find_format(choices.one({"nerfstudio", "lws", "3ds", "npy"}));
  const auto piece = 1 + choices.number(63);
  options.keys.keeps_decimals = choices.yes();
  fuzz::require_same_readings(choices.rest(), options, piece, false);
  return 0;
}
