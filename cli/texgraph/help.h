// SPDX-License-Identifier: Apache-2.0
// What --help prints. docs/rendering.md says the same at length; a test compares the options of
// both.
#pragma once

#include <string_view>

namespace texgraph::cli {

inline constexpr std::string_view kTexgraphHelp = R"(usage: texgraph COMMAND [options] ...

Commands
  render                draw a texture graph or a compiled shader to PNG or OpenEXR files
  tiles                 make a set of tiles that fit together, of pictures of a material

'texgraph COMMAND --help' lists a command's options.

  -h, --help            print this, and exit
  --version             print the version, and exit
)";

inline constexpr std::string_view kRenderHelp = R"(usage: texgraph render [options] INPUT -o FILE

Draws a texture graph (JSON, JSONC or YAML), or a shader by its manifest, without a window.
'-' reads a graph from standard input.

Picture
  -o FILE               write the picture to FILE (.png or .exr), '-' for standard output
  --format FORMAT       png or exr, whatever the file is called (default: by its extension; png without one)
  --size SIZE           WxH, or N for a square, in pixels (default: 512)
  --uv U0,V0,U1,V1      the part of texture space to draw: left, bottom, right, top (default: 0,0,1,1)
  --output NAME         the graph's output to draw (default: color, or the first one; of a mesh, lit)
  --bits N              for each channel: PNG 8 (default) or 16, OpenEXR 16 (half, default) or 32 (float)
  --time T              the value of the input 'time', in seconds (default: 0)

On a mesh
  --mesh MESH           plane, wall, sphere, cube, cylinder, or a binary glTF file (.glb): draw the graph's outputs
                        on it, lit; --output NAME draws one of them, unlit
  --camera YAW,PITCH[,DISTANCE]
                        where it is seen from: degrees to the right and up, and in the mesh's units how far from
                        its middle (default: so far that all of it is seen)
  --fov DEGREES         the angle of view, from the bottom to the top (default: 30)
  --light YAW,PITCH     where the key light comes from: degrees from the camera's own yaw, and up (default: -45,45)
  --tile N, --tile NU,NV
                        repeat the texture so often where it would be once (default: 1)
  --relief H            how high a height of 1 is, without an output 'normal', in sides of the texture (default: 0.02)
  --samples N           for each pixel: 1, 4, 16 (default) or 64
  --background COLOR    like #30343a, or none: then the picture has alpha
  --turntable           let the camera go once around, over --frames N

Several pictures
  --frames N            draw N frames (up to 9999) to numbered files: FILE.0001.png and so on
  --time T0,T1          let the time go from T0 to T1, which the frame after the last would have
  --sweep NAME[=A,B]    let a uniform parameter go from one end of its range, or from A, to the other, or B
  --contact-sheet       one picture of all outputs in a grid; with --sweep, --turntable or --time T0,T1, of the frames
                        (default: 9); --size is the size of one

Graph
  --set NAME=VALUE      give a parameter another value; may be repeated
  -I FOLDER             look for blocks in FOLDER before the library; may be repeated
  --root FOLDER         read images, and a manifest's shader, from inside FOLDER only; may be repeated
  --target TARGET       glsl330 (default) or glsl450

Driver
  --context CONTEXT     auto (default), egl or osmesa
  --timeout T           give up after so many seconds (default: 60)

Messages
  --color WHEN          auto (default), always or never
  -q                    don't say how the picture was made, and show no progress
  -h, --help            print this, and exit

Exit codes: 0 done, 1 the graph is wrong, 2 the command line is wrong, 3 a file cannot be read or written, 4 a
limit was reached, 5 there is no context or the driver failed, 70 a mistake of texgraph's own.
)";

inline constexpr std::string_view kTilesHelp = R"(usage: texgraph tiles [options] MAP [MAP ...]

Makes a set of tiles that fit together wherever their colours agree, of one picture or of several maps of one material
(PNG or JPEG, of one size), which are cut alike. Writes a pack of all tiles for each map, and a JSON file that says
what a program must know to draw them.

Tiles
  --tile-size N         the side of a tile in pixels (default: 256); a map must be twice as large
  --corners N           how many colours corners have: 2 (default) to 4, which make 16, 81 or 256 tiles
  --edges H,V           instead: how many colours edges have that lie, and that stand, 1 to 4 each
  --wraps               the maps repeat: what goes out on one side comes in on the other
  --seed N              another set (default: 0)
  --candidates N        among how many places the best are searched: 8 to 1024 (default: 256)
  --own-middles         more variety, but more seams: each tile has a place of its own in its middle. For what has no order
  --even                no grid seen from afar: places whose light and dark parts cancel. For what has no order
  --weights W,W,...     how much each map counts where seams are searched (default: all alike)

Files
  -o FILE               write the pack to FILE (.png), '-' for standard output; of several maps once for each
                        (default: MAP.tiles.png in the current folder)
  --json FILE           what a program must know (default: .json beside the first pack; none beside standard output)
  --corner-pack         with --edges: also Wei's second pack, for corners, in FILE.corners.png beside each pack

Pictures for people, of the first map
  --view FILE           the tiles apart, with their colours marked
  --tiling FILE         a tiling with random colours
  --tiling-size CxR     how many tiles it has, or N for a square (default: 8)

Messages
  --report              print how visible the seams are, for each edge and tile, to standard output
  --color WHEN          auto (default), always or never
  -q                    don't say what was made, and show no progress
  -h, --help            print this, and exit

Exit codes: 0 done, 1 a map is wrong or too small, 2 the command line is wrong, 3 a file cannot be read or written, 4 a
limit was reached, 70 a mistake of texgraph's own.
)";

}  // namespace texgraph::cli
