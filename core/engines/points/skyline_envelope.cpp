#include "core/engines/points/skyline_envelope.h"

#include <algorithm>
#include <span>

namespace noonmark {

namespace {

/// Builds a list of pieces from left to right.
class PieceList {
public:
    void add(const SeenEdge& edge, double from, double to) {
        constexpr double least = 1e-12;  // radians: rounding of an azimuth
        if (to - from < least) return;
        if (!pieces_.empty()) {
            SeenEdge& last = pieces_.back();
            const bool same =
                last.east == edge.east && last.north == edge.north && last.building == edge.building;
            if (same && from - last.to < least) {
                last.to = to;
                return;
            }
        }
        pieces_.push_back(edge);
        pieces_.back().from = from;
        pieces_.back().to = to;
    }

    // Two curves of this kind cross at most once within half a turn.
    void addHigher(const SeenEdge& one, const SeenEdge& other, double from, double to) {
        const double east = one.east - other.east, north = one.north - other.north;
        const double middle = (from + to) / 2;
        double crossing = std::atan2(-north, east);  // where east sin + north cos is 0
        crossing += std::round((middle - crossing) / std::numbers::pi) * std::numbers::pi;
        if (crossing <= from || crossing >= to) {
            add(one.tanAt(middle) >= other.tanAt(middle) ? one : other, from, to);
            return;
        }
        const double before = (from + crossing) / 2;
        const bool oneFirst = one.tanAt(before) >= other.tanAt(before);
        add(oneFirst ? one : other, from, crossing);
        add(oneFirst ? other : one, crossing, to);
    }

    std::vector<SeenEdge> take() { return std::move(pieces_); }

private:
    std::vector<SeenEdge> pieces_;
};

std::vector<SeenEdge> mergeHighest(const std::vector<SeenEdge>& one, const std::vector<SeenEdge>& other) {
    PieceList highest;
    std::size_t i = 0, j = 0;
    double at = 0;
    while (i < one.size() || j < other.size()) {
        const SeenEdge* first = i < one.size() ? &one[i] : nullptr;
        const SeenEdge* second = j < other.size() ? &other[j] : nullptr;
        const double firstFrom = first != nullptr ? std::max(at, first->from) : fullTurn;
        const double secondFrom = second != nullptr ? std::max(at, second->from) : fullTurn;
        const double from = std::min(firstFrom, secondFrom);
        const bool hasFirst = first != nullptr && firstFrom <= from;
        const bool hasSecond = second != nullptr && secondFrom <= from;
        double to = fullTurn;
        if (first != nullptr) to = std::min(to, hasFirst ? first->to : first->from);
        if (second != nullptr) to = std::min(to, hasSecond ? second->to : second->from);
        if (hasFirst && hasSecond)
            highest.addHigher(*first, *second, from, to);
        else if (hasFirst || hasSecond)
            highest.add(hasFirst ? *first : *second, from, to);
        at = to;
        if (first != nullptr && first->to <= at) ++i;
        if (second != nullptr && second->to <= at) ++j;
        if (!hasFirst && !hasSecond) break;
    }
    return highest.take();
}

std::vector<SeenEdge> highestOf(std::span<const SeenEdge> edges) {
    if (edges.size() <= 1) return {edges.begin(), edges.end()};
    const std::size_t half = edges.size() / 2;
    return mergeHighest(highestOf(edges.first(half)), highestOf(edges.subspan(half)));
}

void cutAtNorth(std::vector<SeenEdge>& edges) {
    const std::size_t count = edges.size();
    for (std::size_t i = 0; i < count; ++i) {
        if (edges[i].to <= fullTurn) continue;
        SeenEdge rest = edges[i];
        rest.from = 0;
        rest.to -= fullTurn;
        edges[i].to = fullTurn;
        edges.push_back(rest);
    }
}

}  // namespace

std::vector<SeenEdge> findHighest(std::vector<SeenEdge> edges) {
    cutAtNorth(edges);
    return highestOf(edges);
}

}  // namespace noonmark
