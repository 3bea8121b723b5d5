// SPDX-License-Identifier: Apache-2.0
/// What is left of a value above the next lower whole number: from 0 up to but not including 1,
/// also below zero.
/// @param value the value
genType fraction(genType value) { return fract(value); }
