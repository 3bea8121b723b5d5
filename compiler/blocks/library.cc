// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <utility>

#include "compiler/base/files.h"
#include "compiler/base/name_map.h"
#include "compiler/base/text.h"
#include "compiler/blocks/block.h"
#include "compiler/blocks/check.h"
#include "compiler/blocks/limits.h"
#include "compiler/blocks/lower.h"
#include "compiler/blocks/parser.h"

namespace texgraph::blocks {
namespace {

constexpr int kMaxFolderDepth = 16;
constexpr size_t kMaxFolderFiles = 100'000;
constexpr std::string_view kTypes = "types";

const EmbeddedFile* FindEmbedded(std::string_view name) {
  const std::vector<EmbeddedFile>& files = EmbeddedFiles();
  auto found = std::ranges::lower_bound(files, name, {}, &EmbeddedFile::name);
  return found != files.end() && found->name == name ? &*found : nullptr;
}

}  // namespace

struct Library::Impl : Program {
  // A file in a folder of the user's.
  struct UserFile {
    std::string path;    // as it is opened
    std::string inside;  // under the folder
    std::string second;  // another one of this name in the same folder
  };

  Impl(ir::Module& module, Sources& sources, Diagnostics& diagnostics,
       std::vector<std::string> folders, bool fold)
      : Program(module, sources, diagnostics), lowering(*this, fold) {
    for (const std::string& folder : folders) AddFolder(folder);
  }

  // --- The user's folders ---

  // What stands in an earlier folder goes first.
  void AddFolder(const std::string& folder) {
    namespace fs = std::filesystem;
    std::error_code error;
    // Sorted, so that what is found depends on the names alone.
    std::map<std::string, fs::path> found;
    fs::recursive_directory_iterator at(folder, error), end;
    if (error) {
      diagnostics.Warn(DiagnosticKind::kCannotRead, {},
                       "the block folder '" + Printable(folder) + "' cannot be read");
      return;
    }
    // Links to folders are not entered by default.
    for (size_t seen = 0; at != end && !error && seen < kMaxFolderFiles;
         at.increment(error), ++seen) {
      if (at.depth() >= kMaxFolderDepth) at.disable_recursion_pending();
      std::error_code ignored;
      bool is_file = fs::is_regular_file(at->symlink_status(ignored));
      const fs::path& path = at->path();
      if (!is_file || path.extension() != ".glsl" || !IsIdentifier(path.stem().native())) continue;
      found.emplace(path.lexically_relative(folder).generic_string(), path);
    }
    std::map<std::string, UserFile, std::less<>> here;
    for (const auto& [inside, path] : found) {
      auto [known, added] = here.try_emplace(path.stem().native(), UserFile{path, inside, {}});
      if (!added && known->second.second.empty()) known->second.second = path;
    }
    for (auto& [name, file] : here) user_files.try_emplace(name, std::move(file));
  }

  // --- Program ---

  bool HasFile(std::string_view name) const override {
    if (name == kTypes) return false;
    return user_files.contains(name) || FindEmbedded(name);
  }

  std::vector<std::string_view> FileNames() const override {
    std::vector<std::string_view> names;
    for (const EmbeddedFile& file : EmbeddedFiles()) {
      if (file.name != kTypes) names.push_back(file.name);
    }
    for (const auto& [name, file] : user_files) {
      if (name != kTypes) names.push_back(name);
    }
    std::ranges::sort(names);
    auto repeated = std::ranges::unique(names);
    names.erase(repeated.begin(), repeated.end());
    return names;
  }

  const File* SharedFile() override {
    if (!shared_tried) {
      shared_tried = true;
      if (const EmbeddedFile* embedded = FindEmbedded(kTypes)) {
        std::unique_ptr<File> file = LoadEmbedded(*embedded);
        CheckFile(*this, *file);
        shared = std::move(file);
      }
    }
    return shared.get();
  }

  File* FindFile(std::string_view name) override {
    if (File** usual = checked.Find(name)) return *usual;
    if (auto known = files.find(name); known != files.end()) {
      // A file that is being checked knows its own functions; nobody else asks for them then.
      return known->second && known->second->valid ? known->second.get() : nullptr;
    }
    if (!HasFile(name)) return nullptr;
    SharedFile();
    auto user = user_files.find(name);
    std::unique_ptr<File> file =
        user != user_files.end() ? LoadUser(name, user->second) : LoadEmbedded(*FindEmbedded(name));
    File* result = file.get();
    files.emplace(name, std::move(file));
    if (!result) return nullptr;
    if (!parse_failed) CheckFile(*this, *result);
    if (!result->valid) return nullptr;
    checked.Add(result->name, result);
    return result;
  }

