// The world of a colony on a bitmap, as the loop sees it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "core/colony/best_path.h"
#include "core/colony/colony_memory.h"
#include "core/colony/tour_measures.h"
#include "core/colony/trail_model.h"
#include "core/loop/colony_loop.h"
#include "kernels/walk/walk.h"
#include "lasius/plan/progress.h"
#include "lasius/plan/request.h"
#include "lasius/plan/result.h"

namespace lasius {

/// A colony on a bitmap. Its grid and its start may change between runs.
class GridColony final : public ColonyWorld {
 public:
  /// What comes after a run: another one goes on with the trail, or nothing reads it again.
  enum class After { nothing, more_runs };

  /// `own`, checked, may take the place of some rules; disc and terrain as of run_colony(). All
  /// outlive the object. `first_ant` picks the first ant's random numbers, those after it follow.
  GridColony(const Grid& grid, const Params& params, ColonyMemory& memory, const OwnRules& own,
             After after, const disc::DiscSpace* disc, const cost::Terrain* terrain = nullptr,
             int first_ant = 0);
  GridColony(const GridColony&) = delete;  // the trail refers to the moves
  GridColony& operator=(const GridColony&) = delete;

  /// Makes the trail blank for questions like this one; its stop condition may leave it in pieces.
  void begin(const Request& request);
  /// Gets ready for a run. A best tour that passes the new start goes on from there.
  void set_out(const Request& request, const Observer& observer);
  /// Goes on from `request.start`, with the trail as it is.
  Result run(const Request& request, int iterations, const Observer& observer);

  /// The best path so far, of an iteration that was cut short too.
  BestPath& best_path() noexcept {
    return cut_path_.shorter_than(best_path_) ? cut_path_ : best_path_;
  }
  /// The best of ants and guests; holds until the next iteration.
  Tour best_tour() const noexcept { return memory_.best.tour(); }
  /// Another colony's tour: in the next iteration the trail learns by it as by one more ant.
  void welcome(const Tour& tour) { memory_.guest.offer({&tour, 1}); }

  /// Fits what is remembered to cells that have changed.
  void changed(const Rectangle& part);

  // What the loop asks for.

  /// Sends all ants, batch by batch, measures their tours and polishes them. Where nothing reads
  /// the trail after a cut, one thread lays the walks' trails meanwhile: they have nothing to do
  /// with the polish.
  StopCondition::Cause send_ants(int q) override;
  void offer() override {
    if (!trail_.answers()) offer(best_path_, memory_.tours);
  }
  void offer_cut() override { offer(cut_path_, memory_.tours); }
  void update_trail(int) override;
  int ants() const override { return params_.ants; }
  int threads() const override { return threads_; }
  double tour_length(int ant) const override { return memory_.raw_lengths[ant]; }
  std::optional<Walked> walked(int ant) const override {
    const Ant& one = ants_[ant];
    return Walked{memory_.tours[ant].length, one.steps, one.arrived ? one.move_count + 1 : 0,
                  one.near};
  }
  double best_length() const override { return best_path_.length(); }
  double iteration_best() const override { return best_path_.iteration_best(); }
  bool settled() override { return params_.agreement > 0 && agreed_ >= params_.agreement; }
  double trail_entropy() const override { return trail_.entropy(request_.start); }
  StopCondition::Cause observe(const Convergence& run) override;

 private:
  StopCondition::Cause walk();
  AfterWalk after_walk(int first);
  Tour measured(int number, int thread);
  Tours tours(int first, int count) const;
  void learn_from_walks();
  void offer_what_is_known();
  void offer_way(std::span<const std::uint8_t> way, const StopCondition& stop);
  void offer(BestPath& to, std::span<const Tour> tours) const;

  const Grid& grid_;
  Request request_;
  const Params& params_;
  ColonyMemory& memory_;
  const disc::DiscSpace* disc_;
  After after_;
  int first_ant_;
  std::span<Ant> ants_;
  const Observer* observer_ = nullptr;
  int threads_;
  kernels::Moves moves_;
  TourMeasure measure_;
  TrailModel trail_;
  Band band_;
  kernels::WalkShape shape_;
  kernels::WalkFn kernel_ = nullptr;
  kernels::WalkWorld world_;

  int first_iteration_ = 0;  // of this run
  int iteration_ = 0;
  bool learned_ = false;  // from this iteration's walks
  int agreed_ = 0;        // iterations in a row in which all ants took one way
  BestPath best_path_;    // of whole iterations so far, polished
  BestPath cut_path_;     // of those that were cut short
};

}  // namespace lasius
