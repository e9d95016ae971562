#include "core/engines/ray/traced_view.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "tests/core/engines/scenes.h"
#include "tests/core/simd/random_blocks.h"

namespace noonmark {
namespace {

using namespace tests;

constexpr int width = 66, height = 47;  // not multiples of a packet's four pixels

TracedView trace(const City& city, const PixelCamera& camera, const TracedSpace& space) {
    TracedView view;
    traceView(RayScene::over(city).value(), camera, space, view);
    return view;
}

glm::vec3 placeOf(const PixelCamera& camera, const TracedView& view, std::size_t pixel) {
    const LineOfSight line = lineThrough(camera, int(pixel) % width, int(pixel) / width);
    return glm::vec3(line.origin + double(view.pixels[pixel].depthM) * line.direction);
}

/// A box of 20 m on a plane, seen from the south and above.
struct OneBox {
    City city = cityOf({{{-10, -10, 0}, {10, 10, 20}}});
    PixelCamera camera = makeCamera({0, -100, 60}, {0, 0, 10}, 40, width, height);

    [[nodiscard]] std::size_t pixelOf(glm::dvec3 point) const {
        const glm::dvec3 seen = point - camera.eye;
        const double scale = samplesPerMetre(camera, glm::dot(seen, camera.forward));
        const double column = width * 0.5 + scale * glm::dot(seen, camera.right);
        const double row = height * 0.5 - scale * glm::dot(seen, camera.up);
        return std::size_t(row) * width + std::size_t(column);
    }
};

void expectSameAsSurface(const City& city, const PixelCamera& camera) {
    const TracedView view = trace(city, camera, {.farM = float(farthestVisibleM)});
    const auto surface = findVisibleSurface(RayScene::over(city).value(), true, camera).value();
    ASSERT_EQ(view.pixels.size(), std::size_t(width * height));
    std::size_t point = 0, differing = 0;
    for (std::size_t pixel = 0; pixel < view.pixels.size(); ++pixel) {
        const bool seen = point < surface.pixel.size() && surface.pixel[point] == pixel;
        ASSERT_EQ(kindOf(view.pixels[pixel]) != SeenKind::sky, seen) << pixel;
        if (!seen) continue;
        const glm::vec3 position = surface.points.positions[point], normal = surface.points.normals[point];
        ++point;
        const bool same = glm::distance(placeOf(camera, view, pixel), position) < 0.01F &&
                          glm::dot(normalOf(view.pixels[pixel]), normal) > 0.9999F;
        differing += same ? 0 : 1;
        const bool onGround = position.z < 1e-3F && normal.z > 0.5F;
        EXPECT_TRUE(!same || (kindOf(view.pixels[pixel]) == SeenKind::ground) == onGround) << pixel;
    }
    // A ray along an edge may hit either side.
    EXPECT_LE(differing, 4U);
}

TEST(TracedView, ShowsTheSameAsTheVisibleSurface) {
    for (const std::uint32_t seed : {1U, 2U, 3U}) {
        const City city = cityOf(randomBoxes(seed, 6));
        expectSameAsSurface(city, makeCamera({40, -300, 140}, {60, 60, 10}, 40, width, height));
        PixelCamera parallel = makeCamera({-300, 20, 300}, {60, 60, 0}, 40, width, height);
        parallel.heightM = 220;
        expectSameAsSurface(city, parallel);
    }
}

TEST(TracedView, MarksTheEdgesOfABox) {
    const OneBox box;
    const TracedView view = trace(box.city, box.camera, {});
    EXPECT_FALSE(isEdge(view.pixels[box.pixelOf({0, -10, 10})])) << "within the facade";
    EXPECT_FALSE(isEdge(view.pixels[box.pixelOf({0, 0, 20})])) << "within the roof";
    EXPECT_FALSE(isEdge(view.pixels[box.pixelOf({0, -30, 0})])) << "on the ground";
    int edges = 0;
    const std::size_t middle = box.pixelOf({0, -10, 20});
    for (const std::size_t row : {middle - width, middle, middle + width})
        edges += isEdge(view.pixels[row]) ? 1 : 0;
    EXPECT_EQ(edges, 1) << "between roof and facade";
}

// Above and beside the box is sky: its own pixels have the line, not those of the sky.
TEST(TracedView, SilhouettesBelongToWhatIsNear) {
    OneBox box;
    box.camera = makeCamera({0, -100, 5}, {0, 0, 15}, 40, width, height);
    const TracedView view = trace(box.city, box.camera, {});
    int top = 0, left = 0, right = 0;
    for (std::size_t pixel = 0; pixel < view.pixels.size(); ++pixel) {
        if (!isEdge(view.pixels[pixel])) continue;
        ASSERT_NE(kindOf(view.pixels[pixel]), SeenKind::sky);
        const glm::vec3 place = placeOf(box.camera, view, pixel);
        top += place.z > 17 ? 1 : 0;
        left += place.x < -8.5F && place.z > 2 ? 1 : 0;
        right += place.x > 8.5F && place.z > 2 ? 1 : 0;
    }
    EXPECT_GT(top, 10);
    EXPECT_GT(left, 10);
    EXPECT_GT(right, 10);
}

TEST(TracedView, OnlyTheWantedColumnsAreTraced) {
    const OneBox box;
    const TracedView whole = trace(box.city, box.camera, {});
    TracedView part;
    traceView(RayScene::over(box.city).value(), box.camera, {.firstColumn = 20, .lastColumn = 41}, part);
    for (int row = 0; row < height; ++row) {
        EXPECT_EQ(part.pixels[std::size_t(row * width + 5)].bits, 0U);
        EXPECT_EQ(part.pixels[std::size_t(row * width + 60)].bits, 0U);
        for (int column = 21; column < 40; ++column) {
            const auto pixel = std::size_t(row * width + column);
            ASSERT_EQ(part.pixels[pixel].bits, whole.pixels[pixel].bits) << row << ' ' << column;
        }
    }
}

// The terrain is a plateau of 100 m a side, 30 m above the plane: a sun of 25 degrees would shade 64 m of it.
TEST(TracedView, TheBorderOfATerrainThrowsNoShadow) {
    City city = cityOf({{{-5, 40, 30}, {5, 45, 50}}});
    city.terrain =
        std::make_shared<const Terrain>(Terrain{{-60, -60, 20, 6, 6}, std::vector<float>(36, 30.0F)});
    const PixelCamera camera = makeCamera({0, -60, 400}, {0, 60, 0}, 40, width, height);
    const glm::vec3 sun = glm::normalize(glm::vec3(0, -0.9063F, 0.4226F));
    const auto count = [&](const Terrain* terrain) {
        std::array<int, 2> bySun{};
        const TracedView view = trace(city, camera, {.terrain = terrain, .towardsSun = sun});
        for (std::size_t pixel = 0; pixel < view.pixels.size(); ++pixel) {
            const glm::vec3 place = placeOf(camera, view, pixel);
            const bool beside = kindOf(view.pixels[pixel]) == SeenKind::ground && place.z < 1 &&
                                std::abs(place.x) > 8 && std::abs(place.x) < 45 && place.y > 60;
            if (beside) ++bySun[isInSun(view.pixels[pixel]) ? 1 : 0];
        }
        return bySun;
    };
    EXPECT_GT(count(nullptr)[0], 40) << "the step's shadow";
    EXPECT_EQ(count(city.terrain.get())[0], 0);
    EXPECT_GT(count(city.terrain.get())[1], 100);
}

TEST(TracedView, TerrainHasNoEdges) {
    City city;
    std::vector<float> elevationM(36, 5.0F);
    elevationM[14] = 30;  // a steep hill
    city.terrain = std::make_shared<const Terrain>(Terrain{{-60, -60, 20, 6, 6}, elevationM});
    const TracedView view = trace(city, makeCamera({0, -200, 120}, {0, 0, 0}, 40, width, height), {});
    int ground = 0;
    for (const TracedPixel pixel : view.pixels) {
        ground += kindOf(pixel) == SeenKind::ground ? 1 : 0;
        EXPECT_FALSE(isEdge(pixel));
    }
    EXPECT_GT(ground, width * height / 2);
}

TEST(TracedView, HiddenBuildingsAreLookedThrough) {
    const std::vector<Box3> boxes = randomBoxes(7, 6);
    const PixelCamera camera = makeCamera({40, -300, 140}, {60, 60, 10}, 40, width, height);
    std::vector<std::uint8_t> hidden(boxes.size(), 0);
    std::vector<Box3> rest;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        hidden[i] = i % 3 == 0 ? 1 : 0;
        if (hidden[i] == 0) rest.push_back(boxes[i]);
    }
    const TracedView view = trace(cityOf(boxes), camera, {.hidden = hidden});
    const TracedView expected = trace(cityOf(rest), camera, {});
    std::size_t differing = 0;
    for (std::size_t pixel = 0; pixel < view.pixels.size(); ++pixel)
        differing += view.pixels[pixel].bits != expected.pixels[pixel].bits ? 1 : 0;
    EXPECT_LE(differing, 2U);
}

TEST(TracedView, MarksThePixelsOfMarkedBuildingsAlone) {
    const std::vector<Box3> boxes = randomBoxes(7, 6);
    const PixelCamera camera = makeCamera({40, -300, 140}, {60, 60, 10}, 40, width, height);
    const std::vector<std::uint8_t> second{0, 1};
    const TracedView view = trace(cityOf(boxes), camera, {.marked = second});
    const TracedView plain = trace(cityOf(boxes), camera, {});
    std::size_t marked = 0;
    for (std::size_t pixel = 0; pixel < view.pixels.size(); ++pixel) {
        EXPECT_EQ(isMarked(view.pixels[pixel]), view.hits[pixel] == 1U) << pixel;
        EXPECT_EQ(kindOf(view.pixels[pixel]), kindOf(plain.pixels[pixel])) << pixel;
        EXPECT_FALSE(isMarked(plain.pixels[pixel]));
        marked += isMarked(view.pixels[pixel]) ? 1 : 0;
    }
    EXPECT_GT(marked, 0U);
}

TEST(TracedView, ASectionShowsTheInsideOfWhatItCuts) {
    OneBox box;
    box.camera.section = VisibleBox{{-30, -30, -1}, {30, 30, 10}};
    const TracedView view = trace(box.city, box.camera, {});
    EXPECT_EQ(kindOf(view.pixels[box.pixelOf({0, -10, 5})]), SeenKind::building);
    EXPECT_EQ(kindOf(view.pixels[box.pixelOf({0, 0, 10})]), SeenKind::cut);
    EXPECT_EQ(kindOf(view.pixels[box.pixelOf({0, -25, 0})]), SeenKind::ground);
    EXPECT_EQ(kindOf(view.pixels[box.pixelOf({0, -38, 0})]), SeenKind::sky) << "outside of the box";
    for (const double heightM : {90.0, 200.0, 300.0, 1000.0}) {
        box.camera = makeCamera({0, 0, heightM}, {0, 0, 0}, 40, width, height);
        box.camera.section = VisibleBox{{-30, -30, -1}, {30, 30, 10}};
        const TracedView above = trace(box.city, box.camera, {});
        EXPECT_EQ(kindOf(above.pixels[box.pixelOf({0, 0, 10})]), SeenKind::cut) << heightM;
        EXPECT_EQ(kindOf(above.pixels[box.pixelOf({25, 0, 0})]), SeenKind::ground) << heightM;
    }
}

// The sun stands 45 degrees high in the south: the shadow of the box is as long as the box is high.
TEST(TracedView, ShadowsAreWhereTheSunIsHidden) {
    OneBox box;
    box.camera = makeCamera({0, 0, 200}, {0, 0, 0}, 40, width, height);
    const TracedView view = trace(box.city, box.camera, {.towardsSun = towardsSun(180, 45)});
    const auto lit = [&](glm::dvec3 point) { return isInSun(view.pixels[box.pixelOf(point)]); };
    EXPECT_TRUE(lit({0, 0, 20})) << "the roof";
    EXPECT_TRUE(lit({0, -20, 0}));
    EXPECT_FALSE(lit({0, 18, 0}));
    EXPECT_FALSE(lit({0, 26, 0}));
    EXPECT_TRUE(lit({0, 34, 0}));
    EXPECT_TRUE(lit({20, 18, 0}));
    const TracedView without = trace(box.city, box.camera, {});
    EXPECT_FALSE(isInSun(without.pixels[box.pixelOf({0, -20, 0})])) << "no sun was asked for";
}

std::vector<TracedTrees> treesOf(const Box3& box, TreePart part) {
    return {{RayScene::over(cityOf({box})).value(), {part}}};
}

// A crown in the shape of a box, 30 to 40 m east and 10 to 20 m high: with the sun at 45 degrees in the west
// its shade lies from 40 to 60 m east, that of the box from 10 to 30.
TEST(TracedView, CrownsShadeWhatBuildingsLeaveInTheSun) {
    OneBox scene;
    scene.camera = makeCamera({0, 0, 200}, {0, 0, 0}, 40, width, height);
    const auto traced = [&](TreePart part) {
        const auto trees = treesOf({{30, -10, 10}, {40, 10, 20}}, part);
        return trace(scene.city, scene.camera,
                     {.towardsSun = glm::normalize(glm::vec3(-1, 0, 1)), .trees = trees});
    };
    const auto at = [&](const TracedView& view, glm::dvec3 point) {
        return view.pixels[scene.pixelOf(point)];
    };
    const glm::dvec3 shaded{50, 0, 0}, open{-40, 0, 0}, behindTheHouse{20, 0, 0};
    for (const TreePart part : {TreePart::evergreen, TreePart::leafy}) {
        const TracedView dense = traced(part);
        EXPECT_TRUE(isUnderCrown(at(dense, shaded)));
        EXPECT_FALSE(isInSun(at(dense, shaded)));
        EXPECT_TRUE(isInSun(at(dense, open)));
        EXPECT_FALSE(isUnderCrown(at(dense, open)));
        EXPECT_FALSE(isUnderCrown(at(dense, behindTheHouse))) << "in full shadow";
    }
    const TracedView light = traced(TreePart::bare);
    EXPECT_TRUE(isUnderCrown(at(light, shaded)));
    EXPECT_TRUE(isInSun(at(light, shaded)));
    const TracedView trunk = traced(TreePart::trunk);
    EXPECT_FALSE(isUnderCrown(at(trunk, shaded)));
    EXPECT_TRUE(isInSun(at(trunk, shaded)));
}

// A crown of 10 m to the south of the box covers the middle of its facade.
TEST(TracedView, TreesHideWhatIsBehindThem) {
    const OneBox scene;
    const TracedView without = trace(scene.city, scene.camera, {});
    const std::size_t pixel = scene.pixelOf({0, -35, 22});
    ASSERT_EQ(kindOf(without.pixels[pixel]), SeenKind::building);
    for (const TreePart part : {TreePart::evergreen, TreePart::leafy, TreePart::trunk}) {
        const auto trees = treesOf({{-5, -35, 5}, {5, -25, 25}}, part);
        const TracedView view = trace(scene.city, scene.camera, {.trees = trees});
        EXPECT_EQ(treePartOf(view.pixels[pixel]), part);
        EXPECT_NEAR(placeOf(scene.camera, view, pixel).y, -35, 0.01);
        EXPECT_GT(glm::dot(normalOf(view.pixels[pixel]), glm::vec3(0, -1, 0)), 0.999F);
        EXPECT_FALSE(isBehindBareCrown(view.pixels[pixel]));
        std::size_t seen = 0;
        for (std::size_t i = 0; i < view.pixels.size(); ++i) {
            if (!treePartOf(view.pixels[i])) {
                EXPECT_EQ(view.pixels[i].depthM, without.pixels[i].depthM) << i;
                continue;
            }
            ++seen;
            EXPECT_FALSE(isEdge(view.pixels[i])) << i;
            EXPECT_LT(view.pixels[i].depthM, without.pixels[i].depthM) << i;
        }
        EXPECT_GT(seen, 20U);
    }
}

TEST(TracedView, BuildingsHideTheTreesBehindThem) {
    const OneBox scene;
    const auto trees = treesOf({{-5, 20, 0}, {5, 30, 10}}, TreePart::leafy);
    const TracedView view = trace(scene.city, scene.camera, {.trees = trees});
    EXPECT_EQ(treePartOf(view.pixels[scene.pixelOf({0, -10, 10})]), std::nullopt);
}

TEST(TracedView, BareCrownsAreSeenThrough) {
    const OneBox scene;
    auto trees = treesOf({{-5, -35, 5}, {5, -25, 25}}, TreePart::bare);
    trees.push_back(treesOf({{-1, -31, 0}, {1, -29, 12}}, TreePart::trunk)[0]);
    const TracedView view = trace(scene.city, scene.camera, {.trees = trees});
    const TracedView without = trace(scene.city, scene.camera, {});
    const std::size_t facade = scene.pixelOf({3, -35, 22}), trunk = scene.pixelOf({0, -31, 8});
    EXPECT_TRUE(isBehindBareCrown(view.pixels[facade]));
    EXPECT_EQ(view.pixels[facade].depthM, -without.pixels[facade].depthM);
    EXPECT_EQ(view.pixels[facade].bits, without.pixels[facade].bits);
    EXPECT_TRUE(isBehindBareCrown(view.pixels[trunk])) << "within the crown";
    EXPECT_EQ(treePartOf(view.pixels[trunk]), TreePart::trunk);
    EXPECT_FALSE(isBehindBareCrown(view.pixels[scene.pixelOf({-9, -10, 2})])) << "beside it";
}

TEST(TracedView, IsTheSameOnEveryInstructionSet) {
    const City city = cityOf(randomBoxes(5, 6));
    const PixelCamera camera = makeCamera({40, -300, 140}, {60, 60, 10}, 40, width, height);
    const TracedSpace space{.towardsSun = towardsSun(140, 30)};
    const TracedView expected = trace(city, camera, space);
    forEachInstructionSet([&] {
        const TracedView view = trace(city, camera, space);
        for (std::size_t pixel = 0; pixel < view.pixels.size(); ++pixel) {
            ASSERT_EQ(view.pixels[pixel].bits, expected.pixels[pixel].bits) << pixel;
            ASSERT_EQ(view.pixels[pixel].depthM, expected.pixels[pixel].depthM) << pixel;
        }
    });
}

}  // namespace
}  // namespace noonmark
