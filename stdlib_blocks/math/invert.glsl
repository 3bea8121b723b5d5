// SPDX-License-Identifier: Apache-2.0
/// Turns a value around within a range: `pivot - value`, so that with a pivot of 1 black becomes
/// white.
/// @param value the value
/// @param pivot the value that 0 becomes @default 1
genType invert(genType value, genType pivot) { return pivot - value; }
