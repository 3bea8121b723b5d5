// SPDX-License-Identifier: Apache-2.0
// Runs functions for one batch of at most 64 lanes. Each value is an array of words in the frame of
// its call; values that are parts of others (extract) or given from outside (parameters, globals,
// constants) are pointers to them.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

#include "compiler/ir/module.h"
#include "compiler/ir/texture.h"

namespace texgraph::ir {

class EvaluateObserver;

// Memory that is given back all at once, newest first.
class WordArena {
 public:
  struct Mark {
    size_t chunk;
    size_t used;
  };
  uint32_t* Allocate(size_t words);
  Mark Now() const { return {chunk_, used_}; }
  void Release(Mark mark) {
    chunk_ = mark.chunk;
    used_ = mark.used;
  }

 private:
  struct Chunk {
    std::unique_ptr<uint32_t[]> words;
    size_t size;
  };
  std::vector<Chunk> chunks_;
  size_t chunk_ = 0;
  size_t used_ = 0;
};

class Interpreter {
 public:
  static constexpr uint32_t kMaxLanes = 64;

  // `lanes`: a multiple of 4. `textures`: by GlobalId.
  Interpreter(const Module& module, uint32_t lanes, std::span<const Texture* const> textures);

  // The words of a global in the batch to come; they are not copied.
  void SetGlobal(GlobalId id, const uint32_t* words) { globals_[id.index] = words; }

  // Null: none. The lanes of the batch to come start at `first_lane`.
  void SetObserver(EvaluateObserver* observer, uint32_t first_lane) {
    observer_ = observer;
    first_lane_ = first_lane;
  }

  // Runs a function for the lanes of `active` and copies its results, one after the other, to
  // `results`.
  void Run(FunctionId function, std::span<const uint32_t* const> arguments, uint64_t active,
           uint32_t* results);

 private:
  struct FieldValue;
  // The value of one instruction in one call: words, or a field.
  struct Slot {
    const uint32_t* words = nullptr;
    const FieldValue* field = nullptr;
  };
  struct FieldValue {
    FunctionId function;
    std::vector<Slot> captured;
  };
  struct Frame {
    const Function& f;
    std::vector<Slot> slots;
    std::vector<uint32_t*> storage;  // by ValueId: made when it is first computed, used again by
                                     // the next round of a loop
    std::unordered_map<ValueId, FieldValue> fields;
  };

  void Call(FunctionId function, std::span<const Slot> arguments, uint64_t active,
            uint32_t* results);
  void RunRegion(Frame& frame, RegionId region, uint64_t active);
  void RunInst(Frame& frame, ValueId v, uint64_t active);
  void RunIf(Frame& frame, ValueId v, uint64_t active);
  void RunFor(Frame& frame, ValueId v, uint64_t active);
  void RunCall(Frame& frame, ValueId v, uint64_t active);
  void RunSample(Frame& frame, ValueId v, uint64_t active);
  void RunPlain(Frame& frame, ValueId v, uint64_t active);
  void Observe(Frame& frame, ValueId v, uint64_t active, uint32_t* words);
  void MakeField(Frame& frame, ValueId v);

  const Slot& Get(Frame& frame, ValueId v);
  const uint32_t* Words(Frame& frame, ValueId v) { return Get(frame, v).words; }
  // The array that v's words go to.
  uint32_t* Storage(Frame& frame, ValueId v);
  // The values of `region`'s results, one after the other.
  void CopyResults(Frame& frame, RegionId region, uint32_t* to);
  const uint32_t* ConstantWords(ConstId id);
  size_t SizeOf(TypeId type) const { return size_t{module_.types.Words(type)} * lanes_; }

  const Module& module_;
  const uint32_t lanes_;
  std::span<const Texture* const> textures_;
  std::vector<const uint32_t*> globals_;
  std::vector<std::vector<uint32_t>> constants_;  // by ConstId, in every lane; empty until needed
  WordArena arena_;
  uint32_t depth_ = 0;
  EvaluateObserver* observer_ = nullptr;
  uint32_t first_lane_ = 0;
  // Of the operation that is being computed.
  std::vector<const uint32_t*> operands_;
  std::vector<TypeId> operand_types_;
};

}  // namespace texgraph::ir
