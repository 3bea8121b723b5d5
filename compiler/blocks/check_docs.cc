// SPDX-License-Identifier: Apache-2.0
// The lines that begin with "///": the block's texts, and what "@" tags say of its ports.
#include <algorithm>
#include <charconv>
#include <set>
#include <span>

#include "compiler/base/builtin_input.h"
#include "compiler/base/text.h"
#include "compiler/blocks/check.h"
#include "compiler/blocks/doc_tags.h"
#include "compiler/blocks/limits.h"
#include "compiler/blocks/parser.h"

namespace texgraph::blocks {
namespace {

using ir::TypeId;

struct Setting {  // an inline tag of a parameter
  Piece tag;
  Piece value;
};

struct ParameterDoc {
  Piece name;
  std::string help;
  std::vector<Setting> settings;
};

constexpr std::string_view kInlineTags[] = {
    "@default",   "@length",   "@range",       "@unit",     "@ordered",
    "@not_below", "@computed", "@multiple_of", "@grid_of",  "@transitions",
    "@below",     "@one_of",   "@as_long_as",  "@asked_at", "@colors_of"};
constexpr std::string_view kTags[] = {"@param", "@return", "@source"};

void AppendLine(std::string& text, std::string_view line, char separator) {
  if (line.empty()) return;
  if (!text.empty()) text += separator;
  text += line;
}

class DocChecker {
 public:
  DocChecker(Program& program, File& file)
      : program_(program), file_(file), text_(program.sources.Text(file.source)) {}

  void Run() {
    for (const FunctionAst& function : file_.ast->functions) {
      bool is_port = function.name == file_.name || IsField(function.name);
      ReadDocs(function.docs, is_port, function);
    }
    for (const StructAst& structure : file_.ast->structs) RefuseTags(structure.docs);
    for (const ConstantAst& constant : file_.ast->constants) RefuseTags(constant.docs);
    SetTexts();
    for (Overload& overload : file_.block.overloads) {
      FindWords(overload);
      for (Port& port : overload.inputs) SetPort(overload, port, true);
      for (Port& port : overload.outputs) SetPort(overload, port, false);
      // After all defaults, which are compared.
      for (Port& port : overload.inputs) SetOrder(overload, port);
      for (Port& port : overload.outputs) SetOneOf(overload, port);
    }
  }

 private:
  // What stands before one prototype or function.
  struct Lines {
    const FunctionAst* function;
    std::vector<ParameterDoc> parameters;
    ParameterDoc result;  // without a name
  };

  void Error(SourceRange range, std::string message) {
    // The four meanings of genType would repeat it.
    if (!reported_.insert(range.begin).second) return;
    program_.diagnostics.Error(DiagnosticKind::kBlockDoc, range, std::move(message));
  }

  bool IsField(std::string_view name) const {
    return std::ranges::any_of(file_.fields,
                               [&](const FieldInfo& field) { return field.ast->name == name; });
  }

  // --- Reading ---

  void RefuseTags(DocLines lines) {
    for (const Tag& tag : SplitTags(lines, *file_.ast, text_)) {
      if (tag.name.text.empty()) continue;
      Error(tag.name.range, "tags belong to the block's function and its prototypes, not here");
      return;
    }
  }

  void ReadDocs(DocLines lines, bool is_port, const FunctionAst& function) {
    if (lines.count == 0) return;
    if (!is_port) return RefuseTags(lines);
    Lines& run = runs_.emplace_back();
    run.function = &function;
    ParameterDoc* open = nullptr;
    for (const Tag& tag : SplitTags(lines, *file_.ast, text_)) ReadTag(tag, run, open);
  }

