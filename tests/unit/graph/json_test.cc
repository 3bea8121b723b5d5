// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "tests/unit/graph/graph_testing.h"

namespace texgraph::graph {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string Repeat(std::string_view text, size_t count) {
  std::string out;
  out.reserve(text.size() * count);
  for (size_t i = 0; i < count; ++i) out += text;
  return out;
}

TEST(Json, ReadsEveryKindOfValue) {
  ReadText read(R"( { "a" : [ 1 , -2.5e3, "x", true, false, null ], "b": {}, "c": [] } )");
  ASSERT_TRUE(read.document) << read.Messages();
  EXPECT_EQ(TreeText(*read.document),
            R"({"a": [1, -2500.0, "x", true, false, null], "b": {}, "c": []})");
}

TEST(Json, RangesCoverValuesAndKeys) {
  std::string text = "{\n  \"key\": [12, \"t\"]\n}";
  ReadText read(text);
  ASSERT_TRUE(read.document);
  auto covered = [&](SourceRange range) {
    return text.substr(range.begin, range.end - range.begin);
  };
  const DocumentNode& array = read.document->nodes[1];
  EXPECT_EQ(covered(read.document->nodes[0].range), text);
  EXPECT_EQ(covered(array.key_range), "\"key\"");
  EXPECT_EQ(covered(array.range), "[12, \"t\"]");
  EXPECT_EQ(covered(read.document->nodes[2].range), "12");
  EXPECT_EQ(covered(read.document->nodes[3].range), "\"t\"");
  EXPECT_EQ(read.document->Find(read.document->nodes[0], "key"), &array);
  EXPECT_EQ(read.document->Find(read.document->nodes[0], "other"), nullptr);
}

TEST(Json, PlainStringsStayInTheSource) {
  ReadText read(R"({"plain": "text", "escaped": "a\tb"})");
  ASSERT_TRUE(read.document);
  std::string_view source = read.sources.Text(read.source);
  EXPECT_EQ(read.document->nodes[1].text.data(), source.data() + source.find("text"));
  EXPECT_EQ(read.document->storage.size(), 1u);
}

TEST(Json, EscapesBecomeUtf8) {
  ReadText read(R"(["\"\\\/\b\f\n\r\t", "\u0041\u00e9\u20AC", "\ud83d\ude00", "\u0000"])");
  ASSERT_TRUE(read.document) << read.Messages();
  EXPECT_EQ(read.document->nodes[1].text, "\"\\/\b\f\n\r\t");
  EXPECT_EQ(read.document->nodes[2].text, "A\xc3\xa9\xe2\x82\xac");
  EXPECT_EQ(read.document->nodes[3].text, "\xf0\x9f\x98\x80");
  EXPECT_EQ(read.document->nodes[4].text, std::string_view("\0", 1));
}

TEST(Json, NumbersKeepTheirKind) {
  ReadText read(
      "[0, -0, -0.0, 9223372036854775807, 9223372036854775808, -9223372036854775808, 1e2,"
      " 5e-324, 0e99999999999999999999, 0.1]");
  ASSERT_TRUE(read.document) << read.Messages();
  EXPECT_THAT(read.Places(), IsEmpty());
  const auto& nodes = read.document->nodes;
  EXPECT_TRUE(nodes[1].is_integer);
  EXPECT_TRUE(nodes[2].is_integer);
  EXPECT_TRUE(std::signbit(nodes[2].number));
  EXPECT_FALSE(nodes[3].is_integer);
  EXPECT_TRUE(std::signbit(nodes[3].number));
  EXPECT_EQ(nodes[4].integer, INT64_MAX);
  EXPECT_FALSE(nodes[5].is_integer);
  EXPECT_EQ(nodes[5].number, 9223372036854775808.0);
  EXPECT_EQ(nodes[6].integer, INT64_MIN);
  EXPECT_FALSE(nodes[7].is_integer);
  EXPECT_EQ(nodes[7].number, 100.0);
  EXPECT_EQ(nodes[8].number, 5e-324);
  EXPECT_EQ(nodes[9].number, 0.0);
  EXPECT_EQ(nodes[10].number, 0.1);
}

