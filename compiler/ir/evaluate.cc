// SPDX-License-Identifier: Apache-2.0
#include "compiler/ir/evaluate.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "compiler/ir/interpreter.h"

namespace texgraph::ir {
namespace {

[[noreturn]] void Refuse(const char* what, const std::string& name) {
  std::fprintf(stderr, "texgraph: evaluate: %s%s\n", what, name.c_str());
  std::abort();
}

// Part of a value of all lanes, as one batch sees it.
class BatchInput {
 public:
  // `words`: of one lane or of all.
  BatchInput(const std::vector<uint32_t>& source, uint32_t words, uint32_t lanes,
             uint32_t batch_lanes)
      : source_(source), words_(words), lanes_(lanes), batch_lanes_(batch_lanes) {
    if (source.size() == words) {
      for (uint32_t word : source) batch_.insert(batch_.end(), batch_lanes, word);
    } else {
      batch_.resize(size_t{words} * batch_lanes);
    }
  }

  // The words of lanes [first, first + count); lanes beyond repeat the last quad.
  const uint32_t* At(uint32_t first, uint32_t count) {
    if (source_.size() == words_) return batch_.data();
    for (uint32_t word = 0; word < words_; ++word) {
      const uint32_t* from = source_.data() + size_t{word} * lanes_ + first;
      uint32_t* to = batch_.data() + size_t{word} * batch_lanes_;
      for (uint32_t lane = 0; lane < batch_lanes_; ++lane) {
        to[lane] = from[lane < count ? lane : count - 4 + (lane & 3)];
      }
    }
    return batch_.data();
  }

 private:
  const std::vector<uint32_t>& source_;
  uint32_t words_, lanes_, batch_lanes_;
  std::vector<uint32_t> batch_;
};

// What stands for a global that `inputs` says nothing of: a sampler's own id, the default, zeros.
std::vector<uint32_t> DefaultOf(const Module& module, GlobalId id) {
  const Global& global = module.globals[id.index];
  if (global.kind == GlobalKind::kTexture) return {id.index};
  if (!global.value) return std::vector<uint32_t>(module.types.Words(global.type));
  std::span<const uint32_t> words = module.Words(global.value);
  return {words.begin(), words.end()};
}

void CheckSize(const std::vector<uint32_t>& words, uint32_t size, uint32_t lanes,
               const std::string& name) {
  if (words.size() != size && words.size() != size_t{size} * lanes) {
    Refuse("words of the wrong number for ", name);
  }
}

// The values of all globals: what is given, or the default.
std::vector<std::vector<uint32_t>> GlobalValues(const Module& module,
                                                const EvaluateInputs& inputs) {
  std::vector<std::vector<uint32_t>> values(module.globals.size());
  for (size_t i = 0; i < values.size(); ++i) {
    const Global& global = module.globals[i];
    bool given = global.kind != GlobalKind::kTexture && i < inputs.globals.size() &&
                 !inputs.globals[i].empty();
    values[i] = given ? inputs.globals[i] : DefaultOf(module, GlobalId(i));
    CheckSize(values[i], module.types.Words(global.type), inputs.lanes, global.name);
  }
  return values;
}

}  // namespace

std::vector<std::vector<uint32_t>> Evaluate(const Module& module, FunctionId function,
                                            const EvaluateInputs& inputs,
                                            std::span<const std::vector<uint32_t>> arguments) {
  const Function& f = module[function];
  const uint32_t lanes = inputs.lanes, batch_lanes = std::min(lanes, Interpreter::kMaxLanes);
  if (lanes % 4 != 0) Refuse("lanes that are no whole quads", "");
  if (arguments.size() != f.parameters.size()) Refuse("arguments of the wrong number for ", f.name);

  const std::vector<std::vector<uint32_t>> values = GlobalValues(module, inputs);
  std::vector<BatchInput> globals, parameters;
  for (size_t i = 0; i < values.size(); ++i) {
    globals.emplace_back(values[i], module.types.Words(module.globals[i].type), lanes, batch_lanes);
  }
  for (size_t i = 0; i < arguments.size(); ++i) {
    const Parameter& parameter = f.parameters[i];
    if (module.types.Kind(parameter.type) == TypeKind::kField)
      Refuse("a field as argument of ", f.name);
    CheckSize(arguments[i], module.types.Words(parameter.type), lanes, parameter.name);
    parameters.emplace_back(arguments[i], module.types.Words(parameter.type), lanes, batch_lanes);
  }

  std::vector<std::vector<uint32_t>> results;
  size_t result_words = 0;
  for (const Result& result : f.results) {
    results.emplace_back(size_t{module.types.Words(result.type)} * lanes);
    result_words += module.types.Words(result.type);
  }
  Interpreter interpreter(module, batch_lanes, inputs.textures);
  std::vector<const uint32_t*> batch_arguments(arguments.size());
  std::vector<uint32_t> batch(result_words * batch_lanes);
  for (uint32_t first = 0; first < lanes; first += batch_lanes) {
    const uint32_t count = std::min(batch_lanes, lanes - first);
    for (size_t i = 0; i < globals.size(); ++i) {
      interpreter.SetGlobal(GlobalId(i), globals[i].At(first, count));
    }
    for (size_t i = 0; i < parameters.size(); ++i)
      batch_arguments[i] = parameters[i].At(first, count);
    interpreter.SetObserver(inputs.observer, first);
    const uint64_t active = count == 64 ? ~uint64_t{0} : (uint64_t{1} << count) - 1;
    interpreter.Run(function, batch_arguments, active, batch.data());
    const uint32_t* from = batch.data();
    for (std::vector<uint32_t>& result : results) {
      for (size_t word = 0; word < result.size() / lanes; ++word, from += batch_lanes) {
        std::copy_n(from, count, result.begin() + static_cast<ptrdiff_t>(word * lanes + first));
      }
    }
  }
  return results;
}

}  // namespace texgraph::ir