  // `open` is what inline tags belong to, if anything.
  void ReadTag(const Tag& tag, Lines& run, ParameterDoc*& open) {
    std::string_view name = tag.name.text;
    if (name.empty()) {
      for (const Piece& piece : tag.pieces) description_.push_back(piece.text);
      return;
    }
    bool is_inline = std::ranges::find(kInlineTags, name) != std::end(kInlineTags);
    if (is_inline && open && (open != &run.result || name == "@one_of")) {
      return ReadSetting(tag, *open);
    }
    open = nullptr;
    if (is_inline) {
      Error(tag.name.range, "'" + std::string(name) + "' stands in the text of a '@param'");
    } else if (name == "@param") {
      if (ReadParameter(tag, run)) open = &run.parameters.back();
    } else if (name == "@return") {
      for (const Piece& piece : tag.pieces) AppendLine(run.result.help, piece.text, ' ');
      open = &run.result;
    } else if (name == "@source") {
      for (const Piece& piece : tag.pieces) AppendLine(file_.block.source, piece.text, ' ');
    } else {
      std::vector<std::string_view> known(std::begin(kTags), std::end(kTags));
      known.insert(known.end(), std::begin(kInlineTags), std::end(kInlineTags));
      Error(tag.name.range,
            "there is no tag '" + Printable(name, 40) + "'" + DidYouMean(name, known));
    }
  }

  bool ReadParameter(const Tag& tag, Lines& run) {
    ParameterDoc doc;
    Piece first = tag.pieces.empty() ? Piece{} : tag.pieces[0];
    doc.name = TakeWord(first);
    if (doc.name.text.empty()) {
      Error(tag.name.range, "'@param' needs the name of a parameter");
      return false;
    }
    doc.help = first.text;
    for (size_t i = 1; i < tag.pieces.size(); ++i) AppendLine(doc.help, tag.pieces[i].text, ' ');
    CheckParameterName(doc.name, *run.function);
    for (const ParameterDoc& other : run.parameters) {
      if (other.name.text == doc.name.text) {
        Error(doc.name.range, "'" + std::string(doc.name.text) + "' is described twice");
      }
    }
    run.parameters.push_back(std::move(doc));
    return true;
  }

  // It must be a parameter of the function below, or of any if a prototype is below; or a field.
  void CheckParameterName(const Piece& name, const FunctionAst& function) {
    std::vector<std::string_view> known;
    for (const FunctionAst& other : file_.ast->functions) {
      if (IsField(other.name)) known.push_back(other.name);
      bool counts = &other == &function || (!function.body && other.name == file_.name);
      if (!counts || IsField(other.name)) continue;
      for (const ParameterAst& parameter : other.parameters) known.push_back(parameter.name);
    }
    if (std::ranges::find(known, name.text) != known.end()) return;
    Error(name.range, "there is no parameter '" + Printable(name.text, 60) + "'" +
                          DidYouMean(name.text, known));
  }

  bool SameLine(const Piece& a, const Piece& b) const {
    return text_.substr(a.range.end, b.range.begin - a.range.end).find('\n') ==
           std::string_view::npos;
  }

  void ReadSetting(const Tag& tag, ParameterDoc& doc) {
    Piece value = tag.pieces.empty() ? Piece{} : tag.pieces[0];
    if (tag.name.text == "@ordered") {
      if (!value.text.empty() && SameLine(tag.name, value)) {
        return Error(tag.name.range, "'@ordered' ends its line; it takes no value");
      }
      if (!value.text.empty()) AppendLine(doc.help, value.text, ' ');
    } else if (value.text.empty()) {
      Error(tag.name.range, "'" + std::string(tag.name.text) + "' needs a value behind it");
      return;
    }
    for (const Setting& other : doc.settings) {
      if (other.tag.text == tag.name.text) {
        Error(tag.name.range, "'" + std::string(tag.name.text) + "' stands here twice");
      }
    }
    // The next lines go on with the parameter's text.
    for (size_t i = 1; i < tag.pieces.size(); ++i) AppendLine(doc.help, tag.pieces[i].text, ' ');
    doc.settings.push_back({tag.name, value});
  }

  // --- Texts ---

  // The first sentence ends at a '.' that a blank or the end follows.
  void SetTexts() {
    std::string all;
    for (std::string_view line : description_) all += std::string(line) + "\n";
    size_t end = 0;
    bool found = false;
    for (; end < all.size() && !found; ++end) {
      found = all[end] == '.' &&
              (end + 1 == all.size() || IsBlank(all[end + 1]) || all[end + 1] == '\n');
    }
    std::string summary = all.substr(0, end);
    std::ranges::replace(summary, '\n', ' ');
    auto trim = [](std::string text) {
      size_t first = text.find_first_not_of(" \n");
      if (first == std::string::npos) return std::string();
      return text.substr(first, text.find_last_not_of(" \n") - first + 1);
    };
    file_.block.summary = trim(std::move(summary));
    file_.block.details = trim(all.substr(end));
  }

