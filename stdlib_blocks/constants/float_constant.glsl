// SPDX-License-Identifier: Apache-2.0
/// One number, to be used in several places.
/// @param value the number @default 0
float float_constant(float value) { return value; }
