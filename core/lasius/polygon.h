// Component lasius::polygon: all of it.
#pragma once

#include "lasius/polygon_plan.h"
#include "lasius/polygon_world.h"
