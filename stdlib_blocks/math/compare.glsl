// SPDX-License-Identifier: Apache-2.0
const int RELATION_LESS = 0;
const int RELATION_LESS_EQUAL = 1;
const int RELATION_GREATER = 2;
const int RELATION_GREATER_EQUAL = 3;
const int RELATION_EQUAL = 4;
const int RELATION_NOT_EQUAL = 5;

/// Whether one number is less than, equal to or greater than another, for `select`.
/// @param a first number
/// @param b second number @default 0
/// @param relation what is asked @default RELATION_LESS
bool compare(float a, float b, const int relation) {
  return relation == RELATION_LESS            ? a < b
         : relation == RELATION_LESS_EQUAL    ? a <= b
         : relation == RELATION_GREATER       ? a > b
         : relation == RELATION_GREATER_EQUAL ? a >= b
         : relation == RELATION_EQUAL         ? a == b
                                              : a != b;
}
