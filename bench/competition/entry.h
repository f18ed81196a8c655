// What a program of the Grid-Based Path Planning Competition's any-angle track consists of: the
// functions that its start kit (github.com/gppc-dev/startkit-classic) calls, under the names that
// it gives them. entry.cpp is lasius as such an entry.
#pragma once

#include <string>
#include <vector>

/// A place of the plane; cell (x, y) is the square from there to (x + 1, y + 1), y down.
struct xyLoc {
  double x, y;
};

/// Prepares a map of `width` times `height` cells, row by row, true where free, and keeps what it
/// makes in a file; none where there would be too much.
void PreprocessMap(const std::vector<bool>& bits, int width, int height,
                   const std::string& filename);
/// Makes the map ready, from that file if it is there. What is returned is kept to the end.
void* PrepareForSearch(const std::vector<bool>& bits, int width, int height,
                       const std::string& filename);
/// Puts the shortest path between two lattice points into `path`; empty where they are one, or
/// there is none. True: nothing is left to do.
bool GetPath(void* data, xyLoc s, xyLoc g, std::vector<xyLoc>& path);
std::string GetName();
