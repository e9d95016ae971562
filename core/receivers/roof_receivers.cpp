#include "core/receivers/roof_receivers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "core/describe/text.h"
#include "core/receivers/rasterize.h"

namespace noonmark {

namespace {

/// The part of a building above the plane, as seen from it; none where all of it is below.
std::shared_ptr<const Building> lowered(const Building& building, float byM) {
    Building above = building;
    std::erase_if(above.parts, [&](const Part& part) { return part.topM <= byM; });
    for (Part& part : above.parts) {
        part.topM -= byM;
        part.bottomM = std::max(0.0F, part.bottomM - byM);
        part.isOverhanging = part.isOverhanging && part.bottomM > 0;
    }
    return above.parts.empty() ? nullptr : std::make_shared<const Building>(std::move(above));
}

bool hasMesh(const Building& building) {
    return std::ranges::any_of(building.parts, [](const Part& part) { return part.mesh != nullptr; });
}

}  // namespace

std::optional<City> cutAbovePlane(const City& city, double planeM) {
    if (city.terrain) return std::nullopt;
    City above{city.frame, {}, nullptr};
    for (const auto& building : city.buildings) {
        if (hasMesh(*building)) return std::nullopt;
        if (auto part = lowered(*building, float(planeM))) above.buildings.push_back(std::move(part));
    }
    return above;
}

void raiseToPlane(Receivers& receivers, double planeM) {
    if (receivers.cells.empty()) return;
    double sum = 0;
    for (const std::uint32_t cell : receivers.cells) sum += receivers.position(cell).z;
    const double mean = sum / double(receivers.cells.size());
    receivers.groundM.assign(receivers.grid.size(), float(mean + planeM));
}

namespace {

constexpr float none = std::numeric_limits<float>::lowest();

/// Raises cells to the highest surface over them.
class RoofHeights {
public:
    explicit RoofHeights(const Grid& grid) : grid_(grid), heightM_(grid.size(), none) {}

    void add(const Part& part) {
        if (!part.mesh) return fill(part.footprint, [&](glm::dvec2) { return double(part.topM); });
        for (const glm::uvec3 t : part.mesh->triangles)
            add(glm::dvec3(part.mesh->vertices[t.x]), glm::dvec3(part.mesh->vertices[t.y]),
                glm::dvec3(part.mesh->vertices[t.z]));
    }

    [[nodiscard]] float at(std::size_t cell) const { return heightM_[cell]; }

private:
    template <class Height>
    void fill(const Footprint& footprint, const Height& height) {
        forEachRun(footprint, grid_, [&](int row, int first, int end) {
            for (int column = first; column < end; ++column) {
                float& highest = heightM_[grid_.index(column, row)];
                highest = std::max(highest, float(height(grid_.centre(column, row))));
            }
        });
    }

    // Faces count whichever way they point: the highest one is what is seen from above, and sheets may face
    // down.
    void add(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
        const glm::dvec2 u = glm::dvec2(b) - glm::dvec2(a), v = glm::dvec2(c) - glm::dvec2(a);
        const double area = u.x * v.y - u.y * v.x;
        if (!(std::abs(area) > 1e-9)) return;
        fill({{glm::vec2(a), glm::vec2(b), glm::vec2(c)}, {}}, [&](glm::dvec2 p) {
            const glm::dvec2 d = p - glm::dvec2(a);
            const double s = (d.x * v.y - d.y * v.x) / area, t = (u.x * d.y - u.y * d.x) / area;
            return a.z + s * (b.z - a.z) + t * (c.z - a.z);
        });
    }

    const Grid& grid_;
    std::vector<float> heightM_;
};

void addRoofs(Receivers& receivers, const City& city) {
    RoofHeights heights(receivers.grid);
    for (const auto& building : city.buildings)
        if (overlaps(bounds(*building), receivers.grid))
            for (const Part& part : building->parts) heights.add(part);
    receivers.groundM.resize(receivers.kind.size());
    for (std::size_t cell = 0; cell < receivers.kind.size(); ++cell) {
        if (receivers.kind[cell] != CellKind::building || heights.at(cell) == none) continue;
        receivers.kind[cell] = CellKind::roof;
        receivers.groundM[cell] = heights.at(cell);
    }
}

}  // namespace

std::string_view describe(ReceiverPlaces places) {
    constexpr std::string_view words[] = {NM_TEXT("the ground"), NM_TEXT("roofs"),
                                          NM_TEXT("the ground and roofs")};
    return words[std::size_t(places)];
}

Receivers placeAtHeights(Receivers receivers, const City& city, ReceiverPlaces places) {
    if (places == ReceiverPlaces::ground) return receivers;
    addRoofs(receivers, city);
    if (places == ReceiverPlaces::roofs)
        for (const CellKind open : {CellKind::ground, CellKind::water})
            std::ranges::replace(receivers.kind, open, CellKind::outside);
    receivers.cells.clear();
    for (std::size_t cell = 0; cell < receivers.kind.size(); ++cell)
        if (isReceiver(receivers.kind[cell])) receivers.cells.push_back(std::uint32_t(cell));
    return receivers;
}

Result<void> checkOnGround(ReceiverPlaces places) {
    if (places == ReceiverPlaces::ground) return {};
    return failure(NM_TEXT("This is measured on the ground only, not on roofs"), "receivers",
                   NM_TEXT("Choose the ground, or run a study of the roofs"));
}

Result<Receivers> placeReceivers(const City& city, const Region& region, const ReceiverSettings& settings,
                                 const std::stop_token& stop) {
    return placeReceiversOnGround(city, region, settings, stop).map([&](Receivers receivers) {
        return placeAtHeights(std::move(receivers), city, settings.places);
    });
}

}  // namespace noonmark
