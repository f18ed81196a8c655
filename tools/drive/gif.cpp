#include "tools/drive/gif.h"

#include <gif_lib.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>

namespace lasius::tool {
namespace {

using Frame = Raster<std::uint8_t>;

/// What giflib refuses is our fault, or memory: all is written to memory first.
void check(int done) {
  if (done != GIF_OK) throw std::runtime_error("giflib refuses a film");
}

struct EndMap {
  void operator()(ColorMapObject* map) const { GifFreeMapObject(map); }
};

class Gif {
 public:
  Gif(int width, int height, std::span<const Colour> colours) {
    const int size = 1 << GifBitSize(static_cast<int>(colours.size()));
    const std::unique_ptr<ColorMapObject, EndMap> map(GifMakeMapObject(size, nullptr));
    file_ = EGifOpen(this, take, nullptr);
    if (map == nullptr || file_ == nullptr) throw std::bad_alloc();
    const auto byte = [](double share) {
      return static_cast<GifByteType>(std::lround(255 * share));
    };
    std::ranges::transform(colours, map->Colors, [&](const Colour& c) {
      return GifColorType{byte(c.red), byte(c.green), byte(c.blue)};
    });
    EGifSetGifVersion(file_, true);
    check(EGifPutScreenDesc(file_, width, height, map->BitsPerPixel, 0, map.get()));
    repeat();
  }
  ~Gif() {
    if (file_ != nullptr) EGifCloseFile(file_, nullptr);
  }
  Gif(const Gif&) = delete;
  Gif& operator=(const Gif&) = delete;

  void add(const Frame& frame, const Window& part, int hundredths) {
    const GraphicsControlBlock control{DISPOSE_DO_NOT, false, hundredths, NO_TRANSPARENT_COLOR};
    GifByteType bytes[4];
    EGifGCBToExtension(&control, bytes);
    check(EGifPutExtension(file_, GRAPHICS_EXT_FUNC_CODE, sizeof bytes, bytes));
    check(EGifPutImageDesc(file_, part.columns.from, part.rows.from, part.width(), part.height(),
                           false, nullptr));
    for (int y = part.rows.from; y < part.rows.to; ++y) {
      std::vector<GifPixelType> line(frame.values.data() + frame.index(part.columns.from, y),
                                     frame.values.data() + frame.index(part.columns.to - 1, y) + 1);
      check(EGifPutLine(file_, line.data(), part.width()));
    }
  }

  const std::string& finish() {
    check(EGifCloseFile(std::exchange(file_, nullptr), nullptr));
    return bytes_;
  }

 private:
  static int take(GifFileType* file, const GifByteType* bytes, int count) {
    static_cast<Gif*>(file->UserData)->bytes_.append(reinterpret_cast<const char*>(bytes), count);
    return count;
  }

  /// For ever: the extension that all browsers know.
  void repeat() {
    constexpr GifByteType kEver[] = {1, 0, 0};
    check(EGifPutExtensionLeader(file_, APPLICATION_EXT_FUNC_CODE));
    check(EGifPutExtensionBlock(file_, 11, "NETSCAPE2.0"));
    check(EGifPutExtensionBlock(file_, sizeof kEver, kEver));
    check(EGifPutExtensionTrailer(file_));
  }

  std::string bytes_;
  GifFileType* file_ = nullptr;
};

/// Where two frames differ, at least one pixel.
Window difference(const Frame& a, const Frame& b) {
  Window part{{a.width, 0}, {a.height, 0}};
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      if (a.at(x, y) == b.at(x, y)) continue;
      part.columns = {std::min(part.columns.from, x), std::max(part.columns.to, x + 1)};
      part.rows = {std::min(part.rows.from, y), y + 1};
    }
  }
  return part.width() > 0 ? part : Window{{0, 1}, {0, 1}};
}

}  // namespace

void check_films() {}

void write_gif(std::ostream& out, std::span<const Colour> colours, const std::vector<Frame>& frames,
               int hundredths_a_frame) {
  Gif gif(frames.front().width, frames.front().height, colours);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const Frame& frame = frames[i];
    const Window all{{0, frame.width}, {0, frame.height}};
    gif.add(frame, i == 0 ? all : difference(frames[i - 1], frame),
            i + 1 == frames.size() ? 200 : hundredths_a_frame);
  }
  out << gif.finish();
}

}  // namespace lasius::tool
