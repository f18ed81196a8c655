#include "bench/peers/textbook_tours.h"

#include <algorithm>
#include <numeric>
#include <random>

namespace lasius::peers {

namespace {

constexpr int kNeighbours = 10;
constexpr int kLongestPiece = 3;  // of Or-opt
constexpr int kBridge = 50;       // positions that a double bridge spans

class Textbook {
 public:
  Textbook(int size, const std::vector<std::int32_t>& costs, bool or_opt)
      : n_(size), costs_(costs), or_opt_(or_opt), tour_(size), position_(size), queued_(size, 0) {
    near_.resize(static_cast<std::size_t>(n_) * kNeighbours);
    std::vector<int> others(n_);
    for (int v = 0; v < n_; ++v) {
      std::iota(others.begin(), others.end(), 0);
      others.erase(others.begin() + v);
      const int count = std::min(kNeighbours, n_ - 1);
      std::partial_sort(others.begin(), others.begin() + count, others.end(),
                        [&](int a, int b) { return cost(v, a) < cost(v, b); });
      for (int k = 0; k < kNeighbours; ++k) near_[v * kNeighbours + k] = others[k % count];
      others.resize(n_);
    }
  }

  const std::vector<int>& tour() const { return tour_; }
  std::int64_t length() const {
    std::int64_t sum = cost(tour_.back(), tour_.front());
    for (int p = 1; p < n_; ++p) sum += cost(tour_[p - 1], tour_[p]);
    return sum;
  }
  void set(std::vector<int> tour) {
    tour_ = std::move(tour);
    for (int p = 0; p < n_; ++p) position_[tour_[p]] = p;
  }
  void nearest_neighbour() {
    std::vector<int> tour = {0};
    std::vector<char> done(n_, 0);
    done[0] = 1;
    while (static_cast<int>(tour.size()) < n_) {
      int best = -1;
      for (int v = 0; v < n_; ++v)
        if (!done[v] && (best < 0 || cost(tour.back(), v) < cost(tour.back(), best))) best = v;
      done[best] = 1;
      tour.push_back(best);
    }
    set(std::move(tour));
  }
  void queue(int v) {
    if (!queued_[v]) waiting_.push_back(v);
    queued_[v] = 1;
  }
  void queue_all() {
    for (const int v : tour_) queue(v);
  }
  void improve() {
    while (!waiting_.empty()) {
      const int v = waiting_.back();
      waiting_.pop_back();
      queued_[v] = 0;
      while (two_opt(v) || (or_opt_ && or_opt(v))) {
      }
    }
  }
  // Two pieces of a stretch change places.
  void double_bridge(std::mt19937_64& random) {
    const int span = std::min(kBridge, n_ - 1), from = static_cast<int>(random() % n_);
    int cuts[3];
    for (int& cut : cuts) cut = 1 + static_cast<int>(random() % (span - 1));
    std::sort(cuts, cuts + 3);
    std::vector<int> piece;
    for (int k = 0; k < span; ++k) piece.push_back(tour_[(from + k) % n_]);
    std::rotate(piece.begin() + cuts[0], piece.begin() + cuts[1], piece.begin() + cuts[2]);
    for (int k = 0; k < span; ++k) put((from + k) % n_, piece[k]);
    for (const int cut : cuts)
      for (const int k : {cut - 1, cut}) queue(tour_[(from + k) % n_]);
    for (const int k : {cuts[0] + cuts[2] - cuts[1] - 1, cuts[0] + cuts[2] - cuts[1]})
      queue(tour_[(from + k) % n_]);
  }

