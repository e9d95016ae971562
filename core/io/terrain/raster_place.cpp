#include "core/io/terrain/raster_place.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "core/geo/lon_lat.h"

namespace noonmark {

glm::dvec2 RasterPlace::at(glm::dvec2 pixel) const {
    const auto& g = geoTransform;
    return {g[0] + pixel.x * g[1] + pixel.y * g[2], g[3] + pixel.x * g[4] + pixel.y * g[5]};
}

std::vector<glm::dvec2> PixelPlaces::local(const std::vector<glm::dvec2>& pixels) const {
    constexpr double farthestM = 1e6;  // the projection to a plane folds back beyond its horizon
    std::vector<glm::dvec2> points;
    points.reserve(pixels.size());
    for (const glm::dvec2 pixel : pixels) points.push_back(raster_.at(pixel));
    std::vector<glm::dvec2> places;
    places.reserve(pixels.size());
    for (const LonLat place : crs_.lonLat(points))
        places.push_back(computeGreatCircleM(place, frame_.origin()) < farthestM
                             ? frame_.localFromLonLat(place)
                             : glm::dvec2(std::numeric_limits<double>::quiet_NaN()));
    return places;
}

namespace {

// A lattice of points over a window, corners included, `side` + 1 in each direction; row by row.
std::vector<glm::dvec2> latticeOver(const PixelExtent& window, int side) {
    std::vector<glm::dvec2> pixels;
    for (int y = 0; y <= side; ++y)
        for (int x = 0; x <= side; ++x)
            pixels.emplace_back(window.column + double(window.columns) * x / side,
                                window.row + double(window.rows) * y / side);
    return pixels;
}

// The box of four corners, a tenth larger, since curved sides extend beyond the corners.
struct QuadBox {
    glm::dvec2 low{1e300}, high{-1e300};
    void add(glm::dvec2 place) {
        if (std::isnan(place.x)) return;
        low = glm::min(low, place);
        high = glm::max(high, place);
    }
    [[nodiscard]] bool overlaps(double farAwayM) const {
        if (low.x > high.x) return false;
        const glm::dvec2 more = (high - low) * 0.1;
        return low.x - more.x < farAwayM && low.y - more.y < farAwayM && high.x + more.x > -farAwayM &&
               high.y + more.y > -farAwayM;
    }
};

// The part of a window in which cells of a lattice overlap the square around the origin.
std::optional<PixelExtent> shrunk(const PixelExtent& window, const PixelPlaces& places, double farAwayM) {
    constexpr int side = 64;
    const std::vector<glm::dvec2> corners = places.local(latticeOver(window, side));
    glm::ivec2 first(side), end(0);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            QuadBox box;
            for (const int corner : {0, 1, side + 1, side + 2})
                box.add(corners[std::size_t(y) * (side + 1) + std::size_t(x + corner)]);
            if (!box.overlaps(farAwayM)) continue;
            first = glm::min(first, glm::ivec2(x, y));
            end = glm::max(end, glm::ivec2(x + 1, y + 1));
        }
    if (first.x >= end.x) return std::nullopt;
    const auto from = [](int count, int at) { return int(std::int64_t(count) * at / side); };
    const auto to = [](int count, int at) { return int((std::int64_t(count) * at + side - 1) / side); };
    const int left = from(window.columns, first.x), top = from(window.rows, first.y);
    return PixelExtent{window.column + left, window.row + top, to(window.columns, end.x) - left,
                       to(window.rows, end.y) - top};
}

}  // namespace

std::optional<PixelExtent> extentNear(const RasterPlace& raster, const PixelPlaces& places, double farAwayM) {
    std::optional<PixelExtent> window = PixelExtent{0, 0, raster.columns, raster.rows};
    constexpr int maxRounds = 12;  // each round leaves a thirtieth of the window, or nearly the final one
    for (int round = 0; round < maxRounds; ++round) {
        const auto next = shrunk(*window, places, farAwayM);
        if (!next || *next == *window) return next;
        window = next;
    }
    return window;
}

namespace {

// Values at points that are spread evenly over -1 to 1 in u and v, and the polynomials that are orthogonal
// over them: 1, u, u2 - m2, u3 - (m4 / m2) u. The least-squares coefficients are then sums of products.
class EvenSamples {
public:
    static constexpr int side = 33;
    explicit EvenSamples(std::vector<glm::dvec2> values) : values_(std::move(values)) {
        for (int i = 0; i < side; ++i) {
            const double square = at(i) * at(i);
            m2_ += square / side;
            m4_ += square * square / side;
        }
    }
    static double at(int i) { return 2.0 * i / (side - 1) - 1; }

