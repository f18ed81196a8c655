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
///   world        "bitmap" (default), "polygon", "arm" or "online"; unit of lengths, default
///   "cells" seeds        runs of each contender, default 30 contenders   list of {name, label,
///   algorithm, preset: "book", set: {parameter: value}}, or of
///                {name, label, like, set}: another one's, with other settings
///   compare      names of contenders (default: all, in their order)
///   questions    list of {name, map, start, goal, published: {contender: {length, iterations,
///                seconds}}}
///   experiments  list of {name, title, text, optimum, where, compare, questions, target, charts,
///                portrait, by_ant}, see Experiment; optimum is "any-angle" (default),
///                "4 moves" or "8 moves"; compare and questions default to the study's; where
///                {WORD: text} says what $WORD stands for in the contenders' values and in the
///                experiment's text; charts {NAME: [contender]}
///   claims       list of {text, place, test, note, in, a, b, value, at, budget, target, best_of,
///                own_limit, factor, within, share, from, to, baseline}, see Claim and Value; a
///                list `b` makes a claim of each, and `in_each` of each experiment; baseline {a,
///                value, at, target, from, to}
/// A list of texts is one text, joined by blanks. @throws std::exception for anything else.
Study parse_study(std::string_view json);

}  // namespace lasius::study
