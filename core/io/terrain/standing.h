#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/io/pieces/read_part.h"
#include "core/io/terrain/buildings_on_terrain.h"

namespace noonmark {

/// The building of the piece that carries each building: the lowest of those that it lies over, or, of a
/// bridge, that it touches; itself if none does. Only for buildings of meshes; empty for other pieces.
std::vector<std::size_t> findCarriers(const FilePiece& piece);

/// The buildings of a piece that state a base on the ground, for a terrain from bases: without those that
/// others carry, and none of a mesh that counts from its own zero.
std::vector<BasedBuilding> findBasedBuildings(const FilePiece& piece,
                                              const std::vector<std::size_t>& carriers, const Frame& frame);

/// Meshes with elevations (not countsFromZero) are read as if they floated above their zero: decides anew
/// which of their parts are overhangs, above the base of each building or of its carrier.
void markOverhangsOnBases(FilePiece& piece, const std::vector<std::size_t>& carriers);

/// Whether a mesh whose bases lie at this height can count from its own zero: from 20 m below it (basements)
/// to 2 m above it. Otherwise, and if its bases follow a terrain that varies, its heights are elevations.
bool countsFromZero(double baseM);

/// Places the buildings of a file on the ground, by one rule for all kinds of files. A building's base is the
/// ground elevation that its file states, or the lowest point of its geometry; its gap is that base minus the
/// lowest ground under its outline. Footprints without elevations are set down on the terrain. For the others
/// Stand::automatic decides for the whole file:
/// - The bases are all at one height (within 0.5 m, between their quartiles) or count from the zero of a
///   mesh, and the ground varies: each building is set down. What is more than 2 m above the height of nine
///   buildings in ten keeps its height above the ground: stilts.
/// - The gaps are alike (their spread is at most 2 m, or a quarter of the spread of the ground). If their
///   median is over 1 m and over their spread, all are shifted by it, else they stay. A building that is
///   farther than 5 m and three spreads from the median is set down by itself, but for a mesh above the
///   ground: a bridge.
/// - Otherwise the bases do not follow the terrain, and each building is set down.
///
/// What others carry moves with them. Without a terrain the ground is flat at z = 0, and each stated base is
/// set on it. Parts of meshes become overhangs, or stop to be, by the ground that they get.
class Standing {
public:
    /// `terrain`: null for flat ground. `carriers`: of the piece. All must outlive this object, and the piece
    /// must not change.
    Standing(const FilePiece& piece, const std::vector<std::size_t>& carriers, const Frame& frame,
             const Terrain* terrain, Stand wanted);

    /// The building with this index of the piece, on its ground.
    [[nodiscard]] std::shared_ptr<const Building> place(std::size_t building) const;

    /// How the bases fit the terrain (without the file's name); nothing if none is stated, or the ground is
    /// flat.
    [[nodiscard]] const std::optional<BaseFit>& fit() const { return fit_; }

    /// Number of buildings that flat ground moved.
    [[nodiscard]] std::size_t flattened() const;

private:
    /// How a building with a base gets to its place: it is lifted, and stands then on its stated ground
    /// (local z after the lift) or, without one, where it is.
    struct Footing {
        float liftM = 0;
        std::optional<float> groundM;
    };

    [[nodiscard]] bool hasBase(std::size_t building) const;
    [[nodiscard]] bool isCarried(std::size_t building) const;
    [[nodiscard]] double gapOf(std::size_t building) const;
    void findGround();
    void decide(Stand wanted);
    void follow(float shiftM);
    void setApart();
    void setDown();
    void followCarriers();

    const FilePiece& piece_;
    const std::vector<std::size_t>& carriers_;
    const Terrain* terrain_;
    float zeroM_ = 0;             ///< local z of the zero that the piece's z count from
    bool fromZero_ = false;       ///< meshes that count from their own zero, and do not follow the terrain
    std::vector<float> lowestM_;  ///< ground under each building that has a base
    std::vector<Footing> footings_;
    std::optional<BaseFit> fit_;
};

/// What to say of a file whose buildings do not stand where it states. `asked`: the user chose the rule.
Warnings describeStanding(const BaseFit& fit, bool asked);

/// Decides anew which parts of a mesh building are overhangs above `groundM(x, y)`.
void redetectOverhangs(Building& building, const std::function<float(glm::dvec2)>& groundM);

}  // namespace noonmark
