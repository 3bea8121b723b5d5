# SPDX-License-Identifier: Apache-2.0
# Makes a C++ source of the files of stdlib_blocks/. Run with cmake -P and:
#   LIST    the file that sets TEXGRAPH_STDLIB_BLOCKS
#   FOLDER  where the files are
#   OUTPUT  the source to write
# A raw string literal ends at )glsl", which no block contains; long files are split, since compilers limit literals.
include("${LIST}")

set(entries "")
foreach(path IN LISTS TEXGRAPH_STDLIB_BLOCKS)
  cmake_path(GET path STEM name)
  list(APPEND entries "${name} ${path}")
endforeach()
# The program looks names up by halving, so they are sorted by name and not by path; a blank sorts before all that names have.
list(SORT entries)

set(text "// Made from stdlib_blocks/ by embed_blocks.cmake.\n#include \"compiler/blocks/block.h\"\n\n")
string(APPEND text "namespace texgraph::blocks {\n\n")
string(APPEND text "const std::vector<EmbeddedFile>& EmbeddedFiles() {\n")
string(APPEND text "  static const std::vector<EmbeddedFile> files = {\n")
foreach(entry IN LISTS entries)
  string(REGEX REPLACE " .*" "" name "${entry}")
  string(REGEX REPLACE ".* " "" path "${entry}")
  file(READ "${FOLDER}/${path}" content)
  string(LENGTH "${content}" length)
  string(APPEND text "      {\"${name}\", \"${path}\",\n")
  set(at 0)
  while(at LESS length)
    string(SUBSTRING "${content}" ${at} 8000 piece)
    string(APPEND text "       R\"glsl(${piece})glsl\"\n")
    math(EXPR at "${at} + 8000")
  endwhile()
  string(APPEND text "      },\n")
endforeach()
string(APPEND text "  };\n  return files;\n}\n\n}  // namespace texgraph::blocks\n")
file(WRITE "${OUTPUT}" "${text}")