  // --- Ports ---

  // What this overload's own lines say of a port, else what the prototypes' do, else any other
  // overload's.
  const ParameterDoc* FindDoc(const Overload& overload, std::string_view name) const {
    const FunctionAst* own = file_.functions[overload.function].ast;
    auto find = [&](auto&& matches) -> const ParameterDoc* {
      for (const Lines& run : runs_) {
        if (!matches(*run.function)) continue;
        for (const ParameterDoc& doc : run.parameters) {
          if (doc.name.text == name) return &doc;
        }
      }
      return nullptr;
    };
    if (auto doc = find([&](const FunctionAst& f) { return &f == own; })) return doc;
    if (auto doc = find([](const FunctionAst& f) { return !f.body; })) return doc;
    return find([](const FunctionAst&) { return true; });
  }

  void SetPort(const Overload& overload, Port& port, bool is_input) {
    if (!is_input && port.name == "result") {
      const FunctionAst* own = file_.functions[overload.function].ast;
      for (const Lines& run : runs_) {
        if (port.help.empty() || run.function == own) {
          if (!run.result.help.empty()) port.help = run.result.help;
        }
      }
    }
    const ParameterDoc* doc = FindDoc(overload, port.name);
    if (!doc) return;
    port.help = doc->help;
    gen_type_ = overload.gen_type;
    // The default is checked against the range.
    for (std::string_view tag : {"@unit", "@range", "@length", "@default", "@ordered", "@not_below",
                                 "@multiple_of", "@grid_of", "@colors_of", "@transitions", "@below",
                                 "@as_long_as", "@asked_at", "@one_of", "@computed"}) {
      for (const Setting& setting : doc->settings) {
        if (setting.tag.text == tag) SetSetting(port, setting, is_input);
      }
    }
  }

  void SetSetting(Port& port, const Setting& setting, bool is_input) {
    std::string_view tag = setting.tag.text;
    if (tag == "@unit") {
      port.unit = setting.value.text;
    } else if (tag == "@range") {
      SetRange(port, setting);
    } else if (tag == "@length") {
      SetLength(port, setting);
    } else if (tag == "@one_of") {
      if (is_input) Error(setting.tag.range, "an input has no '@one_of'");
    } else if (NamesInputs(tag)) {
      if (!is_input) Error(setting.tag.range, "an output has no '" + std::string(tag) + "'");
    } else if (tag == "@computed") {
      SetComputed(port, setting);
    } else if (!is_input || port.kind == PortKind::kTexture) {
      Error(setting.tag.range, is_input ? "a texture has no default" : "an output has no default");
    } else {
      SetDefault(port, setting.value);
    }
  }

  static bool ReadNumber(std::string_view text, double& value) {
    if (text.starts_with('+')) text.remove_prefix(1);
    auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() && value - value == 0;
  }

  void SetRange(Port& port, const Setting& setting) {
    Piece rest = setting.value;
    Piece least = TakeWord(rest), most = TakeWord(rest);
    double minimum = 0, maximum = 0;
    bool read = ReadNumber(least.text, minimum) && ReadNumber(most.text, maximum);
    TypeId type = ValueType(port);
    if (!read || !rest.text.empty() || minimum > maximum) {
      Error(setting.value.range, "a range is two numbers, the lesser first: '@range 0 1'");
    } else if (!type || !ir::IsVector(ElementOf(type)) || ir::IsBool(ElementOf(type))) {
      Error(setting.tag.range, "only numbers have a range");
    } else {
      port.minimum = minimum;
      port.maximum = maximum;
    }
  }

  // Of an array; else the type itself.
  TypeId ElementOf(TypeId type) const {
    const ir::Types& types = program_.module.types;
    return types.Kind(type) == ir::TypeKind::kArray ? types.ElementType(type, 0) : type;
  }

