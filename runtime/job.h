// SPDX-License-Identifier: Apache-2.0
// A request and the memory that its result comes back in, on the parent's side of the child
// process.
#pragma once

#include "runtime/child.h"
#include "runtime/render.h"
#include "runtime/shared_result.h"

namespace texgraph::runtime {

class SharedBlock {
 public:
  SharedBlock() = default;
  SharedBlock(const SharedBlock&) = delete;
  SharedBlock& operator=(const SharedBlock&) = delete;
  ~SharedBlock();
  bool Allocate(size_t pixel_bytes);
  SharedResult& operator*() const { return *result_; }

 private:
  SharedResult* result_ = nullptr;
  size_t size_ = 0;
};

struct Job {
  const RenderRequest* request;
  RenderResult* result;
  RenderPlan plan;
  SharedBlock shared;
};

// From the shared memory to the job's result. The first when the child says that it is done with
// the job, the second when it crashed at it or was too slow.
void Collect(const Job& job);
void CollectFailure(const Job& job, const Child& child, Child::Event event);

}  // namespace texgraph::runtime
