#include "core/accumulate/horizon/open_parts.h"

#include <algorithm>
#include <cmath>

#include "core/accumulate/ray_reference.h"

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

std::span<const Gap> OpenSweep::intervals(const OpenView& view, std::span<const HorizonCode> horizons,
                                          const std::stop_token& stop) {
    view_ = &view;
    axes_ = ShadowAxes(view.away);
    alongPerMetre_ = axes_.alongPerDistance / view.cellM;
    lowestTan_ = double(steepnessOf(view.lowest) / (1 - steepnessOf(view.lowest)));
    findLines();
    horizons_ = horizons;
    gaps_.clear();
    merged_ = 0;
    for (const OpenTriangle& triangle : view.triangles) {
        if (stop.stop_requested()) return {};
        add(triangle);
    }
    merge();
    return gaps_;
}

void OpenSweep::findLines() {
    const TileBox& box = view_->tile.box;
    const double from = axes_.swapped ? box.firstColumn : box.firstRow,
                 to = from + (axes_.swapped ? box.columns : box.rows) - 1;
    lines_ = {std::max(std::min(axes_.sign * from, axes_.sign * to), std::ceil(view_->within.lowAlong)),
              std::min(std::max(axes_.sign * from, axes_.sign * to), std::floor(view_->within.highAlong))};
}

void OpenSweep::add(const OpenTriangle& triangle) {
    for (std::size_t i = 0; i < 3; ++i) {
        const ShadowAxes::Point point = axes_.from(glm::dvec2(triangle[i]));
        corners_[i] = {point.q, point.along, triangle[i].z * alongPerMetre_};
    }
    std::ranges::sort(corners_, {}, &Corner::q);
    const auto [near, far] = std::minmax({corners_[0].along, corners_[1].along, corners_[2].along});
    const double rise = std::max({corners_[0].rise, corners_[1].rise, corners_[2].rise});
    if (rise <= 0 || corners_[0].q >= corners_[2].q) return;
    if (corners_[2].q <= view_->within.lowQ || corners_[0].q >= view_->within.highQ) return;
    const double first = std::max(std::ceil(near), lines_.first),
                 last = std::min(std::floor(far + rise / lowestTan_ + 1), lines_.last);
    for (double along = first; along <= last; ++along)
        addLine(int(along), along > far ? codeAt(rise, along - far) : codeAt(1, 0));
    if (gaps_.size() - merged_ > gapsAMerge) merge();
}

// The cells of one line across whose shadow line meets the triangle: lowest q <= q < highest q. None of them
// can see it higher than `most`, but for a level of rounding.
void OpenSweep::addLine(int along, HorizonCode most) {
    const OpenTile& tile = view_->tile;
    const double shift = axes_.k * along;
    const int low = axes_.swapped ? tile.box.firstRow : tile.box.firstColumn,
              count = axes_.swapped ? tile.box.rows : tile.box.columns;
    const double lowQ = std::max(corners_[0].q, view_->within.lowQ),
                 highQ = std::min(corners_[2].q, view_->within.highQ);
    const double first = std::max(std::ceil(lowQ + shift), double(low)),
                 end = std::min(std::ceil(highQ + shift), double(low + count));
    const int line = int(axes_.sign) * along;
    for (int across = int(first); across < end; ++across) {
        const int column = axes_.swapped ? line : across, row = axes_.swapped ? across : line;
        const std::int32_t number =
            tile.numbers[std::size_t(row - tile.box.firstRow) * std::size_t(tile.box.columns) +
                         std::size_t(column - tile.box.firstColumn)];
        if (number >= 0 && horizons_[std::size_t(number)] <= most) addCell(number, across - shift, along);
    }
}

void OpenSweep::addCell(std::int32_t number, double q, double along) {
    const Crossing a = crossing(corners_[0], corners_[2], q);
    const Crossing b =
        q < corners_[1].q ? crossing(corners_[0], corners_[1], q) : crossing(corners_[1], corners_[2], q);
    const Crossing near = a.along > b.along ? a : b, far = a.along > b.along ? b : a;
    const double toNear = along - near.along, toFar = along - far.along;
    if (toFar <= onTheWall) return;
    const std::vector<float>& grounds = view_->tile.groundsM;
    const double ground = grounds.empty() ? 0 : double(grounds[std::size_t(number)]) * alongPerMetre_;
    // Over the receiver itself: everything up to the zenith.
    const bool over = toNear <= 0 && (near.rise * toFar - far.rise * toNear) / (toFar - toNear) > ground;
    const HorizonCode atNear = toNear > 0 ? codeAt(near.rise - ground, toNear)
                               : over     ? codeAt(1, 0)
                                          : noHorizon,
                      atFar = codeAt(far.rise - ground, toFar);
    const HorizonCode low = std::min(atNear, atFar), high = std::max(atNear, atFar);
    // Below the horizon it changes nothing: what it would join begins at the horizon or below, too.
    if (high > std::max(view_->lowest, horizons_[std::size_t(number)]))
        gaps_.push_back({std::uint32_t(number), low, high});
}

void OpenSweep::merge() {
    merge_.run(gaps_, horizons_.size());
    merged_ = gaps_.size();
}

OpenTile::OpenTile(const Receivers& receivers, const ReceiverBlocks& blocks, double datumM)
    : box(blocks.box()), numbers(std::size_t(box.columns) * std::size_t(box.rows), -1) {
    if (!receivers.flat()) groundsM.resize(blocks.numbers());
    for (const ReceiverBlocks::Block& block : blocks.blocks()) {
        const std::uint8_t* places = blocks.places(block, false);
        for (std::uint32_t n = 0; n < block.count; ++n) {
            const int column = block.column - box.firstColumn + places[n] % ReceiverBlocks::side,
                      row = block.row - box.firstRow + places[n] / ReceiverBlocks::side;
            if (column >= box.columns || row >= box.rows) continue;
            const std::uint32_t number = block.first + n, cell = blocks.cell(number);
            numbers[std::size_t(row) * std::size_t(box.columns) + std::size_t(column)] = std::int32_t(number);
            if (!receivers.flat() && cell != ReceiverBlocks::padding)
                groundsM[number] = float(double(rayOrigin(receivers.position(cell)).z) - datumM);
        }
    }
}

}  // namespace noonmark
