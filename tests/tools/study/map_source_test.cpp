#include "tools/study/map_source.h"

#include <gtest/gtest.h>

#include "lasius/base/error.h"

namespace lasius::study {
namespace {

TEST(GeneratedMap, IsReadWholeOrRefused) {
  const GeneratedMap made = generated_map("blobs 30x20 0.25 7");
  EXPECT_EQ(made.options.width, 30);
  EXPECT_EQ(made.options.height, 20);
  EXPECT_EQ(made.options.density, 0.25);
  EXPECT_EQ(made.options.seed, 7u);
  EXPECT_EQ(generated_map("maze 9x9 default 1").options.density, GenerateOptions{}.density);
  for (const char* source :
       {"blobs 20x20 0,3 1", "blobs 20x20 nan 1", "blobs 20x20 inf 1", "blobs 20x20 -1 1",
        "blobs 20x20 defualt 1", "blobs 20x20 0.3abc 1", "blobs 20x20z 0.1 1",
        "blobs 20x20x5 0.1 1", "blobs 20x20 0.1 -1", "blobs 20x20 0.1 1x", "blobs 20x20 0.1 1 9",
        "blobs 20x20 0.1", "blob 20x20 0.1 1", "blobs 20 0.1 1", ""}) {
    EXPECT_THROW((void)generated_map(source), Error) << source;
  }
}

TEST(LoadMap, RefusesWhatItCannotMake) {
  EXPECT_THROW((void)load_map("castle 10x10 0.2 1", LASIUS_MAPS_DIR), Error);
  EXPECT_THROW((void)load_map("random 10x 0.2 1", LASIUS_MAPS_DIR), Error);
  EXPECT_THROW((void)load_map("missing.map", LASIUS_MAPS_DIR), Error);
  EXPECT_EQ(load_map("random 10x8 0.25 3", LASIUS_MAPS_DIR).height(), 8);
}

}  // namespace
}  // namespace lasius::study
