// SPDX-License-Identifier: Apache-2.0
// A block: one GLSL file that became typed signatures and, on demand, IR functions. See
// docs/blocks.md for the language.
//
// File `stdlib_blocks/<family>/<block>.glsl` defines the function `<block>`, in one or several
// overloads (`genType` counts as four), with whatever private functions, constants and structs it
// needs. A function that a file calls but does not define is another block's, found by its name in
// the library.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/base/diagnostics.h"
#include "compiler/base/source.h"
#include "compiler/ir/module.h"

namespace texgraph::blocks {

enum class PortKind : uint8_t {
  kValue,     // any value
  kTemplate,  // "const": must be known when the shader is made
  kTexture,   // a sampler
  kField,     // a prototype without a body: a function port
};

// A word that stands for a value of an enumeration: for a parameter `const int blend`, the file's
// constants `const int BLEND_MIX = 0; const int BLEND_ADD = 1;` make the words "mix" and "add".
struct EnumWord {
  std::string word;
  int32_t value;
};

struct Port {
  std::string name;
  PortKind kind = PortKind::kValue;
  ir::TypeId type;    // kField: a field type
  SourceRange range;  // of the declaration
  std::string help;   // from "/// @param name help"
  std::string unit;   // "@unit degrees"
  // "@default": a constant of the port's type (kField: of the field's result type), or the name of
  // a built-in input ("uv"), or neither: the port must be connected.
  ir::ConstId default_value;
  std::string default_input;
  // "@default name" of a field: what stands there is this block, whose inputs are the prototype's
  // parameters of their names, else their own defaults. Whether there is such a block is not known
  // before it is needed.
  std::string default_block;
  // "@asked_at name", of a value with a constant default: evaluated for a function port, where that
  // input is the very coordinate which the port asks at, the prototype's parameter of this port's
  // name; else, and where the prototype has none, the default.
  std::optional<uint32_t> asked_at;
  // "@computed name advice": of a template port without a value, it is what this block of the
  // library gives for the ports that are named as its inputs. If that is not known when the shader
  // is made, it is the default. The advice says what to change when it is out of range.
  std::string computed_by;
  std::string advice;
  std::optional<double> minimum, maximum;  // "@range 0 1", each component
  // How many elements an array has: "@length 3 256", or 1 to kMaxArrayLength; 0 for other types.
  uint32_t min_length = 0, max_length = 0;
  bool ordered = false;  // "@ordered": no component is below the one before it
  // "@not_below name": no component is below the one of that input of the overload, which has the
  // same type.
  std::optional<uint32_t> not_below;
  // "@multiple_of name": columns and rows are multiples of those of the texture at that input, if
  // its size is known when the shader is made.
  std::optional<uint32_t> multiple_of;
  // "@grid_of name": without a value it is the columns and rows of the patterns that the texture at
  // that input packs, and it has no other value.
  std::optional<uint32_t> grid_of;
  // "@colors_of name": without a value it is the colours of the tile set at that input, of corners
  // for an int, of edges for an ivec2, and it has no other value.
  std::optional<uint32_t> colors_of;
  // "@transitions name": for m families, one more than the greatest number of the array at that
  // input, m^4 patterns, one for each way in which the four corners of a tile can be of families.
  // None is below 0 where two corners differ.
  std::optional<uint32_t> transitions_of;
  // "@below name": its numbers count what that input has: the patterns or lists of a texture, the
  // elements of an array, the fields of an ivec2 grid, or as many as an int says.
  std::optional<uint32_t> below;
  // "@as_long_as name": a list with as many elements as the one at that input.
  std::optional<uint32_t> as_long_as;
  // "@one_of name ...", of an output: what is known of its numbers. Each is one of an array, of a
  // texture, or of what stands at a value or field; of a "const int" one from 0 to below it.
  std::vector<uint32_t> one_of;
  std::vector<EnumWord> words;
  std::vector<std::string> field_parameters;  // kField: the names of the prototype's parameters
};

struct Overload {
  // The file's fields in its order, then the function's parameters that are not `out`.
  std::vector<Port> inputs;
  // The return value first (named "result"), then the out parameters.
  std::vector<Port> outputs;
  ir::TypeId gen_type;    // what genType stands for here; invalid if nothing of it is generic
  uint32_t function = 0;  // index in the file's functions
};

struct Block {
  std::string name;
  std::string family;   // "tiles"
  std::string path;     // "tiles/brick_grid.glsl"; for a user's block its path under the -I folder
  std::string summary;  // the first sentence
  std::string details;  // the rest of the text, lines kept
  std::string source;   // "@source": where the method comes from
  SourceRange range;    // of the first overload's name
  std::vector<Overload> overloads;
  const struct File* file = nullptr;  // file.h
};

// The blocks that one compilation can use: the embedded library and the folders of -I (which come
// first), each parsed when it is first asked for. Types, constants and functions go into `module`.
class Library {
 public:
  // `fold` false keeps what constants would decide, for the unoptimised leg of the tests; loop
  // bounds and template values are known all the same.
  Library(ir::Module& module, Sources& sources, Diagnostics& diagnostics,
          std::vector<std::string> folders = {}, bool fold = true);
  ~Library();

  // Null if there is no such block, or if it is wrong (then it was reported, once).
  const Block* Find(std::string_view name);
  // Whether a file of that name exists, without parsing it.
  bool Exists(std::string_view name) const;
  std::vector<std::string_view> Names() const;  // sorted
  // The struct types of types.glsl ("Tile") and the basic types; invalid if there is none.
  ir::TypeId FindType(std::string_view name);
  // The IR function of an overload for these values of its kTemplate inputs, one for each, in their
  // order and of their types; it has no parameters for them, the others are in the order of
  // `inputs`. Made once for each combination, after the functions that it calls. Invalid if
  // something is wrong with these values, a loop too long, say (reported).
  ir::FunctionId Function(const Block& block, const Overload& overload,
                          std::span<const ir::ConstId> template_values);
  // Checks the bodies of all functions in the block's file, and of what they call; Function() looks
  // only at those that are used. False if something is wrong (reported).
  bool CheckBodies(const Block& block);
  // Paths of the files outside the program that were read, for dependency files.
  const std::vector<std::string>& FilesRead() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// The embedded library, made from stdlib_blocks/ when the program is built. Sorted by name.
struct EmbeddedFile {
  std::string_view name;  // "brick_grid"
  std::string_view path;  // "tiles/brick_grid.glsl"
  std::string_view text;
};
const std::vector<EmbeddedFile>& EmbeddedFiles();

}  // namespace texgraph::blocks
