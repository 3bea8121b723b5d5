// SPDX-License-Identifier: Apache-2.0
/// A number as a whole number: the largest that is not above it. Random bits keep their bits.
/// @param value the value
int to_int(float value) { return int(floor(value)); }
int to_int(uint value) { return int(value); }
