#include "lasius/vehicle/space.h"

#include <cmath>
#include <utility>

#include "core/base/poller.h"
#include "core/grid/clearance.h"
#include "core/vehicle/sweep.h"
#include "kernels/base/mask.h"

namespace lasius::vehicle {

Outline::Outline(const Vehicle& vehicle)
    : count_(static_cast<int>(vehicle.footprint.size())),
      convex_(true),
      around_(circumscribed_radius(vehicle)),
      inside_(inscribed_radius(vehicle)) {
  std::copy(vehicle.footprint.begin(), vehicle.footprint.end(), corners_.begin());
  bool left = false;
  bool right = false;
  for (int i = 0; i < count_; ++i) {
    const Point a = corners_[i];
    const Point b = corners_[(i + 1) % count_];
    const Point c = corners_[(i + 2) % count_];
    const double turn = (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x);
    left = left || turn > 0;
    right = right || turn < 0;
  }
  convex_ = !(left && right);
  lay_covers(vehicle);
}

// Slices of the rectangle around the footprint, across its longer side.
void Outline::lay_covers(const Vehicle& vehicle) {
  Point low = corners_[0];
  Point high = corners_[0];
  for (int i = 1; i < count_; ++i) {
    low = {std::min(low.x, corners_[i].x), std::min(low.y, corners_[i].y)};
    high = {std::max(high.x, corners_[i].x), std::max(high.y, corners_[i].y)};
  }
  const bool upright = high.y - low.y > high.x - low.x;
  const auto turned = [&](Point p) { return upright ? Point{p.y, p.x} : p; };
  low = turned(low);
  high = turned(high);
  const double along = high.x - low.x;
  const double across = high.y - low.y;
  const int slices = static_cast<int>(
      std::clamp(std::ceil(3 * along / std::max(across, 1e-6)), 3.0, 1.0 * kSlices));
  const double width = along / slices;
  for (int i = 0; i < slices; ++i) {
    // At both ends two, that stand out less.
    const int rows = i == 0 || i == slices - 1 ? 2 : 1;
    for (int row = 0; row < rows; ++row) {
      const double height = across / rows;
      const Point centre = turned({low.x + (i + 0.5) * width, low.y + (row + 0.5) * height});
      Vehicle seen = vehicle;
      for (Point& p : seen.footprint) p = {p.x - centre.x, p.y - centre.y};
      covers_[covers_count_++] = {centre, std::sqrt(width * width + height * height) / 2 + 1e-6,
                                  std::max(0.0, inscribed_radius(seen) - 1e-6)};
    }
  }
}

/// Cells that a motion of the lattice is long at most, and some.
constexpr double kMostDriven = 260;

BitColumns::BitColumns(const Grid& grid, int margin)
    : width_(grid.width()),
      height_(grid.height()),
      left_((margin / 64 + 1) * 64),
      top_(margin + 1),
      rows_(height_ + 2 * top_) {
  const int columns = left_ / 64 + grid.words() + margin / 64 + 3;
  // Masks are read to the end of their padding.
  bits_.assign(static_cast<std::size_t>(columns) * rows_ + kernels::kMaskRows, ~std::uint64_t{0});
  for (int y = 0; y < height_; ++y) {
    const std::uint64_t* words = grid.row(y);
    std::uint64_t* to = bits_.data() + (left_ / 64) * rows_ + top_ + y;
    for (int w = 0; w < grid.words(); ++w) to[w * rows_] = words[w];
  }
}

Space::Impl::Impl(const Vehicle& vehicle, const Grid& grid, ClearanceField field)
    : vehicle_(vehicle),
      outline_(vehicle),
      // A motion's mask reaches beyond the circle by what the motion drives.
      bits_(grid, static_cast<int>(outline_.around() +
                                   std::min(4 * vehicle.turning_radius, kMostDriven)) +
                      64),
      field_(std::move(field)) {}

double Space::Impl::clearance(double x, double y) const noexcept {
  if (!(x >= 0 && y >= 0 && x < width() && y < height())) return 0;
  const Cell cell{static_cast<int>(x), static_cast<int>(y)};
  const double dx = x - cell.x - 0.5;
  const double dy = y - cell.y - 0.5;
  return field_.at(cell) - std::sqrt(dx * dx + dy * dy);
}

Space::Impl::Room Space::Impl::room(const Pose& pose) const noexcept {
  const auto [sine, cosine] = kernels::sine_cosine(pose.yaw);
  Room known{1e9, false};
  for (const Outline::Cover& disc : outline_.covers()) {
    const double x = pose.x + disc.centre.x * cosine - disc.centre.y * sine;
    const double y = pose.y + disc.centre.x * sine + disc.centre.y * cosine;
    if (!(x >= 0 && y >= 0 && x < width() && y < height())) {
      known.free = -1;
      continue;
    }
    const Cell cell{static_cast<int>(x), static_cast<int>(y)};
    const double dx = x - cell.x - 0.5;
    const double dy = y - cell.y - 0.5;
    const double beside = std::sqrt(dx * dx + dy * dy);
    const double clear = field_.at(cell);
    known.free = std::min(known.free, clear - beside - disc.outer);
    known.met = known.met || clear + beside < disc.inner;
  }
  return known;
}

bool Space::Impl::free_at(const Pose& pose, double grown) const {
  const Room known = room(pose);
  if (known.met) return false;
  return known.free > grown || raster_free(pose, grown);
}

bool Space::Impl::raster_free(const Pose& pose, double grown) const {
  return !outline_.visit_cells(pose, grown, [&](int row, int first, int last) {
    return bits_.any_blocked(row, first, last);
  });
}

std::optional<Cell> Space::Impl::met(const Pose& pose, double grown) const {
  Cell cell{};
  const bool touches = outline_.visit_cells(pose, grown, [&](int row, int first, int last) {
    for (int x = first; x <= last; ++x) {
      cell = {x, row};
      if (bits_.any_blocked(row, x, x)) return true;
    }
    return false;
  });
  return touches ? std::optional(cell) : std::nullopt;
}

double Space::Impl::touch(const Segment& motion, double open, bool earliest) const {
  const double extent = motion.extent();
  const double turned = motion.gear == 0 ? extent : motion.sharpest() * extent;
  const double driven = motion.gear == 0 ? 0 : extent;
  Segment near = motion;  // the same, with all of its digits for what it turns
  near.begin.yaw = half_turned(motion.begin.yaw);
  // Within some turns the margin of the outline holds the rounding of a yaw.
  const double rounding = turned > 64 ? 0x1p-50 * turned * outline_.around() : 0;
  return touch([&](double share) { return near.pose(share * extent); },
               driven + turned * outline_.around(), open, earliest, rounding);
}

bool Space::Impl::all_free(std::span<const Segment> motions, double open, bool last_first,
                           std::int64_t& checked) const {
  for (std::size_t i = 0; i < motions.size(); ++i) {
    ++checked;
    if (touch(motions[last_first ? motions.size() - 1 - i : i], open, false) <= 1) return false;
  }
  return true;
}

namespace {

constexpr double kFar = 500000;

/// Poses far outside the map touch it; numbers beyond what is exact are not looked at.
bool within(const Pose& pose) {
  return std::fabs(pose.x) < kFar && std::fabs(pose.y) < kFar && std::fabs(pose.yaw) < 1e6;
}

/// The share of the way between two poses that is looked at: up to far outside the map.
double share_within(const Pose& a, const Pose& b) {
  if (!within(a) || !within({0, 0, b.yaw})) return 0;
  if (!std::isfinite(b.x - a.x) || !std::isfinite(b.y - a.y)) return 0;
  const auto share = [](double from, double to) {
    return std::fabs(to) < kFar ? 1 : (std::copysign(kFar, to) - from) / (to - from);
  };
  return std::min(share(a.x, b.x), share(a.y, b.y));
}

Cell cell_of(const Pose& pose) {
  return within(pose) ? Cell{floor_of(pose.x), floor_of(pose.y)} : Cell{-1, -1};
}

Contact contact_at(const Space& space, int segment, double at, const Pose& pose) {
  Contact contact{segment, at, pose, cell_of(pose), !space.free(pose)};
  if (within(pose)) {
    contact.cell = space.impl().met(pose, Space::Impl::kFine).value_or(contact.cell);
  }
  return contact;
}

}  // namespace

Space::Space(const Grid& grid, const Vehicle& vehicle) : Space(*make(grid, vehicle, {})) {}

std::optional<Space> Space::make(const Grid& grid, const Vehicle& vehicle,
                                 const StopCondition& stop) {
  validate(vehicle);
  if (stop.poll() != StopCondition::Cause::none) return std::nullopt;
  Poller poller(stop);
  std::optional<ClearanceField> field = lasius::clearance(grid, ClearanceOf::centres, poller);
  if (!field) return std::nullopt;
  Space space;
  space.impl_ = std::make_shared<const Impl>(vehicle, grid, std::move(*field));
  return space;
}

Space::Space(const Space&) noexcept = default;
Space& Space::operator=(const Space&) noexcept = default;
Space::Space(Space&&) noexcept = default;
Space& Space::operator=(Space&&) noexcept = default;
Space::~Space() = default;

const Vehicle& Space::vehicle() const noexcept { return impl_->vehicle(); }

bool Space::free(const Pose& pose) const { return within(pose) && impl_->free_at(pose, 0); }

bool Space::free(const Segment& motion) const {
  return within(motion.begin) && within(motion.end()) &&
         impl_->touch(motion, Impl::kCoarse, false) > 1;
}

std::optional<Cell> Space::contact(const Pose& pose) const {
  return within(pose) ? impl_->met(pose, 0) : cell_of(pose);
}

std::optional<Contact> Space::first_contact(std::span<const Segment> path) const {
  for (std::size_t i = 0; i < path.size(); ++i) {
    Segment s = path[i];
    const bool straight =
        s.gear != 0 && s.length > 0 && s.sharpest() == 0 && std::fabs(s.angle) < 1e6;
    if (straight) s.length = std::min(s.length, 4 * kFar);  // it leaves the map before
    const bool inside = within(s.begin) && (straight || within(s.end()));
    const double share = inside ? impl_->touch(s, Impl::kFine, true) : 0;
    if (share > 1) continue;
    const double at = share * s.extent();
    return contact_at(*this, static_cast<int>(i), at, s.pose(at));
  }
  return std::nullopt;
}

std::optional<Contact> Space::first_contact(std::span<const Pose> path) const {
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Pose& a = path[i];
    const Pose& b = path[std::min(i + 1, path.size() - 1)];
    const double looked_at = share_within(a, b);
    const bool inside = looked_at > 0;
    const double turn = inside ? looked_at * half_turned(b.yaw - a.yaw) : 0;
    const double yaw = inside ? half_turned(a.yaw) : 0;
    const double dx = inside ? looked_at * (b.x - a.x) : 0;
    const double dy = inside ? looked_at * (b.y - a.y) : 0;
    const auto pose_at = [&](double share) {
      return Pose{a.x + share * dx, a.y + share * dy, yaw + share * turn};
    };
    const double driven = std::sqrt(dx * dx + dy * dy);
    const double reach = driven + std::fabs(turn) * impl_->outline().around();
    double share = inside ? impl_->touch(pose_at, reach, Impl::kFine, true) : 0;
    if (looked_at < 1) share = std::min(share, 1.);
    if (share > 1) continue;
    Pose met = pose_at(share);
    met.yaw += a.yaw - yaw;
    return contact_at(*this, static_cast<int>(i), share * looked_at, met);
  }
  return std::nullopt;
}

}  // namespace lasius::vehicle
