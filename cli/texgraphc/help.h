// SPDX-License-Identifier: Apache-2.0
// What --help prints. docs/texgraphc.md says the same at length; a test compares the options of
// both.
#pragma once

#include <string_view>

namespace texgraph::cli {

inline constexpr std::string_view kHelp = R"(usage: texgraphc [options] GRAPH...

Compiles texture graphs (JSON, JSONC or YAML) into small fragment shaders. Beside each shader it writes a
manifest, a JSON file that says all that an engine needs to bind the shader. '-' reads standard input.

Output
  -o FILE               write the shader to FILE, '-' for standard output; with several graphs, or with a '/'
                        at the end, the folder for all outputs (default: GRAPH-NAME.frag in the current folder)
  --manifest FILE       write the manifest to FILE instead of beside the shader
  --target TARGET       glsl330 (default), glsl450 or spirv
  --emit FORM           shader (default), or function: a GLSL function to paste into a shader of your own
  --set NAME=VALUE      give a parameter another value; may be repeated
  --validate            show GLSL to glslang before it is written, as SPIR-V always is
  -j N                  compile N graphs at the same time; 0 is one for each core (default: 1)

Input
  -I FOLDER             look for blocks in FOLDER before the library; may be repeated
  --root FOLDER         read images from inside FOLDER only, wherever the graph says they are; may be repeated
  --format FORMAT       json, jsonc or yaml, whatever the file's name says

Dependencies
  -MD                   write the names of all files that were read to OUTPUT.d, for make and ninja
  -MF FILE              write them to FILE
  -MT TARGET            the target in that file (default: the output)

Messages
  --color WHEN          auto (default), always or never
  -w                    no warnings
  -Werror               warnings are errors
  --dump-after PHASE    print the intermediate form after build, specialize, simplify, differentiate, legalize,
                        or all of them, to standard error (with '-o -' to standard output); may be repeated

Information
  --list-blocks         list the blocks with a line on each, and exit
  --print-reference BLOCK
                        print the ports of a block, and exit
  -h, --help            print this, and exit
  --version             print the version, and exit

Exit codes: 0 done, 1 a graph or block is wrong, 2 the command line is wrong, 3 a file cannot be read or
written, 4 a limit was reached, 70 a mistake of texgraphc's own.
)";

}  // namespace texgraph::cli