// HOSTILE 29 to 31 are numbers that crashed other readers.
TEST(Json, TooSmallNumbersBecomeZeroWithAWarning) {
  for (const std::string& number :
       {std::string("1e-999"), std::string("-1e-999"), std::string("0.0000074836628E-2147483636"),
        "0." + Repeat("0", 1'000'000) + "1", std::string("128.748476e-336"),
        Repeat("1", 300) + "e-99999999999999999999"}) {
    ReadText read(number);
    ASSERT_TRUE(read.document) << read.Messages();
    EXPECT_EQ(read.document->nodes[0].number, 0.0);
    EXPECT_EQ(std::signbit(read.document->nodes[0].number), number[0] == '-');
    EXPECT_THAT(read.Places(), ElementsAre("warning: 1:1 number-underflow"));
  }
  ReadText denormal("1e-310");
  ASSERT_TRUE(denormal.document);
  EXPECT_EQ(denormal.document->nodes[0].number, 1e-310);
  EXPECT_THAT(denormal.Places(), IsEmpty());
}

TEST(Json, TooLargeNumbersAreRefused) {
  for (const std::string& number :
       {std::string("1e999"), std::string("-1e999"), Repeat("9", 400),
        std::string("0.001e9999999999999999999999"), "0." + Repeat("0", 400) + "1e800"}) {
    ReadText read("[1, " + number + "]");
    EXPECT_FALSE(read.document) << number;
    EXPECT_THAT(read.Places(), ElementsAre("1:5 number-range"));
    EXPECT_THAT(read.Messages(), HasSubstr("out of range"));
  }
}

struct Mistake {
  std::string text;
  std::string place;    // of the only diagnostic
  std::string message;  // part of it
};

void ExpectMistakes(const std::vector<Mistake>& mistakes, DocumentFormat format) {
  for (const Mistake& mistake : mistakes) {
    ReadText read(mistake.text, format);
    EXPECT_FALSE(read.document) << mistake.text;
    EXPECT_THAT(read.Places(), ElementsAre(mistake.place)) << mistake.text;
    EXPECT_THAT(read.Messages(), HasSubstr(mistake.message)) << mistake.text;
  }
}

TEST(Json, EachMistakeHasItsMessageAndPlace) {
  ExpectMistakes(
      {
          {"", "1:1 empty-document", "the document is empty"},
          {" \n\t ", "2:3 empty-document", "the document is empty"},
          {"\xef\xbb\xbf", "1:4 empty-document", "the document is empty"},
          {"{\"a\":1}{\"b\":2}", "1:8 syntax", "nothing may follow"},
          {"[1] x", "1:5 syntax", "nothing may follow"},
          {"{'a': 1}", "1:2 syntax", "keys stand in double quotes"},
          {"['a']", "1:2 syntax", "text stands in double quotes"},
          {"{a: 1}", "1:2 syntax", "keys need double quotes: \"a\""},
          {"[abc]", "1:2 syntax", "text needs double quotes: \"abc\""},
          {"{\"a\" 1}", "1:6 syntax", "expected ':'"},
          {"{\"a\": 1 \"b\": 2}", "1:9 syntax", "expected ',' or '}'"},
          {"[1 2]", "1:4 syntax", "expected ',' or ']'"},
          {"[1, 2}", "1:6 syntax (1:1)", "expected ']', since an array is open"},
          {"{\"a\": 1]", "1:8 syntax (1:1)", "expected '}', since an object is open"},
          {"[\"a\": 1]", "1:5 syntax", "an array has no keys"},
          {"[1,\n", "2:1 syntax (1:1)", "the document ends inside an array"},
          {"{\"a\": {\"b\"", "1:11 syntax (1:7)", "the document ends inside an object"},
          {"[1,,2]", "1:4 syntax", "a value is missing before this ','"},
          {"[,1]", "1:2 syntax", "a value is missing before this ','"},
          {"[1,]", "1:3 syntax", "unless the file name ends in .jsonc"},
          {"{\"a\":1,}", "1:7 syntax", "unless the file name ends in .jsonc"},
          {"[1] // x", "1:5 syntax", "comments need a file name that ends in .jsonc"},
          {"/* x */ 1", "1:1 syntax", "comments need a file name that ends in .jsonc"},
          {"[1] # x", "1:5 syntax", "comments begin with '//'"},
          {"[NaN]", "1:2 syntax", "numbers are finite"},
          {"[Infinity]", "1:2 syntax", "numbers are finite"},
          {"[-Infinity]", "1:2 syntax", "numbers are finite"},
          {"[010]", "1:2 syntax", "leading zeros"},
          {"[0x10]", "1:2 syntax", "decimal"},
          {"[+1]", "1:2 syntax", "leading '+'"},
          {"[.5]", "1:2 syntax", "begin with a digit"},
          {"[5.]", "1:2 syntax", "digits must follow the '.'"},
          {"[1e]", "1:2 syntax", "digits must follow the exponent"},
          {"[-]", "1:2 syntax", "digits must follow the '-'"},
          {"[1_000]", "1:3 syntax", "expected ',' or ']'"},
          {"[True]", "1:2 syntax", "write 'true'"},
          {"[FALSE]", "1:2 syntax", "write 'false'"},
          {"[\"a\nb\"]", "1:2 syntax", "not closed on its line"},
          {"[\"a", "1:2 syntax", "not closed on its line"},
          {"[\"a\tb\"]", "1:4 syntax", "write \\u0009"},
          {"[\"\\x41\"]", "1:3 syntax", "unknown escape"},
          {"[\"\\u12g4\"]", "1:3 syntax", "four hexadecimal digits"},
          {"[\"\\ud800\"]", "1:3 encoding", "half of a surrogate pair"},
          {"[\"\\udc00\\ud800\"]", "1:3 encoding", "half of a surrogate pair"},
          {"[\"\\ud800\\u0041\"]", "1:3 encoding", "half of a surrogate pair"},
          {"[\"\xc0\xaf\"]", "1:3 encoding", "byte 0xC0 at byte offset 2"},
          {"[\"abcdefgh\xed\xa0\x80\"]", "1:11 encoding", "byte 0xED at byte offset 10"},
          {std::string("{}\0", 3), "1:3 encoding", "NUL byte at byte offset 2"},
          {"\xff\xfe{\0}\0", "1:1 encoding", "UTF-16"},
          {std::string("{\0}\0", 4), "1:2 encoding", "UTF-16"},
      },
      DocumentFormat::kJson);
}

