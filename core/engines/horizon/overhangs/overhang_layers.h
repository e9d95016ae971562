#pragma once

#include <span>
#include <vector>

#include "core/engines/horizon/geometry/shadow_axes.h"
#include "core/engines/horizon/overhangs/overhang_shapes.h"

namespace noonmark {

/// Of something that hangs, what lies between two neighbouring corners of it as they are seen along one
/// azimuth, lowQ <= q < highQ: there the side that faces the shadow and the one that faces the sun are both
/// straight.
struct OverhangStrip {
    /// At lowQ, and what comes to it for each q. `rise`: such that rise / (distance in `along`) is a tangent.
    struct Side {
        double along, slope, rise, riseSlope;
    };
    double lowQ, highQ;
    Side near, far;  ///< to the shadow
};

/// Strips that lie beside each other, by q: a triangle is one layer, a prism one or, where its outline lies
/// several times across, more.
struct OverhangLayer {
    std::size_t firstStrip, endStrip;
    bool solid;  ///< all between its sides is, from the far one's foot to the near one's top
    double lowQ, highQ, lowestAlong, highestAlong, highestRise;
};

/// What hangs, in the axes of one azimuth. Keeps its memory from one to the next.
class OverhangLayers {
public:
    /// Replaces what is there. `alongPerMetre`: cells along a metre of distance. Some 50 ns a strip.
    void set(std::span<const OverhangShapes* const> shapes, const ShadowAxes& axes, double alongPerMetre);

    [[nodiscard]] std::span<const OverhangLayer> all() const { return layers_; }
    [[nodiscard]] std::span<const OverhangStrip> of(const OverhangLayer& layer) const {
        return std::span(strips_).subspan(layer.firstStrip, layer.endStrip - layer.firstStrip);
    }

private:
    /// A corner, or where something is crossed.
    struct Corner {
        double q, along, rise;
    };
    /// Of a wall, from its lower q to its higher.
    struct Edge {
        double lowQ, highQ, along, slope;  // `along` at lowQ; slope of it against q
        [[nodiscard]] double at(double q) const { return along + slope * (q - lowQ); }
    };
    void add(const OverhangTriangle& triangle, const ShadowAxes& axes);
    void addStrip(const Corner& a1, const Corner& a2, const Corner& b1, const Corner& b2);
    void add(const OverhangPrism& prism, const ShadowAxes& axes);
    void findEdges(const OverhangPrism& prism, const ShadowAxes& axes);
    void addAcross(double lowQ, double highQ, double bottom, double top);
    void addLayers(bool solid, double rise);

    double alongPerMetre_ = 1;
    std::vector<OverhangStrip> strips_;
    std::vector<OverhangLayer> layers_;
    ShadowExtent extent_;  // of the shape at hand
    std::vector<Edge> edges_;
    std::vector<double> corners_;
    std::vector<const Edge*> crossed_;
    std::vector<std::vector<OverhangStrip>> across_;  // of the shape at hand, layer by layer
};

}  // namespace noonmark
