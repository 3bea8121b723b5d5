// SPDX-License-Identifier: Apache-2.0
#include "compiler/ir/module.h"

#include <algorithm>

namespace texgraph::ir {
namespace {

uint64_t HashWords(TypeId type, std::span<const uint32_t> words) {
  uint64_t hash = type.index * 0x9e3779b97f4a7c15ull;
  for (uint32_t word : words) hash = (hash ^ word) * 0x9e3779b97f4a7c15ull + (hash >> 29);
  return hash >> 32;
}

}  // namespace

uint32_t ForLoop::Trips() const {
  int64_t distance = step > 0 ? int64_t(last) - first : int64_t(first) - last;
  int64_t stride = step > 0 ? int64_t(step) : -int64_t(step);
  return distance <= 0 ? 0 : static_cast<uint32_t>((distance + stride - 1) / stride);
}

ConstId Module::Intern(TypeId type, std::span<const uint32_t> words) {
  if (2 * constants_.size() >= constant_slots_.size()) {
    constant_slots_.assign(std::max<size_t>(64, 4 * constant_slots_.size()), ConstId());
    for (size_t i = 0; i < constants_.size(); ++i) {
      ConstantSlot(constants_[i].type, Words(ConstId(i))) = ConstId(i);
    }
  }
  ConstId& known = ConstantSlot(type, words);
  if (known) return known;
  known = ConstId(constants_.size());
  constants_.push_back({type, static_cast<uint32_t>(words_.size())});
  words_.insert(words_.end(), words.begin(), words.end());
  return known;
}

ConstId& Module::ConstantSlot(TypeId type, std::span<const uint32_t> words) {
  const size_t mask = constant_slots_.size() - 1;
  for (size_t slot = HashWords(type, words) & mask;; slot = (slot + 1) & mask) {
    ConstId& id = constant_slots_[slot];
    if (!id || (constants_[id.index].type == type && std::ranges::equal(Words(id), words)))
      return id;
  }
}

NameId Module::InternName(std::string_view name) {
  if (const NameId* known = name_index_.Find(name)) return *known;
  names_.emplace_back(name);
  NameId id(names_.size() - 1);
  name_index_.Add(names_.back(), id);
  return id;
}

OriginId Module::AddOrigin(const Origin& origin) {
  auto keep = [&](std::string_view text) { return Name(InternName(text)); };
  origins.push_back({keep(origin.node), keep(origin.block), keep(origin.source)});
  return OriginId(origins.size() - 1);
}

GlobalId Module::AddGlobal(Global global) {
  globals.push_back(std::move(global));
  return GlobalId(globals.size() - 1);
}

TypeId Module::CallType(const Function& function) {
  if (function.results.size() == 1) return function.results[0].type;
  std::vector<TypeId> elements;
  for (const Result& result : function.results) elements.push_back(result.type);
  return types.Tuple(elements);
}

}  // namespace texgraph::ir
