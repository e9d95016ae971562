#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/city/footprints/repair_footprint.h"

namespace noonmark::tests {

/// The area of a polygon, valid or not, by scan lines and winding numbers: a point is inside if the outline
/// winds around it and no hole does; a hole that lies wholly outside an outline counts separately. Shares no
/// code and no method with the code under test.
class WindingArea {
public:
    explicit WindingArea(const std::vector<RawRing>& rings)
        : outside_(rings.size(), true), winding_(rings.size()) {
        for (std::size_t r = 0; r < rings.size(); ++r)
            for (std::size_t i = 0; i < rings[r].size(); ++i)
                addEdge(rings[r][i], rings[r][(i + 1) % rings[r].size()], r);
        std::sort(edges_.begin(), edges_.end(),
                  [](const Edge& e, const Edge& f) { return e.low.y < f.low.y; });
        findSlabs();
    }

    double operator()() {
        if (edges_.empty()) return 0;
        outside_[0] = false;
        bool hasOutline = false;
        forEachSpan([&](double) {
            for (std::size_t i = 1; i < winding_.size(); ++i)
                if (winding_[0] != 0 && winding_[i] != 0) outside_[i] = false;
            hasOutline |= winding_[0] != 0;
        });
        double sum = 0;
        forEachSpan([&](double area) { sum += inside() ? area : 0; });
        return hasOutline ? sum : 0;
    }

private:
    struct Edge {
        glm::dvec2 low, high;
        std::size_t ring;
        int turn;
        [[nodiscard]] double xAt(double y) const {
            return low.x + (y - low.y) / (high.y - low.y) * (high.x - low.x);
        }
    };
    struct Crossing {
        double x;
        const Edge* edge;
    };

    void addEdge(glm::dvec2 a, glm::dvec2 b, std::size_t ring) {
        if (!(std::isfinite(a.x + a.y) && std::isfinite(b.x + b.y))) return;
        ys_.push_back(a.y);
        if (a.y < b.y) edges_.push_back({a, b, ring, 1});
        if (a.y > b.y) edges_.push_back({b, a, ring, -1});
    }

    // Between two neighbouring heights no edge ends and no two edges cross, so that one scan line there
    // measures exactly.
    void findSlabs() {
        for (std::size_t i = 0; i < edges_.size(); ++i)
            for (std::size_t j = i + 1; j < edges_.size() && edges_[j].low.y < edges_[i].high.y; ++j)
                addCrossing(edges_[i], edges_[j]);
        std::sort(ys_.begin(), ys_.end());
        ys_.erase(std::unique(ys_.begin(), ys_.end()), ys_.end());
    }

    void addCrossing(const Edge& e, const Edge& f) {
        const double from = std::max(e.low.y, f.low.y);
        const double to = std::min(e.high.y, f.high.y);
        const double before = e.xAt(from) - f.xAt(from);
        const double after = e.xAt(to) - f.xAt(to);
        if (before * after < 0) ys_.push_back(from + (to - from) * before / (before - after));
    }

    [[nodiscard]] bool inside() const {
        bool covered = winding_[0] != 0;
        for (std::size_t i = 1; i < winding_.size(); ++i) covered &= winding_[i] == 0 || outside_[i];
        for (std::size_t i = 1; i < winding_.size(); ++i) covered |= winding_[i] != 0 && outside_[i];
        return covered;
    }

    template <class Visit>
    void forEachSpan(Visit visit) {
        std::size_t next = 0;
        std::vector<const Edge*> active;
        for (std::size_t i = 0; i + 1 < ys_.size(); ++i) {
            const double y = (ys_[i] + ys_[i + 1]) / 2;
            while (next < edges_.size() && edges_[next].low.y < y) active.push_back(&edges_[next++]);
            std::erase_if(active, [&](const Edge* edge) { return edge->high.y <= y; });
            visitLine(active, y, ys_[i + 1] - ys_[i], visit);
        }
    }

    template <class Visit>
    void visitLine(const std::vector<const Edge*>& active, double y, double heightM, Visit& visit) {
        std::vector<Crossing> crossings;
        for (const Edge* edge : active) crossings.push_back({edge->xAt(y), edge});
        std::sort(crossings.begin(), crossings.end(),
                  [](const Crossing& p, const Crossing& q) { return p.x < q.x; });
        std::fill(winding_.begin(), winding_.end(), 0);
        for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
            winding_[crossings[i].edge->ring] += crossings[i].edge->turn;
            if (crossings[i + 1].x > crossings[i].x) visit((crossings[i + 1].x - crossings[i].x) * heightM);
        }
    }

    std::vector<Edge> edges_;  ///< sorted by their lower end
    std::vector<double> ys_;
    std::vector<bool> outside_;
    std::vector<int> winding_;  ///< winding numbers of the current span, by ring
};

}  // namespace noonmark::tests
