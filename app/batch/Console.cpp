// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/Console.h"

#include <algorithm>
#include <cstdio>
#include <fmt/format.h>
#include <unistd.h>

namespace toile::batch {
namespace {

constexpr int barWidth = 24;

std::string timeLeft(double seconds, double fraction) {
    if (fraction < 0.02) return "";
    const int left = static_cast<int>(seconds * (1 - fraction) / fraction);
    return fmt::format(", {}:{:02} left", left / 60, left % 60);
}

/// Unlike fmt::print this does not throw where the terminal is gone, when there is still a checkpoint to be written.
void say(const std::string& text) {
    std::fputs(text.c_str(), stderr);
    std::fflush(stderr);
}

} // namespace

std::string oneLine(std::string_view text) {
    std::string line;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        const auto next = static_cast<unsigned char>(i + 1 < text.size() ? text[i + 1] : 0);
        if (byte < 0x20 || byte == 0x7f) line += byte == '\n' ? "\\n" : fmt::format("\\u{:04x}", byte);
        else if (byte == 0xc2 && next >= 0x80 && next < 0xa0) { // U+0080 to U+009F, of which one begins commands, too
            line += fmt::format("\\u{:04x}", next);
            ++i;
        } else line += text[i];
    }
    return line;
}

void printError(const Error& error) {
    say(oneLine(toString(error)) + '\n');
}

void printWarnings(const std::vector<Warning>& warnings) {
    for (const Warning& warning : warnings) say(oneLine(warning.place + ": " + warning.text) + '\n');
}

ProgressBar::ProgressBar(bool quiet)
    : quiet_(quiet), terminal_(isatty(STDERR_FILENO) == 1), start_(std::chrono::steady_clock::now()), last_(start_) {}

ProgressBar::~ProgressBar() {
    if (shown_ && terminal_) say("\r\x1b[K");
}

Progress ProgressBar::progress() {
    if (quiet_) return {};
    return [this](double fraction, const std::string& what) { show(fraction, what); };
}

Progress ProgressBar::progress(std::size_t done, std::size_t parts) {
    if (quiet_) return {};
    return [this, done, parts](double fraction, const std::string& what) {
        show((static_cast<double>(done) + fraction) / static_cast<double>(parts), what);
    };
}

void ProgressBar::show(double fraction, const std::string& what) {
    const auto now = std::chrono::steady_clock::now();
    const double between = terminal_ ? 0.1 : 1.0;
    if (std::chrono::duration<double>(now - last_).count() < between) return;
    last_ = now;
    shown_ = true;
    const double elapsed = std::chrono::duration<double>(now - start_).count();
    const int full = std::clamp(static_cast<int>(fraction * barWidth), 0, barWidth);
    const std::string line = fmt::format("[{:#<{}}{:.<{}}] {:3.0f} %{}  {}", "", full, "", barWidth - full,
                                         100 * fraction, timeLeft(elapsed, fraction), oneLine(what));
    say(terminal_ ? fmt::format("\r{}\x1b[K", line) : line + '\n');
}

} // namespace toile::batch
