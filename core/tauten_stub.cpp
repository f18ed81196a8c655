#include "lasius/path.h"
namespace lasius {
std::vector<Point> tauten(const Grid&, std::span<const Point> p, const StopCondition&) { return {p.begin(), p.end()}; }
}
