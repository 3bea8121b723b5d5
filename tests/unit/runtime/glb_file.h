// SPDX-License-Identifier: Apache-2.0
// Binary glTF files out of their parts, right or wrong as a test wants them.
#pragma once

#include <string.h>

#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

namespace texgraph::runtime {

template <class T>
void AppendBytes(std::string& bytes, std::initializer_list<T> values) {
  for (const T& value : values) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
}

inline std::string GlbFile(std::string json, std::string binary) {
  while (json.size() % 4 != 0) json += ' ';
  while (binary.size() % 4 != 0) binary += '\0';
  std::string bytes;
  const auto size = static_cast<uint32_t>(28 + json.size() + binary.size());
  AppendBytes<uint32_t>(bytes, {0x46546c67, 2, size});
  AppendBytes<uint32_t>(bytes, {static_cast<uint32_t>(json.size()), 0x4e4f534a});
  bytes += json;
  AppendBytes<uint32_t>(bytes, {static_cast<uint32_t>(binary.size()), 0x004e4942});
  return bytes + binary;
}

// One triangle in the plane z = 0: corners (0,0), (1,0), (0,1), with uv as glTF has it: its v goes
// down. POSITION is accessor 0, TEXCOORD_0 is 1, the indices (uint16) are 2, NORMAL is 3 if it is
// asked for. A test replaces parts of the JSON.
inline std::string TriangleBinary() {
  std::string bytes;
  AppendBytes<float>(bytes, {0, 0, 0, 1, 0, 0, 0, 1, 0});  // 0
  AppendBytes<float>(bytes, {0, 1, 1, 1, 0, 0});           // 36
  AppendBytes<uint16_t>(bytes, {0, 1, 2, 0});              // 60
  AppendBytes<float>(bytes, {0, 0, 1, 0, 0, 1, 0, 0, 1});  // 68, to 104
  return bytes;
}

inline std::string TriangleJson() {
  return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
"nodes": [{"mesh": 0}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2}]}],
"accessors": [
{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
{"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC2"},
{"bufferView": 2, "componentType": 5123, "count": 3, "type": "SCALAR"},
{"bufferView": 3, "componentType": 5126, "count": 3, "type": "VEC3"}],
"bufferViews": [
{"buffer": 0, "byteOffset": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 24},
{"buffer": 0, "byteOffset": 60, "byteLength": 6}, {"buffer": 0, "byteOffset": 68, "byteLength": 36}],
"buffers": [{"byteLength": 104}]})";
}

}  // namespace texgraph::runtime
