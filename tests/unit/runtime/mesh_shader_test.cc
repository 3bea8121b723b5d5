// SPDX-License-Identifier: Apache-2.0
#include "runtime/mesh_shader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compiler/graph/graph.h"
#include "compiler/spirv/compile_spirv.h"
#include "runtime/scene.h"

namespace texgraph::runtime {
namespace {

using testing::HasSubstr;
using testing::Not;

// A function with those of a graph's outputs whose bit is set, and its manifest.
std::string Function(uint32_t outputs, Manifest& manifest) {
  const ir::Types types;
  manifest.is_function = true;
  manifest.entry_point = "made";
  manifest.inputs = {
      {"uv", "", ir::kVec2, {}}, {"normal", "", ir::kVec3, {}}, {"time", "", ir::kFloat, {}}};
  std::string parameters = "vec2 uv, vec3 normal";
  std::string body;
  std::string type = "void";
  const bool single = (outputs & (outputs - 1)) == 0;
  for (size_t i = 0; i < std::size(graph::kBuiltinOutputs); ++i) {
    if ((outputs >> i & 1) == 0) continue;
    const std::string name(graph::kBuiltinOutputs[i].name);
    const std::string own(graph::kBuiltinOutputs[i].type);
    manifest.outputs.push_back({name, name, types.Find(own)});
    if (single) type = own;
    if (!single) parameters += ", out " + own + " out_" + name;
    body += single ? "  return " + own + "(time);\n" : "  out_" + name + " = " + own + "(time);\n";
  }
  return "uniform float time;\n" + type + " made(" + parameters + ") {\n" + body + "}\n";
}

// A second compiler takes the shader with any subset of outputs, in both dialects, lit and unlit.
TEST(MeshShaderTest, IsValidForEveryGraph) {
  for (uint32_t outputs = 1; outputs < 128; ++outputs) {
    Manifest manifest;
    const std::string function = Function(outputs, manifest);
    manifest.dialect = outputs % 2 == 0 ? ShaderDialect::kGlsl330 : ShaderDialect::kGlsl450;
    std::vector<std::string_view> names = {kLitOutput};
    for (const ManifestOutput& output : manifest.outputs) names.push_back(output.name);
    const MeshShader shader = ComposeMeshShader(function, manifest, names);
    Diagnostics diagnostics;
    ASSERT_TRUE(spirv::ValidateGlsl(shader.fragment, diagnostics))
        << diagnostics.all().front().message << shader.fragment;
    names.erase(names.begin());
    const MeshShader unlit = ComposeMeshShader(function, manifest, names);
    ASSERT_TRUE(spirv::ValidateGlsl(unlit.fragment, diagnostics)) << unlit.fragment;
  }
  Diagnostics diagnostics;
  EXPECT_TRUE(spirv::ValidateGlsl(ResolveFragmentShader(), diagnostics));
}

TEST(MeshShaderTest, LeavesTheGraphsTextAsItIs) {
  Manifest manifest;
  const std::string function = Function(5, manifest) + "// mesh_ and mesh2_\n";
  const std::vector<std::string_view> names = {kLitOutput};
  const MeshShader shader = ComposeMeshShader(function, manifest, names);
  EXPECT_THAT(shader.fragment, HasSubstr(function));
  EXPECT_EQ(shader.prefix, "mesh3_");
  EXPECT_THAT(shader.fragment, HasSubstr("made(mesh3_uv, normalize(mesh3_normal), "));
  EXPECT_THAT(shader.vertex, Not(HasSubstr("$")));
}

}  // namespace
}  // namespace texgraph::runtime
