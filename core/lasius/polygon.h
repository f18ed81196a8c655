// Component lasius::polygon: all of it.
#pragma once

#include "lasius/polygon/plan.h"
#include "lasius/polygon/world.h"
