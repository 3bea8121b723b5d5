// SPDX-License-Identifier: Apache-2.0
#include "cli/texgraphc/depfile.h"

#include <gtest/gtest.h>

namespace texgraph::cli {
namespace {

TEST(PrintDepfile, OneNameALine) {
  EXPECT_EQ(PrintDepfile("a.frag", {"a.json", "b.png"}), "a.frag: \\\n  a.json \\\n  b.png\n");
  EXPECT_EQ(PrintDepfile("a.frag", {}), "a.frag:\n");
}

TEST(PrintDepfile, NamesOnce) {
  EXPECT_EQ(PrintDepfile("a", {"x", "y", "x"}), "a: \\\n  x \\\n  y\n");
}

// GCC writes these for files of such names (gcc -MD -MT 'a b' ...).
TEST(PrintDepfile, EscapesAsGccDoes) {
  EXPECT_EQ(PrintDepfile("a b", {"c#d", "e$f", "g\\h", "i\\ j", "k\\\\ l"}),
            "a\\ b: \\\n  c\\#d \\\n  e$$f \\\n  g\\h \\\n  i\\\\\\ j \\\n  k\\\\\\\\\\ l\n");
}

}  // namespace
}  // namespace texgraph::cli
