// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/common/progress.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>

#include "apps/common/interrupt.h"

namespace dsc::apps {

namespace {

constexpr auto interval = std::chrono::milliseconds(100);
constexpr std::size_t default_width = 80;

bool is_terminal(std::FILE* stream) { return ::isatty(::fileno(stream)) == 1; }

std::size_t terminal_width(std::FILE* stream) {
    winsize size{};
    if (::ioctl(::fileno(stream), TIOCGWINSZ, &size) != 0 || size.ws_col < 20) return default_width;
    return size.ws_col;
}

// Cuts UTF-8 text after `width` characters.
std::string shortened(const std::string& text, std::size_t width) {
    std::size_t characters = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool is_start = (static_cast<unsigned char>(text[i]) & 0xC0) != 0x80;
        if (is_start && characters++ == width) return text.substr(0, i);
    }
    return text;
}

}  // namespace

ProgressObserver::ProgressObserver(ProgressMode mode, std::FILE* stream)
    : stream_(stream),
      is_shown_(mode == ProgressMode::bar || (mode == ProgressMode::automatic && is_terminal(stream))),
      width_(terminal_width(stream)) {}

ProgressObserver::~ProgressObserver() { clear(); }

bool ProgressObserver::is_cancelled() const { return is_interrupted(); }

void ProgressObserver::progress(std::string_view stage, double fraction, std::string_view figure) {
    if (!is_shown_) return;
    const auto now = std::chrono::steady_clock::now();
    if (is_line_ && now - last_ < interval) return;
    last_ = now;

    std::string line(stage);
    if (fraction >= 0) {
        line += ' ' + std::to_string(static_cast<int>(100 * std::clamp(fraction, 0.0, 1.0))) + " %";
    }
    if (!figure.empty()) line += ", " + std::string(figure);
    // "\x1b[K" clears the rest of the line.
    std::fprintf(stream_, "\r%s\x1b[K", shortened(line, width_ - 1).c_str());
    std::fflush(stream_);
    is_line_ = true;
}

void ProgressObserver::clear() {
    if (!is_line_) return;
    std::fputs("\r\x1b[K", stream_);
    std::fflush(stream_);
    is_line_ = false;
}

}  // namespace dsc::apps
