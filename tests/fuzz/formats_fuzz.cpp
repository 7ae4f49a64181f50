// Fuzzer of the readers of products' files: any bytes as a camera path, a scene, keyframes or an array.
#include <fuzzer/FuzzedDataProvider.h>

#include <cstdint>

#include "reading.hpp"

/// The last bytes choose the options.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tcb;
  FuzzedDataProvider choices(data, size);
  InputOptions options;
  options.format = find_format(choices.PickValueInArray({"nerfstudio", "lws", "3ds", "npy", "ase", "fbx"}));
  const auto piece = choices.ConsumeIntegralInRange<std::size_t>(1, 64);
  options.keys.keeps_decimals = choices.ConsumeBool();
  fuzz::require_same_readings(choices.ConsumeRemainingBytesAsString(), options, piece, false);
  return 0;
}