  static bool ReadLength(std::string_view text, uint32_t& value) {
    auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() && value >= 1 &&
           value <= kMaxArrayLength;
  }

  void SetLength(Port& port, const Setting& setting) {
    Piece rest = setting.value;
    Piece least = TakeWord(rest), most = TakeWord(rest);
    uint32_t minimum = 0, maximum = 0;
    bool read = ReadLength(least.text, minimum) && ReadLength(most.text, maximum);
    if (port.kind != PortKind::kTemplate || !IsUnsized(program_.module.types, port.type)) {
      Error(setting.tag.range, "only an array without a length of its own has '@length'");
    } else if (!read || !rest.text.empty() || minimum > maximum) {
      Error(setting.value.range,
            "a length is two numbers from 1 to 1024, the lesser first: '@length 3 256'");
    } else {
      port.min_length = minimum;
      port.max_length = maximum;
    }
  }

  void SetComputed(Port& port, const Setting& setting) {
    Piece rest = setting.value;
    Piece name = TakeWord(rest);
    if (port.kind != PortKind::kTemplate || !port.default_value) {
      Error(setting.tag.range, "only a 'const' parameter with a default is computed");
    } else if (!IsIdentifier(name.text)) {
      Error(name.range, "'@computed' needs the name of a block");
    } else {
      port.computed_by = name.text;
      port.advice = rest.text;
    }
  }

  void SetDefault(Port& port, const Piece& value) {
    TypeId type = ValueType(port);
    const File* shared = program_.SharedFile();
    bool is_constant =
        file_.constants.contains(value.text) || (shared && shared->constants.contains(value.text));
    bool is_name = IsIdentifier(value.text) && value.text != "true" && value.text != "false";
    if (is_name && !is_constant) return SetDefaultName(port, value);
    Expr* expr =
        ParseDocExpression(*file_.ast, value.range, program_.sources, program_.diagnostics);
    if (!expr || reported_.contains(expr->range.begin)) return;
    port.default_value =
        CheckConstant(program_, file_, *expr, type, true, DiagnosticKind::kBlockDoc);
    if (!port.default_value) {
      reported_.insert(expr->range.begin);
      return;
    }
    CheckDefaultRange(port, value);
  }

  // An input of the graph, or the word of an enumeration; of a field it may be a block.
  void SetDefaultName(Port& port, const Piece& value) {
    for (const EnumWord& word : port.words) {
      if (word.word != value.text) continue;
      uint32_t bits = static_cast<uint32_t>(word.value);
      port.default_value = program_.module.Intern(ir::kInt, {&bits, 1});
      return;
    }
    std::vector<std::string_view> known;
    for (const EnumWord& word : port.words) known.push_back(word.word);
    for (const BuiltinInput& input : kBuiltinInputs) {
      known.push_back(input.name);
      if (input.name != value.text) continue;
      TypeId type = program_.module.types.Find(input.type);
      bool fits = type == port.type || (type == ir::kFloat && ir::IsVector(port.type) &&
                                        ir::ScalarOf(port.type) == ir::Scalar::kFloat);
      if (port.kind == PortKind::kValue && fits) {
        port.default_input = value.text;
      } else if (port.kind == PortKind::kValue && port.type == gen_type_ && ir::IsFloat(type)) {
        // "uv" is the default of a genType where that is vec2; the others have none.
      } else {
        Error(value.range, "'" + std::string(value.text) + "' is a " + std::string(input.type) +
                               " that is not known when the shader is made; this port takes " +
                               program_.module.types.Text(port.type));
      }
      return;
    }
    if (port.kind == PortKind::kField) {
      port.default_block = value.text;
      return;
    }
    Error(value.range, "there is no constant and no input '" + Printable(value.text, 60) + "'" +
                           DidYouMean(value.text, known));
  }

