// SPDX-License-Identifier: Apache-2.0
/// A whole number, or a yes or no, as a number: true is 1.
/// @param value the value
float to_float(int value) { return float(value); }
float to_float(uint value) { return float(value); }
float to_float(bool value) { return float(value); }
