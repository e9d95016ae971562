#include "core/accumulate/horizon/open_parts.h"

#include <algorithm>
#include <cmath>

#include "core/accumulate/ray_reference.h"

namespace noonmark {

namespace {

// Gaps that are collected before those of one receiver are made one.
constexpr std::size_t gapsAMerge = std::size_t{1} << 20U;
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
    ++views_;
    lows_.resize(std::max(lows_.size(), view.tile.squares.size()));
    gaps_.clear();
    merged_ = 0;
    for (const OpenTriangle& triangle : view.triangles) {
        if (stop.stop_requested()) return {};
        add(triangle);
        if (gaps_.size() - merged_ > gapsAMerge) merge();
    }
    for (const OpenPrism& prism : view.prisms) {
        if (stop.stop_requested()) return {};
        add(prism);
        if (gaps_.size() - merged_ > gapsAMerge) merge();
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
    forEachLine(
        {first, last}, {corners_[0].q, corners_[2].q},
        [&](double along) { return along > far ? codeAt(rise, along - far) : codeAt(1, 0); },
        [&](int along, HorizonCode most) { addLine(along, most); });
}

// Lines of one row of squares, or of one column where swapped.
bool OpenSweep::mayBeSeen(const Range& lines, const Range& q, HorizonCode most) {
    constexpr int side = ReceiverBlocks::side;
    const TileBox& box = view_->tile.box;
    const LineCells one = cellsOf(int(lines.first), q.first, q.last),
                    other = cellsOf(int(lines.last), q.first, q.last);
    const int low = axes_.swapped ? box.firstRow : box.firstColumn,
              lineLow = axes_.swapped ? box.firstColumn : box.firstRow;
    const int first = std::min(one.first, other.first) - low,
              end = std::min(std::max(one.end, other.end) - low, axes_.swapped ? box.rows : box.columns);
    const auto columns = std::size_t((box.columns + side - 1) / side),
               line = std::size_t((one.line - lineLow) / side);
    for (int across = std::max(0, first / side * side); across < end; across += side) {
        const auto square = std::size_t(across / side);
        if (lowestIn(axes_.swapped ? square * columns + line : line * columns + square) <= most) return true;
    }
    return false;
}

// `blind` where nobody is.
HorizonCode OpenSweep::lowestIn(std::size_t square) {
    SquareLow& low = lows_[square];
    if (low.view == views_) return low.code;
    const auto [first, end] = view_->tile.squares[square];
    low = {views_, blind};
    for (const HorizonCode code : horizons_.subspan(first, end - first)) low.code = std::min(low.code, code);
    return low.code;
}

OpenSweep::LineCells OpenSweep::cellsOf(int along, double lowQ, double highQ) const {
    const TileBox& box = view_->tile.box;
    const double shift = axes_.k * along;
    const int low = axes_.swapped ? box.firstRow : box.firstColumn,
              count = axes_.swapped ? box.rows : box.columns;
    const double first = std::max(std::ceil(std::max(lowQ, view_->within.lowQ) + shift), double(low)),
                 end = std::min(std::ceil(std::min(highQ, view_->within.highQ) + shift), double(low + count));
    return {int(axes_.sign) * along, int(first), int(std::max(first, end)), shift};
}

std::int32_t OpenSweep::numberAt(int line, int across) const {
    const TileBox& box = view_->tile.box;
    const int column = axes_.swapped ? line : across, row = axes_.swapped ? across : line;
    return view_->tile.numbers[std::size_t(row - box.firstRow) * std::size_t(box.columns) +
                               std::size_t(column - box.firstColumn)];
}

// Such that height over it is as `rise`.
double OpenSweep::groundOf(std::int32_t number) const {
    const std::vector<float>& grounds = view_->tile.groundsM;
    return grounds.empty() ? 0 : double(grounds[std::size_t(number)]) * alongPerMetre_;
}

// The cells of one line across whose shadow line meets the triangle: lowest q <= q < highest q. None of them
// can see it higher than `most`, but for a level of rounding.
void OpenSweep::addLine(int along, HorizonCode most) {
    const LineCells cells = cellsOf(along, corners_[0].q, corners_[2].q);
    for (int across = cells.first; across < cells.end; ++across) {
        const std::int32_t number = numberAt(cells.line, across);
        if (number >= 0 && horizons_[std::size_t(number)] <= most)
            addCell(number, across - cells.shift, along);
    }
}

void OpenSweep::addCell(std::int32_t number, double q, double along) {
    const Crossing a = crossing(corners_[0], corners_[2], q);
    const Crossing b =
        q < corners_[1].q ? crossing(corners_[0], corners_[1], q) : crossing(corners_[1], corners_[2], q);
    const Crossing near = a.along > b.along ? a : b, far = a.along > b.along ? b : a;
    const double toNear = along - near.along, toFar = along - far.along;
    if (toFar <= onWhatHangs) return;
    const double ground = groundOf(number);
    // Over the receiver itself: everything up to the zenith.
    const bool over = toNear <= 0 && (near.rise * toFar - far.rise * toNear) / (toFar - toNear) > ground;
    const HorizonCode atNear = toNear > 0 ? codeAt(near.rise - ground, toNear)
                               : over     ? codeAt(1, 0)
                                          : noHorizon,
                      atFar = codeAt(far.rise - ground, toFar);
    addGap(number, std::min(atNear, atFar), std::max(atNear, atFar));
}

void OpenSweep::addGap(std::int32_t number, HorizonCode low, HorizonCode high) {
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
    constexpr int side = ReceiverBlocks::side;
    const glm::ivec2 all = blocks.squares();
    squares.assign(std::size_t(all.x) * std::size_t(all.y), {0, 0});
    for (const ReceiverBlocks::Block& block : blocks.blocks()) {
        squares[std::size_t((block.row - box.firstRow) / side) * std::size_t(all.x) +
                std::size_t((block.column - box.firstColumn) / side)] = {block.first,
                                                                         block.first + block.count};
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
