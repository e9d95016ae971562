#pragma once

#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "core/city/city.h"
#include "core/samples/street_axes.h"

namespace noonmark {

/// Random numbers for the samples, identical on every machine: the C++ standard leaves the distributions of
/// <random>, and the last bits of std::exp and std::cos, to the implementation. One stream per block, so that
/// a block does not depend on the number of other blocks.
class SampleRandom {
public:
    SampleRandom(std::uint32_t seed, int column, int row);

    /// 0 (included) to 1 (excluded), in steps of 2^-32.
    double uniform();
    double between(double low, double high) { return low + (high - low) * uniform(); }
    bool chance(double probability) { return uniform() < probability; }

    /// Log-normal; the underlying normal is a sum of twelve uniform numbers, so it ends at 6 sigma.
    double logNormal(double median, double sigma);

private:
    std::mt19937 engine_;
};

/// e^x for |x| <= 20 to 12 digits, computed with + * and / only: the same bits on every machine.
double portableExp(double x);

struct SineCosine {
    double sine;
    double cosine;
};
/// Sine and cosine of a share of the full turn, -1 to 1, to 12 digits; the same bits on every machine.
SineCosine portableSineCosine(double turns);

/// A lot in a block. Its front is on the street to the south or to the north.
struct Lot {
    StreetBox box;
    bool frontsNorth = false;
    StreetPolygon ground;  ///< the polygon of the box that a skewed avenue leaves

    [[nodiscard]] bool isWhole() const { return computeArea(ground) > 0.999 * box.width() * box.depth(); }
};

struct LotWidths {
    double narrowestM = 7.5;
    double widestM = 30;
    double preferWide = 0;  ///< 0: narrow lots are common; 1: all widths are equally likely
};

/// The lots of a block: two rows back to back, side by side without gaps; together they fill the block.
std::vector<Lot> cutIntoLots(const StreetBox& block, const LotWidths& widths, SampleRandom& random);

/// The lots with their ground cut by an avenue; lots with less than 60 m2 left are removed.
std::vector<Lot> cutBy(const SkewedAvenue& avenue, std::vector<Lot> lots);

struct LotBuildingSettings {
    double heightM = 20;
    int roundness = 0;  ///< extra points on each curved facade
};

/// Makes a plausible building on a lot, inside its ground: row house, L, U, courtyard, bowed front, podium
/// with a square or round tower, or setbacks in three tiers, chosen by height, width and chance. On a cut lot
/// the building follows the cut. Its footprints are simple or repaired. No parts if the ground is too small.
Building buildOnLot(const Lot& lot, const LotBuildingSettings& settings, const StreetAxes& axes,
                    SampleRandom& random);

/// A prism from a polygon in street axes. The outline counter-clockwise, holes clockwise; polygons that are
/// not simple are repaired.
std::vector<Part> makePrism(const std::vector<StreetPolygon>& rings, double bottomM, double topM,
                            const StreetAxes& axes);

/// The appearance of a quarter.
struct BlockSettings {
    LotWidths widths;
    /// Median height on a lot whose middle is at `street`
    std::function<double(glm::dvec2 street)> medianHeightM;
    double heightSigma = 0.45;  ///< standard deviation of the logarithm of heights
    double lowestM = 7;
    double highestM = 420;
    int roundness = 0;
    std::vector<SkewedAvenue> avenues;  ///< avenues that cut lots
    std::vector<StreetBox> cleared;     ///< lots that overlap one of these stay empty
};

/// The buildings of one block, with log-normal heights, in the order of its lots; narrow lots stay under nine
/// times their width.
std::vector<Building> buildOnLots(const StreetBox& block, const BlockSettings& settings,
                                  const StreetAxes& axes, SampleRandom& random);

}  // namespace noonmark
