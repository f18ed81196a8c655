#include "tools/bitmap/announce.h"

#include <array>
#include <cstdio>

#include "tools/bitmap/answer.h"
#include "tools/bitmap/report.h"
#include "tools/console/streams.h"
#include "tools/console/values.h"

namespace lasius::tool {

void announce(const PreparedMap& map, const RunOptions& run) {
  if (run.messages.quiet) return;
  for (const auto& note : run.notes) message(note);
  const Preparation prepared = map.planner ? map.planner->preparation() : Preparation{};
  if (prepared.state == Preparation::State::too_large)
    message("--prepare has no effect: it would take more than " +
            std::to_string(PrepareOptions{}.max_bytes >> 20) + " MB for this map");
  if (!run.messages.verbose) return;
  std::array<char, 160> text;
  std::snprintf(text.data(), text.size(),
                map.planner
                    ? ": %d x %d cells, hash %s, read in %.1f ms, prepared in %.1f ms"
                    : ": %d x %d cells, hash %s, read in %.1f ms, interrupted after %.1f ms",
                map.width, map.height, hash_text(map.hash).c_str(), map.read_ms, map.prepare_ms);
  message(map.file + text.data());
  if (prepared.state == Preparation::State::ready) {
    std::snprintf(text.data(), text.size(), "--prepare: %lld corners, %lld edges, %.1f MB, %.1f ms",
                  static_cast<long long>(prepared.vertices), static_cast<long long>(prepared.edges),
                  1e-6 * static_cast<double>(prepared.bytes), 1e3 * prepared.seconds);
    message(text.data());
  }
  message(run.params.algorithm() + ", seed " + std::to_string(run.params.seed) + ", " +
          counted(run.params.threads, "thread"));
}

}  // namespace lasius::tool
