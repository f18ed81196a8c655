// Studies as data: the JSON files in tools/study/sources, which the program holds.
#pragma once

#include <string_view>
#include <vector>

#include "tools/study/study.h"

namespace lasius::study {

/// The studies that the program holds, in the order of `lasius study list`: their names, which are
/// those of the files.
std::vector<std::string_view> study_names();

/// The study of this name, one of `study_names()`. Reads no file and runs nothing.
Study make_study(std::string_view name);

/// A study from JSON. An object with
///   name, summary, source, text
///   contenders   list of {name, label, algorithm, set: {parameter: value}}
///   compare      names of contenders, NAME-x10 for the same with ten times the iterations
///                (default: all, in their order)
///   questions    list of {name, map, start, goal, published: {contender: {length, iterations,
///                seconds}}}
///   experiments  list of {name, title, text, optimum, where, compare, questions, portrait,
///   by_ant};
///                optimum is "any-angle" (default), "4 moves" or "8 moves"; compare and questions
///                default to the study's; where {WORD: text} says what $WORD stands for in the
///                contenders' values and in the experiment's text
///   claims       list of {text, check, in, reason}; check is a function of claims.h, with its
///                arguments by name: `in` the experiments, `a` and `b` the contenders
/// A list of texts is one text, joined by blanks. @throws std::exception for anything else.
Study parse_study(std::string_view json);

}  // namespace lasius::study