  void CheckDefaultRange(const Port& port, const Piece& value) {
    TypeId type = program_.module.constant(port.default_value).type;
    if (port.max_length > 0) {
      uint32_t length = program_.module.types.ElementCount(type);
      if (length < port.min_length || length > port.max_length) {
        Error(value.range, "the default is not as long as '@length' says");
        return;
      }
      type = ElementOf(type);
    }
    if (!ir::IsVector(type) || ir::IsBool(type)) return;
    bool known_word = port.words.empty();
    for (uint32_t word : program_.module.Words(port.default_value)) {
      double number = ir::NumberOf(type, word);
      // The range is of doubles, the default of floats: 0.1 is in [0.1, 1].
      auto nearest = [&](double limit) {
        return ir::IsFloat(type) ? static_cast<double>(static_cast<float>(limit)) : limit;
      };
      if (port.minimum && (number < nearest(*port.minimum) || number > nearest(*port.maximum))) {
        Error(value.range, "the default is outside of the range");
        return;
      }
      for (const EnumWord& choice : port.words) known_word = known_word || choice.value == number;
    }
    if (!known_word) Error(value.range, "the default is none of the port's words");
  }

  // --- Least and greatest values, multiples ---

  // Set when all inputs are known.
  static bool NamesInputs(std::string_view tag) {
    return tag == "@ordered" || tag == "@not_below" || tag == "@multiple_of" || tag == "@grid_of" ||
           tag == "@colors_of" || tag == "@transitions" || tag == "@below" ||
           tag == "@as_long_as" || tag == "@asked_at";
  }

  // Of a field, the type of its results.
  TypeId ValueType(const Port& port) const { return program_.module.types.ValueOf(port.type); }

  bool HoldsNumbers(const Port& port) const {
    TypeId type = ValueType(port);
    return ir::IsVector(type) && !ir::IsBool(type) && port.words.empty();
  }

  void SetOrder(const Overload& overload, Port& port) {
    const ParameterDoc* doc = FindDoc(overload, port.name);
    if (!doc) return;
    for (const Setting& setting : doc->settings) {
      if (setting.tag.text == "@ordered") SetOrdered(port, setting);
      if (setting.tag.text == "@not_below") SetNotBelow(overload, port, setting);
      if (setting.tag.text == "@multiple_of") SetSizeOf(overload, port, setting, port.multiple_of);
      if (setting.tag.text == "@grid_of") SetSizeOf(overload, port, setting, port.grid_of);
      if (setting.tag.text == "@colors_of") SetColorsOf(overload, port, setting);
      if (setting.tag.text == "@transitions") SetTransitions(overload, port, setting);
      if (setting.tag.text == "@below") SetBelow(overload, port, setting);
      if (setting.tag.text == "@as_long_as") SetAsLongAs(overload, port, setting);
      if (setting.tag.text == "@asked_at") SetAskedAt(overload, port, setting);
    }
  }

  void SetOrdered(Port& port, const Setting& setting) {
    if (!HoldsNumbers(port) || ir::IsScalar(ValueType(port))) {
      return Error(setting.tag.range, "only vectors of numbers are '@ordered'");
    }
    port.ordered = true;
    if (!port.default_value) return;
    std::span<const uint32_t> words = program_.module.Words(port.default_value);
    CheckDefaultOrder(port, words.first(words.size() - 1), words.subspan(1), setting);
  }

  // The input that a tag names; null, and reported, if there is none.
  const Port* FindInput(const Overload& overload, const Setting& setting) {
    return FindInput(overload, setting.value);
  }
  const Port* FindInput(const Overload& overload, const Piece& piece) {
    const std::string_view name = piece.text;
    auto input = std::ranges::find(overload.inputs, name, &Port::name);
    if (input != overload.inputs.end()) return &*input;
    std::vector<std::string_view> known;
    for (const Port& other : overload.inputs) known.push_back(other.name);
    Error(piece.range, "there is no input '" + Printable(name, 60) + "'" + DidYouMean(name, known));
    return nullptr;
  }

  // Columns and rows that go by a texture's: "@multiple_of", "@grid_of".
  void SetSizeOf(const Overload& overload, const Port& port, const Setting& setting,
                 std::optional<uint32_t>& size_of) {
    const Port* texture = FindInput(overload, setting);
    if (!texture) return;
    if (port.kind != PortKind::kTemplate || port.type != ir::kIvec2 ||
        texture->kind != PortKind::kTexture) {
      return Error(setting.tag.range,
                   "'" + std::string(setting.tag.text) +
                       "' is for a 'const ivec2', and names an input that is a texture");
    }
    size_of = static_cast<uint32_t>(texture - overload.inputs.data());
  }

