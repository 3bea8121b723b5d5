// SPDX-License-Identifier: Apache-2.0
// texgraphc's operator new and delete, which this program has as well.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <new>
#include <random>
#include <thread>
#include <utility>
#include <vector>

namespace {

struct Block {
  unsigned char* bytes;
  size_t size;
  unsigned char value;
};

Block Make(size_t size, unsigned char value) {
  auto* bytes = static_cast<unsigned char*>(::operator new(size));
  std::memset(bytes, value, size);
  return {bytes, size, value};
}

bool IsWhole(const Block& block) {
  return std::all_of(block.bytes, block.bytes + block.size,
                     [&](unsigned char byte) { return byte == block.value; });
}

// Sizes on both sides of every border between lists, and of that to the large ones.
TEST(MemoryTest, BlocksKeepWhatIsWrittenWhileOthersComeAndGo) {
  std::mt19937 random(1);
  std::vector<Block> blocks;
  for (int i = 0; i < 20000; ++i) {
    const size_t size = random() % 8 == 0 ? random() % 100000 : random() % 600;
    blocks.push_back(Make(size, static_cast<unsigned char>(i)));
    EXPECT_EQ(reinterpret_cast<uintptr_t>(blocks.back().bytes) % 16, 0u) << size;
    while (blocks.size() > 300) {
      std::swap(blocks[random() % blocks.size()], blocks.back());
      ASSERT_TRUE(IsWhole(blocks.back()));
      ::operator delete(blocks.back().bytes, blocks.back().size);
      blocks.pop_back();
    }
  }
  for (const Block& block : blocks) {
    ASSERT_TRUE(IsWhole(block));
    ::operator delete(block.bytes);
  }
}

TEST(MemoryTest, ADroppedBlockIsTheNextOfItsSize) {
  void* first = ::operator new(100);
  ::operator delete(first);
  void* second = ::operator new(97);
  EXPECT_EQ(first, second);
  ::operator delete(second);
}

TEST(MemoryTest, AnotherThreadMayDropABlock) {
  std::vector<Block> blocks;
  std::thread([&] {
    for (int i = 0; i < 5000; ++i) {
      blocks.push_back(Make(static_cast<size_t>(i % 700), static_cast<unsigned char>(i)));
    }
  }).join();
  for (const Block& block : blocks) {
    EXPECT_TRUE(IsWhole(block));
    ::operator delete(block.bytes);
  }
}

TEST(MemoryTest, WhatCannotBeHadIsAnException) {
  for (size_t size : {SIZE_MAX, SIZE_MAX - 16, SIZE_MAX / 2 + 1}) {
    EXPECT_THROW((void)::operator new(size), std::bad_alloc) << size;
  }
}

}  // namespace
