// Allocations: how many the program of unit tests has made.
#pragma once

#include <atomic>
#include <cstddef>

namespace tcb {

extern std::atomic<std::size_t> allocations;

}  // namespace tcb
