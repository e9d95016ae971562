#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/engines/horizon/geometry/shadow_axes.h"
#include "core/engines/horizon/geometry/wall_list.h"
#include "core/geo/grid.h"

namespace noonmark {

/// An overhang with vertical walls. In cells and in metres above a datum, like all shapes.
struct OverhangPrism {
    std::vector<std::vector<glm::dvec2>> rings;  ///< outer ring and holes
    double bottomM, topM;
};

/// A triangle of an overhang that is not a prism.
using OverhangTriangle = std::array<glm::dvec3, 3>;

/// The overhangs of one building; each is a prism where possible.
struct OverhangShapes {
    static constexpr std::size_t maximum =
        50'000;  ///< limit per city: each is examined from every cell that it may shade

    std::uint32_t building = 0;  ///< as in OverhangPart
    std::vector<OverhangPrism> prisms;
    std::vector<OverhangTriangle> triangles;
    glm::dvec2 low{1e30}, high{-1e30};  ///< bounds
    double topM = -1e30;

    [[nodiscard]] std::size_t size() const { return prisms.size() + triangles.size(); }
};

/// Pointers to overhangs; not owned.
using OverhangList = std::vector<const OverhangShapes*>;

/// One entry per building. `parts`: those of one building must be adjacent. `datumM`: local z from which
/// heights are measured.
std::vector<OverhangShapes> toOverhangShapes(const OverhangParts& parts, const Grid& grid, double datumM);

/// The same. Error if there are more than `maximum`.
Result<std::vector<OverhangShapes>> makeOverhangShapes(const OverhangParts& parts, const Grid& grid,
                                                       double datumM);

OverhangList listOf(std::span<const OverhangShapes> shapes);

/// Error if the count exceeds OverhangShapes::maximum.
Result<void> checkOverhangCount(std::size_t count);

/// The part of an overhang between two neighbouring corners as seen along one azimuth, lowQ <= q < highQ.
/// Within it, the side that faces the shadow and the side that faces the sun are both straight.
struct OverhangStrip {
    /// Values at lowQ and their change per q. `rise` is scaled so that rise / (distance in `along`) is a
    /// tangent.
    struct Side {
        double along, slope, rise, riseSlope;
    };
    double lowQ, highQ;
    Side near, far;  ///< `near` faces the shadow, `far` the sun
};

/// Strips side by side, in order of q. A triangle is one layer; a prism is one layer, or several if its
/// outline crosses an azimuth more than twice.
struct OverhangLayer {
    std::size_t firstStrip, endStrip;
    bool solid;  ///< all space between the sides, from the far side's bottom to the near side's top, is solid
    double lowQ, highQ, lowestAlong, highestAlong, highestRise;
};

/// Overhangs in the axes of one azimuth. Reuses its memory.
class OverhangLayers {
public:
    /// Replaces the contents. `alongPerMetre`: cells along per metre of distance. Some 50 ns per strip.
    void set(std::span<const OverhangShapes* const> shapes, const ShadowAxes& axes, double alongPerMetre);

    [[nodiscard]] std::span<const OverhangLayer> all() const { return layers_; }
    [[nodiscard]] std::span<const OverhangStrip> of(const OverhangLayer& layer) const {
        return std::span(strips_).subspan(layer.firstStrip, layer.endStrip - layer.firstStrip);
    }

private:
    /// A corner, or an intersection.
    struct Corner {
        double q, along, rise;
    };
    /// A wall's edge, from its lower q to its higher.
    struct Edge {
        double lowQ, highQ, along, slope;  // `along` at lowQ, and its change per q
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
    ShadowExtent extent_;  // of the current shape
    std::vector<Edge> edges_;
    std::vector<double> corners_;
    std::vector<const Edge*> crossed_;
    std::vector<std::vector<OverhangStrip>> across_;  // of the current shape, by layer
};

}  // namespace noonmark