  void SetColorsOf(const Overload& overload, Port& port, const Setting& setting) {
    const Port* texture = FindInput(overload, setting);
    if (!texture) return;
    const bool is_number = port.type == ir::kInt || port.type == ir::kIvec2;
    if (port.kind != PortKind::kTemplate || !is_number || texture->kind != PortKind::kTexture) {
      return Error(setting.tag.range,
                   "'@colors_of' is for a 'const int' or 'const ivec2', and names an input that is "
                   "a texture");
    }
    port.colors_of = static_cast<uint32_t>(texture - overload.inputs.data());
  }

  bool IsListOfInts(const Port& port) const {
    return IsList(port) && ElementOf(port.type) == ir::kInt;
  }

  void SetTransitions(const Overload& overload, Port& port, const Setting& setting) {
    const Port* families = FindInput(overload, setting);
    if (!families) return;
    if (families == &port || !IsListOfInts(port) || !IsListOfInts(*families)) {
      return Error(setting.tag.range,
                   "'@transitions' is for a 'const int[]', and names another one");
    }
    port.transitions_of = static_cast<uint32_t>(families - overload.inputs.data());
  }

  bool IsList(const Port& port) const {
    return port.kind == PortKind::kTemplate && IsUnsized(program_.module.types, port.type);
  }

  void SetAsLongAs(const Overload& overload, Port& port, const Setting& setting) {
    const Port* other = FindInput(overload, setting);
    if (!other) return;
    if (other == &port || !IsList(port) || !IsList(*other)) {
      return Error(setting.tag.range, "'@as_long_as' is for a list, and names another one");
    }
    port.as_long_as = static_cast<uint32_t>(other - overload.inputs.data());
  }

  // An int, a list of them, a function that gives one, or a map.
  bool HoldsIndices(const Port& port) const {
    return port.kind == PortKind::kTexture || IsListOfInts(port) || ValueType(port) == ir::kInt;
  }

  void SetBelow(const Overload& overload, Port& port, const Setting& setting) {
    const Port* counted = FindInput(overload, setting);
    if (!counted) return;
    const bool counts =
        counted->kind == PortKind::kTexture ||
        (counted->kind == PortKind::kTemplate &&
         (counted->type == ir::kInt || counted->type == ir::kIvec2 || IsListOfInts(*counted)));
    if (counted == &port || !counts || !HoldsIndices(port)) {
      return Error(setting.tag.range,
                   "'@below' is for ints and maps, and names an input that is a texture, or a "
                   "'const' int, ivec2 or int[]");
    }
    port.below = static_cast<uint32_t>(counted - overload.inputs.data());
  }

  void SetAskedAt(const Overload& overload, Port& port, const Setting& setting) {
    const Port* coordinate = FindInput(overload, setting);
    if (!coordinate) return;
    const bool is_place = coordinate->kind == PortKind::kValue && ir::IsVector(coordinate->type) &&
                          ir::IsFloat(coordinate->type);
    if (coordinate == &port || !is_place || port.kind != PortKind::kValue || !port.default_value) {
      return Error(setting.tag.range,
                   "'@asked_at' is for a value with a constant as its default, and names another "
                   "input of floats");
    }
    port.asked_at = static_cast<uint32_t>(coordinate - overload.inputs.data());
  }

  // Of the return value what this overload's own lines say, else those of any.
  const std::vector<Setting>* OutputSettings(const Overload& overload, const Port& port) const {
    if (port.name != "result") {
      const ParameterDoc* doc = FindDoc(overload, port.name);
      return doc ? &doc->settings : nullptr;
    }
    const FunctionAst* own = file_.functions[overload.function].ast;
    const Lines* found = nullptr;
    for (const Lines& run : runs_) {
      if (run.result.help.empty() || (found && run.function != own)) continue;
      found = &run;
    }
    return found ? &found->result.settings : nullptr;
  }

