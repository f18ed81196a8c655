#include "core/base/waiting.h"

#include <csignal>

namespace lasius {
namespace {

volatile std::sig_atomic_t waiting = 0;

}  // namespace

Waiting::Waiting(bool waits) noexcept { waiting = waits ? 1 : 0; }
Waiting::~Waiting() { waiting = 0; }
bool Waiting::now() noexcept { return waiting != 0; }

}  // namespace lasius
