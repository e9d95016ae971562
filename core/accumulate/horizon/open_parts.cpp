#include "core/accumulate/horizon/open_parts.h"

#include <algorithm>
#include <cmath>

#include "core/accumulate/ray_reference.h"
#include "core/city/city.h"

namespace noonmark {

namespace {

// Gaps that are collected before those of one receiver are made one.
constexpr std::size_t gapsAMerge = std::size_t{1} << 20U;
constexpr double onTheWall = 1e-3;  // cells; nearer than that a receiver is on the triangle

HorizonCode codeAt(double rise, double distance) {
    return rise <= 0 ? noHorizon : codeOfHorizon(float(rise / (rise + distance)));
}

/// Where the vertical plane through the receiver meets a side.
struct Crossing {
    double along, rise;
};

template <class Corner>
Crossing crossing(const Corner& a, const Corner& b, double q) {
    const double t = std::clamp((q - a.q) / (b.q - a.q), 0.0, 1.0);
    return {a.along + t * (b.along - a.along), a.rise + t * (b.rise - a.rise)};
}

}  // namespace

void addTriangles(const Part& part, const Grid& grid, double datumM, std::vector<OpenTriangle>& triangles) {
    const TriangleMesh mesh = part.mesh ? *part.mesh : meshOf(part);
    const auto corner = [&](std::uint32_t index) {
        const glm::dvec3 point(mesh.vertices[index]);
        return glm::dvec3((point.x - grid.westM) / grid.cellM - 0.5,
                          (point.y - grid.southM) / grid.cellM - 0.5, point.z - datumM);
    };
    for (const glm::uvec3& triangle : mesh.triangles)
        triangles.push_back({corner(triangle.x), corner(triangle.y), corner(triangle.z)});
}

std::vector<Gap> OpenSweep::sweep(glm::dvec2 away, HorizonCode lowest, double cellM,
                                  std::span<HorizonCode> codes, const std::stop_token& stop) {
    const ShadowAxes axes(away);
    alongPerMetre_ = axes.alongPerDistance / cellM;
    lowest_ = lowest;
    codes_ = codes;
    lowestTan_ = double(steepnessOf(lowest) / (1 - steepnessOf(lowest)));
    gaps_.clear();
    merged_ = 0;
    for (const OpenTriangle& triangle : triangles_) {
        if (stop.stop_requested()) return {};
        add(triangle, axes);
    }
    merge();
    std::vector<Gap> open;
    for (const Gap& gap : gaps_) {
        HorizonCode& horizon = codes[gap.number];
        // What begins a level above ends there too: the two are one but for rounding. And below the lowest
        // sun there is nothing to see.
        if (int(gap.low) <= std::max(int(horizon) + 1, int(lowest)))
            horizon = std::max(horizon, gap.high);
        else if (gap.high > horizon)
            open.push_back(gap);
    }
    return open;
}

void OpenSweep::add(const OpenTriangle& triangle, const ShadowAxes& axes) {
    for (std::size_t i = 0; i < 3; ++i) {
        const ShadowAxes::Point point = axes.from(glm::dvec2(triangle[i]));
        corners_[i] = {point.q, point.along, triangle[i].z * alongPerMetre_};
    }
    std::ranges::sort(corners_, {}, &Corner::q);
    const auto [near, far] = std::minmax({corners_[0].along, corners_[1].along, corners_[2].along});
    const double rise = std::max({corners_[0].rise, corners_[1].rise, corners_[2].rise});
    if (rise <= 0 || corners_[0].q >= corners_[2].q) return;
    const double from = axes.swapped ? tile_.box.firstColumn : tile_.box.firstRow,
                 to = from + (axes.swapped ? tile_.box.columns : tile_.box.rows) - 1;
    const double tileLow = std::min(axes.sign * from, axes.sign * to),
                 tileHigh = std::max(axes.sign * from, axes.sign * to);
    const double first = std::max(std::ceil(near), tileLow),
                 last = std::min(std::floor(far + rise / lowestTan_ + 1), tileHigh);
    for (double along = first; along <= last; ++along)
        addLine(int(along), along > far ? codeAt(rise, along - far) : codeAt(1, 0), axes);
    if (gaps_.size() - merged_ > gapsAMerge) merge();
}

// The cells of one line across whose shadow line meets the triangle: lowest q <= q < highest q. None of them
// can see it higher than `most`, but for a level of rounding.
void OpenSweep::addLine(int along, HorizonCode most, const ShadowAxes& axes) {
    const double shift = axes.k * along;
    const int low = axes.swapped ? tile_.box.firstRow : tile_.box.firstColumn,
              count = axes.swapped ? tile_.box.rows : tile_.box.columns;
    const double first = std::max(std::ceil(corners_[0].q + shift), double(low)),
                 end = std::min(std::ceil(corners_[2].q + shift), double(low + count));
    const int line = int(axes.sign) * along;
    for (int across = int(first); across < end; ++across) {
        const int column = axes.swapped ? line : across, row = axes.swapped ? across : line;
        const std::int32_t number =
            tile_.numbers[std::size_t(row - tile_.box.firstRow) * std::size_t(tile_.box.columns) +
                          std::size_t(column - tile_.box.firstColumn)];
        if (number >= 0 && codes_[std::size_t(number)] <= most) addCell(number, across - shift, along);
    }
}

void OpenSweep::addCell(std::int32_t number, double q, double along) {
    const Crossing a = crossing(corners_[0], corners_[2], q);
    const Crossing b =
        q < corners_[1].q ? crossing(corners_[0], corners_[1], q) : crossing(corners_[1], corners_[2], q);
    const Crossing near = a.along > b.along ? a : b, far = a.along > b.along ? b : a;
    const double toNear = along - near.along, toFar = along - far.along;
    if (toFar <= onTheWall) return;
    const double ground =
        tile_.groundsM.empty() ? 0 : double(tile_.groundsM[std::size_t(number)]) * alongPerMetre_;
    // Over the receiver itself: everything up to the zenith.
    const bool over = toNear <= 0 && (near.rise * toFar - far.rise * toNear) / (toFar - toNear) > ground;
    const HorizonCode atNear = toNear > 0 ? codeAt(near.rise - ground, toNear)
                               : over     ? codeAt(1, 0)
                                          : noHorizon,
                      atFar = codeAt(far.rise - ground, toFar);
    const HorizonCode low = std::min(atNear, atFar), high = std::max(atNear, atFar);
    // Below the horizon it changes nothing: what it would join begins at the horizon or below, too.
    if (high > std::max(lowest_, codes_[std::size_t(number)]))
        gaps_.push_back({std::uint32_t(number), low, high});
}

// By receiver and from below; those that meet become one.
void OpenSweep::merge() {
    std::ranges::sort(gaps_, [](const Gap& a, const Gap& b) {
        return a.number != b.number ? a.number < b.number : a.low < b.low;
    });
    std::size_t kept = 0;
    for (const Gap& gap : gaps_) {
        Gap* last = kept > 0 ? &gaps_[kept - 1] : nullptr;
        if (last != nullptr && last->number == gap.number && int(gap.low) <= int(last->high) + 1)
            last->high = std::max(last->high, gap.high);
        else
            gaps_[kept++] = gap;
    }
    gaps_.resize(kept);
    merged_ = kept;
}

OpenTile::OpenTile(const Receivers& receivers, const ReceiverBlocks& blocks, double datumM)
    : box(blocks.box()), numbers(std::size_t(box.columns) * std::size_t(box.rows), -1) {
    const auto columns = std::uint32_t(receivers.grid.columns);
    if (!receivers.flat()) groundsM.resize(blocks.numbers());
    for (std::size_t number = 0; number < blocks.numbers(); ++number) {
        const std::uint32_t cell = blocks.cell(number);
        if (cell == ReceiverBlocks::padding) continue;
        const int column = int(cell % columns) - box.firstColumn, row = int(cell / columns) - box.firstRow;
        numbers[std::size_t(row) * std::size_t(box.columns) + std::size_t(column)] = std::int32_t(number);
        if (!receivers.flat())
            groundsM[number] = float(double(rayOrigin(receivers.position(cell)).z) - datumM);
    }
}

}  // namespace noonmark
