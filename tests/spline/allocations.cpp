// Allocations: counts those of the whole program.
#include "spline/allocations.hpp"

#include <cstdlib>
#include <new>

namespace tcb {

std::atomic<std::size_t> allocations{0};

namespace {

void* counted(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}

}  // namespace
}  // namespace tcb

void* operator new(std::size_t size) { return tcb::counted(size); }
void* operator new[](std::size_t size) { return tcb::counted(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
