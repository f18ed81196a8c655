// Component lasius::io: parameters and answers on bitmaps as JSON text, and back.
#pragma once

#include <string>
#include <string_view>

#include "lasius/cost/proof.h"
#include "lasius/io_export.h"
#include "lasius/params/params.h"
#include "lasius/plan/result.h"

namespace lasius {

/// One JSON object on one line, under the names that `lasius plan --json` gives: "algorithm",
/// "seed", "threads" and "parameters", an object of all parameters of the algorithm by name.
/// Numbers read back as the same, bit for bit.
LASIUS_IO_EXPORT std::string params_to_json(const Params& params);

/// The parameters in such a text, validated. What it leaves out stays as the constructor of Params
/// sets it, other members are skipped: so what `lasius plan --json` printed will do, whose
/// "parameters" hold the settings of its request beside them.
/// @throws Error(file_broken) where the text is no JSON object with an algorithm's name, or a
///         member is of another type; Error(invalid_parameter) for an unknown algorithm or
///         parameter (with the nearest), or a value that is out of range.
LASIUS_IO_EXPORT Params params_from_json(std::string_view text);

/// One JSON object on one line, under the names that `lasius plan --json` gives: "status", "error",
/// "length", "path", "iterations", "best", "mean", "arrived", "lower_bound", "gap", "optimal"; then
/// "fault", "own_rules", "way_out", "goal_reached", "nearest_free" and "nearest_reachable" where
/// the answer has them. What is missing, or no number, is null. Result::limit is not written: with
/// "limit" it is read back as Limit::time, the only one on bitmaps.
LASIUS_IO_EXPORT std::string result_to_json(const Result& result);

/// The answer in such a text, or in what `lasius plan --json` printed (cells); "gap" follows from
/// the others and is not read. @throws Error(file_broken), naming the member.
LASIUS_IO_EXPORT Result result_from_json(std::string_view text);

/// A proof as JSON of format "lasius-proof/1" (docs/costs.md), a line for each of its lists.
/// @param weights  where it is not empty: JSON that says what made the weights, kept as "weights"
LASIUS_IO_EXPORT std::string proof_to_json(const CostProof& proof, std::string_view weights = {});

/// The same members as CBOR (RFC 8949), half as long: "runs" and "values" are typed arrays (RFC
/// 8746) of 4-byte integers and of doubles, the low byte first.
LASIUS_IO_EXPORT std::string proof_to_cbor(const CostProof& proof, std::string_view weights = {});

/// The proof in such a text; numbers are the same, bit for bit. Whether it holds check_proof says.
/// @param file  its name, for what is refused
/// @throws Error(file_broken), naming the member.
LASIUS_IO_EXPORT CostProof proof_from_json(std::string_view text,
                                           const std::string& file = "the proof");
LASIUS_IO_EXPORT CostProof proof_from_cbor(std::string_view bytes,
                                           const std::string& file = "the proof");

}  // namespace lasius