  // --- Reading ---

  std::unique_ptr<File> LoadEmbedded(const EmbeddedFile& embedded) {
    std::string path(embedded.path);
    return Load(embedded.name, path, "stdlib_blocks/" + path, std::string(embedded.text));
  }

  std::unique_ptr<File> LoadUser(std::string_view name, const UserFile& user) {
    if (!user.second.empty()) {
      diagnostics.Error(DiagnosticKind::kBlockName, {},
                        "block '" + std::string(name) + "' is in two files of one folder, '" +
                            Printable(user.path) + "' and '" + Printable(user.second) + "'");
      return nullptr;
    }
    std::optional<std::string> text = ReadFile(user.path, kMaxFileBytes, {}, diagnostics);
    if (!text) return nullptr;
    files_read.push_back(user.path);
    return Load(name, user.inside, user.path, std::move(*text));
  }

  std::unique_ptr<File> Load(std::string_view name, const std::string& path, std::string shown,
                             std::string text) {
    auto file = std::make_unique<File>();
    file->name = name;
    file->path = path;
    file->family = FolderOf(path);
    file->source = sources.Add(std::move(shown), std::move(text));
    size_t errors = diagnostics.error_count();
    file->ast = ParseFile(file->source, sources, diagnostics);
    parse_failed = diagnostics.error_count() > errors;
    return file;
  }

  std::map<std::string, UserFile, std::less<>> user_files;
  std::map<std::string, std::unique_ptr<File>, std::less<>> files;
  NameMap<File*> checked;  // those that are valid
  std::unique_ptr<File> shared;
  bool shared_tried = false;
  bool parse_failed = false;  // the file that was read last
  std::vector<std::string> files_read;
  Lowering lowering;
};

Library::Library(ir::Module& module, Sources& sources, Diagnostics& diagnostics,
                 std::vector<std::string> folders, bool fold)
    : impl_(std::make_unique<Impl>(module, sources, diagnostics, std::move(folders), fold)) {}

Library::~Library() = default;

const Block* Library::Find(std::string_view name) {
  File* file = impl_->FindFile(name);
  if (!file) return nullptr;
  if (!std::exchange(file->is_described, true)) {
    const size_t errors = impl_->diagnostics.error_count();
    CheckDocs(*impl_, *file);
    file->is_described_well = impl_->diagnostics.error_count() == errors;
  }
  return file->is_described_well ? &file->block : nullptr;
}

bool Library::Exists(std::string_view name) const { return impl_->HasFile(name); }

std::vector<std::string_view> Library::Names() const { return impl_->FileNames(); }

ir::TypeId Library::FindType(std::string_view name) {
  ir::TypeId basic = impl_->module.types.Find(name);
  if (basic && basic.index < ir::kBasicTypeCount) return basic;
  const File* shared = impl_->SharedFile();
  if (!shared) return {};
  auto found = shared->structs.find(name);
  return found == shared->structs.end() ? ir::TypeId() : found->second.type;
}

ir::FunctionId Library::Function(const Block& block, const Overload& overload,
                                 std::span<const ir::ConstId> template_values) {
  size_t next = 0;
  bool fits = true;
  for (const Port& port : overload.inputs) {
    if (port.kind != PortKind::kTemplate) continue;
    fits = fits && next < template_values.size() && template_values[next] &&
           ConvertsTo(impl_->module.types, impl_->module.constant(template_values[next]).type,
                      port.type);
    ++next;
  }
  File* file = impl_->FindFile(block.name);
  if (!file || !fits || next != template_values.size()) {
    std::fprintf(stderr, "texgraph: blocks: function '%s' asked for with wrong template values\n",
                 block.name.c_str());
    std::abort();
  }
  return impl_->lowering
      .Function(*file, overload.function, overload.gen_type, template_values, block.range)
      .id;
}

bool Library::CheckBodies(const Block& block) {
  size_t errors = impl_->diagnostics.error_count();
  File* file = impl_->FindFile(block.name);
  for (uint32_t f = 0; file && f < file->functions.size(); ++f) {
    for (const Overload& overload : block.overloads) {
      const FunctionInfo& function = file->functions[f];
      if (function.needs_gen_type && !overload.gen_type) continue;
      if (!function.is_block || overload.function == f)
        impl_->lowering.CheckReachable(*file, f, overload.gen_type);
    }
  }
  return file && impl_->diagnostics.error_count() == errors;
}

const std::vector<std::string>& Library::FilesRead() const { return impl_->files_read; }

}  // namespace texgraph::blocks
