// SPDX-License-Identifier: Apache-2.0
// Random edits of sound blocks: whatever comes of them is accepted or reported, and what is
// accepted is well formed.
#include <gtest/gtest.h>
#include <pthread.h>

#include <random>
#include <string>

#include "compiler/blocks/check.h"
#include "compiler/blocks/lower.h"
#include "compiler/blocks/parser.h"
#include "compiler/ir/verify.h"
#include "tests/unit/blocks/block_testing.h"

namespace texgraph::blocks {
namespace {

// A program whose only file is the one at hand, besides the embedded ones that it calls: these are
// checked anew each time, so that every run is a program's first.
class OneFile : public Program {
 public:
  OneFile(ir::Module& module, Sources& sources, Diagnostics& diagnostics)
      : Program(module, sources, diagnostics), library_(module, sources, diagnostics) {}

  File* FindFile(std::string_view name) override {
    const Block* block = library_.Find(name);
    return block ? const_cast<File*>(block->file) : nullptr;
  }
  bool HasFile(std::string_view name) const override { return library_.Exists(name); }
  std::vector<std::string_view> FileNames() const override { return {}; }
  const File* SharedFile() override { return nullptr; }

 private:
  Library library_;
};

// What is wrong with the answer to a text; "" if nothing is.
std::string Try(std::string_view name, const std::string& text, bool fold) {
  ir::Module module;
  Sources sources;
  Diagnostics diagnostics;
  OneFile program(module, sources, diagnostics);
  File file;
  file.name = name;
  file.path = "a.glsl";
  file.source = sources.Add("a.glsl", text);
  file.ast = ParseFile(file.source, sources, diagnostics);
  if (diagnostics.HasErrors()) return "";
  CheckFile(program, file);
  if (!file.valid) return diagnostics.HasErrors() ? "" : "refused without a word";
  Lowering lowering(program, fold);
  for (const Overload& overload : file.block.overloads) {
    std::vector<ir::ConstId> values;
    for (const Port& port : overload.inputs) {
      if (port.kind != PortKind::kTemplate) continue;
      ir::TypeId type = ValueType(module, port);
      std::vector<uint32_t> words(module.types.Words(type), 1);
      values.push_back(port.default_value ? port.default_value : module.Intern(type, words));
    }
    bool made =
        lowering.Function(file, overload.function, overload.gen_type, values, {}).id.valid();
    if (!made && !diagnostics.HasErrors()) return "not lowered without a word";
  }
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    if (diagnostic.range.source.valid() &&
        diagnostic.range.end > sources.Text(diagnostic.range.source).size() + 1) {
      return "a place outside of the text";
    }
  }
  return ir::Verify(module);
}

using Random = std::mt19937;

size_t Below(Random& random, size_t limit) { return limit == 0 ? 0 : random() % limit; }

// Pieces of the language, so that not every edit ends in the lexer.
std::string Piece(Random& random, const std::string& text) {
  static const char* const kPieces[] = {"(",
                                        ")",
                                        "{",
                                        "}",
                                        "[",
                                        "]",
                                        ";",
                                        ",",
                                        ".",
                                        "?",
                                        ":",
                                        "=",
                                        "+",
                                        "-",
                                        "*",
                                        "/",
                                        "<",
                                        ">",
                                        "!",
                                        "~",
                                        "1",
                                        "0",
                                        "2.0",
                                        "1e30",
                                        "0x7fffffff",
                                        "4294967295u",
                                        "const ",
                                        "in ",
                                        "out ",
                                        "inout ",
                                        "if (",
                                        "else ",
                                        "for (int i = 0; i < 3; i++) ",
                                        "return ",
                                        "struct S { float a; };",
                                        "true",
                                        "int ",
                                        "uint ",
                                        "float ",
                                        "vec2 ",
                                        "vec4(",
                                        "mat2(",
                                        "genType ",
                                        "void ",
                                        "sampler2D s",
                                        "float[2](1.0, 2.0)",
                                        ".x",
                                        ".yx",
                                        ".length()",
                                        "const vec2 p[]",
                                        "@length 1 2 ",
                                        "++",
                                        "--",
                                        "+=",
                                        "<<",
                                        "&&",
                                        "footprint(",
                                        "fract(sin(",
                                        "texture(",
                                        "max(",
                                        "hash(1u)",
                                        "random(1u, 2)",
                                        "/// @param a b @default 1\n",
                                        "@range 0 1",
                                        "\n",
                                        "//",
                                        "/*",
                                        "*/",
                                        "\"",
                                        "#",
                                        "\\",
                                        "\xff",
                                        "\xc3\xa4"};
  if (random() % 3 == 0 && !text.empty()) {
    size_t at = Below(random, text.size());
    return text.substr(at, Below(random, 24));
  }
  return kPieces[Below(random, std::size(kPieces))];
}

std::string Edited(Random& random, std::string text) {
  for (size_t edits = 1 + Below(random, 4); edits > 0; --edits) {
    size_t at = Below(random, text.size() + 1);
    switch (random() % 4) {
      case 0:
        text.erase(at, 1 + Below(random, 3));
        break;
      case 1:
        text.insert(at, Piece(random, text));
        break;
      case 2:
        text.insert(at, 1, static_cast<char>(random()));
        break;
      default: {
        std::string piece = Piece(random, text);
        text.replace(at, std::min(piece.size(), text.size() - at), piece);
      }
    }
  }
  return text;
}

// Texts with everything that the language has.
const std::vector<std::string>& Seeds() {
  static const std::vector<std::string> seeds = {
      "genType image(vec2 uv);\nconst int MODE_A = 0;\nconst int MODE_B = 1;\nconst float W[3] = "
      "float[3](0.25, 0.5, 0.25);\n"
      "struct P { vec2 at; float w[2]; };\ngenType at(vec2 p, const int n) { return image(p) * "
      "float(n); }\n"
      "/// A. B.\n/// @param a it @default 1.0 @range 0 2 @unit m\n/// @param mode how @default b\n"
      "genType x(genType a, vec2 uv, const int mode, int n, sampler2D s, out vec3 o) {\n"
      "  P p = P(uv, float[](1.0, W[n])); mat2 m = mat2(uv, uv.yx); o = vec3(0); o[n] = 1.0;\n"
      "  for (int i = 0; i < mode + 2; i++) { if (p.w[0] > 0.5) { p.at.yx += m * uv; } else p.w[n] "
      "-= W[i % 3]; }\n"
      "  if (n > 3) return a; o.zy = texture(s, fract(p.at)).xy;\n"
      "  return (n & 1) == 0 ? at(p.at, mode) : a * footprint(a); }\n",
      "float f(float a, inout float b, out float c) { b += a; c = b; return a; }\n"
      "void x(float a, float b, const bool k, out float r) { float c, d = 1.0; r = f(a, b, c); "
      "++r;\n"
      "  if (k) { if (a > b) { r = 2.0; return; } d *= 2.0; } else { r -= f(1.0, b, r); }\n"
      "  for (int i = 3; i >= -3; i -= 2) for (int j = 0; j < 2; ++j) { r += float(hash(uint(i ^ "
      "j)) >> 8u) * d; } }\n",
  };
  return seeds;
}

TEST(BlockFuzz, RandomEditsAreAcceptedOrReported) {
  Random random(20240229);
  std::vector<std::pair<std::string, std::string>> texts;
  for (const std::string& seed : Seeds()) texts.emplace_back("x", seed);
  for (const EmbeddedFile& file : EmbeddedFiles()) texts.emplace_back(file.name, file.text);
  for (size_t i = 0; i < Seeds().size(); ++i) EXPECT_EQ(Try("x", Seeds()[i], true), "");
  for (int round = 0; round < 6000; ++round) {
    // The seeds are richer than any one block.
    const auto& [name, text] = texts[round % 2 ? Below(random, texts.size()) : Below(random, 2)];
    std::string edited = Edited(random, text);
    ASSERT_EQ(Try(name, edited, round % 3 != 0), "") << edited;
  }
}

// The deepest nests that are accepted, and those that are not, on a stack of 256 kB.
void* TryDeepNests(void* result) {
  auto text = [](std::string_view open, std::string_view middle, std::string_view close,
                 size_t depth) {
    std::string all = "float x(float a, vec2 v) { ";
    for (size_t i = 0; i < depth; ++i) all += open;
    all += middle;
    for (size_t i = 0; i < depth; ++i) all += close;
    return all + " return a; }";
  };
  std::string& wrong = *static_cast<std::string*>(result);
  for (size_t depth : {60, 95, 150, 190, 199, 250, 5000}) {
    for (const std::string& nest :
         {text("a = max(", "a", ", 1.0);", 1), text("{", "a = 1.0;", "}", depth),
          text("if (a > 1.0) { ", "a = 2.0;", " } else a = 1.0;", depth),
          text("if (a > 1.0) return a; ", "", "", depth),
          text("if (a > 1.0) { if (v.x > a) return 1.0; ", "a = 2.0;", "}", depth),
          text("for (int i = 0; i < 1; i++) ", "a += 1.0;", "", depth),
          "float x(float a) { return " + std::string(depth, '(') + "a" + std::string(depth, ')') +
              "; }",
          "float x(float a) { return " + std::string(depth, '-') + "a; }"}) {
      for (bool fold : {true, false}) {
        std::string found = Try("x", nest, fold);
        if (!found.empty()) wrong += found + ": " + nest.substr(0, 60) + "\n";
      }
    }
    std::string calls, ends, chooses, sum;
    for (size_t i = 0; i < depth; ++i) {
      calls += "clamp(1.0, f(";
      ends += "), 2.0)";
      chooses += "a > 1.0 ? f(a) : ";
      sum += "a + f(1) * ";
    }
    for (const std::string& expression : {calls + "a" + ends, chooses + "a", sum + "a"}) {
      std::string found = Try(
          "x",
          "float f(float a) { return sin(a); }\nfloat x(float a) { return " + expression + "; }",
          false);
      if (!found.empty()) wrong += found + ": " + expression.substr(0, 60) + "\n";
    }
    if (depth > 1000) continue;
    // Functions that call each other from inside nests.
    std::string chain = "float f0(float a) { return a; }\n";
    for (int i = 1; i < 63; ++i) {
      chain += "float f" + std::to_string(i) + "(float a) { ";
      for (size_t j = 0; j < depth; ++j)
        chain += j % 2 ? "if (a > 1.0) " : "for (int i = 0; i < 1; i++) ";
      chain += "a = 1.0 + f" + std::to_string(i - 1) + "(a); return a; }\n";
    }
    std::string found = Try("x", chain + "float x(float a) { return f62(a); }", true);
    if (!found.empty()) wrong += found + ": functions " + std::to_string(depth) + "\n";
  }
  return nullptr;
}

// Instrumented code takes several times as much.
#if defined(__SANITIZE_ADDRESS__)
constexpr size_t kStack = 4096 * 1024;
#else
constexpr size_t kStack = 256 * 1024;
#endif

TEST(BlockFuzz, DeepNestsFitIntoASmallStack) {
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  ASSERT_EQ(pthread_attr_setstacksize(&attributes, kStack), 0);
  pthread_t thread;
  std::string wrong;
  ASSERT_EQ(pthread_create(&thread, &attributes, TryDeepNests, &wrong), 0);
  pthread_join(thread, nullptr);
  pthread_attr_destroy(&attributes);
  EXPECT_EQ(wrong, "");
}

}  // namespace
}  // namespace texgraph::blocks
