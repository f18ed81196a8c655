#include "lasius/stop.h"

namespace lasius {

TimeSource::~TimeSource() = default;

}  // namespace lasius
