#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "core/accumulate/horizon/horizon_code.h"
#include "core/accumulate/horizon/open_triangles.h"
#include "core/accumulate/horizon/shadow_axes.h"
#include "core/accumulate/horizon/wall_list.h"
#include "core/receivers/grid.h"

namespace noonmark {

/// A part with plumb walls that hangs: looked at whole, not triangle by triangle.
struct OpenPrism {
    std::vector<std::vector<glm::dvec2>> rings;  ///< outer one and holes, cells
    double bottomM, topM;                        ///< above the datum
};

/// What hangs, each part whole where it can be.
struct OpenShapes {
    std::vector<OpenPrism> prisms;
    std::vector<OpenTriangle> triangles;  ///< of all else
    [[nodiscard]] bool empty() const { return prisms.empty() && triangles.empty(); }
};

/// `datumM`: local z that heights count from. Error: prisms and triangles are more than OpenTriangles::most.
Result<OpenShapes> openShapes(const OpenParts& parts, const Grid& grid, double datumM);

/// A prism in the axes of one azimuth.
struct PrismOutline {
    /// Of a wall, from its lower q to its higher.
    struct Edge {
        double lowQ, highQ, along, slope;  ///< `along` at lowQ; slope of it against q
    };
    std::vector<Edge> edges;  ///< by lowQ
    double lowQ = 0, highQ = 0, lowestAlong = 0, highestAlong = 0;
    double bottom = 0, top = 0;  ///< such that bottom / (distance in `along`) is a tangent

    void set(const OpenPrism& prism, const ShadowAxes& axes, double alongPerMetre);

private:
    void add(const ShadowAxes::Point& a, const ShadowAxes::Point& b);
};

/// A way over an outline at rising q.
class OutlineWalk {
public:
    void begin(const PrismOutline& outline);

    /// `along` of the walls at q, in pairs: inside is between the two of each. Valid until the next call.
    std::span<const double> alongs(double q);

private:
    const PrismOutline::Edge *next_ = nullptr, *end_ = nullptr;
    std::vector<const PrismOutline::Edge*> crossed_;
    std::vector<double> alongs_;
};

/// Cells; nearer than that a receiver is on what hangs.
inline constexpr double onWhatHangs = 1e-3;

/// Of something this much higher at this distance in `along`.
inline HorizonCode codeAt(double rise, double distance) {
    return rise <= 0 ? noHorizon : codeOfHorizon(float(rise / (rise + distance)));
}

}  // namespace noonmark
