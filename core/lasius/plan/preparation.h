// To prepare a map: to make its visibility graph before the first request to `exact`.
#pragma once

#include <cstdint>
#include <string_view>

#include "lasius/base/stop.h"
#include "lasius/export.h"

namespace lasius {

/// How a map is prepared: every vertex of its tangent visibility graph learns which others it sees,
/// so that queries to `exact` look around from start and goal only (Oh & Leong 2017, ENLSVG).
struct PrepareOptions {
  int threads = 0;  ///< at most 1024; 0: as many as OpenMP gives; never changes what is prepared
  /// A graph that would take more is abandoned. A Workspace takes 32 bytes more for each vertex.
  std::int64_t max_bytes = std::int64_t{1} << 30;
  /// Ends the preparation; what was made of the graph is dropped. Planner::make_prepared
  /// asks it while components are labelled, too.
  StopCondition stop = {};
  /// Gives corners hub labels as well: then a query looks around nowhere, and searches nothing. Not
  /// for a disc. Where they would take too much, planning goes on by the graph alone.
  bool labels = false;
  /// Labels with more entries a vertex than this, on average, are abandoned.
  int max_label_entries = 128;
  /// And those whose entries would take more than this, 20 bytes each, or the lists of what 8 x 8
  /// cells see, 8 bytes for each vertex that they do, and 8 more where not all of the free ones do.
  std::int64_t max_label_bytes = std::int64_t{64} << 20;
};

/// What came of it.
struct Preparation {
  /// How it ended.
  enum class State {
    none,       ///< not asked for, or gone with an edit
    ready,      ///< `exact` plans on it
    too_large,  ///< abandoned: it would take more than max_bytes
    stopped,    ///< abandoned: the stop condition said so
  };
  State state = State::none;  ///< how it ended
  /// Corners of obstacles at which a path may bend; 0 if stopped before they were counted.
  std::int64_t vertices = 0;
  std::int64_t edges = 0;  ///< from vertex to vertex in sight, if ready
  std::int64_t bytes = 0;  ///< held, if ready
  double seconds = 0;      ///< spent
  /// Of hub labels.
  struct Labels {
    State state = State::none;  ///< how they ended; too_large: as PrepareOptions say
    std::int64_t entries = 0;   ///< hubs that vertices know, if ready
    std::int64_t bytes = 0;     ///< held, with what each tile of cells sees, if ready
    double seconds = 0;         ///< spent, beside those of the graph
  };
  Labels labels = {};  ///< where they were asked for
};
/// The name, as in "too_large".
LASIUS_EXPORT std::string_view to_string(Preparation::State) noexcept;

}  // namespace lasius
