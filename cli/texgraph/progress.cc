// SPDX-License-Identifier: Apache-2.0
#include "cli/texgraph/progress.h"

#include <fmt/format.h>
#include <stdlib.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string_view>

#include "compiler/base/output_files.h"

namespace texgraph::cli {
namespace {

constexpr double kSecondsBetween = 0.05;

double Now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

bool IsTerminal() {
  const char* terminal = getenv("TERM");
  return isatty(STDERR_FILENO) != 0 && terminal != nullptr && std::string_view(terminal) != "dumb";
}

uint32_t Columns() {
  winsize size = {};
  if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return 80;
  return size.ws_col;
}

}  // namespace

std::string ProgressLine(uint32_t done, uint32_t total, double seconds, uint32_t columns,
                         ProgressUnit unit) {
  std::string text = unit == ProgressUnit::kFrames
                         ? fmt::format("{} of {} frames", done, total)
                         : fmt::format("{} %", uint64_t{100} * done / total);
  if (done > 0 && done < total) {
    const double left = std::ceil(seconds / done * (total - done));
    text += left < 120 ? fmt::format(", {:.0f} s left", left)
                       : fmt::format(", {:.0f} min left", std::ceil(left / 60));
  }
  // Two brackets, a blank, and a last column that some terminals wrap at.
  const size_t used = text.size() + 4;
  const size_t width = columns > used ? std::min<size_t>(30, columns - used) : 0;
  if (width < 5) return text.substr(0, columns > 0 ? columns - 1 : 0);
  const size_t full = width * done / total;
  return fmt::format("[{}{}] {}", std::string(full, '#'), std::string(width - full, '.'), text);
}

Progress::Progress(uint32_t total, bool wanted, ProgressUnit unit)
    : total_(total), unit_(unit), is_shown_(wanted && total > 1 && IsTerminal()), start_(Now()) {
  if (is_shown_) Draw();
}

Progress::~Progress() {
  if (is_shown_) (void)WriteAll(STDERR_FILENO, "\r\x1b[K");
}

void Progress::Reach(uint32_t done) {
  done_ = std::clamp(done, done_, total_);
  if (is_shown_ && (done_ == total_ || Now() - drawn_ >= kSecondsBetween)) Draw();
}

void Progress::Draw() {
  drawn_ = Now();
  const std::string line = ProgressLine(done_, total_, drawn_ - start_, Columns(), unit_);
  (void)WriteAll(STDERR_FILENO, "\r" + line + "\x1b[K");
}

}  // namespace texgraph::cli
