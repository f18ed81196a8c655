// Tours over problems of TSPLIB, and what they share with those on maps.
#pragma once

#include <memory>

#include "lasius/tour/tour.h"
#include "tools/options/options.h"
#include "tools/record/problem.h"

namespace lasius::tool {

inline constexpr const char* kTourFormat = "lasius-tour/1";
inline constexpr const char* kLegAlgorithm = "exact";  ///< that legs are planned by

/// Takes the algorithm and its parameters from `run` to `ants`, and leaves `run` those of legs.
void choose_ants(TourCommand& command);
/// Of ants: their course.
void add_course(Json& json, const Record& record);
/// `lasius tour PROBLEM.tsp`.
std::unique_ptr<Problem> tsplib_problem(TourCommand command);
/// `lasius tour MAP`.
std::unique_ptr<Problem> tour_problem(TourCommand command);

/// The question, without its stops and ends.
TourRequest request_of(const TourCommand& command, const StopCondition& stop);
/// Tells of each shorter tour, in `unit` after times `scale`; none where nobody watches.
TourObserver told_to(const Problem::Watch& watch, double scale, const std::string& unit);
SearchResult search_result(const TourResult& tour);
void add_parameters(Json& json, const TourCommand& command);
/// {order}, null without a tour.
Json order_json(const TourResult& tour);

}  // namespace lasius::tool
