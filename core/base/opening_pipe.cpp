#include "core/base/opening_pipe.h"

#include <atomic>
#include <filesystem>
#include <system_error>

namespace lasius {
namespace {

std::atomic<int> pipes_being_opened = 0;
static_assert(std::atomic<int>::is_always_lock_free, "signal handlers read it");

bool is_named_pipe(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::is_fifo(path, ignored);
}

}  // namespace

OpeningPipe::OpeningPipe(const std::string& path) : is_pipe_(is_named_pipe(path)) {
  if (is_pipe_) ++pipes_being_opened;
}

OpeningPipe::~OpeningPipe() {
  if (is_pipe_) --pipes_being_opened;
}

bool OpeningPipe::under_way() noexcept { return pipes_being_opened > 0; }

}  // namespace lasius
