#include "app/report/book/sun_view.h"

#include <tbb/parallel_for.h>

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/report/maps/map_view.h"

namespace noonmark {

namespace {

constexpr float farM = 6000;  // rays start so far from the ground in the middle
constexpr int maxMaskPixels = 3000;

/// What a pixel shows: a surface, for the lines between surfaces, and its colour.
struct Seen {
    std::int64_t surface = 0;
    QRgb colour = 0;
};

QImage maskOf(const std::vector<Place>& places, const Box2& area) {
    const glm::vec2 size = area.high - area.low;
    const float perM = std::min(1.0F, float(maxMaskPixels) / std::max(size.x, size.y));
    QImage mask(std::max(1, int(size.x * perM)), std::max(1, int(size.y * perM)), QImage::Format_Grayscale8);
    mask.fill(0);
    QPainter painter(&mask);
    const MapView view(glm::dvec2(area.low + area.high) / 2.0, perM, QRectF(mask.rect()));
    for (const Place& place : places)
        for (const Footprint& polygon : place.polygons) {
            QPainterPath path;
            view.addTo(path, polygon);
            painter.fillPath(path, Qt::white);
        }
    return mask;
}

/// Parallel rays of a view that shows certain points.
struct Projection {
    glm::vec3 middle, right, up, sun;
    float perPixel = 1;  // metres

    Projection(const std::vector<glm::vec3>& shown, glm::vec3 towardsSun, const QSize& size)
        : sun(towardsSun) {
        const glm::vec3 ahead = -sun;
        right = std::abs(sun.z) > 0.9999F ? glm::vec3(1, 0, 0)
                                          : glm::normalize(glm::cross(ahead, glm::vec3(0, 0, 1)));
        up = glm::cross(right, ahead);
        glm::vec2 low(1e9F), high(-1e9F);
        for (const glm::vec3 point : shown) {
            const glm::vec2 at(glm::dot(point, right), glm::dot(point, up));
            low = glm::min(low, at);
            high = glm::max(high, at);
        }
        middle = right * ((low.x + high.x) / 2) + up * ((low.y + high.y) / 2);
        // Along the rays, so that they start above the ground.
        middle += sun * glm::dot(shown.front() - middle, sun);
        perPixel = std::max(
            {(high.x - low.x) / float(size.width()), (high.y - low.y) / float(size.height()), 0.01F});
    }

    [[nodiscard]] glm::vec3 originOf(int column, int row, const QSize& size) const {
        const float u = (float(column) + 0.5F - float(size.width()) / 2) * perPixel;
        const float v = (float(size.height()) / 2 - float(row) - 0.5F) * perPixel;
        return middle + right * u + up * v + sun * farM;
    }
};

QColor shaded(const QColor& colour, float light) {
    const auto part = [&](int value) { return std::clamp(int(float(value) * light), 0, 255); };
    return {part(colour.red()), part(colour.green()), part(colour.blue())};
}

/// Walls are told apart by their direction, as the sun falls on them.
Seen seenOf(const RayHit& hit, bool isProposal, glm::vec3 sun) {
    const float light = 0.72F + 0.28F * std::max(0.0F, glm::dot(hit.normal, sun));
    const QColor base = isProposal ? QColor(0x7a, 0x5c, 0xc8) : QColor(0xe9, 0xe6, 0xdf);
    const auto side = std::int64_t(std::lround((hit.normal.x + 2 * hit.normal.y + 4 * hit.normal.z) * 50));
    return {(std::int64_t(*hit.building) + 2) * 2000 + side, shaded(base, light).rgb()};
}

/// The corners of the ground, and of the boxes around the proposal's buildings.
std::vector<glm::vec3> pointsToShow(const City& proposal, const Box2& area) {
    std::vector<glm::vec3> points;
    const auto add = [&](const Box2& box, float height) {
        for (const glm::vec2 corner :
             {box.low, box.high, glm::vec2(box.low.x, box.high.y), glm::vec2(box.high.x, box.low.y)})
            points.emplace_back(corner, height);
    };
    add(area, 0);
    for (const auto& building : proposal.buildings) add(bounds(*building), topM(*building));
    return points;
}

void drawEdges(QImage& image, const std::vector<std::int64_t>& surfaces) {
    const int width = image.width();
    for (int y = 0; y + 1 < image.height(); ++y)
        for (int x = 0; x + 1 < width; ++x) {
            const auto at = std::size_t(y) * std::size_t(width) + std::size_t(x);
            if (surfaces[at] != surfaces[at + 1] || surfaces[at] != surfaces[at + std::size_t(width)])
                image.setPixel(x, y, QColor(0x55, 0x55, 0x5c).rgb());
        }
}

}  // namespace

Result<SunViewScene> SunViewScene::make(const DiagramScene& scene, const Box2& area,
                                        const std::stop_token& stop, const City& shown) {
    City all = scene.city;
    all.buildings.insert(all.buildings.end(), scene.proposal.buildings.begin(),
                         scene.proposal.buildings.end());
    std::vector<bool> isProposal(all.buildings.size(), false);
    std::fill(isProposal.begin() + std::ptrdiff_t(scene.city.buildings.size()), isProposal.end(), true);
    auto rays = RayScene::over(all, stop);
    if (!rays) return tl::make_unexpected(rays.error());
    return SunViewScene(*std::move(rays), std::move(isProposal), maskOf(scene.places, area), area,
                        pointsToShow(shown, area));
}

bool SunViewScene::isPlace(glm::vec2 ground) const {
    const glm::vec2 at = (ground - area_.low) / (area_.high - area_.low);
    const int x = int(std::floor(at.x * float(places_.width())));
    const int y = places_.height() - 1 - int(std::floor(at.y * float(places_.height())));
    return places_.valid(x, y) && qGray(places_.pixel(x, y)) > 127;
}

QImage SunViewScene::paint(const SunStep& sun, const QSize& size) const {
    const Projection projection(shown_, sun.direction, size);
    QImage image(size, QImage::Format_RGB32);
    std::vector<std::int64_t> surfaces(std::size_t(size.width()) * std::size_t(size.height()));
    uchar* const bits = image.bits();
    const auto stride = image.bytesPerLine();
    tbb::parallel_for(0, size.height(), [&](int row) {
        auto* const line = reinterpret_cast<QRgb*>(bits + row * stride);
        for (int column = 0; column < size.width(); ++column) {
            const glm::vec3 origin = projection.originOf(column, row, size);
            const auto hit = rays_.firstHit(origin, -sun.direction);
            Seen seen;
            if (hit && hit->building) {
                seen = seenOf(*hit, isProposal_[*hit->building], sun.direction);
            } else {
                const glm::vec3 ground =
                    hit ? hit->position : origin - sun.direction * (origin.z / sun.direction.z);
                const bool place = isPlace(glm::vec2(ground));
                seen = {place ? 1 : 0,
                        place ? QColor(0xb5, 0xd9, 0xae).rgb() : QColor(0xff, 0xff, 0xff).rgb()};
            }
            line[column] = seen.colour;
            surfaces[std::size_t(row) * std::size_t(size.width()) + std::size_t(column)] = seen.surface;
        }
    });
    drawEdges(image, surfaces);
    return image;
}

}  // namespace noonmark
