// The whole public API of lasius::lasius.
#pragma once

#include "lasius/batch.h"
#include "lasius/clearance.h"
#include "lasius/components.h"
#include "lasius/error.h"
#include "lasius/generate.h"
#include "lasius/geometry.h"
#include "lasius/grid.h"
#include "lasius/map_io.h"
#include "lasius/output.h"
#include "lasius/params.h"
#include "lasius/path.h"
#include "lasius/planner.h"
#include "lasius/shortest_walk.h"
#include "lasius/stop.h"
#include "lasius/version.h"
