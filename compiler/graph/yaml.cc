// SPDX-License-Identifier: Apache-2.0
// Built on libfyaml's parser events. Its document tree is not used: resolving an alias bomb there
// takes minutes, and its messages go to stderr.
#include "compiler/graph/yaml.h"

#include <fmt/format.h>
#include <libfyaml.h>

#include <algorithm>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "compiler/graph/document_builder.h"
#include "compiler/graph/encoding.h"
#include "compiler/graph/number.h"

namespace texgraph::graph {
namespace {

// libfyaml scans a flow collection to its end before the first event of it, so that a million open
// brackets cost it seconds. Texts with as many unclosed ones as this are refused beforehand.
constexpr int kMaxUnclosedBrackets = 1000;

struct ParserDelete {
  void operator()(fy_parser* parser) const { fy_parser_destroy(parser); }
};
struct DiagDelete {
  void operator()(fy_diag* diag) const { fy_diag_destroy(diag); }
};

// A finished node with an anchor, or one that is still open.
struct Anchor {
  uint32_t begin = 0;
  uint32_t end = 0;  // 0: still open
  int height = 0;
};

// What a plain scalar is.
enum class PlainKind : uint8_t { kText, kNull, kBool, kNumber, kNotFinite };

class YamlReader {
 public:
  YamlReader(SourceId source, std::string_view text, Document& document, Diagnostics& diagnostics)
      : source_(source),
        text_(text),
        offset_(ByteOrderMarkLength(text)),
        document_(document),
        diagnostics_(diagnostics),
        builder_(source, document, diagnostics) {}

  bool Read();

 private:
  // What is open: an object waits for a key and a value in turn.
  struct Level {
    bool object;
    bool has_key = false;
    std::string anchor;
    uint32_t node = 0;
  };

  bool Handle(fy_event& event);
  bool HandleNode(fy_event& event);
  bool CheckNodeProperties(fy_event& event);
  bool OpenContainer(fy_event& event, DocumentKind kind);
  bool CloseContainer(fy_event& event);
  bool ReadKey(fy_event& event);
  bool ReadScalar(fy_event& event);
  bool ReadAlias(fy_event& event);
  void FinishValue(const std::string& anchor, uint32_t node);

  bool Fail(DiagnosticKind kind, SourceRange range, std::string message) {
    diagnostics_.Error(kind, range, std::move(message));
    return false;
  }
  bool ReportParserError();
  bool CheckBrackets();

  size_t Offset(const fy_mark* mark) const {
    return mark == nullptr ? text_.size() : std::min(mark->input_pos + offset_, text_.size());
  }
  SourceRange Range(fy_event& event) const;
  SourceRange TokenRange(fy_token* token) const;
  SourceRange MarkedRange(fy_token* token, char mark) const;
  static std::string_view Text(fy_token* token) {
    size_t length = 0;
    const char* text = token == nullptr ? nullptr : fy_token_get_text(token, &length);
    return text == nullptr ? std::string_view() : std::string_view(text, length);
  }
  std::string_view InSource(std::string_view text, SourceRange range);
  std::string AnchorName(fy_event& event) {
    return std::string(Text(fy_event_get_anchor_token(&event)));
  }

