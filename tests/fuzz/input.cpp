// What libFuzzer calls, the same for every target.
#include "tests/fuzz/reading.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  lasius::fuzz::check({reinterpret_cast<const char*>(data), size});
  return 0;
}
