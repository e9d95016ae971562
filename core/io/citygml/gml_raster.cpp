#include <fmt/format.h>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "core/io/citygml/gml_object.h"

namespace noonmark {

namespace {

constexpr std::size_t maxRasterPosts = 4'000'000;  // as triangles of a TIN some 250 bytes each
constexpr double lowestElevationM = -1000;  // below it a number stands for "no elevation", such as -9999

// What is no number, such as "inapplicable", is NaN.
std::vector<double> readElevations(std::string_view text) {
    constexpr std::string_view blanks = " \t\r\n,;";
    std::vector<double> elevations;
    for (std::size_t at = text.find_first_not_of(blanks); at != text.npos;
         at = text.find_first_not_of(blanks, at)) {
        const std::size_t end = std::min(text.find_first_of(blanks, at), text.size());
        double number = 0;
        const auto [after, error] = std::from_chars(text.data() + at, text.data() + end, number);
        const bool isGood = error == std::errc() && after == text.data() + end && number > lowestElevationM;
        elevations.push_back(isGood ? number : std::numeric_limits<double>::quiet_NaN());
        at = end;
    }
    return elevations;
}

glm::dvec2 gmlPointOf(const std::vector<double>& numbers) { return {numbers[0], numbers[1]}; }

}  // namespace

void GmlRasterReader::end(std::string_view name, std::string_view text) {
    std::vector<double> numbers;
    if (name == "fileName") file_ = text;
    if (name == "sequenceRule") isLinear_ = text.empty() || text == "Linear";
    if (name == "tupleList" || name == "doubleOrNilReasonTupleList") elevations_ = readElevations(text);
    if (!readGmlNumbers(text, numbers) || numbers.size() < 2) return;
    if (name == "low") low_ = gmlPointOf(numbers);
    if (name == "high") high_ = gmlPointOf(numbers);
    if (name == "pos" || name == "coordinates") origin_ = gmlPointOf(numbers);
    if (name == "offsetVector") offsets_.push_back(gmlPointOf(numbers));
}

std::string GmlRasterReader::findFault() const {
    if (!file_.empty()) return "its elevations are in " + file_;
    if (elevations_.empty() || !origin_ || offsets_.size() != 2 || !high_) return "it holds no grid";
    if (!isLinear_) return "its elevations are not in rows";
    const glm::dvec2 posts = *high_ - low_ + 1.0;
    if (!(posts.x >= 2) || !(posts.y >= 2) || posts.x * posts.y > double(maxRasterPosts))
        return fmt::format("its grid has {:g} x {:g} elevations", posts.x, posts.y);
    if (posts.x * posts.y == double(elevations_.size())) return {};
    return fmt::format("it has {} elevations for a grid of {:g} x {:g}", elevations_.size(), posts.x,
                       posts.y);
}

CityJsonBlock GmlRasterReader::makeBlock(const std::string& id) const {
    const auto columns = std::size_t(high_->x - low_.x + 1), rows = elevations_.size() / columns;
    CityJsonBlock block;
    std::vector<std::uint32_t> vertexOf;
    for (std::size_t i = 0; i < elevations_.size(); ++i) {
        vertexOf.push_back(std::uint32_t(block.vertices.size()));
        if (!std::isfinite(elevations_[i])) continue;
        const glm::dvec2 at =
            *origin_ + double(i % columns) * offsets_[0] + double(i / columns) * offsets_[1];
        block.vertices.emplace_back(at, elevations_[i]);
    }
    CityJsonBody body(1);
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
        if (std::isfinite(elevations_[a] + elevations_[b] + elevations_[c]))
            body[0].push_back({{vertexOf[a], vertexOf[b], vertexOf[c]}});
    };
    for (std::size_t row = 0; row + 1 < rows; ++row)
        for (std::size_t i = row * columns; i + 1 < (row + 1) * columns; ++i) {
            add(i, i + 1, i + columns + 1);
            add(i, i + columns + 1, i + columns);
        }
    block.objects.push_back({.id = id, .type = "TINRelief"});
    block.objects.front().body = CityJsonGeometry{.bodies = {std::move(body)}};
    return block;
}

}  // namespace noonmark
