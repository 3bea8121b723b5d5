// SPDX-License-Identifier: Apache-2.0
// Where texgraphc's outputs go, and that they are all there or none.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "compiler/textures/image.h"
#include "tests/unit/base/scratch_folder.h"
#include "tests/unit/cli/program.h"
#include "tests/unit/cli/sample_graphs.h"

namespace texgraph {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

class Output : public testing::Test {
 protected:
  void SetUp() override {
    folder.Write("wall.json", std::string(kProceduralGraph));
    folder.Write("wrong.json", "{ \"texgraph\": 1 }");
  }

  Outcome Run(std::vector<std::string> arguments, std::string input = {}) {
    Program program = Texgraphc(std::move(arguments), folder.path());
    program.input = std::move(input);
    return program.Run();
  }

  ScratchFolder folder;
};

TEST_F(Output, ShaderAndManifestBesideEachOther) {
  Outcome outcome = Run({"wall.json", "-o", "shader.frag"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
  EXPECT_EQ(outcome.out + outcome.error, "");
  EXPECT_THAT(folder.Names(), ElementsAre("shader.frag", "shader.json", "wall.json", "wrong.json"));
  EXPECT_THAT(folder.Read("shader.frag"), HasSubstr("#version 330\n"));
  EXPECT_EQ(nlohmann::json::parse(folder.Read("shader.json"))["shader"], "shader.frag");
}

TEST_F(Output, DefaultNamesFollowTheGraphTargetAndForm) {
  EXPECT_EQ(Run({"wall.json"}).exit_code, 0);
  EXPECT_THAT(folder.Names(),
              ElementsAre("wall.frag", "wall.json", "wall.manifest.json", "wrong.json"));
  EXPECT_EQ(folder.Read("wall.json"), kProceduralGraph);
  EXPECT_EQ(Run({"wall.json", "--emit", "function"}).exit_code, 0);
  EXPECT_THAT(folder.Read("wall.glsl"), HasSubstr("wall("));
  EXPECT_EQ(Run({"wall.json", "--target", "spirv"}).exit_code, 0);
  EXPECT_THAT(folder.Read("wall.spv"), StartsWith("\x03\x02\x23\x07"));
}

TEST_F(Output, ValidateShowsEveryFormToGlslang) {
  for (const char* target : {"glsl330", "glsl450", "spirv"}) {
    for (const char* form : {"shader", "function"}) {
      if (std::string(target) == "spirv" && std::string(form) == "function") continue;
      Outcome plain = Run({"wall.json", "-o", "-", "--target", target, "--emit", form});
      Outcome seen =
          Run({"wall.json", "-o", "-", "--target", target, "--emit", form, "--validate"});
      EXPECT_EQ(seen.exit_code, 0) << target << form << seen.error;
      EXPECT_EQ(seen.out, plain.out);
    }
  }
}

TEST_F(Output, StandardInputAndOutput) {
  Outcome outcome = Run({"-", "-o", "-"}, std::string(kProceduralGraph));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
  EXPECT_THAT(outcome.out, HasSubstr("#version 330\n"));
  EXPECT_EQ(outcome.error, "");
  EXPECT_THAT(folder.Names(), ElementsAre("wall.json", "wrong.json"));
  Outcome file = Run({"wall.json", "-o", "-", "--manifest", "m.json"});
  EXPECT_EQ(nlohmann::json::parse(folder.Read("m.json"))["dialect"], "glsl330");
  EXPECT_EQ(Run({"-", "--format", "yaml", "-o", "-"}, std::string(kProceduralGraph)).exit_code,
            0);  // JSON is YAML
  EXPECT_EQ(Run({"-", "-o", "-"}, "[").exit_code, 1);
  EXPECT_THAT(Run({"-", "-o", "-"}, "[").error, StartsWith("<stdin>:1:2: error: "));
}

TEST_F(Output, DumpGoesToStandardErrorOrBeforeTheShader) {
  Outcome outcome = Run({"wall.json", "-o", "x.frag", "--dump-after", "build"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
  EXPECT_THAT(outcome.error, HasSubstr("// after build\n"));
  EXPECT_EQ(outcome.out, "");
  Outcome both = Run({"wall.json", "-o", "-", "--dump-after", "build", "--dump-after", "legalize"});
  EXPECT_THAT(both.out, StartsWith("// after build\n"));
  EXPECT_LT(both.out.find("// after legalize\n"), both.out.find("#version 330"));
  EXPECT_EQ(both.error, "");
  Outcome all = Run({"wall.json", "-o", "-", "--dump-after", "all"});
  for (const char* phase : {"build", "specialize", "simplify", "differentiate", "legalize"}) {
    EXPECT_THAT(all.out, HasSubstr(std::string("// after ") + phase + "\n"));
  }
}

TEST_F(Output, FoldersAndSeveralGraphs) {
  folder.Write("deck.json", std::string(kProceduralGraph));
  ASSERT_EQ(mkdir((folder / "out").c_str(), 0755), 0);
  for (const char* jobs : {"1", "2", "0"}) {
    Outcome outcome =
        Run({"wall.json", "wrong.json", "deck.json", "nowhere.json", "-o", "out", "-j", jobs});
    EXPECT_EQ(outcome.exit_code, 1);  // the first that failed
    EXPECT_LT(outcome.error.find("wrong.json"), outcome.error.find("nowhere.json"));
    EXPECT_THAT(folder.Read("out/wall.frag"), HasSubstr("#version 330\n"));
    EXPECT_NE(folder.Read("out/deck.json"), "");
    std::filesystem::remove_all(folder / "out");
    std::filesystem::create_directory(folder / "out");
  }
  EXPECT_EQ(Run({"wall.json", "-o", "out/"}).exit_code, 0);
  EXPECT_NE(folder.Read("out/wall.frag"), "");
  EXPECT_EQ(Run({"wall.json", "deck.json", "-o", "missing/"}).exit_code, 3);
}

TEST_F(Output, ManyGraphsOnManyThreadsGiveTheSameAsOneByOne) {
  std::vector<std::string> one = {"-o", "one/", "-j", "1"}, many = {"-o", "many/", "-j", "8"};
  for (int i = 0; i < 24; ++i) {
    std::string name = "g" + std::to_string(i) + ".json", graph(kProceduralGraph);
    graph.replace(graph.find("\"value\": 7"), 10, "\"value\": " + std::to_string(i + 1));
    folder.Write(name, graph);
    one.push_back(name);
    many.push_back(name);
  }
  std::filesystem::create_directory(folder / "one");
  std::filesystem::create_directory(folder / "many");
  EXPECT_EQ(Run(one).exit_code, 0);
  EXPECT_EQ(Run(many).exit_code, 0);
  for (int i = 0; i < 24; ++i) {
    for (const char* extension : {".frag", ".json"}) {
      std::string name = "/g" + std::to_string(i) + extension;
      EXPECT_EQ(folder.Read("one" + name), folder.Read("many" + name));
      EXPECT_NE(folder.Read("one" + name), "");
    }
  }
}

TEST_F(Output, NoTwoOutputsGoToOneFile) {
  folder.Write("again.json", std::string(kProceduralGraph).insert(1, "\"name\": \"wall\", "));
  std::filesystem::create_directory(folder / "out");
  Outcome outcome = Run({"wall.json", "again.json", "-o", "out"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.error, HasSubstr("'out/wall.frag': another output goes there; graphs of "
                                       "one name differ by a key \"name\""));
  EXPECT_EQ(Run({"wall.json", "-o", "x.frag", "--manifest", "./x.frag"}).exit_code, 2);
  EXPECT_EQ(Run({"wall.json", "-o", "x.frag", "-MF", "x.json"}).exit_code, 2);
  EXPECT_EQ(Run({"wall.json", "-o", "-", "--manifest", "-"}).exit_code, 2);
}

// The files of derived textures go by the graph's name; those of one run are kept apart.
TEST_F(Output, GraphsOfOneNameDoNotShareTextures) {
  const auto graph = [](int number) {
    return R"({"texgraph": 1, "textures": {"m": {"map": [[0, )" + std::to_string(number) +
           R"(]]}}, "nodes": {"g": {"block": "virtual_tile_map", "in": {}},
              "w": {"block": "explicit_indirection_map", "in": {"map": "m", "tile": "g"}}},
              "outputs": {"height": "w"}})";
  };
  folder.Write("map.json", graph(1));
  folder.Write("map.yaml", graph(2));
  std::filesystem::create_directory(folder / "out");
  for (const char* jobs : {"1", "2"}) {
    Outcome outcome = Run({"map.json", "map.yaml", "-o", "out", "-j", jobs});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.error, HasSubstr("another output goes there; graphs of one name"));
  }
  const std::string first = folder.Read("out/map.m.ktx2");
  EXPECT_EQ(Run({"map.json", "-o", "alone.frag"}).exit_code, 0);
  EXPECT_NE(first, "");
  EXPECT_EQ(folder.Read("map.m.ktx2"), first);
  // With a name of its own each has its own.
  folder.Write("map.yaml", graph(2).insert(1, "\"name\": \"other\", "));
  EXPECT_EQ(Run({"map.json", "map.yaml", "-o", "out"}).exit_code, 0);
  EXPECT_EQ(folder.Read("out/map.m.ktx2"), first);
  EXPECT_NE(folder.Read("out/other.m.ktx2"), "");
  EXPECT_NE(folder.Read("out/other.m.ktx2"), first);
}

// Pictures that several textures are made of are read once; each is what it is alone.
TEST_F(Output, MeansAreTheSameBesideTheirPatterns) {
  textures::Image sheet;
  sheet.width = sheet.height = 16;
  sheet.channels = 4;
  for (int i = 0; i < 1024; ++i) sheet.pixels.push_back(static_cast<uint8_t>(i * i / 7));
  folder.Write("sheet.png", *textures::EncodePng(sheet));
  const std::string ground = R"("ground": {"sheet": "sheet.png", "grid": [2, 2]})";
  const std::string means =
      R"("where": {"map": [[0, 1], [2, 3]], "of": "ground"}, "far": {"means": "where"})";
  const auto compile = [&](const std::string& textures, const std::string& color) {
    folder.Write("g.json", R"({"texgraph": 1, "textures": {)" + textures + R"(}, "nodes": {
        "grid": {"block": "virtual_tile_map", "in": {}},
        "near": {"block": "reference_texture",
                 "in": {"patterns": "ground", "tile": "grid", "pattern": 1}},
        "mean": {"block": "image", "in": {"picture": "far"}},
        "both": {"block": "add", "in": {"a": "near", "b": "mean"}}},
        "outputs": {"color": ")" +
                               color + R"("}})");
    std::filesystem::remove(folder / "g.far.ktx2");
    std::filesystem::remove(folder / "g.ground.ktx2");
    Outcome outcome = Run({"g.json", "-o", "g.frag"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
    return std::pair(folder.Read("g.ground.ktx2"), folder.Read("g.far.ktx2"));
  };
  const auto near = compile(ground + ", " + means, "near");
  const auto mean = compile(ground + ", " + means, "mean");
  EXPECT_EQ(near.second, "");
  EXPECT_EQ(mean.first, "");
  const auto expected = std::pair(near.first, mean.second);
  EXPECT_NE(expected.first, "");
  EXPECT_NE(expected.second, "");
  EXPECT_EQ(compile(ground + ", " + means, "both"), expected);
  EXPECT_EQ(compile(means + ", " + ground, "both"), expected);
}

TEST_F(Output, InputsAreNeverOverwritten) {
  ASSERT_EQ(symlink("wall.json", (folder / "link.frag").c_str()), 0);
  folder.Write("other.json", std::string(kProceduralGraph));
  std::filesystem::create_directory(folder / "blocks");
  folder.Write("blocks/half_of.glsl",
               "/// Half.\n/// @param x whole\nfloat half_of(float x) { return 0.5 * x; }\n");
  folder.Write(
      "uses.json",
      "{ \"texgraph\": 1, \"nodes\": { \"a\": { \"block\": \"half_of\", \"in\": { \"x\": 1 } } }, "
      "\"outputs\": { \"height\": \"a\" } }");
  for (std::vector<std::string> arguments : std::vector<std::vector<std::string>>{
           {"wall.json", "-o", "wall.json"},
           {"wall.json", "-o", "./wall.json"},
           {"wall.json", "-o", "link.frag"},
           {"wall.json", "-o", "x.frag", "--manifest", "wall.json"},
           {"wall.json", "-o", "x.frag", "-MF", "wall.json"},
           {"uses.json", "-I", "blocks", "-o", "blocks/half_of.glsl"}}) {
    Outcome outcome = Run(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << testing::PrintToString(arguments) << outcome.error;
    EXPECT_THAT(outcome.error, HasSubstr("it is one of the files that are read [usage]"));
  }
  EXPECT_EQ(folder.Read("wall.json"), kProceduralGraph);
  EXPECT_THAT(folder.Read("blocks/half_of.glsl"), StartsWith("/// Half."));
}

TEST_F(Output, DependencyFiles) {
  std::filesystem::create_directory(folder / "my blocks");
  folder.Write("my blocks/half_of.glsl",
               "/// Half.\n/// @param x whole\nfloat half_of(float x) { return 0.5 * x; }\n");
  folder.Write(
      "uses.json",
      "{ \"texgraph\": 1, \"nodes\": { \"a\": { \"block\": \"half_of\", \"in\": { \"x\": 1 } } }, "
      "\"outputs\": { \"height\": \"a\" } }");
  EXPECT_EQ(Run({"uses.json", "-I", "my blocks", "-o", "x.frag", "-MD"}).exit_code, 0);
  EXPECT_EQ(folder.Read("x.frag.d"), "x.frag: \\\n  uses.json \\\n  my\\ blocks/half_of.glsl\n");
  EXPECT_EQ(
      Run({"uses.json", "-I", "my blocks", "-o", "x.frag", "-MF", "deps", "-MT", "all"}).exit_code,
      0);
  EXPECT_THAT(folder.Read("deps"), StartsWith("all: \\\n  uses.json"));
  EXPECT_EQ(Run({"wall.json", "-o", "y.frag", "-MD"}).exit_code, 0);
  EXPECT_EQ(folder.Read("y.frag.d"), "y.frag: \\\n  wall.json\n");
}

TEST_F(Output, WarningsCanBeSilencedOrMadeErrors) {
  folder.Write(
      "tiny.json",
      "{ \"texgraph\": 1, \"nodes\": { \"a\": { \"block\": \"add\", \"in\": { \"a\": 1e-999 } } }, "
      "\"outputs\": { \"height\": \"a\" } }");
  Outcome plain = Run({"tiny.json", "-o", "x.frag"});
  EXPECT_EQ(plain.exit_code, 0);
  EXPECT_THAT(plain.error, HasSubstr("warning: "));
  EXPECT_EQ(Run({"tiny.json", "-o", "x.frag", "-w"}).error, "");
  Outcome strict = Run({"tiny.json", "-o", "strict.frag", "-Werror"});
  EXPECT_EQ(strict.exit_code, 1);
  EXPECT_THAT(strict.error, HasSubstr("error: "));
  EXPECT_EQ(folder.Read("strict.frag"), "");
}

TEST_F(Output, ColorsOnlyWhereTheyAreWanted) {
  EXPECT_EQ(Run({"wrong.json"}).error.find('\x1b'), std::string::npos);  // not a terminal
  EXPECT_NE(Run({"wrong.json", "--color", "always"}).error.find('\x1b'), std::string::npos);
}

// The author of a block learns of all mistakes in its bodies without a graph that uses it.
TEST_F(Output, PrintReferenceChecksTheWholeBlock) {
  std::filesystem::create_directory(folder / "blocks");
  folder.Write("blocks/third_of.glsl",
               "float inner(float x) { return y; }\n"
               "float unused(float x) { return vec2(x); }\n"
               "/// A third.\n/// @param x what\n"
               "float third_of(float x) { return 0.3 * inner(x) + dFdx(x); }\n");
  Outcome outcome = Run({"-I", "blocks", "--print-reference", "third_of"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.error,
              AllOf(HasSubstr("third_of.glsl:1:31: error: "), HasSubstr("[block-name]"),
                    HasSubstr("third_of.glsl:2:"), HasSubstr("[block-type]"),
                    HasSubstr("third_of.glsl:5:51: error: "), HasSubstr("[block-subset]")));
}

TEST_F(Output, BlocksAreListedAndDescribed) {
  Outcome list = Run({"--list-blocks"});
  EXPECT_EQ(list.exit_code, 0) << list.error;
  EXPECT_THAT(list.out, HasSubstr("\n  brick_grid "));
  EXPECT_THAT(list.out, HasSubstr("tiles\n"));
  Outcome reference = Run({"--print-reference", "brick_grid"});
  EXPECT_EQ(reference.exit_code, 0) << reference.error;
  for (const char* part :
       {"brick_grid  (tiles/brick_grid.glsl)", "row_offset", "default 0.5, range 0 to 1",
        "const bool", "default uv", "Outputs\n  tile"}) {
    EXPECT_THAT(reference.out, HasSubstr(part));
  }
  Outcome generic = Run({"--print-reference", "add"});
  EXPECT_THAT(generic.out, HasSubstr("genType is float, vec2, vec3 or vec4"));
  Outcome list_port = Run({"--print-reference", "sdf_polygon"});
  EXPECT_THAT(list_port.out,
              HasSubstr("points  const vec2[]  default vec2[](vec2(0.1), vec2(0.5, "
                        "0.3), vec2(0.9, 0.1), vec2(0.5, 0.9)), 3 to 1024 elements"));
  Outcome unknown = Run({"--print-reference", "brick_gird"});
  EXPECT_EQ(unknown.exit_code, 1);
  EXPECT_THAT(unknown.error, HasSubstr("did you mean 'brick_grid'? [unknown-block]"));
  EXPECT_EQ(unknown.out, "");
}

}  // namespace
}  // namespace texgraph