 private:
  std::int32_t cost(int a, int b) const { return costs_[static_cast<std::size_t>(a) * n_ + b]; }
  int next(int v) const { return tour_[(position_[v] + 1) % n_]; }
  int previous(int v) const { return tour_[(position_[v] + n_ - 1) % n_]; }
  void put(int p, int v) {
    tour_[p] = v;
    position_[v] = p;
  }
  // The positions from i on to j, cyclic, or the others: whichever are fewer.
  void reverse(int i, int j) {
    int length = (j - i + n_) % n_ + 1;
    if (2 * length > n_) {
      const int old = i;
      i = (j + 1) % n_;
      j = (old + n_ - 1) % n_;
      length = n_ - length;
    }
    for (int k = 0; k < length / 2; ++k) {
      const int a = tour_[i], b = tour_[j];
      put(i, b);
      put(j, a);
      i = (i + 1) % n_;
      j = (j + n_ - 1) % n_;
    }
  }
  bool two_opt(int v) {
    for (const bool forward : {true, false}) {
      const int w = forward ? next(v) : previous(v);
      for (int k = 0; k < kNeighbours; ++k) {
        const int a = near_[v * kNeighbours + k];
        const std::int32_t gone = cost(v, w) - cost(v, a);
        if (gone <= 0) break;
        const int b = forward ? next(a) : previous(a);
        if (gone + cost(a, b) - cost(w, b) <= 0) continue;
        if (forward)
          reverse(position_[w], position_[a]);
        else
          reverse(position_[a], position_[w]);
        for (const int end : {v, w, a, b}) queue(end);
        return true;
      }
    }
    return false;
  }
  // Moves up to three stops that begin at v beside a near one, either way round, by reversals.
  bool or_opt(int v) {
    for (int length = 1; length <= kLongestPiece; ++length)
      for (const bool forward : {true, false}) {
        int last = v;
        for (int k = 1; k < length; ++k) last = forward ? next(last) : previous(last);
        const int before = forward ? previous(v) : next(v),
                  behind = forward ? next(last) : previous(last);
        if (before == behind || before == last) return false;
        const std::int64_t gone =
            std::int64_t{cost(before, v)} + cost(last, behind) - cost(before, behind);
        for (int k = 0; k < kNeighbours; ++k) {
          const int a = near_[v * kNeighbours + k];
          if (cost(v, a) >= gone) break;
          const int offset = (position_[a] - position_[v] + n_) % n_;
          if ((forward ? offset : (n_ - offset) % n_) < length) continue;  // in the piece
          for (const bool ahead : {true, false}) {
            const int b = ahead ? next(a) : previous(a);
            const int at = (position_[b] - position_[v] + n_) % n_;
            if ((forward ? at : (n_ - at) % n_) < length) continue;
            if (gone + cost(a, b) - cost(a, v) - cost(last, b) <= 0) continue;
            move(v, last, length, forward, a, b);
            for (const int end : {v, last, before, behind, a, b}) queue(end);
            return true;
          }
        }
      }
    return false;
  }
  // The piece from v to last between a and b, v beside a.
  void move(int v, int last, int length, bool forward, int a, int b) {
    std::vector<int> piece;
    for (int p = position_[v], k = 0; k < length; ++k, p = (p + (forward ? 1 : n_ - 1)) % n_)
      piece.push_back(tour_[p]);
    const bool a_first = next(a) == b;
    if (!a_first) std::reverse(piece.begin(), piece.end());
    // The others move up, from the gap to the place, the shorter way round.
    const int left = a_first ? a : b;
    int low = position_[forward ? v : last];
    const int up = (position_[left] - (low + length - 1) + 2 * n_) % n_;  // others to go down
    const int rest = n_ - length;
    if (2 * up <= rest) {
      for (int k = 0; k < up; ++k, low = (low + 1) % n_) put(low, tour_[(low + length) % n_]);
    } else {
      int high = (low + length - 1) % n_;
      for (int k = 0; k < rest - up; ++k, high = (high + n_ - 1) % n_)
        put(high, tour_[(high + 2 * n_ - length) % n_]);
      low = (high - length + 1 + 2 * n_) % n_;
    }
    for (int k = 0; k < length; ++k) put((low + k) % n_, piece[k]);
  }

  int n_;
  const std::vector<std::int32_t>& costs_;
  bool or_opt_;
  std::vector<int> tour_, position_, near_, waiting_;
  std::vector<char> queued_;
};

}  // namespace

std::vector<int> textbook_tour(int size, const std::vector<std::int32_t>& costs, TourMethod method,
                               std::uint64_t seed, const TourWatch& watch,
                               const std::function<bool()>& stop) {
  std::mt19937_64 random(seed);
  Textbook textbook(size, costs, method != TourMethod::two_opt);
  textbook.nearest_neighbour();
  textbook.queue_all();
  textbook.improve();
  std::vector<int> best = textbook.tour();
  std::int64_t least = textbook.length();
  bool more = watch(least) && method != TourMethod::two_opt;
  while (more && !stop()) {
    if (method == TourMethod::ils) {
      textbook.double_bridge(random);
    } else {
      std::vector<int> order(size);
      std::iota(order.begin(), order.end(), 0);
      std::shuffle(order.begin(), order.end(), random);
      textbook.set(std::move(order));
      textbook.queue_all();
    }
    textbook.improve();
    const std::int64_t length = textbook.length();
    if (length < least) more = watch(length);
    if (length <= least) {
      least = length;
      best = textbook.tour();
    } else if (method == TourMethod::ils) {
      textbook.set(best);
    }
  }
  return best;
}

}  // namespace lasius::peers