  SourceId source_;
  std::string_view text_;
  size_t offset_;  // of what libfyaml sees
  Document& document_;
  Diagnostics& diagnostics_;
  DocumentBuilder builder_;
  std::unique_ptr<fy_diag, DiagDelete> parser_diagnostics_;
  std::unique_ptr<fy_parser, ParserDelete> parser_;
  std::vector<Level> levels_;
  std::unordered_map<std::string, Anchor> anchors_;
  size_t alias_nodes_ = 0;
  int documents_ = 0;
};

bool YamlReader::CheckBrackets() {
  int open = 0;
  for (size_t i = 0; i < text_.size(); ++i) {
    char c = text_[i];
    if (c == '[' || c == '{') ++open;
    if ((c == ']' || c == '}') && open > 0) --open;
    if (open > kMaxUnclosedBrackets) {
      auto at = static_cast<uint32_t>(i);
      return Fail(DiagnosticKind::kNestingLimit, {source_, at, at + 1},
                  fmt::format("arrays and objects are nested deeper than {}", kMaxNesting));
    }
    bool control = static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\r' && c != '\t';
    if (control || c == 0x7f) {
      auto at = static_cast<uint32_t>(i);
      return Fail(DiagnosticKind::kSyntax, {source_, at, at + 1},
                  fmt::format("control character; write \"\\x{:02x}\"", static_cast<unsigned>(c)));
    }
  }
  return true;
}

bool YamlReader::Read() {
  // libfyaml takes a tab on a line of its own for a mistake.
  if (text_.find_first_not_of(" \t\r\n", offset_) == std::string_view::npos) {
    return Fail(DiagnosticKind::kEmptyDocument, {source_, 0, 0}, "the document is empty");
  }
  if (!CheckBrackets()) return false;
  fy_diag_cfg diag_config;
  fy_diag_cfg_default(&diag_config);
  diag_config.fp = nullptr;  // nothing on stderr
  diag_config.level = FYET_ERROR;
  parser_diagnostics_.reset(fy_diag_create(&diag_config));
  fy_parse_cfg config{};
  config.diag = parser_diagnostics_.get();
  config.flags = static_cast<fy_parse_cfg_flags>(FYPCF_QUIET | FYPCF_DISABLE_DEPTH_LIMIT |
                                                 FYPCF_JSON_NONE | FYPCF_DEFAULT_VERSION_1_2);
  parser_.reset(fy_parser_create(&config));
  std::string_view seen = text_.substr(offset_);
  if (parser_diagnostics_ == nullptr || parser_ == nullptr ||
      fy_parser_set_string(parser_.get(), seen.data(), seen.size()) != 0) {
    return Fail(DiagnosticKind::kOutOfMemory, {source_, 0, 0}, "no memory for the YAML parser");
  }
  fy_diag_set_collect_errors(parser_diagnostics_.get(), true);
  while (fy_event* event = fy_parser_parse(parser_.get())) {
    bool ok = Handle(*event);
    fy_parser_event_free(parser_.get(), event);
    if (!ok) return false;
  }
  if (fy_parser_get_stream_error(parser_.get())) return ReportParserError();
  if (document_.nodes.empty() ||
      (document_.nodes[0].kind == DocumentKind::kNull && document_.nodes[0].text.empty())) {
    return Fail(DiagnosticKind::kEmptyDocument, {source_, 0, 0}, "the document is empty");
  }
  return true;
}

bool YamlReader::ReportParserError() {
  void* iterator = nullptr;
  const fy_diag_error* error = fy_diag_errors_iterate(parser_diagnostics_.get(), &iterator);
  if (error == nullptr) return Fail(DiagnosticKind::kSyntax, {source_, 0, 0}, "this is no YAML");
  auto at = static_cast<uint32_t>(error->fyt == nullptr ? text_.size()
                                                        : Offset(fy_token_start_mark(error->fyt)));
  uint32_t end = at < text_.size() ? at + 1 : at;
  return Fail(DiagnosticKind::kSyntax, {source_, at, end}, Printable(error->msg));
}

SourceRange YamlReader::TokenRange(fy_token* token) const {
  if (token == nullptr) return {source_, 0, 0};
  return {source_, static_cast<uint32_t>(Offset(fy_token_start_mark(token))),
          static_cast<uint32_t>(Offset(fy_token_end_mark(token)))};
}

// libfyaml's marks leave out the '&' of anchors and the '*' of aliases.
SourceRange YamlReader::MarkedRange(fy_token* token, char mark) const {
  SourceRange range = TokenRange(token);
  if (range.begin > 0 && text_[range.begin - 1] == mark) --range.begin;
  return range;
}

SourceRange YamlReader::Range(fy_event& event) const {
  fy_token* token = fy_event_get_token(&event);
  if (token == nullptr)
    return {source_, static_cast<uint32_t>(text_.size()), static_cast<uint32_t>(text_.size())};
  if (event.type == FYET_ALIAS) return MarkedRange(token, '*');
  SourceRange range = TokenRange(token);
  if (event.type != FYET_SCALAR) return range;
  fy_scalar_style style = fy_token_scalar_style(token);
  bool quoted = style == FYSS_SINGLE_QUOTED || style == FYSS_DOUBLE_QUOTED;
  // The marks leave out the quotes, too.
  if (quoted && range.begin > 0 && range.end < text_.size()) {
    --range.begin;
    ++range.end;
  }
  return range;
}

// `text` as a view into the source where it stands there as it is, else kept by the document.
std::string_view YamlReader::InSource(std::string_view text, SourceRange range) {
  std::string_view written = text_.substr(range.begin, range.end - range.begin);
  if (written == text) return written;
  if (written.size() == text.size() + 2 && written.substr(1, text.size()) == text) {
    return written.substr(1, text.size());
  }
  return builder_.Keep(std::string(text));
}

bool YamlReader::Handle(fy_event& event) {
  switch (event.type) {
    case FYET_DOCUMENT_START:
      if (++documents_ == 1) return true;
      return Fail(DiagnosticKind::kYamlFeature, Range(event),
                  "a second document begins here; one file holds one graph");
    case FYET_MAPPING_END:
    case FYET_SEQUENCE_END:
      return CloseContainer(event);
    case FYET_MAPPING_START:
    case FYET_SEQUENCE_START:
    case FYET_SCALAR:
    case FYET_ALIAS:
      return HandleNode(event);
    default:
      return true;
  }
}

bool YamlReader::HandleNode(fy_event& event) {
  if (!CheckNodeProperties(event)) return false;
  if (!levels_.empty() && levels_.back().object && !levels_.back().has_key) return ReadKey(event);
  switch (event.type) {
    case FYET_MAPPING_START:
      return OpenContainer(event, DocumentKind::kObject);
    case FYET_SEQUENCE_START:
      return OpenContainer(event, DocumentKind::kArray);
    case FYET_SCALAR:
      return ReadScalar(event);
    default:
      return ReadAlias(event);
  }
}

bool YamlReader::CheckNodeProperties(fy_event& event) {
  fy_token* tag = event.type == FYET_ALIAS ? nullptr : fy_event_get_tag_token(&event);
  if (tag == nullptr) return true;
  return Fail(DiagnosticKind::kYamlFeature, TokenRange(tag), "tags are not supported");
}

bool YamlReader::OpenContainer(fy_event& event, DocumentKind kind) {
  DocumentNode node;
  node.kind = kind;
  node.range = Range(event);
  if (node.range.end <= node.range.begin) {
    node.range.end = std::min(node.range.begin + 1, static_cast<uint32_t>(text_.size()));
  }
  Level level{kind == DocumentKind::kObject, false, AnchorName(event),
              static_cast<uint32_t>(document_.nodes.size())};
  if (!builder_.Open(node)) return false;
  if (!level.anchor.empty()) anchors_[level.anchor] = {};
  levels_.push_back(std::move(level));
  return true;
}

bool YamlReader::CloseContainer(fy_event& event) {
  Level level = std::move(levels_.back());
  levels_.pop_back();
  SourceRange range = Range(event);
  builder_.Close(std::max(range.end, document_.nodes[level.node].range.begin + 1));
  FinishValue(level.anchor, level.node);
  return true;
}

// Afterwards the anchor, if there is one, stands for the nodes from `node` on.
void YamlReader::FinishValue(const std::string& anchor, uint32_t node) {
  if (!levels_.empty()) levels_.back().has_key = false;
  if (anchor.empty()) return;
  anchors_[anchor] = {node, static_cast<uint32_t>(document_.nodes.size()), builder_.last_height()};
}

bool YamlReader::ReadKey(fy_event& event) {
  SourceRange range = Range(event);
  if (event.type != FYET_SCALAR) {
    const char* what = event.type == FYET_ALIAS ? "an alias as a key is not supported"
                                                : "a key must be plain text";
    return Fail(DiagnosticKind::kYamlFeature, range, what);
  }
  if (fy_token* anchor = fy_event_get_anchor_token(&event)) {
    return Fail(DiagnosticKind::kYamlFeature, MarkedRange(anchor, '&'),
                "anchors on keys are not supported");
  }
  fy_token* token = fy_event_get_token(&event);
  std::string_view text = Text(token);
  if (text == "<<" && fy_token_scalar_style(token) == FYSS_PLAIN) {
    return Fail(DiagnosticKind::kYamlFeature, range, "merge keys are not supported");
  }
  builder_.SetKey(InSource(text, range), range);
  levels_.back().has_key = true;
  return true;
}

// JSON's numbers, and those that begin or end with their '.': no two loaders read these
// differently.
bool IsNumber(std::string_view text) {
  if (text[0] == '-') text.remove_prefix(1);
  size_t point = text.find('.');
  if (point == std::string_view::npos) {
    return !text.starts_with('-') && SpellNumber(text).length == text.size();
  }
  std::string_view whole = text.substr(0, point), rest = text.substr(point + 1);
  size_t digits = std::min(rest.find_first_not_of("0123456789"), rest.size());
  if (whole.empty() && digits == 0) return false;
  NumberSpelling spelling = SpellNumber(whole);
  if (whole.starts_with('-') || spelling.length != whole.size() || spelling.has_fraction) {
    return false;
  }
  rest.remove_prefix(digits);
  if (rest.empty()) return true;
  if (rest[0] != 'e' && rest[0] != 'E') return false;
  rest.remove_prefix(rest.size() > 1 && (rest[1] == '+' || rest[1] == '-') ? 2 : 1);
  return !rest.empty() && rest.find_first_not_of("0123456789") == std::string_view::npos;
}

// YAML 1.2's JSON schema: "010", "0x10", "1_000" and "yes" are text, so that they are refused where
// a number or a bool is needed, and not misread. `number` is set to what from_chars can read.
PlainKind Classify(std::string_view text, std::string_view& number) {
  if (text.empty() || text == "~" || text == "null") return PlainKind::kNull;
  if (text == "true" || text == "false") return PlainKind::kBool;
  constexpr std::string_view kNotFinite[] = {".inf", ".Inf", ".INF", ".nan", ".NaN", ".NAN"};
  bool sign = text[0] == '+' || text[0] == '-';
  for (std::string_view word : kNotFinite) {
    if (text.substr(sign ? 1 : 0) == word) return PlainKind::kNotFinite;
  }
  number = text.substr(text[0] == '+' ? 1 : 0);
  if (number.empty() || (number.size() < text.size() && number[0] == '-')) return PlainKind::kText;
  return IsNumber(number) ? PlainKind::kNumber : PlainKind::kText;
}

bool YamlReader::ReadScalar(fy_event& event) {
  fy_token* token = fy_event_get_token(&event);
  std::string_view text = Text(token);
  DocumentNode node;
  node.kind = DocumentKind::kString;
  node.range = Range(event);
  bool plain = token == nullptr || fy_token_scalar_style(token) == FYSS_PLAIN;
  std::string_view number;
  switch (plain ? Classify(text, number) : PlainKind::kText) {
    case PlainKind::kText:
      break;
    case PlainKind::kNull:
      node.kind = DocumentKind::kNull;
      break;
    case PlainKind::kBool:
      node.kind = DocumentKind::kBool;
      node.boolean = text == "true";
      break;
    case PlainKind::kNumber:
      if (!SetNumber(number, node, diagnostics_)) return false;
      break;
    case PlainKind::kNotFinite:
      return Fail(DiagnosticKind::kNumberRange, node.range,
                  fmt::format("numbers are finite: '{}' is none", text));
  }
  if (node.kind == DocumentKind::kString || node.kind == DocumentKind::kNull) {
    node.text = InSource(text, node.range);
  }
  if (node.kind == DocumentKind::kString) {
    if (FindBadByte(node.text) && node.text.find('\0') == std::string_view::npos) {
      return Fail(DiagnosticKind::kEncoding, node.range, "the escapes make no valid UTF-8");
    }
  }
  auto index = static_cast<uint32_t>(document_.nodes.size());
  if (!builder_.Add(node)) return false;
  FinishValue(AnchorName(event), index);
  return true;
}

bool YamlReader::ReadAlias(fy_event& event) {
  SourceRange range = Range(event);
  std::string name(Text(fy_event_get_token(&event)));
  auto found = anchors_.find(name);
  if (found == anchors_.end()) {
    return Fail(DiagnosticKind::kSyntax, range,
                fmt::format("the alias '{}' has no anchor before it", Printable(name)));
  }
  const Anchor& anchor = found->second;
  if (anchor.end == 0) {
    return Fail(DiagnosticKind::kYamlFeature, range,
                fmt::format("recursive alias: '{}' stands inside its own anchor", Printable(name)));
  }
  alias_nodes_ += anchor.end - anchor.begin;
  if (alias_nodes_ > kMaxAliasNodes) {
    return Fail(DiagnosticKind::kAliasLimit, range,
                fmt::format("aliases expand to more than {} values", kMaxAliasNodes));
  }
  if (!builder_.AddCopy(anchor.begin, anchor.end, anchor.height, range)) return false;
  FinishValue({}, 0);
  return true;
}

}  // namespace

bool ReadYaml(SourceId source, std::string_view text, Document& document,
              Diagnostics& diagnostics) {
  return YamlReader(source, text, document, diagnostics).Read();
}

}  // namespace texgraph::graph
