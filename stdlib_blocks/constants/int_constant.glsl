// SPDX-License-Identifier: Apache-2.0
/// One whole number, to be used in several places.
/// @param value the number @default 0
int int_constant(int value) { return value; }
