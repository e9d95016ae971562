#include "core/study/elements/element_models.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "core/measures/palette.h"

namespace noonmark {
namespace {

template <class T>
T numberAt(const std::string& bytes, std::size_t offset) {
    T value;
    std::memcpy(&value, bytes.data() + offset, sizeof(T));
    return value;
}

// A bay of 4 x 3 m of a wall that faces south, its point at (10, 20) and 1.5 m above the floor at 6 m.
ElementMap oneBay() {
    MeasuredElement element{.id = "wall 1 \xff"};
    element.position = {10, 20, 7.5F};
    element.normal = {0, -1, 0};
    element.pane = {{-2, -1.5}, {2, 1.5}};
    element.sunlitMin = 120;
    element.grossMin = 240;
    element.continuousMin = 90;
    return {{element}, 360};
}

TEST(ElementMaps, TheCornersOfABayLieInFrontOfItsWall) {
    const auto corners = cornersOf(oneBay().elements[0]);
    EXPECT_EQ(corners[0], glm::vec3(8, 19.97F, 6));
    EXPECT_EQ(corners[2], glm::vec3(12, 19.97F, 9));
    MeasuredElement point = oneBay().elements[0];
    point.pane = {};
    EXPECT_EQ(cornersOf(point)[2], glm::vec3(10.5F, 19.97F, 8.1F)) << "a window without a size";
}

TEST(ElementGltf, ABayIsARectangleInTheColourOfItsShadow) {
    const std::string file = toGlb(oneBay());
    ASSERT_EQ(file.substr(0, 4), "glTF");
    EXPECT_EQ(numberAt<std::uint32_t>(file, 4), 2U);
    ASSERT_EQ(numberAt<std::uint32_t>(file, 8), file.size());
    const auto text = numberAt<std::uint32_t>(file, 12);
    EXPECT_EQ(text % 4, 0U);
    const auto json = nlohmann::json::parse(file.substr(20, text));
    const std::string bytes = file.substr(20 + text + 8);
    EXPECT_EQ(json["buffers"][0]["byteLength"], bytes.size());
    EXPECT_EQ(json["scenes"][0]["nodes"], nlohmann::json::array({0}));
    EXPECT_EQ(json["meshes"][0]["extras"]["ids"].size(), 1U);
    const auto& primitive = json["meshes"][0]["primitives"][0];
    const auto offsetOf = [&](const nlohmann::json& accessor) {
        const std::size_t view = json["accessors"][accessor.get<std::size_t>()]["bufferView"];
        return json["bufferViews"][view]["byteOffset"].get<std::size_t>();
    };
    const auto& attributes = primitive["attributes"];
    const std::size_t first = offsetOf(attributes["POSITION"]);
    EXPECT_EQ(numberAt<float>(bytes, first), 8) << "x is east";
    EXPECT_EQ(numberAt<float>(bytes, first + 4), 6) << "y is up";
    EXPECT_EQ(numberAt<float>(bytes, first + 8), -19.97F) << "z is south";
    EXPECT_EQ(numberAt<float>(bytes, offsetOf(attributes["_SUNLIT_MIN"])), 120);
    EXPECT_EQ(numberAt<std::uint32_t>(bytes, offsetOf(primitive["indices"]) + 20), 3U);
    const double red = shadowRgb(240.0 / legendScale(360).top).red / 255.0;
    EXPECT_NEAR(numberAt<std::uint8_t>(bytes, offsetOf(attributes["COLOR_0"])),
                255 * std::pow((red + 0.055) / 1.055, 2.4), 1)
        << "linear light";
}

}  // namespace
}  // namespace noonmark
