#include "tools/console/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "core/base/printable.h"

namespace lasius::tool {

bool wants_progress(const Messages& messages) {
  if (messages.progress == ProgressMode::always) return true;
  return messages.progress == ProgressMode::automatic && !messages.quiet &&
         ::isatty(STDERR_FILENO) == 1;
}

ProgressLine::ProgressLine(bool shown, std::int64_t total, double limit_seconds)
    : shown_(shown), total_(total), limit_seconds_(limit_seconds) {}

ProgressLine::~ProgressLine() {
  if (drawn_) std::fputs("\r\033[K", stderr);
}

void ProgressLine::update(std::int64_t done, const std::string& note) {
  const auto now = Clock::now();
  if (!shown_ || now < next_) return;
  next_ = now + std::chrono::milliseconds(100);
  drawn_ = true;

  const double elapsed = std::chrono::duration<double>(now - start_).count();
  if (total_ <= 0) {
    std::fprintf(stderr, "\r\033[K%.0f s  %s", elapsed, printable(note).c_str());
    return;
  }
  constexpr int kWidth = 24;
  const double share = std::min(1.0, static_cast<double>(done) / static_cast<double>(total_));
  const auto filled = static_cast<std::size_t>(share * kWidth);
  double left = share > 0 ? elapsed * (1 - share) / share : 0;
  if (limit_seconds_ > 0) left = std::min(left, std::max(0.0, limit_seconds_ - elapsed));
  const std::string bar = std::string(filled, '#') + std::string(kWidth - filled, '.');
  std::fprintf(stderr, "\r\033[K[%s] %lld/%lld  %s  %.0f s left", bar.c_str(),
               static_cast<long long>(done), static_cast<long long>(total_),
               printable(note).c_str(), left);
}

}  // namespace lasius::tool