    // Coefficients of 1, u, v, u2, uv, v2, u3, u2v, uv2, v3; or of the first three alone.
    using Coefficients = std::array<glm::dvec2, 10>;
    [[nodiscard]] Coefficients plane() const {
        Coefficients c{};
        c[0] = part(0, 0), c[1] = part(1, 0), c[2] = part(0, 1);
        return c;
    }
    [[nodiscard]] Coefficients cubic() const {
        Coefficients c = plane();
        c[3] = part(2, 0), c[4] = part(1, 1), c[5] = part(0, 2);
        c[6] = part(3, 0), c[7] = part(2, 1), c[8] = part(1, 2), c[9] = part(0, 3);
        c[0] -= m2_ * (c[3] + c[5]);
        c[1] -= m4_ / m2_ * c[6] + m2_ * c[8];
        c[2] -= m4_ / m2_ * c[9] + m2_ * c[7];
        return c;
    }

private:
    [[nodiscard]] double polynomial(int degree, double u) const {
        switch (degree) {
            case 0:
                return 1;
            case 1:
                return u;
            case 2:
                return u * u - m2_;
            default:
                return u * (u * u - m4_ / m2_);
        }
    }
    [[nodiscard]] glm::dvec2 part(int ofU, int ofV) const {
        glm::dvec2 sum(0);
        double squares = 0;
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const double p = polynomial(ofU, at(x)) * polynomial(ofV, at(y));
                sum += p * values_[std::size_t(y) * side + std::size_t(x)];
                squares += p * p;
            }
        return sum / squares;
    }

    std::vector<glm::dvec2> values_;
    double m2_ = 0, m4_ = 0;
};

// The true positions of a window's posts, at `side` x `side` of them or of points between.
class TruePlaces {
public:
    TruePlaces(const PixelPlaces& places, const PixelExtent& window, bool flipped)
        : places_(places), window_(window), flipped_(flipped) {}

    // Columns and rows of these posts.
    [[nodiscard]] std::vector<glm::dvec2> postsOf(int side) const {
        std::vector<glm::dvec2> posts;
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                posts.emplace_back(double(window_.columns - 1) * x / (side - 1),
                                   double(window_.rows - 1) * y / (side - 1));
        return posts;
    }
    [[nodiscard]] std::vector<glm::dvec2> of(const std::vector<glm::dvec2>& posts) const {
        std::vector<glm::dvec2> pixels;
        for (const glm::dvec2 post : posts)
            pixels.emplace_back(window_.column + post.x + 0.5,
                                window_.row + (flipped_ ? double(window_.rows - 1) - post.y : post.y) + 0.5);
        return places_.local(pixels);
    }
    // NaN if a post has no position.
    [[nodiscard]] double worstOf(const PostGrid& grid) const {
        double worst = 0;
        for (const int side : {EvenSamples::side, 39}) {
            const std::vector<glm::dvec2> posts = postsOf(side), places = of(posts);
            for (std::size_t i = 0; i < posts.size(); ++i) {
                const double off = glm::distance(grid.centre(posts[i].x, posts[i].y), places[i]);
                if (std::isnan(off)) return off;
                worst = std::max(worst, off);
            }
        }
        return worst;
    }

private:
    const PixelPlaces& places_;
    const PixelExtent& window_;
    bool flipped_;
};

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

bool turnsRight(const PixelPlaces& places, const PixelExtent& window) {
    const glm::dvec2 middle(window.column + window.columns / 2.0, window.row + window.rows / 2.0);
    const auto at = places.local({middle, middle + glm::dvec2(1, 0), middle + glm::dvec2(0, 1)});
    return cross(at[1] - at[0], at[2] - at[0]) < 0;
}

PostGrid gridOf(const EvenSamples::Coefficients& c, const PixelExtent& window) {
    PostGrid grid;
    grid.columns = window.columns;
    grid.rows = window.rows;
    grid.first = c[0] - c[1] - c[2];
    grid.columnStep = c[1] * (2.0 / (window.columns - 1));
    grid.rowStep = c[2] * (2.0 / (window.rows - 1));
    std::copy(c.begin() + 3, c.end(), grid.bend.begin());
    const PostGrid::Steps middle = grid.stepsAt({(window.columns - 1) / 2.0, (window.rows - 1) / 2.0});
    grid.cellM = std::sqrt(std::abs(cross(middle.column, middle.row)));
    return grid;
}

}  // namespace

PlacedPosts placePosts(const PixelPlaces& places, const PixelExtent& window) {
    constexpr double exactM = 0.001;
    const bool flipped = turnsRight(places, window);
    const TruePlaces truth(places, window, flipped);
    const EvenSamples samples(truth.of(truth.postsOf(EvenSamples::side)));
    PlacedPosts placed{gridOf(samples.plane(), window), flipped};
    placed.misplacedM = truth.worstOf(placed.posts);
    if (placed.misplacedM <= exactM) return placed;
    placed.posts = gridOf(samples.cubic(), window);
    placed.misplacedM = truth.worstOf(placed.posts);
    return placed;
}

}  // namespace noonmark