  void SetOneOf(const Overload& overload, Port& port) {
    const std::vector<Setting>* settings = OutputSettings(overload, port);
    if (!settings) return;
    for (const Setting& setting : *settings) {
      if (setting.tag.text != "@one_of") continue;
      if (port.type != ir::kInt) return Error(setting.tag.range, "only an int is '@one_of'");
      for (Piece rest = setting.value; !rest.text.empty();) {
        const Port* input = FindInput(overload, TakeWord(rest));
        if (!input) return;
        if (!HoldsIndices(*input)) {
          return Error(setting.tag.range, "'@one_of' names inputs that are ints, lists or maps");
        }
        port.one_of.push_back(static_cast<uint32_t>(input - overload.inputs.data()));
      }
    }
  }

  void SetNotBelow(const Overload& overload, Port& port, const Setting& setting) {
    const Port* least = FindInput(overload, setting);
    if (!least) return;
    if (least == &port || !HoldsNumbers(port) || !HoldsNumbers(*least) ||
        ValueType(*least) != ValueType(port)) {
      return Error(setting.value.range,
                   "'@not_below' names another input of numbers of the same type");
    }
    port.not_below = static_cast<uint32_t>(least - overload.inputs.data());
    if (!port.default_value || !least->default_value) return;
    CheckDefaultOrder(port, program_.module.Words(least->default_value),
                      program_.module.Words(port.default_value), setting);
  }

  void CheckDefaultOrder(const Port& port, std::span<const uint32_t> least,
                         std::span<const uint32_t> most, const Setting& setting) {
    for (size_t i = 0; i < least.size(); ++i) {
      if (ir::NumberOf(ValueType(port), most[i]) >= ir::NumberOf(ValueType(port), least[i]))
        continue;
      return Error(setting.tag.range, "the defaults break '" + std::string(setting.tag.text) + "'");
    }
  }

  // --- Enumerations ---

  static std::string Prefix(std::string_view name) {
    std::string prefix(name);
    for (char& c : prefix) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    return prefix + "_";
  }

  // Of two parameters `row` and `row_mode`, ROW_MODE_FIXED is the latter's.
  void FindWords(Overload& overload) {
    std::vector<std::pair<std::string, Port*>> ports;
    for (Port& port : overload.inputs) {
      if (port.kind == PortKind::kTemplate && port.type == ir::kInt) {
        ports.emplace_back(Prefix(port.name), &port);
      }
    }
    if (ports.empty()) return;
    std::map<std::string_view, ConstantInfo> constants = file_.constants;
    if (const File* shared = program_.SharedFile()) {
      constants.insert(shared->constants.begin(), shared->constants.end());
    }
    for (const auto& [name, info] : constants) {
      bool is_int = info.value && program_.module.constant(info.value).type == ir::kInt;
      Port* best = nullptr;
      size_t length = 0;
      for (const auto& [prefix, port] : ports) {
        if (!is_int || !name.starts_with(prefix) || name.size() <= prefix.size()) continue;
        if (prefix.size() <= length) continue;
        best = port;
        length = prefix.size();
      }
      if (!best) continue;
      // What blocks share makes words only where the file speaks of it: a parameter that happens to
      // have such a name is a number. Nor are they added to words of the file's own.
      const std::string_view prefix = name.substr(0, length);
      const bool is_own = file_.constants.contains(name);
      const auto own = file_.constants.lower_bound(prefix);
      const bool has_own = own != file_.constants.end() && own->first.starts_with(prefix);
      if (!is_own && (has_own || text_.find(prefix) == text_.npos)) continue;
      std::string word(name.substr(length));
      for (char& c : word) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
      int32_t value = static_cast<int32_t>(program_.module.Words(info.value)[0]);
      best->words.push_back({std::move(word), value});
    }
    for (auto& [prefix, port] : ports) {
      // One constant makes no choice.
      if (port->words.size() == 1) port->words.clear();
      std::ranges::stable_sort(port->words, {}, &EnumWord::value);
    }
  }

  Program& program_;
  File& file_;
  std::string_view text_;
  std::vector<std::string_view> description_;
  std::vector<Lines> runs_;
  std::set<uint32_t> reported_;
  TypeId gen_type_;  // of the overload whose ports are set
};

}  // namespace

void CheckDocs(Program& program, File& file) { DocChecker(program, file).Run(); }

}  // namespace texgraph::blocks
