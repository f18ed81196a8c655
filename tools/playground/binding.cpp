// The library as the playground's worker sees it: plain objects and typed arrays, no exceptions. A
// call that fails returns {error: sentence}.

#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "lasius/lasius.h"
#include "lasius/version.h"
#include "tools/bitmap/picture_recorder.h"
#include "tools/report/key_frames.h"

namespace lasius::playground {
namespace {

using emscripten::val;
using tool::PictureRecorder;

constexpr int kMostPixels = 400;  // of a frame, a side
// Up to so many cells the pheromone of every one is read, else only around the ants' tracks.
constexpr std::int64_t kReadAll = std::int64_t{1} << 17;

/// A JavaScript array with the same numbers: Float64Array and so on.
template <class Number>
val array_of(const std::vector<Number>& numbers) {
  return val(emscripten::typed_memory_view(numbers.size(), numbers.data())).call<val>("slice");
}

template <class List, class Make>
val list_of(const List& list, Make make) {
  val all = val::array();
  for (const auto& each : list) all.call<void>("push", make(each));
  return all;
}

val text_of(std::string_view text) { return val(std::string(text)); }

/// What `call` returns, or {error}.
template <class Call>
val guarded(const Call& call) {
  std::string problem = "out of memory: the map or the colony is too large for a page";
  try {
    return call();
  } catch (const std::bad_alloc&) {
  } catch (const std::exception& error) {
    problem = error.what();
  }
  val failed = val::object();
  failed.set("error", problem);
  return failed;
}

/// {algorithm, preset, seed, values: {name: text}}. Threads are one here, and no parameter.
Params params_of(const val& question) {
  const bool book = question["preset"].as<std::string>() == to_string(Preset::book);
  Params params(question["algorithm"].as<std::string>(), book ? Preset::book : Preset::usual);
  params.seed = static_cast<std::uint64_t>(question["seed"].as<double>());
  params.threads = 1;
  const val values = question["values"];
  for (const std::string& name :
       emscripten::vecFromJSArray<std::string>(val::global("Object").call<val>("keys", values))) {
    set_parameter(params, name, values[name].as<std::string>());
  }
  validate(params);
  return params;
}

/// Names and values of all parameters, as text.
val values_of(const Algorithm& algorithm, Preset preset) {
  const Params params(algorithm.name, preset);
  val values = val::object();
  for (const Parameter& parameter : algorithm.parameters)
    values.set(std::string(parameter.name), get_parameter(params, parameter.name));
  return values;
}

val parameter_object(const Parameter& parameter) {
  val object = val::object();
  object.set("name", text_of(parameter.name));
  object.set("type", text_of(parameter.type));
  object.set("range", parameter.range());
  object.set("choices", list_of(parameter.choices, text_of));
  object.set("least", parameter.least);
  object.set("most", parameter.most);
  object.set("summary", text_of(parameter.summary));
  return object;
}

val algorithm_object(const Algorithm& algorithm) {
  val presets = val::object();
  for (const Preset preset : {Preset::usual, Preset::book})
    if (has_preset(algorithm.name, preset))
      presets.set(std::string(to_string(preset)), values_of(algorithm, preset));
  val object = val::object();
  object.set("name", text_of(algorithm.name));
  object.set("summary", text_of(algorithm.summary));
  object.set("source", text_of(algorithm.source));
  object.set("kind", text_of(to_string(algorithm.kind)));
  object.set("parameters", list_of(algorithm.parameters, parameter_object));
  object.set("presets", presets);
  return object;
}

val algorithm_list() { return list_of(algorithms(), algorithm_object); }

val kind_list() {
  return list_of(map_kind_names(), [kind = 0](std::string_view name) mutable {
    val object = val::object();
    object.set("name", text_of(name));
    object.set("max_density", max_density(static_cast<MapKind>(kind++)));
    return object;
  });
}

/// The rules of a colony in a line each, with the numbers of the question.
val formula_list(const val& question) {
  return guarded([&] { return list_of(formulas(params_of(question)), text_of); });
}

val map_object(const Grid& grid) {
  val object = val::object();
  object.set("width", grid.width());
  object.set("height", grid.height());
  object.set("cells", array_of(grid.bytes(Nonzero::blocked)));
  return object;
}

/// {kind, width, height, density, seed}
val generated(const val& wish) {
  return guarded([&] {
    const auto names = map_kind_names();
    const auto found = std::find(names.begin(), names.end(), wish["kind"].as<std::string>());
    if (found == names.end())
      throw Error(ErrorCode::invalid_parameter, "no such kind of map", "take one of the list");
    return map_object(generate(static_cast<MapKind>(found - names.begin()),
                               {.width = wish["width"].as<int>(),
                                .height = wish["height"].as<int>(),
                                .density = wish["density"].as<double>(),
                                .seed = static_cast<std::uint64_t>(wish["seed"].as<double>())}));
  });
}

/// A map from the bytes of a file; `name` is for messages.
val read(const std::string& name, const std::string& bytes) {
  return guarded([&] {
    const std::string path = "/" + name;
    std::ofstream(path, std::ios::binary).write(bytes.data(), std::ssize(bytes));
    const struct Remover {
      const std::string& path;
      ~Remover() { std::remove(path.c_str()); }
    } remover{path};
    return map_object(read_map(path).grid);
  });
}

Cell cell_of(const val& place) { return {place["x"].as<int>(), place["y"].as<int>()}; }

/// x, y, x, y, ...
val path_array(const std::vector<Point>& path) {
  std::vector<double> numbers;
  for (const Point p : path) numbers.insert(numbers.end(), {p.x, p.y});
  return array_of(numbers);
}

val curves_object(const Convergence& curves) {
  val object = val::object();
  object.set("best", array_of(curves.best));
  object.set("mean", array_of(curves.mean));
  object.set("arrived", array_of(curves.arrived));
  return object;
}

val result_object(const Result& result) {
  val object = curves_object(result.curves);
  object.set("status", text_of(to_string(result.status)));
  object.set("message", result.error);
  object.set("length", result.length);
  object.set("path", path_array(result.path));
  object.set("iterations", result.curves.iterations);
  object.set("optimal", result.optimal);
  if (result.nearest_free) {
    val cell = val::object();
    cell.set("x", result.nearest_free->x);
    cell.set("y", result.nearest_free->y);
    object.set("nearest_free", cell);
  }
  return object;
}

/// trail: by pixel the largest pheromone, or least terminal index, NaN where no cell is free;
/// tracks: the ants' cells of the iteration. Pixel (x, y) holds cells from (x, y) * cells_a_pixel.
val frame_object(const GridProgress& progress, const PictureRecorder& rasters) {
  const auto& trail = rasters.pheromone().values;
  val object = val::object();
  object.set("iteration", progress.iteration + 1);
  object.set("best", progress.best_length);
  object.set("mean", progress.mean_length);
  object.set("arrived", progress.arrived);
  object.set("ants", progress.ants());
  object.set("path", path_array(progress.path()));
  object.set("trail", array_of(trail.values));
  object.set("tracks", array_of(rasters.newest().now.values));
  object.set("width", trail.width);
  object.set("height", trail.height);
  object.set("cells_a_pixel", rasters.cells_a_pixel());
  return object;
}

/// A map ready for planning.
class World {
 public:
  /// Takes one byte a cell, not 0 where it is blocked, row by row from the top left; for a disc of
  /// a radius in cells, a point's is 0.
  World(int width, int height, const std::string& cells, double radius)
      : planner_(Grid(width, height, bytes(cells), Nonzero::blocked), Disc{radius}) {}

