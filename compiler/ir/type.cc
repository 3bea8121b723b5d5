// SPDX-License-Identifier: Apache-2.0
#include "compiler/ir/type.h"

#include <utility>

namespace texgraph::ir {
namespace {

constexpr std::string_view kBasicNames[kBasicTypeCount] = {
    "void", "bool",  "bvec2", "bvec3", "bvec4", "int",  "ivec2", "ivec3", "ivec4",     "uint",           "uvec2",    "uvec3",
    "uvec4", "float", "vec2",  "vec3",  "vec4",  "mat2", "mat3",  "mat4",  "sampler2D", "sampler2DArray", "sampler3D"};

std::string ArrayText(const std::string& element, uint32_t length) {
  return element + "[" + (length ? std::to_string(length) : "") + "]";
}

}  // namespace

Types::Types() {
  for (uint32_t i = 0; i < kBasicTypeCount; ++i) {
    TypeId id(i);
    Type type;
    type.kind = i == 0 ? TypeKind::kVoid
                : IsVector(id) ? TypeKind::kVector
                : IsMatrix(id) ? TypeKind::kMatrix
                               : TypeKind::kSampler;
    type.name = kBasicNames[i];
    Intern(std::move(type));
  }
}

TypeId Types::Intern(Type type) {
  TypeId id(types_.size());
  types_.push_back(std::move(type));
  words_.push_back(CountWords(id));
  by_text_.emplace(Text(id), id);
  return id;
}

// From those of what the type holds, which comes before it.
uint32_t Types::CountWords(TypeId id) const {
  const Type& type = types_[id.index];
  uint32_t words = 0;
  switch (type.kind) {
    case TypeKind::kVoid:
    case TypeKind::kField:
      return 0;
    case TypeKind::kVector:
      return Width(id);
    case TypeKind::kMatrix:
      return MatrixSize(id) * MatrixSize(id);
    case TypeKind::kSampler:
      return 1;
    case TypeKind::kStruct:
      for (const StructField& field : type.fields) words += Words(field.type);
      return words;
    case TypeKind::kTuple:
      for (TypeId element : type.elements) words += Words(element);
      return words;
    case TypeKind::kArray:
      return type.length * Words(type.elements[0]);
  }
  return 0;
}

void Types::KeepFields(TypeId id, const std::vector<bool>& keep) {
  std::vector<StructField> kept;
  for (size_t i = 0; i < keep.size(); ++i) {
    if (keep[i]) kept.push_back(std::move(types_[id.index].fields[i]));
  }
  types_[id.index].fields = std::move(kept);
  for (uint32_t i = id.index; i < types_.size(); ++i) words_[i] = CountWords(TypeId(i));
}

TypeId Types::Struct(std::string_view name, std::vector<StructField> fields) {
  if (TypeId known = Find(name)) {
    const Type& type = types_[known.index];
    bool same = type.kind == TypeKind::kStruct && type.fields.size() == fields.size();
    for (size_t i = 0; same && i < fields.size(); ++i) {
      same = type.fields[i].name == fields[i].name && type.fields[i].type == fields[i].type;
    }
    return same ? known : TypeId();
  }
  Type type;
  type.kind = TypeKind::kStruct;
  type.name = name;
  type.fields = std::move(fields);
  return Intern(std::move(type));
}

TypeId Types::Array(TypeId element, uint32_t length) {
  std::string text = ArrayText(Text(element), length);
  if (auto known = by_text_.find(text); known != by_text_.end()) return known->second;
  Type type;
  type.kind = TypeKind::kArray;
  type.elements = {element};
  type.length = length;
  return Intern(std::move(type));
}

TypeId Types::Tuple(std::span<const TypeId> elements) {
  Type type;
  type.kind = TypeKind::kTuple;
  type.elements.assign(elements.begin(), elements.end());
  std::string text = "(";
  for (size_t i = 0; i < elements.size(); ++i) text += (i ? ", " : "") + Text(elements[i]);
  text += ")";
  if (auto known = by_text_.find(text); known != by_text_.end()) return known->second;
  return Intern(std::move(type));
}

TypeId Types::Field(TypeId result, std::span<const TypeId> parameters) {
  Type type;
  type.kind = TypeKind::kField;
  type.elements = {result};
  type.elements.insert(type.elements.end(), parameters.begin(), parameters.end());
  std::string text = "field(";
  for (size_t i = 0; i < parameters.size(); ++i) text += (i ? ", " : "") + Text(parameters[i]);
  text += ") -> " + Text(result);
  if (auto known = by_text_.find(text); known != by_text_.end()) return known->second;
  return Intern(std::move(type));
}

TypeId Types::Find(std::string_view name) const {
  auto known = by_text_.find(name);
  return known == by_text_.end() ? TypeId() : known->second;
}

TypeId Types::ElementType(TypeId aggregate, uint32_t index) const {
  const Type& type = types_[aggregate.index];
  switch (type.kind) {
    case TypeKind::kVector: return ScalarType(aggregate);
    case TypeKind::kMatrix: return ColumnType(aggregate);
    case TypeKind::kStruct: return type.fields[index].type;
    case TypeKind::kTuple: return type.elements[index];
    case TypeKind::kArray: return type.elements[0];
    default: return TypeId();
  }
}

// Columns of a matrix and elements of an array are of one size, members of a struct are not.
uint32_t Types::ElementOffset(TypeId aggregate, uint32_t index) const {
  const TypeKind kind = Kind(aggregate);
  if (kind != TypeKind::kStruct && kind != TypeKind::kTuple) {
    return index * Words(ElementType(aggregate, 0));
  }
  uint32_t offset = 0;
  for (uint32_t i = 0; i < index; ++i) offset += Words(ElementType(aggregate, i));
  return offset;
}

uint32_t Types::ElementCount(TypeId aggregate) const {
  const Type& type = types_[aggregate.index];
  switch (type.kind) {
    case TypeKind::kVector: return Width(aggregate);
    case TypeKind::kMatrix: return MatrixSize(aggregate);
    case TypeKind::kStruct: return static_cast<uint32_t>(type.fields.size());
    case TypeKind::kTuple: return static_cast<uint32_t>(type.elements.size());
    case TypeKind::kArray: return type.length;
    default: return 0;
  }
}

std::string Types::Text(TypeId id) const {
  const Type& type = types_[id.index];
  switch (type.kind) {
    case TypeKind::kArray: return ArrayText(Text(type.elements[0]), type.length);
    case TypeKind::kTuple: {
      std::string text = "(";
      for (size_t i = 0; i < type.elements.size(); ++i) {
        text += (i ? ", " : "") + Text(type.elements[i]);
      }
      return text + ")";
    }
    case TypeKind::kField: {
      std::string text = "field(";
      for (size_t i = 1; i < type.elements.size(); ++i) {
        text += (i > 1 ? ", " : "") + Text(type.elements[i]);
      }
      return text + ") -> " + Text(type.elements[0]);
    }
    default: return type.name;
  }
}

}  // namespace texgraph::ir
