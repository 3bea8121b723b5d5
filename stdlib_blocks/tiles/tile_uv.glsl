// SPDX-License-Identifier: Apache-2.0
/// The coordinate within a tile, from (0, 0) at its lower left corner to (1, 1): what is drawn with
/// it is in every tile.
/// @param tile the tile
vec2 tile_uv(Tile tile) { return tile.local; }

/// @param tile the cell in space
vec3 tile_uv(Tile3 tile) { return tile.local; }