  /// The question is that of params_of with {start: {x, y}, goal: {x, y}}. `watch`, unless null, is
  /// called with the frames that a KeyFrames of `most` asks for, and after the last iteration.
  val plan(const val& question, const val& watch, int most) const {
    return guarded([&] {
      const Params params = params_of(question);
      const Request request{.start = cell_of(question["start"]), .goal = cell_of(question["goal"])};
      if (watch.isNull()) return result_object(planner_.plan(request, params));
      struct Frame {};  // the page keeps them
      tool::KeyFrames<Frame> sent(static_cast<std::size_t>(most));
      // Tracks of no iteration are kept there.
      PictureRecorder rasters(planner_.grid(), {std::numeric_limits<int>::max()}, params,
                              {.pixels = kMostPixels, .read_all = kReadAll});
      const auto look = [&](const GridProgress& progress) {
        rasters.observe(progress);
        const bool last = progress.iteration + 1 == params.iterations;
        if (sent.wants(progress.iteration)) {
          sent.add({});
        } else if (!last) {
          return;
        }
        rasters.capture(progress);
        watch(frame_object(progress, rasters));
      };
      return result_object(planner_.plan(request, params, {.observer = look}));
    });
  }

  /// The bytes of a MovingAI .map of it.
  val text() const {
    const std::string path = "/written.map";
    write_map(planner_.grid(), path);
    std::ifstream file(path, std::ios::binary);
    const std::vector<std::uint8_t> content{std::istreambuf_iterator<char>(file), {}};
    return array_of(content);
  }

 private:
  static std::span<const std::uint8_t> bytes(const std::string& cells) {
    return {reinterpret_cast<const std::uint8_t*>(cells.data()), cells.size()};
  }

  Planner planner_;
};

std::string version() { return LASIUS_VERSION; }

EMSCRIPTEN_BINDINGS(lasius) {
  using emscripten::function;
  function("version", &version);
  function("algorithms", &algorithm_list);
  function("kinds", &kind_list);
  function("formulas", &formula_list);
  function("generate", &generated);
  function("read", &read);
  emscripten::class_<World>("World")
      .constructor<int, int, const std::string&, double>()
      .function("plan", &World::plan)
      .function("text", &World::text);
}

}  // namespace
}  // namespace lasius::playground
