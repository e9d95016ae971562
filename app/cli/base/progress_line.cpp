#include "app/cli/base/progress_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "core/base/clean_text.h"

namespace noonmark::cli {

namespace {
constexpr std::string_view wipe = "\r\x1b[K";
constexpr int barCells = 30;
}  // namespace

ProgressLine::~ProgressLine() {
    if (shown_) console_.err << wipe << std::flush;
}

void ProgressLine::report(double fraction, std::string_view stage) {
    if (!console_.watched) return;
    const std::unique_lock lock(mutex_, std::try_to_lock);
    const auto now = std::chrono::steady_clock::now();
    if (!lock || (shown_ && now - *shown_ < std::chrono::milliseconds(100))) return;
    shown_ = now;
    const double share = std::clamp(fraction, 0.0, 1.0);
    const int filled = int(share * barCells);
    console_.err << wipe
                 << fmt::format("[{:=<{}}{:<{}}] {:3.0f} %  {}", "", filled, "", barCells - filled,
                                share * 100, cleanText(stage))
                 << std::flush;
}

}  // namespace noonmark::cli
