// SPDX-License-Identifier: Apache-2.0
// operator new and delete of texgraphc: a compiler makes and drops many small objects and ends
// soon. Small blocks are cut from large ones and go to a list of their size when they are dropped,
// ready for the next of that size; they are never given back to the system. That takes a few
// instructions, where malloc and free, which keep neighbours together, take a fifth of all the
// time. A thread has lists of its own; a block may be dropped by another thread than made it.
#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

// Before each block stands how many of these it takes, with that; 0 before what malloc gave.
constexpr size_t kUnit = 16;
constexpr size_t kHeader = 8;
constexpr size_t kMostUnits = 32;
constexpr size_t kLargestSmall = kMostUnits * kUnit - kHeader;
constexpr size_t kChunk = 64 * 1024;
static_assert(sizeof(size_t) <= kHeader && alignof(std::max_align_t) <= kUnit);

struct Dropped {
  Dropped* next;
};

thread_local Dropped* dropped[kMostUnits + 1];  // by units
thread_local std::byte* chunk = nullptr;        // what is left of it: blocks begin at the header
thread_local size_t chunk_left = 0;

size_t& UnitsOf(void* block) {
  return *reinterpret_cast<size_t*>(static_cast<std::byte*>(block) - kHeader);
}

void* FromSystem(size_t size) {
  while (true) {
    if (void* memory = std::malloc(size)) return memory;
    const std::new_handler handler = std::get_new_handler();
    if (handler == nullptr) throw std::bad_alloc();
    handler();
  }
}

void* Large(size_t size) {
  if (size > PTRDIFF_MAX) throw std::bad_alloc();
  void* block = static_cast<std::byte*>(FromSystem(kUnit + size)) + kUnit;
  UnitsOf(block) = 0;
  return block;
}

void* FromChunk(size_t units) {
  if (chunk_left < units * kUnit) {
    chunk = static_cast<std::byte*>(FromSystem(kChunk)) + kUnit - kHeader;
    chunk_left = kChunk - kUnit;
  }
  void* block = chunk + kHeader;
  chunk += units * kUnit;
  chunk_left -= units * kUnit;
  UnitsOf(block) = units;
  return block;
}

}  // namespace

void* operator new(size_t size) {
  if (size > kLargestSmall) return Large(size);
  const size_t units = (size + kHeader + kUnit - 1) / kUnit;
  Dropped* const block = dropped[units];
  if (block == nullptr) return FromChunk(units);
  dropped[units] = block->next;
  return block;
}

void operator delete(void* block) noexcept {
  if (block == nullptr) return;
  const size_t units = UnitsOf(block);
  if (units == 0) return std::free(static_cast<std::byte*>(block) - kUnit);
  dropped[units] = new (block) Dropped{dropped[units]};
}

void operator delete(void* block, size_t) noexcept { operator delete(block); }
