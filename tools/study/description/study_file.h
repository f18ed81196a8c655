// Studies as data: YAML or JSON, those of the program (tools/study/sources) and of users alike.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tools/study/study.h"

namespace lasius::study {

/// The studies that the program holds, in the order of `lasius study list`: their names, which are
/// those of the files.
std::vector<std::string_view> study_names();

/// The study of this name, one of `study_names()`. Reads no file and runs nothing.
Study make_study(std::string_view name);

/// A study from YAML or JSON, a map with
///   name         default the file's; summary, source, text
///   world        "bitmap" (default), "polygon", "arm" or "online"; unit of lengths, default
///                "cells"
///   seeds        N for 1 to N, or A..B; default 30
///   maps         {NAME: map}, a map being a file's name, "KIND WxH DENSITY SEED", a list of both,
///                or a family {kind, size, density, seeds}: a map for each of their values
///   contenders   list of {name, label, algorithm, preset: book or a preset's file, set:
///                {parameter: value}, budget, sweep: no}, or of {name, label, like, set}: another
///                one's, with other settings
///   compare      names of contenders (default: all, in their order)
///   sweep        {design: grid, random or latin, points, seed, factors: {parameter: [values] or
///                {from, to, scale: linear or log, levels}}}: every contender that has one of the
///                parameters is there once for each point, as NAME-1 and so on
///   budget       {iterations, steps, seconds} of a run, whichever ends first
///   questions    list of {name, map, start, goal, published: {contender: {length, iterations,
///                seconds}}}, or of {name, map, draw: N or {count, seed, apart}}: start and goal
///                are drawn, see draw_questions(). On bitmaps also radius, by which obstacles grow
///                (cells), cost: FILE*FACTOR or a list of them, and inflation: [RADIUS, SCALING,
///                WEIGHT], whose costs take the place of lengths, and frame: world, where lengths
///                are in metres of a ROS map; a name of `maps` stands for all maps of that name, no
///                map for all maps
///   experiments  list of {name, title, text, optimum, where, compare, questions, target or
///                targets, charts, portrait, by_ant}, see Experiment; optimum is "any-angle"
///                (default), "4 moves" or "8 moves"; compare, questions, optimum and targets
///                default to the study's; where {WORD: text} says what $WORD stands for in the
///                contenders' values and in the experiment's text; charts {NAME: [contender]}.
///                Without the list the study itself is its only experiment, "runs"
///   claims       list of {text, place, test, note, in, a, b, value, at, budget, target, best_of,
///                own_limit, factor, within, share, from, to, baseline}, see Claim and Value; `in`
///                defaults to all experiments; a list `b` makes a claim of each, and `in_each` of
///                each experiment; baseline {a, value, at, target, from, to}
/// A list of texts is one text, joined by blanks. `file` is how errors call it; what lies in its
/// folder is found. On bitmaps algorithms and parameters are tried.
/// @throws Error(file_broken) for anything else, naming line and key, with the nearest known one.
Study parse_study(std::string_view text, const std::string& file = "study");

/// parse_study() of a file's text. @throws Error(file_missing), too
Study read_study(const std::string& file);

}  // namespace lasius::study