TEST(Json, CommentsAndTrailingCommasNeedJsonc) {
  ReadText read("// start\n{ /* a\n * b */ \"a\": [1, 2,], // end\n \"b\": 3,\n} // last",
                DocumentFormat::kJsonc);
  ASSERT_TRUE(read.document) << read.Messages();
  EXPECT_EQ(TreeText(*read.document), R"({"a": [1, 2], "b": 3})");
  ExpectMistakes(
      {
          {"// only this", "1:13 empty-document", "empty"},
          {"[1 /* x", "1:4 syntax", "the comment is not closed"},
          {"[1 /*/ ]", "1:4 syntax", "the comment is not closed"},
          {"[,]", "1:2 syntax", "a value is missing"},
          {"[1,,]", "1:4 syntax", "a value is missing"},
          {"{,}", "1:2 syntax", "expected a key"},
          {"[1 / 2]", "1:4 syntax", "unexpected '/'"},
      },
      DocumentFormat::kJsonc);
}

TEST(Json, AllDuplicateKeysAreReportedWithBothPlaces) {
  ReadText read("{\"a\": 1,\n \"b\": {\"c\": 1, \"c\": 2},\n \"\\u0061\": 3,\n \"a\": 4}");
  EXPECT_THAT(read.Places(), ElementsAre("2:16 duplicate-key (2:8)", "3:2 duplicate-key (1:2)",
                                         "4:2 duplicate-key (1:2)"));
  EXPECT_THAT(read.Messages(), HasSubstr("the key 'a' stands twice"));
  // With so many keys that they are hashed.
  std::string many = "{";
  for (int i = 0; i < 100; ++i) many += "\"k" + std::to_string(i) + "\": 1,\n";
  ReadText hashed(many + "\"k7\": 2}");
  EXPECT_THAT(hashed.Places(), ElementsAre("101:1 duplicate-key (8:1)"));
}

TEST(Json, NestingHasALimit) {
  std::string deepest = Repeat("[", kMaxNesting) + Repeat("]", kMaxNesting);
  EXPECT_TRUE(ReadText(deepest).document);
  ReadText deeper("[" + deepest + "]");
  EXPECT_FALSE(deeper.document);
  EXPECT_THAT(deeper.Places(), ElementsAre("1:65 nesting-limit"));
  EXPECT_EQ(deeper.diagnostics.exit_code(), ExitCode::kLimit);
  for (std::string_view open : {"[", "{\"a\":"}) {
    std::string text = Repeat(open, 1'000'000);
    double start = CpuSeconds();
    ReadText read(text);
    double time = CpuSeconds() - start;
    EXPECT_FALSE(read.document);
    EXPECT_THAT(read.Messages(), HasSubstr("nested deeper than 64"));
    EXPECT_LT(time, 1.0);  // about 5 ms
  }
}

