// Worlds that are not as the map has them, for the study `online`.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "lasius/drive/drive.h"

namespace lasius::study {

/// A map, what is there, and a drive through it.
struct OnlineWorld {
  Grid known, truth;  ///< at the beginning
  Cell start, goal;
  Changes changes;
};

/// A world by its words: FAMILY NUMBER, `file NUMBER FILE` with a map of `maps`. Map, start and
/// goal are those of the number; what is otherwise than the map has it is drawn by `seed`.
///   city       streets of a generated city are closed where shortest ways turn
///   rooms      doors shut while the robot drives, and open again
///   warehouse  pallets stand in the aisles between shelves, forklifts drive there
///   noise      of a map of 15% noise one cell in 16 is otherwise
///   file       streets closed and doors that shut, on a map of `maps`; at most 200 cells a side:
///              those of a larger map stand for squares of its cells
/// Start and goal are joined on the map, in the truth, and where all doors are shut at once.
/// @throws Error(invalid_parameter) for other words; what a map's file throws.
OnlineWorld make_online_world(const std::string& words, std::uint64_t seed,
                              const std::filesystem::path& maps);

/// The truth with all that ever shuts shut at once; moving obstacles left out.
Grid all_shut(const OnlineWorld& world);

}  // namespace lasius::study
