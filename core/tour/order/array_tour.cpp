#include "core/tour/order/array_tour.h"

#include <utility>

namespace lasius::tour {

ArrayTour::ArrayTour(const Costs& costs, std::vector<int> order)
    : costs_(&costs), at_(std::move(order)), place_(at_.size()), leg_(at_.size()) {
  for (int p = 0; p < size(); ++p) place_[at_[p]] = p;
  for (int p = 0; p < size(); ++p) cost_ += leg_[p] = costs(at_[p], at_[after(p)]);
}

void ArrayTour::write(int place, int stop) {
  log_.push_back({place, at_[place], leg_[place]});
  at_[place] = stop;
  place_[stop] = place;
}

void ArrayTour::set_leg(int place) {
  cost_ -= leg_[place];
  cost_ += leg_[place] = (*costs_)(at_[place], at_[after(place)]);
}

void ArrayTour::apply(const Exchange& exchange) {
  struct Piece {
    int first, last;  // places, as they are passed now
    bool backward;
  };
  const int ends = 2 * exchange.cuts;
  Piece pieces[Exchange::kMostCuts] = {};
  int longest = 0, most = -1, x = 1;
  for (int i = 0; i < exchange.cuts; ++i) {
    const int other = x % 2 == 1 ? (x + 1 == ends ? 0 : x + 1) : (x == 0 ? ends - 1 : x - 1);
    const auto where = [&](int end) {
      const int p = exchange.cut[end / 2];
      return end % 2 == 0 ? p : after(p);
    };
    pieces[i] = {where(x), where(other), x % 2 == 0};
    const int low = pieces[i].backward ? pieces[i].last : pieces[i].first;
    const int high = pieces[i].backward ? pieces[i].first : pieces[i].last;
    const int length = high >= low ? high - low + 1 : high - low + 1 + size();
    if (length > most) most = length, longest = i;
    x = exchange.partner[other];
  }
  // The longest stays; where it would be passed backward, all others are passed the other way.
  const bool turn = pieces[longest].backward;
  copy_.clear();
  for (int i = 1; i < exchange.cuts; ++i) {
    const int k = turn ? longest - i + exchange.cuts : longest + i;
    const Piece& piece = pieces[k % exchange.cuts];
    const int from = turn ? piece.last : piece.first, to = turn ? piece.first : piece.last;
    const bool backward = piece.backward != turn;
    for (int p = from;; p = backward ? before(p) : after(p)) {
      copy_.push_back(at_[p]);
      if (p == to) break;
    }
  }
  const int end = turn ? pieces[longest].first : pieces[longest].last;
  int p = end;
  log_.push_back({p, at_[p], leg_[p]});
  for (const int stop : copy_) write(p = after(p), stop);
  set_leg(p = end);
  for (std::size_t i = 0; i < copy_.size(); ++i) set_leg(p = after(p));
}

void ArrayTour::undo() {
  for (auto it = log_.rbegin(); it != log_.rend(); ++it) {
    at_[it->place] = it->stop;
    place_[it->stop] = it->place;
    cost_ += it->leg - leg_[it->place];
    leg_[it->place] = it->leg;
  }
  log_.clear();
}

}  // namespace lasius::tour