TEST(Json, LongKeysAndByteOrderMarksAreFine) {
  ReadText read("\xef\xbb\xbf{\"" + std::string(2000, 'k') + "\":\t1\r\n}");
  ASSERT_TRUE(read.document) << read.Messages();
  EXPECT_EQ(read.document->nodes[1].key.size(), 2000u);
}

TEST(Json, FormatComesFromTheNameOrTheFirstCharacter) {
  EXPECT_EQ(FormatOf("a.json", "x"), DocumentFormat::kJson);
  EXPECT_EQ(FormatOf("a.JSONC", "x"), DocumentFormat::kJsonc);
  EXPECT_EQ(FormatOf("a.yaml", "{"), DocumentFormat::kYaml);
  EXPECT_EQ(FormatOf("a.yml", "{"), DocumentFormat::kYaml);
  EXPECT_EQ(FormatOf("<stdin>", "\xef\xbb\xbf \n{"), DocumentFormat::kJson);
  EXPECT_EQ(FormatOf("<stdin>", "// x\n{"), DocumentFormat::kJsonc);
  EXPECT_EQ(FormatOf("<stdin>", "texgraph: 1"), DocumentFormat::kYaml);
}

// --- JSONTestSuite ------------------------------------------------------------------------------

std::filesystem::path SuiteFolder() {
  return std::filesystem::path(TEXGRAPH_SOURCE_DIR "/../shared/data/json_test_suite/test_parsing");
}

std::string FileText(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::filesystem::path> SuiteFiles(std::string_view prefix) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(SuiteFolder())) {
    if (entry.path().filename().string().starts_with(prefix)) files.push_back(entry.path());
  }
  return files;
}

TEST(JsonTestSuite, AcceptsWhatMustBeAccepted) {
  if (!std::filesystem::exists(SuiteFolder())) GTEST_SKIP() << "JSONTestSuite is not there";
  auto files = SuiteFiles("y_");
  EXPECT_EQ(files.size(), 95u);
  for (const auto& path : files) {
    ReadText read(FileText(path));
    EXPECT_TRUE(read.document) << path << read.Messages();
    // Two of these files have a key twice. That is well-formed JSON but no graph: the tree is read,
    // and the key reported.
    bool duplicate = path.filename().string().starts_with("y_object_duplicated_key");
    EXPECT_EQ(read.diagnostics.error_count(), duplicate ? 1u : 0u) << path << read.Messages();
    if (duplicate) {
      EXPECT_THAT(read.Places()[0], HasSubstr("duplicate-key"));
    }
  }
}

TEST(JsonTestSuite, RefusesWhatMustBeRefused) {
  if (!std::filesystem::exists(SuiteFolder())) GTEST_SKIP() << "JSONTestSuite is not there";
  auto files = SuiteFiles("n_");
  EXPECT_EQ(files.size(), 188u);
  for (const auto& path : files) {
    ReadText read(FileText(path));
    EXPECT_FALSE(read.document) << path;
    EXPECT_EQ(read.diagnostics.all().size(), 1u) << path << read.Messages();
  }
}

// The files about which the standard leaves a choice: 64 levels at most, finite numbers, UTF-8.
TEST(JsonTestSuite, ChoosesWhereTheStandardLeavesAChoice) {
  if (!std::filesystem::exists(SuiteFolder())) GTEST_SKIP() << "JSONTestSuite is not there";
  for (const auto& path : SuiteFiles("i_")) {
    ReadText read(FileText(path));
    std::string name = path.filename().string();
    bool accepted = name.find("int.json") != std::string::npos ||
                    name.find("negative_int") != std::string::npos ||
                    name.find("underflow") != std::string::npos ||
                    name.find("huge_neg_exp") != std::string::npos ||
                    name.find("BOM_empty_object") != std::string::npos;
    EXPECT_EQ(read.document.has_value(), accepted) << path << read.Messages();
  }
}

}  // namespace
}  // namespace texgraph::graph
