// SPDX-License-Identifier: Apache-2.0
// The types of values: GLSL's, plus fields (functions as values, gone after Specialize) and tuples (the results of calls, ifs
// and loops with several results). The basic types have fixed ids, so they can be named as constants anywhere; the others are
// interned in a Types table, so equal types have equal ids.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/base/ids.h"

namespace texgraph::ir {

using TypeId = Id<struct TypeTag>;

enum class TypeKind : uint8_t { kVoid, kVector, kMatrix, kSampler, kStruct, kArray, kTuple, kField };
// The scalar that a vector, a matrix or an array of them is made of.
enum class Scalar : uint8_t { kBool, kInt, kUint, kFloat };

// Fixed ids. A vector of width 1 is a scalar.
inline constexpr TypeId kVoid{0};
inline constexpr TypeId kBool{1}, kBvec2{2}, kBvec3{3}, kBvec4{4};
inline constexpr TypeId kInt{5}, kIvec2{6}, kIvec3{7}, kIvec4{8};
inline constexpr TypeId kUint{9}, kUvec2{10}, kUvec3{11}, kUvec4{12};
inline constexpr TypeId kFloat{13}, kVec2{14}, kVec3{15}, kVec4{16};
inline constexpr TypeId kMat2{17}, kMat3{18}, kMat4{19};
inline constexpr TypeId kSampler2D{20}, kSampler2DArray{21}, kSampler3D{22};
inline constexpr uint32_t kBasicTypeCount = 23;

constexpr bool IsVector(TypeId t) { return t.index >= 1 && t.index <= 16; }  // scalars too
constexpr bool IsMatrix(TypeId t) { return t.index >= 17 && t.index <= 19; }
constexpr bool IsSampler(TypeId t) { return t.index >= 20 && t.index <= 22; }
constexpr bool IsScalar(TypeId t) { return IsVector(t) && (t.index - 1) % 4 == 0; }
// For vectors and scalars only.
constexpr Scalar ScalarOf(TypeId t) { return static_cast<Scalar>((t.index - 1) / 4); }
constexpr uint32_t Width(TypeId t) { return (t.index - 1) % 4 + 1; }
constexpr TypeId Vector(Scalar s, uint32_t width) {
  return TypeId(1 + 4 * static_cast<uint32_t>(s) + width - 1);
}
constexpr TypeId WithWidth(TypeId t, uint32_t width) { return Vector(ScalarOf(t), width); }
constexpr TypeId ScalarType(TypeId t) { return WithWidth(t, 1); }
constexpr bool IsFloat(TypeId t) { return t.index >= 13 && t.index <= 19; }  // vectors and matrices
constexpr bool IsInteger(TypeId t) { return t.index >= 5 && t.index <= 12; }  // signed or not
constexpr bool IsBool(TypeId t) { return t.index >= 1 && t.index <= 4; }
constexpr uint32_t MatrixSize(TypeId t) { return t.index - 15; }  // mat3 -> 3
constexpr TypeId ColumnType(TypeId t) { return Vector(Scalar::kFloat, MatrixSize(t)); }
// What a word of a value is: a bool is 0 or 1.
constexpr double NumberOf(Scalar s, uint32_t word) {
  if (s == Scalar::kFloat) return std::bit_cast<float>(word);
  return s == Scalar::kInt ? double(static_cast<int32_t>(word)) : double(word);
}
constexpr double NumberOf(TypeId t, uint32_t word) {
  return NumberOf(IsFloat(t) ? Scalar::kFloat : ScalarOf(t), word);
}
// The size of a sampler's coordinate: 2 for sampler2D, 3 for the others.
constexpr uint32_t CoordinateWidth(TypeId t) { return t == kSampler2D ? 2 : 3; }

struct StructField {
  std::string name;
  TypeId type;
};

struct Type {
  TypeKind kind = TypeKind::kVoid;
  std::string name;                 // "vec3", "Tile"; empty for arrays, tuples and fields
  std::vector<StructField> fields;  // kStruct
  std::vector<TypeId> elements;     // kTuple: the elements. kArray: the element. kField: result, then parameters
  uint32_t length = 0;              // kArray; 0: any, which only signatures of blocks have
};

class Types {
 public:
  Types();

  const Type& operator[](TypeId id) const { return types_[id.index]; }
  size_t size() const { return types_.size(); }
  TypeKind Kind(TypeId id) const { return types_[id.index].kind; }

  // `name` is unique: a second call with equal fields gives the same id, with other fields an invalid one.
  TypeId Struct(std::string_view name, std::vector<StructField> fields);
  TypeId Array(TypeId element, uint32_t length);
  TypeId Tuple(std::span<const TypeId> elements);
  TypeId Field(TypeId result, std::span<const TypeId> parameters);
  // Drops the other members of a struct, which keeps its name and id; what holds such structs
  // changes with it.
  void KeepFields(TypeId id, const std::vector<bool>& keep);
  // A basic type or a struct by name; invalid if there is none.
  TypeId Find(std::string_view name) const;

  TypeId ElementType(TypeId aggregate, uint32_t index) const;  // struct, tuple, array, matrix column, vector component
  uint32_t ElementCount(TypeId aggregate) const;
  // The first word of element `index` in an aggregate's words.
  uint32_t ElementOffset(TypeId aggregate, uint32_t index) const;
  // What a field gives; any other type itself.
  TypeId ValueOf(TypeId type) const {
    return Kind(type) == TypeKind::kField ? types_[type.index].elements[0] : type;
  }
  // The number of 32-bit words of a value: vec3 3, mat2 4, structs and arrays the sum; samplers 1, fields 0.
  uint32_t Words(TypeId id) const { return words_[id.index]; }
  // "vec3", "float[4]", "(vec4, float)", "field(vec2) -> vec4".
  std::string Text(TypeId id) const;

 private:
  TypeId Intern(Type type);
  uint32_t CountWords(TypeId id) const;
  std::vector<Type> types_;
  std::vector<uint32_t> words_;
  std::map<std::string, TypeId, std::less<>> by_text_;
};

}  // namespace texgraph::ir
